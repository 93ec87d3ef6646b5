//! The cases of the suite, each solved by its formulations.
//!
//! * `plan` — built-in cases and scene files; formulations of a case share one mesh.
//! * `run` — a run with its judged checks.
//! * `section` — what each case is, and the numbers of its runs.
//! * `page` — which page shows a case, and with which pictures.
//! * `picture` — pressure of all nine against the reference.

pub mod page;
mod picture;
mod picture_band;
mod plan;
mod run;
mod scene;
mod section;

use crate::study::about::About;

pub use picture::pictures;
pub use plan::plan;
pub use run::{Numbers, judge};
pub use section::{results, section, sources};

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Cases",
    asked: "Whether each case, under each of its formulations, is what its reference says.",
    limits: "A case shows its own scene only; what a page of a case calls its limits is said there.",
};
