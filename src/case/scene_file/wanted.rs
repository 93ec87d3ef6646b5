//! The checks of a scene file.

use serde::Deserialize;

use crate::case::check::{Check, Reference};
use crate::case::run::Run;
use crate::error::Error;
use crate::measure::profile;
use crate::oracle::ReferenceKind;
use crate::scene::file::Source;
use crate::scene::file::tables::{Name, Number};
use crate::scene::file::units::Units;

/// `[[check]]`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct CheckTable {
    quantity: Name,
    at: Option<Number>,
    value: Number,
    tolerance: Number,
    kind: Name,
    source: String,
    because: String,
}

/// What a check asks.
#[derive(Clone, Debug)]
pub(super) struct Wanted {
    quantity: Quantity,
    /// Contact coordinate \[mm, or rad\].
    at: f64,
    value: f64,
    tolerance: f64,
    kind: ReferenceKind,
    source: String,
    because: String,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Quantity {
    PeakPressure,
    HalfWidth,
    Resultant,
    Pressure,
}

const QUANTITIES: [(&str, Quantity); 4] = [
    ("peak-pressure", Quantity::PeakPressure),
    ("half-width", Quantity::HalfWidth),
    ("resultant", Quantity::Resultant),
    ("pressure", Quantity::Pressure),
];
const KINDS: [(&str, ReferenceKind); 4] = [
    ("analytic", ReferenceKind::Analytic),
    ("cross-code", ReferenceKind::CrossCode),
    ("measured", ReferenceKind::Measured),
    ("self-consistency", ReferenceKind::SelfConsistency),
];
impl Wanted {
    pub(super) fn check(&self, run: &Run) -> Check {
        let points = &run.solution.points;
        let (name, value) = match self.quantity {
            Quantity::PeakPressure => ("peak pressure [MPa]".into(), run.measures.peak.pressure),
            Quantity::HalfWidth => ("half-width [mm or rad]".into(), run.measures.half_width),
            Quantity::Resultant => ("resultant [N]".into(), run.transmitted),
            Quantity::Pressure => {
                (format!("pressure at s = {:.6} [MPa]", self.at), profile::interpolate(points, self.at))
            }
        };
        // A run that broke off has no value to be judged.
        let value = if run.solution.converged() { value } else { f64::NAN };
        let reference = Reference { name: self.source.clone(), kind: self.kind, value: self.value };
        let requirement = format!("The file's own check: {}", self.source);
        Check::relative(requirement, name, value, reference, self.tolerance, self.because.clone())
    }
}

impl CheckTable {
    /// `along` turns a contact coordinate of the file into mm or rad.
    pub(super) fn wanted(&self, source: Source, units: &Units, along: f64) -> Result<Wanted, Error> {
        let quantity = source.choice("quantity", &self.quantity, &QUANTITIES)?;
        let unit = match quantity {
            Quantity::PeakPressure | Quantity::Pressure => units.stress,
            Quantity::Resultant => units.force,
            Quantity::HalfWidth => along,
        };
        let at = match (&self.at, quantity) {
            (Some(at), Quantity::Pressure) => {
                along * source.number("at", at, "a coordinate from 0 on", |s| s >= 0.0)?
            }
            (None, Quantity::Pressure) => {
                return Err(source.refused(self.quantity.span(), "a pressure without a place", "add `at`"));
            }
            (Some(at), _) => {
                return Err(source.refused(at.span(), "only `pressure` is taken at a place", "leave `at` out"));
            }
            (None, _) => f64::NAN,
        };
        let value = source.number("value", &self.value, "a finite number that is not 0", |x| x.abs() > 0.0)?;
        Ok(Wanted {
            quantity,
            at,
            value: unit * value,
            tolerance: source.positive("tolerance", &self.tolerance)?,
            kind: source.choice("kind of reference", &self.kind, &KINDS)?,
            source: self.source.clone(),
            because: self.because.clone(),
        })
    }
}
