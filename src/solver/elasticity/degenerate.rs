//! Cells turned inside out.

use crate::error::{Error, Kind};
use crate::scene::Scene;

/// Error of a cell turned inside out or of no area.
pub(super) fn degenerate(scene: &Scene, body: usize, cell: usize, jacobian: f64) -> Error {
    let message = format!("cell {cell} has Jacobian determinant {jacobian:.3e} at a quadrature point");
    let remedy = "make the grading gentler or the elements smaller";
    Error { kind: Kind::DegenerateCell, ..Error::at(scene.place_of_body(body), message, remedy) }
}
