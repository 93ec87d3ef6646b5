//! The dimensionless family of the pin–rod, so that any published figure can be placed the day it appears.
//!
//! * `plan` — one trial for the curves, one for the sensitivities.
//! * `run` — pressure and angle by three dimensionless numbers.
//! * `judge` — every run ends as it may, three numbers place a scene, slopes do not depend on their step.
//! * `section`, `picture` — the tables, and the curves over the clearance.

mod judge;
mod picture;
mod plan;
pub mod run;
mod section;

use crate::study::about::About;

pub use judge::judge;
pub use picture::pictures;
pub use plan::plan;
pub use run::{Curves, Ended, Line, Numbers, Place, Placed, Sensitivities, Slope};
pub use section::section;

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "The dimensionless family of the pin–rod",
    asked: "Where a published figure of a pin in an eye belongs, whatever its dimensions.",
    limits: "Eyes of the shape drawn here; no friction, no plate of another outline.",
};
