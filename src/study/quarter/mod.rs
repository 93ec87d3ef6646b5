//! The half cylinder against the quarter: the top may be left out while the contact is small.
//!
//! * `plan` — one trial.
//! * `run` — change of peak and second-moment width by a/R.
//! * `judge` — no more than `judge::LEFT_OUT` at small a/R.
//! * `section` — a row for each a/R.

pub mod judge;
mod plan;
pub mod run;
mod section;

use crate::study::about::About;

pub use judge::{LEFT_OUT, judge};
pub use plan::plan;
pub use run::{Change, Contact, Numbers};
pub use section::{pictures, section};

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Half cylinder against quarter",
    asked: "Whether the top quarter of the half cylinder may be left out, as the paper says.",
    limits: "One cylinder, one material, one way of loading it from above.",
};
