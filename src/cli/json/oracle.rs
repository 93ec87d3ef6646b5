//! What the closed form of a scene says, beside the run.

use schemars::JsonSchema;
use serde::Serialize;

use crate::case::{self, Case};
use crate::measure::{Quantity, relative_error};
use crate::oracle::ReferenceKind;
use crate::solve::run::{Contact, Run};

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
    #[schemars(extend("enum" = ASKED.map(|(_, [quantity, _])| quantity)))]
    pub quantity: &'static str,
    /// Reference value: mm, or rad on an arc; MPa; N.
    pub reference: f64,
    /// Relative error.
    pub error: f64,
    /// Index of the contact, and the quantity.
    #[serde(skip)]
    pub of: (usize, Quantity),
    /// Name of the quantity in a sentence.
    #[serde(skip)]
    pub called: String,
}

/// The numbers that oracles are asked for, with their names in JSON and in a sentence.
const ASKED: [(Quantity, [&str; 2]); 5] = [
    (Quantity::HalfWidth, ["half_width", "half-width"]),
    (Quantity::SecondMomentWidth, ["second_moment_width", "second-moment width"]),
    (Quantity::PeakPressure, ["peak_pressure", "peak pressure"]),
    (Quantity::Pressure { at: 0.0 }, ["pressure_at_zero", "pressure at 0"]),
    (Quantity::Resultant, ["resultant", "resultant"]),
];

/// Readings of the oracle of each contact for the quantities it knows, each beside the same quantity of the run.
pub fn readings(problem: &Case, run: &Run) -> Vec<OracleReading> {
    (0..run.contacts.len()).flat_map(|contact| of_contact(problem, run, contact)).collect()
}

fn of_contact(problem: &Case, run: &Run, contact: usize) -> Vec<OracleReading> {
    let (pair, Contact { measures, transmitted, .. }) = (&problem.scene.contacts[contact], &run.contacts[contact]);
    let all = ASKED.map(|(of, [quantity, name])| {
        let value = match of {
            Quantity::Resultant => *transmitted,
            Quantity::Pressure { .. } => measures.pressure_at_origin,
            _ => of.of(measures),
        };
        let reference = problem.reading(contact, &of);
        let is_width = matches!(of, Quantity::HalfWidth | Quantity::SecondMomentWidth);
        let on_scene = case::Quantity::on(&problem.scene, contact, of.clone());
        let called = if is_width { on_scene.name().into() } else { name.into() };
        OracleReading {
            contact: pair.name.clone(),
            name: reference.name,
            kind: reference.kind,
            quantity,
            reference: reference.value,
            error: relative_error(value, reference.value),
            of: (contact, of),
            called,
        }
    });
    all.into_iter().filter(|reading| reading.reference.is_finite()).collect()
}
