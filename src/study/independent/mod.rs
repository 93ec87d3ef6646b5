//! The same physical problem in other codes that share nothing with one another but the scene: mesh, forms of the contact, iteration and
//! measures are each script's own. A folder, since the scenes, what is asked and what is held are three things.
//!
//! * `benchmark` — the scenes, as numbers.
//! * `run` — one trial a scene: what every script found, beside ours.
//! * `found` — the numbers of a series of meshes, with their uncertainty.
//! * `judge` — differences within their uncertainty, and within what was found.
//! * `section` — the numbers, the profiles.

pub mod benchmark;
pub mod found;
pub mod judge;
pub mod run;
mod section;

use crate::study::about::About;

pub use judge::judge;
pub use run::{Compared as Numbers, against, plan};
pub use section::{pictures, section};

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Against independent codes",
    asked: "Whether codes that share nothing but the scene find the same numbers.",
    limits: "That codes agree is no measurement.",
};
