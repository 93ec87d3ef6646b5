//! What the closed form of a scene says, beside the run.

use schemars::JsonSchema;
use serde::Serialize;

use crate::case::{Case, Reference};
use crate::oracle::{Quantity, ReferenceKind};
use crate::solve::run::{Contact, Run};

use super::Number;

/// What an oracle says of a quantity, and how far the run is from it.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct OracleReading {
    /// Contact that it is of.
    pub contact: String,
    /// Name of the oracle.
    pub name: String,
    /// What kind of truth it is.
    pub kind: ReferenceKind,
    /// The quantity.
    pub quantity: Read,
    /// Reference value: mm, or rad on an arc; MPa; N.
    pub reference: Number,
    /// Relative error.
    pub error: Number,
}

/// A quantity that oracles are asked for.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Read {
    /// Half-width: half of what lies between begin and end.
    HalfWidth,
    /// Second-moment width.
    SecondMomentWidth,
    /// Largest pressure.
    PeakPressure,
    /// Pressure at s = 0.
    PressureAtZero,
    /// Force on the whole contact.
    Resultant,
}

impl Read {
    /// Its name in a sentence.
    pub fn name(self) -> &'static str {
        match self {
            Self::HalfWidth => "half-width",
            Self::SecondMomentWidth => "second-moment width",
            Self::PeakPressure => "peak pressure",
            Self::PressureAtZero => "pressure at 0",
            Self::Resultant => "resultant",
        }
    }
}

/// Readings of the oracle of each contact for the quantities it knows, each beside the same quantity of the run.
pub fn readings(problem: &Case, run: &Run) -> Vec<OracleReading> {
    (0..run.contacts.len()).flat_map(|contact| of_contact(problem, run, contact)).collect()
}

fn of_contact(problem: &Case, run: &Run, contact: usize) -> Vec<OracleReading> {
    let Some(oracle) = problem.oracle_of(contact) else { return Vec::new() };
    let read = |quantity| Reference::read(oracle.as_ref(), quantity).value;
    let resultant = read(Quantity::Resultant) * problem.scene.thickness;
    let (pair, Contact { measures, transmitted, .. }) = (&problem.scene.contacts[contact], &run.contacts[contact]);
    let edge = if pair.path.is_straight() { Quantity::HalfWidth } else { Quantity::ContactAngle };
    let all = [
        (Read::HalfWidth, measures.half_width(), read(edge)),
        (Read::SecondMomentWidth, measures.second_moment_width, read(Quantity::SecondMoment)),
        (Read::PeakPressure, measures.peak.pressure, read(Quantity::PeakPressure)),
        (Read::PressureAtZero, measures.pressure_at_origin, read(Quantity::Pressure { at: 0.0 })),
        (Read::Resultant, *transmitted, resultant),
    ];
    all.into_iter()
        .filter(|(_, _, reference)| reference.is_finite())
        .map(|(quantity, value, reference)| OracleReading {
            contact: pair.name.clone(),
            name: oracle.name().into(),
            kind: oracle.kind(),
            quantity,
            reference: reference.into(),
            error: ((value - reference).abs() / reference.abs()).into(),
        })
        .collect()
}
