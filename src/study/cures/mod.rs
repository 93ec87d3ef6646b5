//! Cures of what fails or is slow, beside the paper's algorithms: the program takes Anderson acceleration, the others are options.
//!
//! * `plan` — a trial for each element, one for the rules, one for each scene of nested starts.
//! * `run` — what came out of any of them.
//! * `record` — over which initial stiffnesses constant stiffness converges, plain and accelerated: measured and recorded.
//! * `rules` — every rule of constant stiffness with every acceleration.
//! * `nested` — iterations of kinematic load from every candidate closed, and from the active set of coarser meshes.
//! * `judge` — the checks.
//! * `section` — the tables.
//! * `picture` — iterations against initial stiffness.

mod judge;
mod nested;
mod picture;
mod plan;
pub mod record;
mod rules;
mod run;
mod section;

use crate::study::about::About;

pub use judge::{judge, times};
pub use nested::{Nested, OnMesh, Start};
pub use picture::pictures;
pub use plan::plan;
pub use record::Runs;
pub use rules::{Ended, Rule};
pub use run::{Numbers, Reach};
pub use section::section;

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Cures of what is slow",
    asked: "Whether accelerations and nested starts widen what converges.",
    limits: "Beside the paper's algorithms: the program takes Anderson acceleration, the others are options.",
};
