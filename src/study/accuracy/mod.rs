//! What an accuracy costs against meshes made by hand, and whether it is kept.
//!
//! * `plan` — which scenes, which accuracies, and the meshes made by hand.
//! * `subject` — the scenes, with their closed forms.
//! * `by_hand` — meshes made by hand.
//! * `run` — an answer beside them.
//! * `judge` — what it must keep.
//! * `section` — a row for each answer.

pub mod by_hand;
pub mod judge;
pub mod plan;
pub mod run;
mod section;
pub mod subject;

use crate::study::about::About;

pub use by_hand::Price;
pub use judge::judge;
pub use plan::{ASKED, plan};
pub use run::Numbers;
pub use section::{pictures, section};
pub use subject::{Subject, closed_form, error};

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "An accuracy asked for instead of a mesh",
    asked: "What an accuracy costs that is asked for, beside a mesh made by hand.",
    limits: "Peak pressure and second-moment width, which meshes made by hand are chosen by; `--accuracy` alone asks for the half-width instead.",
};
