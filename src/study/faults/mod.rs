//! Fault injection: what turned red when a fault was put into a copy of the tree.
//!
//! * `plan` — one trial, the record.
//! * `run` — the record is read.
//! * `judge` — every fault turned a check against a truth red.
//! * `section` — a row for each fault.

mod judge;
mod plan;
pub mod run;
mod section;

use crate::study::about::About;

pub use judge::{is_caught, judge};
pub use plan::plan;
pub use run::{Fault, Numbers, Planted};
pub use section::{pictures, section};

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Fault injection",
    asked: "Which checks turn red when something is broken on purpose.",
    limits: "Faults that somebody thought of, one at a time.",
};
