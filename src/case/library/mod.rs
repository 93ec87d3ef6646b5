//! The cases of the suite, one file each: its numbers, scene, closed form, source and checks.
//!
//! * [`cylinder`], [`pin_rod`] — the paper's two examples.
//! * [`truncated_hertz`], [`pin_plate`] — the same contacts with a closed form and no model error.
//! * [`sphere`], [`indented`] — bodies of revolution: Hertz's sphere, with and without model error, and Sneddon's cone.
//! * [`patch`], [`bars`], [`own_weight`], [`press_fit`], [`flat_punch`] — small scenes with exact solutions.
//! * [`mod@names`] — what `solve` knows them by.
//! * `shared` — supports, references and checks that several have.

pub mod bars;
pub mod cylinder;
pub mod flat_punch;
pub mod indented;
pub mod names;
pub mod own_weight;
pub mod patch;
pub mod pin_plate;
pub mod pin_rod;
pub mod press_fit;
mod shared;
pub mod sphere;
pub mod truncated_hertz;

use crate::case::definition::Case;

pub use bars::Bars;
pub use cylinder::{Cylinder, CylinderModel};
pub use flat_punch::FlatPunch;
pub use indented::Indented;
pub use names::{NAMES, find};
pub use patch::Patch;
pub use pin_plate::PinPlate;
pub use pin_rod::PinRod;
pub use press_fit::PressFit;
pub use shared::{ARC_UNIT, body, fixed};
pub use truncated_hertz::TruncatedHertz;

/// All cases of the suite, in the order of the page.
pub fn all() -> Vec<Case> {
    [
        cylinder::cases(),
        truncated_hertz::cases(),
        pin_rod::cases(),
        pin_plate::cases(),
        patch::cases(),
        bars::cases(),
        own_weight::cases(),
        press_fit::cases(),
        flat_punch::cases(),
        sphere::cases(),
        indented::cases(),
    ]
    .concat()
}
