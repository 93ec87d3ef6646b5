//! Whether an accuracy called met is met: random scenes whose truth is known, solved to five accuracies, from guesses of the
//! candidate stretch up to ten times too long or three times too short.
//!
//! * `sites` — which scenes, and which accuracies.
//! * `plan` — what is run.
//! * `run` — one scene solved to one accuracy, against the truth.
//! * `judge` — what the record must hold.
//! * `section` — what it shows.

pub mod judge;
mod plan;
pub mod run;
mod section;
pub mod sites;

/// Name of the command that surveys it, and of its record.
pub const NAME: &str = "met";

use crate::study::about::About;

pub use judge::judge;
pub use plan::plan;
pub use run::{Numbers, Record};
pub use section::{pictures, section};
pub use sites::{ASKED, families, sites};

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Whether an accuracy called met is met",
    asked: "How often an answer that is called accurate is not.",
    limits: "Random scenes whose truth is known, as for error bars.",
};
