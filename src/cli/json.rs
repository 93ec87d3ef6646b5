//! The result of a solve as JSON, which names its units: millimetre, newton, megapascal, radian and second.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::case::{Case, Judged, Reference, Verdict};
use crate::cli::found::Found;
use crate::cli::reactions::ReactionReading;
use crate::cli::{accuracy, bars};
use crate::oracle::Quantity;
use crate::solution::{IterationError, PointState};
use crate::solve::Run;
use crate::solve::run::Errors;

#[derive(Serialize)]
struct Document<'a> {
    case: &'a str,
    units: Units,
    element: &'a str,
    algorithm: &'a str,
    rule: &'a str,
    /// None where changes are not bounded.
    bound: Option<f64>,
    spring: &'a str,
    criterion: &'a str,
    acceleration: &'a str,
    start: &'a str,
    stiffness: f64,
    order: u8,
    resolution: usize,
    #[serde(rename = "freedoms")]
    dofs: usize,
    retained: usize,
    outcome: String,
    #[serde(rename = "steps")]
    iterations: usize,
    factorisations: usize,
    back_substitutions: usize,
    rejected: usize,
    #[serde(rename = "coarser_steps")]
    coarser_iterations: usize,
    seconds: BTreeMap<&'static str, f64>,
    iteration_error: IterationParts,
    contacts: Vec<Contact<'a>>,
    reactions: &'a [ReactionReading],
    #[serde(skip_serializing_if = "Vec::is_empty")]
    error_bars: Vec<bars::Document>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    checks: Vec<JudgedCheck<'a>>,
    oracles: Vec<OracleReading>,
    #[serde(skip_serializing_if = "Option::is_none")]
    accuracy: Option<accuracy::Document>,
}

/// Units of all numbers; errors and the spring stiffness κ are pure.
#[derive(Serialize)]
struct Units {
    length: &'static str,
    force: &'static str,
    stress: &'static str,
    angle: &'static str,
    time: &'static str,
}

const UNITS: Units = Units { length: "mm", force: "N", stress: "MPa", angle: "rad", time: "s" };

/// What one contact came to; half-widths, centre and positions are lengths, or angles on an arc.
#[derive(Serialize)]
struct Contact<'a> {
    name: &'a str,
    coordinate: &'static str,
    half_width: f64,
    half_width_nodes: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    centre: Option<f64>,
    active_points: usize,
    /// Where every closed stretch begins and ends.
    closed: Vec<[f64; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    note: Option<String>,
    /// Null where it has no limit.
    peak_pressure: Option<f64>,
    peak_position: f64,
    /// Growth of a peak without a limit at the last halving of the elements.
    #[serde(skip_serializing_if = "Option::is_none")]
    peak_growth: Option<f64>,
    pressure_at_zero: f64,
    largest_point_pressure: f64,
    largest_point_position: f64,
    resultant: f64,
    /// Against the solution of the same discrete problem; null where that was not found.
    iteration_error: Option<ContactError>,
    /// What the springs of a penalty change of the discrete solution.
    #[serde(skip_serializing_if = "Option::is_none")]
    penalty_error: Option<ContactError>,
    profile: Vec<Point>,
}

/// What the iteration was judged by, at the worst contact.
#[derive(Serialize)]
struct IterationParts {
    peak: f64,
    force: f64,
    width: f64,
    approach: f64,
}

/// Relative errors, with sign.
#[derive(Serialize)]
struct ContactError {
    peak_pressure: f64,
    half_width: f64,
}

impl From<Errors> for ContactError {
    fn from(errors: Errors) -> Self {
        Self { peak_pressure: errors.peak, half_width: errors.half_width }
    }
}

#[derive(Serialize)]
struct Point {
    position: f64,
    pressure: f64,
    gap: f64,
    area: f64,
}

/// One of the file's own checks.
#[derive(Serialize)]
struct JudgedCheck<'a> {
    quantity: String,
    value: f64,
    /// How far the value may be from the truth of the scene; null where it is not known.
    #[serde(skip_serializing_if = "Option::is_none")]
    bar: Option<f64>,
    reference: f64,
    source: &'a str,
    error: f64,
    tolerance: f64,
    passed: bool,
}

impl<'a> JudgedCheck<'a> {
    fn of(check: &'a Judged) -> Self {
        Self {
            quantity: check.check.quantity.to_string(),
            value: check.value,
            bar: check.bar,
            reference: check.reference.value,
            source: &check.reference.name,
            error: check.error,
            tolerance: check.check.tolerance,
            passed: check.verdict == Verdict::Pass,
        }
    }
}

/// What an oracle says of a quantity, and how far the run is from it.
#[derive(Clone, Debug, Serialize)]
pub struct OracleReading {
    /// Name of the oracle.
    pub name: String,
    /// What kind of truth it is.
    pub kind: String,
    /// The quantity.
    pub quantity: String,
    /// Reference value.
    pub reference: f64,
    /// Relative error.
    pub error: f64,
}

/// The document of a run.
pub fn text(found: &Found, accuracy: Option<accuracy::Document>) -> String {
    let Found { problem, resolution, run, reactions, checks, .. } = found;
    let solution = &run.solution;
    let IterationError { peak, force, width, approach } = solution.error();
    let contacts = (0..run.contacts.len()).map(|contact| of_contact(problem, run, contact)).collect();
    let document = Document {
        case: &problem.name,
        units: UNITS,
        element: run.formulation.element.name(),
        algorithm: run.formulation.algorithm.name(),
        rule: run.formulation.rule.name(),
        bound: Some(run.formulation.leeway.bound).filter(|bound| bound.is_finite()),
        spring: run.formulation.leeway.spring.name(),
        criterion: run.formulation.settings.criterion.name(),
        acceleration: run.formulation.acceleration.name(),
        start: run.formulation.start.name(),
        stiffness: run.formulation.stiffness,
        order: resolution.order.number(),
        resolution: resolution.elements,
        dofs: run.dofs,
        retained: run.retained,
        outcome: solution.outcome.to_string(),
        iterations: solution.work.iterations,
        factorisations: solution.work.factorisations,
        back_substitutions: solution.work.back_substitutions,
        rejected: solution.work.rejected,
        coarser_iterations: solution.coarser.iterations,
        seconds: run.seconds.iter().map(|&(stage, seconds)| (stage.name(), seconds)).collect(),
        iteration_error: IterationParts { peak, force, width, approach },
        contacts,
        reactions,
        error_bars: bars::Document::all(found),
        checks: checks.iter().map(JudgedCheck::of).collect(),
        oracles: oracles(problem, run),
        accuracy,
    };
    serde_json::to_string_pretty(&document).expect("numbers, strings and lists can be written as JSON")
}

fn of_contact<'a>(problem: &'a Case, run: &Run, contact: usize) -> Contact<'a> {
    let (pair, found) = (&problem.scene.contacts[contact], &run.contacts[contact]);
    let point = |p: &PointState| Point { position: p.position, pressure: p.pressure, gap: p.gap, area: p.weight };
    let measures = &found.measures;
    Contact {
        name: &pair.name,
        coordinate: if pair.path.is_straight() { "length" } else { "angle" },
        half_width: measures.half_width,
        half_width_nodes: measures.half_width_nodes,
        centre: pair.path.has_both_sides().then_some(measures.centre),
        active_points: measures.active,
        closed: measures.stretches.iter().map(|stretch| [stretch.begin, stretch.end]).collect(),
        note: run.note(contact),
        peak_pressure: found.unbounded.is_none().then_some(measures.peak.pressure),
        peak_growth: found.unbounded.map(|unbounded| unbounded.growth),
        peak_position: measures.peak.position,
        pressure_at_zero: measures.pressure_at_origin,
        largest_point_pressure: measures.largest.pressure,
        largest_point_position: measures.largest.position,
        resultant: found.transmitted,
        iteration_error: found.iteration.map(ContactError::from),
        penalty_error: found.penalty.map(ContactError::from),
        profile: run.solution.points_of(contact).iter().map(point).collect(),
    }
}

/// Readings of the problem's oracle for the quantities it knows, each beside the same quantity of the run.
pub fn oracles(problem: &Case, run: &Run) -> Vec<OracleReading> {
    let Some(oracle) = &problem.oracle else { return Vec::new() };
    let read = |quantity| Reference::read(oracle.as_ref(), quantity).value;
    let resultant = read(Quantity::Resultant) * problem.scene.thickness;
    let measures = run.measures();
    let edge = if problem.scene.contact().path.is_straight() { Quantity::HalfWidth } else { Quantity::ContactAngle };
    let all = [
        ("half_width", measures.half_width, read(Quantity::SecondMoment)),
        ("edge", 0.5 * (measures.edge() - measures.begin()), read(edge)),
        ("peak_pressure", measures.peak.pressure, read(Quantity::PeakPressure)),
        ("pressure_at_zero", measures.pressure_at_origin, read(Quantity::Pressure { at: 0.0 })),
        ("resultant", run.transmitted(), resultant),
    ];
    all.into_iter()
        .filter(|(_, _, reference)| reference.is_finite())
        .map(|(quantity, value, reference)| OracleReading {
            name: oracle.name().into(),
            kind: oracle.kind().to_string(),
            quantity: quantity.into(),
            reference,
            error: (value - reference).abs() / reference.abs(),
        })
        .collect()
}
