//! What is called converged: every scene, library and file, under all nine formulations, from candidates that hardly reach
//! beyond the contact to such that are a hundred times as long, and under loads a ten-thousandth of the scene's own. No run may
//! be called converged whose peak or half-width is not that of its own discrete problem.
//!
//! * `sites` — scenes, stretches, loads, tolerances.
//! * `plan` — what is run.
//! * `run` — one scene on one stretch, with all its runs.
//! * `judge` — what the record must hold.
//! * `share` — shares of runs that converge.
//! * `section` and `picture` — what it shows.

pub mod judge;
mod picture;
mod plan;
pub mod run;
mod section;
mod share;
pub mod sites;

/// Name of the command that surveys it, and of its record.
pub const NAME: &str = "converged";

use crate::study::about::About;

pub use judge::judge;
pub use picture::pictures;
pub use plan::plan;
pub use run::{Numbers, Record};
pub use section::section;
pub use sites::{Site, sites};

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "What is called converged",
    asked: "Whether a run that is called converged has the peak and the width of its discrete problem.",
    limits: "It says nothing of the mesh: that is what error bars are for.",
};
