//! What several scenes of the library share.

use crate::case::{Against, Check};
use crate::measure::Quantity;
use crate::scene::{
    Body, Circle, Component, ContactPair, Face, Grading, Load, Material, Path, Place, Profile, ReferenceValues, Shape,
    Support,
};

/// Length of arc that holds `N` elements of the candidate stretch on pins \[mm\].
pub const ARC_UNIT: f64 = 10.0;

/// A component prescribed on a named boundary \[mm\].
pub fn fixed(boundary: &'static str, component: Component, value: f64) -> Support {
    Support { at: Place::Boundary(boundary.into()), component, value }
}

/// Symmetry about x = 0 on a named boundary.
pub(super) fn symmetry(boundary: &'static str) -> Support {
    fixed(boundary, Component::X, 0.0)
}

/// A body whose elements on the contact are as large as those of the other one.
pub fn body(name: &str, shape: Shape, material: Material, supports: Vec<Support>, loads: Vec<Load>) -> Body {
    Body { name: name.into(), shape, material, density: 1.0, supports, loads }
}

/// A rectangle with symmetry about x = 0.
pub(super) fn block(
    name: &str,
    x: [f64; 2],
    y: [f64; 2],
    contact: Face,
    material: Material,
    mut supports: Vec<Support>,
    loads: Vec<Load>,
) -> Body {
    supports.push(symmetry("left"));
    body(name, Shape::Rectangle { x, y, contact }, material, supports, loads)
}

/// Prescribed vertical displacement of the side opposite to the contact.
pub(super) fn moved(value: f64) -> Support {
    fixed("far", Component::Y, value)
}

/// Contact of flat sides across a uniform gap.
pub(super) fn flat_contact(second: Option<usize>, gap: f64, stretch: f64) -> ContactPair {
    ContactPair::new(second, Path::HORIZONTAL, Profile::Uniform(gap), stretch)
}

/// Equal elements throughout.
pub(super) fn even(unit: f64) -> Grading {
    Grading { unit, along: 1.0, depth: 1.0, first: 1.0, coarsest: 1.0, end: 1.0 }
}

/// Contact of a pin in a hole, over an angle from the load line.
pub(super) fn hole_contact(radius: f64, clearance: f64, stretch: f64) -> ContactPair {
    let path = Path::Arc(Circle { centre: [0.0, 0.0], radius });
    ContactPair::new(Some(1), path, Profile::Hole { radius, clearance }, stretch)
}

/// `ℓ = R`, `p_ref = F/tR`, `g_ref = c`, or `p_ref ℓ/E*` where there is no clearance (plane stress).
pub(super) fn pin_reference(load: f64, radius: f64, clearance: f64, materials: [Material; 2]) -> ReferenceValues {
    let pressure = load / radius;
    let compliance: f64 = materials.iter().map(|m| 1.0 / m.young).sum();
    let gap = if clearance > 0.0 { clearance } else { pressure * radius * compliance };
    ReferenceValues { length: radius, pressure, gap }
}

/// Why all nine are accepted within 1 %.
pub(super) const ENGINEERING: &str = "engineering tolerance of the paper's comparison; iteration error to 1e-3";

/// Peak and second-moment width against Hertz.
pub(super) fn hertz_checks(tolerance: [f64; 2], because: [&'static str; 2]) -> Vec<Check> {
    vec![
        Check::near(Quantity::PeakPressure, Against::Oracle, tolerance[0], because[0]),
        Check::near(Quantity::SecondMomentWidth, Against::Oracle, tolerance[1], because[1]),
    ]
}
