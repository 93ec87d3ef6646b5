//! Refinement: observed orders pair by pair, the model error of the cylinder, the pin–rod's own uncertainty.
//!
//! * `plan` — one trial per order of the cells, one for the model error, one for the pin–rod.
//! * `run` — errors, ratios and values on each mesh.
//! * `judge` — orders, and what the series say of their own limits.
//! * `section`, `picture` — tables of the meshes, and the errors over the mesh size.

mod judge;
mod picture;
mod plan;
mod run;
mod section;

use crate::study::about::About;

pub use judge::{judge, one_limit};
pub use picture::pictures;
pub use plan::plan;
pub use run::{Departure, Errors, ModelError, Numbers, Orders, PinLevel, PinRod, PinSeries, Ratio};
pub use section::section;

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Refinement",
    asked: "How fast errors fall on finer meshes, and how far the cylinder of the paper is from the half-plane of Hertz.",
    limits: "Orders are read on smooth contacts; where a contact has corners they are lower.",
};
