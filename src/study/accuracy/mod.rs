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

pub use judge::judge;
pub use plan::{ASKED, plan};
pub use by_hand::Price;
pub use run::Numbers;
pub use section::{pictures, section};
pub use subject::{Subject, closed_form, error};
