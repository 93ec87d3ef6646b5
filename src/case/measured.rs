//! Quantities of a run.

use crate::case::check::Check;
use crate::case::definition::Case;
use crate::case::quantity::Quantity;
use crate::error::Error;
use crate::measure::{Quantity as Number, larger, profile};
use crate::solve::{Discretisation, Run};

/// Half-widths over which profiles are compared.
const COMPARED: f64 = 1.5;

impl Case {
    /// The value of what a check asks for; NaN, which no check passes, where the run did not converge. Where it is held against the
    /// verification run of the same mesh, that is given.
    pub(super) fn value(
        &self,
        check: &Check,
        discretisation: &Discretisation,
        run: &Run,
        verification: Option<&Run>,
    ) -> Result<f64, Error> {
        if !run.solution.converged() {
            return Ok(f64::NAN);
        }
        let (quantity, contact) = (&check.quantity, check.contact);
        let points = run.solution.points_of(contact);
        let pressure = |at: f64| self.reference_pressure(contact, at);
        Ok(match quantity {
            Quantity::Number { of, .. } => quantity.factor() * discretisation.number(run, contact, of)?,
            Quantity::Profile => {
                let half_width = self.reading(contact, &Number::HalfWidth).value;
                profile::relative_l2(points, pressure, COMPARED * half_width)
            }
            Quantity::EdgeMeans => {
                verification.map_or(f64::NAN, |other| profile::misplaced(&run.solution.edges, &other.solution.edges))
            }
            Quantity::Departure => {
                let departures = points.iter().map(|point| (point.pressure - pressure(point.position)).abs());
                departures.fold(0.0, larger) / self.scale(contact)
            }
            Quantity::Named { .. } => f64::NAN,
        })
    }

    /// The largest pressure of the oracle of a contact \[MPa\]; the scene's reference pressure where nothing presses.
    fn scale(&self, contact: usize) -> f64 {
        match self.reading(contact, &Number::PeakPressure).value {
            peak if peak > 0.0 => peak,
            _ => self.scene.reference.pressure,
        }
    }
}
