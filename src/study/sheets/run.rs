//! Reference values of a case, with their bars, its closed form, and what other codes found.

use serde::Serialize;

use crate::accuracy::reference::{self, Known};
use crate::accuracy::{Barred, Quantity, Subject, Told, bars};
use crate::case::{Case, library};
use crate::error::Error;
use crate::measure::order::richardson;
use crate::mesh::Resolution;
use crate::oracle;
use crate::oracle::Reading;
use crate::oracle::cross_code::PhysicalAnswer;
use crate::oracle::cross_code::independent::{Independent, Script};
use crate::scene::ContactPair;
use crate::solve::{Discretisation, Formulation, Run};
use crate::study::sheets::described;

/// Halvings of the case's own mesh.
const REFINEMENT: u32 = 1;

/// Cases that other codes solve too, by the names of the frozen scenes.
const SHARED: [(&str, &str); 4] = [
    ("cylinder", "cylinder, a/R = 0.05"),
    ("truncated-hertz", "truncated Hertz"),
    ("pin-rod", "pin-rod"),
    ("pin-plate", "pin in plate"),
];

/// What is on the sheet.
#[derive(Clone, Debug, Serialize)]
pub struct Numbers {
    /// Name on the command line.
    pub name: String,
    /// What it is.
    pub title: String,
    /// The scene in words and numbers, a paragraph or list each.
    pub scene: Vec<String>,
    /// Where scene and closed form come from.
    pub sources: Vec<String>,
    /// Degrees of freedom of the mesh of the reference values.
    pub dofs: usize,
    /// The values.
    pub values: Vec<Value>,
}

/// A reference value.
#[derive(Clone, Debug, Serialize)]
pub struct Value {
    /// The contact, or the body.
    pub of: String,
    /// What it is.
    pub quantity: String,
    /// Unit.
    pub unit: &'static str,
    /// Ours; NaN for a peak without a limit.
    pub value: f64,
    /// How far it may be off; NaN where that is not known.
    pub bound: f64,
    /// Whether it is that of cells of high order fitted to the contact, and not of 8-node cells.
    pub fitted: bool,
    /// What the closed form says.
    pub closed_form: Option<f64>,
    /// What other codes found.
    pub others: Vec<Other>,
}

/// What another code found.
#[derive(Clone, Debug, Serialize)]
pub struct Other {
    /// The script.
    pub script: Script,
    /// Its value on its finest mesh, in the unit of ours.
    pub value: f64,
    /// Its standard uncertainty.
    pub uncertainty: f64,
}

/// The sheet of a case.
pub fn solve(name: &str) -> Result<Numbers, Error> {
    let case = library::find(name, None)?;
    let resolution = Resolution { refinement: REFINEMENT, ..case.resolution };
    let discretisation = Discretisation::of(case.scene.clone(), resolution)?;
    let run = Run::of(&discretisation, &Formulation::verification())?.with_limits(&discretisation)?;
    let barred = bars(&discretisation, &run, &[])?.all;
    of(&case, &discretisation, &run, &barred)
}

impl Numbers {
    /// Takes a number of a contact that is known better; as the last of those of contacts where there was none of its name.
    fn takes(&mut self, pair: &ContactPair, known: &Known) {
        let (name, of, (unit, factor)) = (known.measured.name(), &pair.name, known.measured.unit(&pair.path));
        let Known { value, bound, .. } = known.times(factor);
        match self.values.iter_mut().find(|own| own.of == *of && own.quantity == name) {
            Some(own) if bound <= own.bound => (own.value, own.bound, own.fitted) = (value, bound, true),
            Some(_) => {}
            None if value.is_finite() => {
                let row = Value {
                    of: of.clone(),
                    quantity: name.into(),
                    unit,
                    value,
                    bound,
                    fitted: true,
                    closed_form: None,
                    others: vec![],
                };
                let place = self.values.iter().take_while(|own| own.of == *of).count();
                self.values.insert(place, row);
            }
            None => {}
        }
    }
}

/// The sheet of a case from a run, whose numbers have bars; or from cells fitted to the contact, where that can be and tells more.
pub fn of(case: &Case, discretisation: &Discretisation, run: &Run, barred: &[Barred]) -> Result<Numbers, Error> {
    let shared = SHARED.iter().find(|(known, _)| *known == case.name);
    let frozen = shared.map(|_| Independent::read()).transpose()?;
    let asked = shared.zip(frozen.as_ref()).and_then(|((_, scene), frozen)| frozen.scenes.get(*scene));
    let value = |one: &Barred| {
        let Told { of, quantity, unit, factor } = Told::of(&discretisation.scene, run, one);
        let closed_form = closed_form(case, &one.subject).map(|value| factor * value);
        let series = asked.iter().flat_map(|asked| &asked.series);
        let others = series.filter_map(|(script, series)| other(*script, series, &one.subject, factor)).collect();
        let unbounded = match one.subject {
            Subject::Contact(contact, Quantity::PeakPressure) => run.contacts[contact].unbounded.is_some(),
            _ => false,
        };
        let sound = run.solution.converged() && !unbounded;
        let value = if sound { factor * one.value } else { f64::NAN };
        Value { of, quantity, unit, value, bound: factor * one.bar.total(), fitted: false, closed_form, others }
    };
    let mut numbers = Numbers {
        name: case.name.clone(),
        title: case.title.clone(),
        scene: described::scene(&case.scene),
        sources: sources(case),
        dofs: run.dofs,
        values: barred.iter().map(value).collect(),
    };
    if let ([pair], Ok(answer)) = (&case.scene.contacts[..], reference::answer(&case.scene)) {
        answer.known.iter().for_each(|known| numbers.takes(pair, known));
    }
    Ok(numbers)
}

fn sources(case: &Case) -> Vec<String> {
    let of_oracle = case.oracle().into_iter().map(|oracle| {
        let source = oracle.source();
        format!("{}: {} ({})", oracle.name(), source.citation, source.note)
    });
    let own = std::iter::once(case.source.clone()).filter(|source| !source.is_empty());
    own.chain(of_oracle).collect()
}

/// What the closed form says of a number; none where there is no such form, or it is silent.
fn closed_form(case: &Case, subject: &Subject) -> Option<f64> {
    let Subject::Contact(0, quantity) = subject else { return None };
    let (asked, factor) = match quantity {
        Quantity::PeakPressure => (oracle::Quantity::PeakPressure, 1.0),
        Quantity::SecondMomentWidth => (oracle::Quantity::SecondMoment, 1.0),
        Quantity::End(0) if case.scene.contact().path.is_straight() => (oracle::Quantity::HalfWidth, 1.0),
        Quantity::End(0) => (oracle::Quantity::ContactAngle, 1.0),
        Quantity::Resultant => (oracle::Quantity::Resultant, case.scene.thickness),
        _ => return None,
    };
    match case.oracle()?.read(asked) {
        Reading::Value { value, .. } => Some(factor * value),
        Reading::Silent | Reading::Unavailable(_) => None,
    }
}

/// What a script found of a number; none where it does not tell it.
fn other(script: Script, series: &[PhysicalAnswer], subject: &Subject, factor: f64) -> Option<Other> {
    let of: fn(&PhysicalAnswer) -> f64 = match subject {
        Subject::Contact(0, Quantity::PeakPressure) => |answer| answer.peak,
        Subject::Contact(0, Quantity::SecondMomentWidth) => |answer| answer.half_width,
        _ => return None,
    };
    let [coarse, medium, fine] = series else { return None };
    let values = [coarse, medium, fine].map(|answer| factor * of(answer));
    Some(Other { script, value: values[2], uncertainty: richardson(values).uncertainty() })
}
