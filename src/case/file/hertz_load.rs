//! `{ hertz = { … } }`: the stresses of Hertz's half-plane on a boundary, so that a truncated body has no model error.

use std::f64::consts::PI;
use std::sync::Arc;

use serde::Deserialize;

use crate::case::file::source::Source;
use crate::case::file::units::Units;
use crate::case::file::values::{Name, Number, Pair};
use crate::error::Error;
use crate::oracle::analytic::hertz::Hertz;
use crate::scene::StressField;

/// `{ at = "far", peak-pressure = p0, half-width = a }`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct HertzLoadTable {
    /// Boundary.
    pub at: Name,
    peak_pressure: Number,
    half_width: Number,
    /// Middle of the contact; [0, 0] where it is left out.
    centre: Option<Pair>,
}

impl HertzLoadTable {
    /// The stresses under `p = p₀ √(1 − (x/a)²)` on a half-plane above or below the contact \[MPa\].
    pub fn field(&self, source: Source, units: &Units) -> Result<StressField, Error> {
        let peak = units.stress * source.positive("peak-pressure", &self.peak_pressure)?;
        let a = units.length * source.positive("half-width", &self.half_width)?;
        let centre = self.centre.as_ref().map_or(Ok([0.0; 2]), |centre| source.pair("centre", centre))?;
        let [x0, y0] = centre.map(|x| units.length * x);
        // Stresses depend on P and a alone: a² = 4PR/πE* holds with E* = 1.
        let load = 0.5 * PI * a * peak;
        let hertz = Hertz { load, radius: PI * a * a / (4.0 * load), modulus: 1.0 };
        Ok(StressField(Arc::new(move |[x, y]| {
            let [along, across, shear] = hertz.stress(x - x0, (y - y0).abs());
            [along, across, shear * (y - y0).signum()]
        })))
    }
}
