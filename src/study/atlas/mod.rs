//! The stability atlas: outcome, iterations and error of every element × algorithm × rule, and of what the program makes of the
//! first of them, over initial stiffness and one other number; the plain ones predicted before they are run. Above 400 lines, so
//! a folder:
//!
//! * `plane` — initial stiffness against which other number, and what lies on one mesh.
//! * `record` — what is kept under `snapshots/atlas`, and its chart of classes with their boundaries.
//! * `run` — a point predicted and run; a record read and a twentieth of it recomputed; the paper's scenes before and after
//!   acceleration.
//! * `judge` — predictions against runs, and what the records must hold.
//! * `summary` — what the records say of each method, and what to use.
//! * `section`, `picture` — the page and its charts.

mod judge;
mod picture;
pub mod plane;
pub mod record;
pub mod run;
mod section;
pub mod summary;

use crate::study::about::About;

pub use crate::solve::Ended;
pub use judge::judge;
pub use picture::pictures;
pub use plane::{Plane, Site};
pub use record::{Chart, Record};
pub use run::{Numbers, Saved, plan};
pub use section::section;
pub use summary::{recommendation, recommended};

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Where methods fail",
    asked: "How many iterations every method takes from each initial stiffness, and from which it ends right, over candidates, meshes and \
            scenes.",
    limits: "Scenes of one contact without friction; beyond the surveyed range nothing is known.",
};
