//! Stress on the deformed bodies, and the path of the iterations.
//!
//! * `plan` — a trial per iteration on two bars, a trial per scene.
//! * `run` — the runs, and the recovered fields.
//! * `judge` — a run is within the bound of its error; recovered stresses carry the load.
//! * `section`, `picture` — the charts.

mod judge;
mod picture;
mod plan;
pub mod run;
mod section;

use crate::study::about::About;

pub use judge::judge;
pub use picture::pictures;
pub use plan::plan;
pub use run::{Arc, Field, Numbers, Resultant, Shown, Where};
pub use section::section;

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Fields and iteration paths",
    asked: "What the deformed bodies look like, and which way the iterations go.",
    limits: "Pictures; the resultants of the stresses are checked, not every stress.",
};
