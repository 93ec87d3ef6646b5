//! The disc between two plates against a photograph of its isochromatics: measured, shape only, uncalibrated.
//!
//! * `plan` — one trial.
//! * `field` — the principal stress difference at any point of our disc.
//! * `fit` — five constants from the fringes at the bottom.
//! * `run` — both ends in fringe orders, by width and by mesh.
//! * `judge` — within what is asked at both ends, and sharp enough to fail.
//! * `section`, `picture` — what it shows, fringes measured and computed.

mod field;
mod fit;
mod judge;
mod picture;
mod plan;
pub mod run;
mod section;

use crate::study::about::About;

pub use judge::judge;
pub use picture::pictures;
pub use plan::plan;
pub use run::Numbers;
pub use section::section;

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Against a photograph",
    asked: "Whether the stress field between two plates is that of a photographed disc.",
    limits: "Uncalibrated: shapes only. The photograph tells neither load, nor material, nor pressure.",
};
