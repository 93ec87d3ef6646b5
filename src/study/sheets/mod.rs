//! A benchmark sheet a case of the library: all that somebody with another code needs to run it, and the values to be met.
//!
//! * `plan` — one trial a case.
//! * `run` — reference values with their bars, closed forms, and what other codes found.
//! * `described` — the scene in words and numbers.
//! * `judge` — reference values known well enough, and met by the other codes.
//! * `section` — the list of the sheets; `sheet` — one of them.

pub mod described;
mod judge;
mod plan;
pub mod run;
mod section;
mod sheet;

use crate::study::about::About;

pub use judge::judge;
pub use plan::plan;
pub use run::Numbers;
pub use section::{SHEETS, pictures, section};
pub use sheet::sheet;

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Benchmark sheets",
    asked: "What somebody with another code needs to run the cases of the library.",
    limits: "A closed form may be of an idealised scene; the sheet says where.",
};
