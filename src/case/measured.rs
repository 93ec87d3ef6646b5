//! Quantities of a run.

use crate::case::definition::Case;
use crate::case::quantity::Quantity;
use crate::error::Error;
use crate::measure::{Quantity as Number, larger, profile};
use crate::solve::{Discretisation, Run};

/// Half-widths over which profiles are compared.
const COMPARED: f64 = 1.5;

/// A case solved: the mesh, the run, and the verification run of the same mesh where a check asks for it.
pub(super) struct Solved<'a> {
    pub(super) case: &'a Case,
    pub(super) discretisation: &'a Discretisation,
    pub(super) run: &'a Run,
    pub(super) verification: Option<&'a Run>,
}

impl Solved<'_> {
    /// The value of a quantity in a contact; NaN, which no check passes, where the run did not converge.
    pub(super) fn value(&self, quantity: &Quantity, contact: usize) -> Result<f64, Error> {
        if !self.run.solution.converged() {
            return Ok(f64::NAN);
        }
        let points = self.run.solution.points_of(contact);
        let pressure = |at: f64| self.case.reference_pressure(contact, at);
        Ok(match quantity {
            Quantity::Number { of, .. } => quantity.factor() * self.discretisation.number(self.run, contact, of)?,
            Quantity::Profile => {
                let half_width = self.case.reading(contact, &Number::HalfWidth).value;
                profile::relative_l2(points, pressure, COMPARED * half_width)
            }
            Quantity::EdgeMeans => self
                .verification
                .map_or(f64::NAN, |other| profile::misplaced(&self.run.solution.edges, &other.solution.edges)),
            Quantity::Departure => {
                let departures = points.iter().map(|point| (point.pressure - pressure(point.position)).abs());
                departures.fold(0.0, larger) / self.scale(contact)
            }
            Quantity::Dofs => self.run.dofs as f64,
            Quantity::Named { .. } => f64::NAN,
        })
    }

    /// The largest pressure of the oracle of a contact \[MPa\]; the scene's reference pressure where nothing presses.
    fn scale(&self, contact: usize) -> f64 {
        match self.case.reading(contact, &Number::PeakPressure).value {
            peak if peak > 0.0 => peak,
            _ => self.case.scene.reference.pressure,
        }
    }
}
