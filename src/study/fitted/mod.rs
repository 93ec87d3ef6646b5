//! Cells of high order fitted to the end of the contact: how many digits of peak and second-moment width they give, for how many degrees
//! of freedom.
//!
//! * `plan` — which meshes, and what is asked of them.
//! * `run` — the worst error under all loads, by mesh.
//! * `scenes` — other scenes: pins, two bodies, contacts off the middle.
//! * `judge` — so many digits for so many degrees of freedom.
//! * `section` — a row a mesh.
//! * `picture` — error over degrees of freedom, beside 8-node cells.

mod judge;
mod picture;
mod plan;
mod run;
mod scenes;
mod section;

use crate::study::about::About;

pub use judge::judge;
pub use picture::pictures;
pub use plan::{ASKED, Asked, plan};
pub use run::{Cells, LOADS, Mesh, Numbers, under};
pub use scenes::Elsewhere;
pub use section::section;

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Meshes fitted to the contact",
    asked: "How many degrees of freedom an accuracy costs where cells of high order end with the contact.",
    limits: "Order and layers of the other scenes are chosen by hand, knowing what they give; `--accuracy` has only its error bars.",
};
