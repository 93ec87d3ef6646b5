//! Digitised curves of pins against the same pins of ours; not run while the figures are not at hand.
//!
//! * `plan` — one trial a source.
//! * `run` — the worst deviation of each curve.
//! * `ours` — our own curve of the source's scene.
//! * `judge` — within the combined uncertainty.
//! * `section` — the title; its checks say the rest.

mod judge;
mod ours;
mod plan;
pub mod run;
mod section;

use crate::study::about::About;

pub use judge::judge;
pub use plan::{GAERTNER, plan};
pub use run::{Curve, Numbers};
pub use section::{pictures, section};

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Against digitised curves",
    asked: "Whether stresses and loads along real pins are those that were measured.",
    limits: "Nothing is compared until somebody brings the figures.",
};
