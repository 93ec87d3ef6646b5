//! Another load or clearance on a condensation at hand: pressures only, at the price of a few dense steps.

use crate::contact::ContactPoint;
use crate::error::Error;

/// What has changed since the condensation; the bodies, their supports and the places of their loads have not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Change {
    /// All loads and prescribed displacements times this.
    pub load: f64,
    /// Added to the gap everywhere \[mm\].
    pub clearance: f64,
}

impl Change {
    /// Nothing has changed.
    pub const NONE: Self = Self { load: 1.0, clearance: 0.0 };

    /// Contact points with their gaps after the change.
    pub(super) fn of_points(self, mut points: Vec<ContactPoint>) -> Vec<ContactPoint> {
        points.iter_mut().for_each(|point| point.gap += self.clearance);
        points
    }

    /// A condensed load after the change \[N\].
    pub(super) fn of_load(self, load: &[f64]) -> Vec<f64> {
        load.iter().map(|f| f * self.load).collect()
    }

    /// Refuses numbers that are none.
    pub(super) fn validate(self, scene: &str) -> Result<(), Error> {
        for (key, value) in [("load factor", self.load), ("clearance", self.clearance)] {
            if !value.is_finite() {
                return Err(Error::value(scene, key, value, "a finite number is needed", "give a number"));
            }
        }
        Ok(())
    }
}
