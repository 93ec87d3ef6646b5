//! Whether error bars hold: random scenes whose truth is known on random meshes, and their true errors.
//!
//! * `sites` — which scenes.
//! * `setup` — on which mesh, by which formulation.
//! * `plan` — what is run.
//! * `run` — one scene solved, its errors and bars.
//! * `group` — what some errors and bars say together.
//! * `judge` — what the record must hold.
//! * `section`, `picture` — what it shows.

pub mod group;
pub mod judge;
mod picture;
mod plan;
pub mod run;
mod section;
pub mod setup;
pub mod sites;

/// Name of the command that surveys it, and of its record.
pub const NAME: &str = "coverage";

use crate::study::about::About;

pub use judge::judge;
pub use picture::pictures;
pub use plan::plan;
pub use run::{Kind, Numbers, Record};
pub use section::section;
pub use sites::sites;

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Whether error bars hold",
    asked: "How often the true error is within the error bar that was printed.",
    limits: "Random scenes whose truth is a closed form, or that of a boundary method: what has neither is not among them.",
};
