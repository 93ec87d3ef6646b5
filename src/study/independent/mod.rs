//! The same physical problem in other codes that share nothing with one another but the scene: mesh, forms of the contact, iteration and
//! measures are each script's own.
//!
//! * `benchmark` — the scenes, as numbers.
//! * `plan` — one trial a scene.
//! * `run` — what every script found, beside ours.
//! * `found` — the numbers of a series of meshes, with their uncertainty.
//! * `renewal` — asking the scripts now, and freezing what they answer (feature `python`).
//! * `judge` — differences within their uncertainty, and within what was found.
//! * `section`, `picture` — the numbers, the profiles.

pub mod benchmark;
pub mod found;
pub mod judge;
mod picture;
mod plan;
#[cfg(feature = "python")]
pub mod renewal;
pub mod run;
mod section;

use crate::study::about::About;

pub use judge::judge;
pub use picture::pictures;
#[cfg(feature = "python")]
pub use plan::live;
pub use plan::plan;
pub use run::Compared as Numbers;
pub use section::section;

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Against independent codes",
    asked: "Whether codes that share nothing but the scene find the same numbers.",
    limits: "That codes agree is no measurement.",
};
