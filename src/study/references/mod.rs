//! Reference answers to five digits where no closed form exists: cells of high order fitted to the contact, confirmed by other meshes and by
//! 8-node cells.
//!
//! * `plan` — which scenes, and which digits.
//! * `run` — their numbers on all meshes, and how far these are apart.
//! * `judge` — five digits, and 8-node cells within their own error bars.
//! * `section` — a row a number.

mod judge;
mod plan;
mod run;
mod section;

use crate::study::about::About;

pub use judge::judge;
pub use plan::plan;
pub use run::Numbers;
pub use section::{pictures, section};

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Reference answers",
    asked: "Which numbers of scenes without a closed form are known to five digits.",
    limits: "The bound is drawn from differences between meshes of this code; other codes confirm it to three or four digits only.",
};
