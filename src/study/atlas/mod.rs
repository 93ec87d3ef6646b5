//! The stability atlas: outcome, iterations, rate and error of every element × algorithm × rule, and of what the program makes of
//! the first of them, over initial stiffness and one other number; the plain ones predicted before they are run.
//!
//! * `plane` — initial stiffness against which other number.
//! * `row` — a line of a plane.
//! * `point` — one point, predicted and run.
//! * `record` — what is kept under `snapshots/atlas`.
//! * `survey` — all points, resumable.
//! * `chart` — a plane as classes and their boundaries.
//! * `plan`, `run` — a record is read, and a twentieth of it recomputed.
//! * `agreement` — predictions against runs.
//! * `judge` — what the records must hold.
//! * `summary` — what the records say of each method.
//! * `section`, `recommended`, `slices` — the chapter.
//! * `picture` — iterations with their predictions, `picture_map` — the maps.

pub mod agreement;
pub mod chart;
mod judge;
mod picture;
mod picture_map;
mod plan;
pub mod plane;
pub mod point;
mod recommended;
pub mod record;
pub mod row;
pub mod run;
mod section;
mod slices;
pub mod summary;
pub mod survey;

use crate::study::about::About;

pub use crate::study::class::Class;
pub use chart::Chart;
pub use judge::judge;
pub use picture::pictures;
pub use plan::plan;
pub use plane::Plane;
pub use recommended::{recommendation, recommended};
pub use record::Record;
pub use row::Row;
pub use run::Numbers;
pub use section::section;

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Where methods fail",
    asked: "From which initial stiffness every method ends right, over candidates, meshes and scenes.",
    limits: "Scenes of one contact without friction; beyond the surveyed range nothing is known.",
};
