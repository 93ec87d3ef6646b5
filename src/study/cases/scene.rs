//! The scenes with their loads and supports (the paper's Figs 8 and 12).

use crate::case::library::{Cylinder, PinRod};
use crate::error::Error;
use crate::figure::{Drawing, schematic};

/// The cylinder on its rigid plane.
pub fn cylinder() -> Result<Drawing, Error> {
    let numbers = Cylinder::default();
    let (a, load) = (numbers.half_width(), numbers.load() / (2.0 * numbers.radius));
    let shown = [("R", numbers.radius), ("a", a), ("L", numbers.stretch * a), ("q", load.round())];
    schematic("cylinder", include_str!("cylinder.svg"), &shown)
}

/// The pin in the connecting-rod eye.
pub fn pin_rod() -> Result<Drawing, Error> {
    let numbers = PinRod::default();
    let shown = [
        ("R", numbers.pin_radius),
        ("c", numbers.clearance),
        ("R + c", numbers.pin_radius + numbers.clearance),
        ("outer", numbers.eye_outer_radius),
        ("half width", 0.5 * numbers.shank_width),
        ("height", numbers.shank_end),
        ("F/2", 0.5 * numbers.force),
        ("candidates", numbers.stretch.to_degrees()),
    ];
    schematic("pin-rod", include_str!("pin-rod.svg"), &shown)
}
