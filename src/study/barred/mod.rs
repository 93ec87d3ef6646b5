//! Whether the error bars of the suite's own checks hold.
//!
//! * `plan` — nothing is run: what is looked at is what all other trials found.
//! * `run` — the checks that have a bar, and those whose error is beyond it.
//! * `judge` — how many may be.
//! * `section` — all of them.

pub mod judge;
mod plan;
pub mod run;
mod section;

use crate::study::about::About;

pub use judge::judge;
pub use plan::plan;
pub use run::Numbers;
pub use section::{pictures, section};

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Error bars beside checks",
    asked: "Whether the checks of this suite have errors within their own bars.",
    limits: "Only checks against closed forms have a true error to look at.",
};
