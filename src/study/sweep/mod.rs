//! Iterations against initial stiffness (the paper's Fig. 11), the condition of its "two iterations", and the rules of each algorithm.
//!
//! * `scene` — what is swept, and over which stiffnesses.
//! * `plan` — both scenes under all nine formulations, candidates that end at the contact edge, all rules.
//! * `run` — a curve of one formulation; the outcomes of all rules.
//! * `judge` — what converges is the discrete solution.
//! * `section`, `picture` — the chart and the table.

mod judge;
mod picture;
mod plan;
pub mod run;
pub mod scene;
mod section;

use crate::study::about::About;

pub use judge::judge;
pub use picture::pictures;
pub use plan::plan;
pub use run::Numbers;
pub use section::section;

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Elements and iterations",
    asked: "How many iterations each formulation takes from each initial stiffness.",
    limits: "The scenes of the paper only; the atlas asks the same over candidates and meshes.",
};
