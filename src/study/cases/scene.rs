//! The scenes with their loads and supports (the paper's Figs 8 and 12).

use crate::case::library::{Cylinder, PinRod};
use crate::error::Error;
use crate::figure::{CylinderScene, Drawing, PinRodScene};

/// The cylinder on its rigid plane.
pub fn cylinder() -> Result<Drawing, Error> {
    let numbers = Cylinder::default();
    CylinderScene {
        radius: numbers.radius,
        half_width: numbers.half_width(),
        candidates: numbers.stretch * numbers.half_width(),
        load: (numbers.load() / (2.0 * numbers.radius)).round(),
        notes: vec![],
    }
    .drawing()
}

/// The pin in the connecting-rod eye.
pub fn pin_rod() -> Result<Drawing, Error> {
    let numbers = PinRod::default();
    PinRodScene {
        pin_radius: numbers.pin_radius,
        clearance: numbers.clearance,
        eye_radius: numbers.eye_outer_radius,
        shank_width: numbers.shank_width,
        shank_end: numbers.shank_end,
        force: numbers.force,
        candidates: numbers.stretch.to_degrees(),
        notes: vec![],
    }
    .drawing()
}
