//! The result of a solve as JSON, which names its units: millimetre, newton, megapascal, radian and second.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::case::{Problem, Reference, Run};
use crate::cli::accuracy;
use crate::cli::reactions::ReactionReading;
use crate::measure::profile;
use crate::mesh::Resolution;
use crate::oracle::Quantity;
use crate::scene::Path;
use crate::solution::PointState;

#[derive(Serialize)]
struct Document<'a> {
    case: &'a str,
    units: Units,
    element: &'a str,
    algorithm: &'a str,
    rule: &'a str,
    acceleration: &'a str,
    start: &'a str,
    stiffness: f64,
    order: u8,
    resolution: usize,
    freedoms: usize,
    retained: usize,
    outcome: String,
    steps: usize,
    factorisations: usize,
    back_substitutions: usize,
    rejected: usize,
    coarser_steps: usize,
    seconds: BTreeMap<&'static str, f64>,
    residuals: Residuals,
    contacts: Vec<Contact<'a>>,
    reactions: &'a [ReactionReading],
    oracles: Vec<OracleReading>,
    #[serde(skip_serializing_if = "Option::is_none")]
    accuracy: Option<accuracy::Document>,
}

/// Units of all numbers; residuals, errors and the spring stiffness κ are pure.
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
    #[serde(skip_serializing_if = "Option::is_none")]
    note: Option<String>,
    peak_pressure: f64,
    peak_position: f64,
    resultant: f64,
    profile: Vec<Point>,
}

#[derive(Serialize)]
struct Residuals {
    penetration: f64,
    tension: f64,
    complementarity: f64,
    balance: f64,
}

#[derive(Serialize)]
struct Point {
    position: f64,
    pressure: f64,
    gap: f64,
    area: f64,
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
pub fn text(
    problem: &Problem,
    resolution: Resolution,
    run: &Run,
    reactions: &[ReactionReading],
    accuracy: Option<accuracy::Document>,
) -> String {
    let solution = &run.solution;
    let nan = f64::NAN;
    let last = solution.history.last().map(|step| step.residuals);
    let residuals =
        last.map_or(Residuals { penetration: nan, tension: nan, complementarity: nan, balance: nan }, |r| Residuals {
            penetration: r.penetration,
            tension: r.tension,
            complementarity: r.complementarity,
            balance: r.balance,
        });
    let contacts = (0..run.contacts.len()).map(|contact| of_contact(problem, run, contact)).collect();
    let document = Document {
        case: &problem.name,
        units: UNITS,
        element: run.formulation.element.name(),
        algorithm: run.formulation.algorithm.name(),
        rule: run.formulation.rule.name(),
        acceleration: run.formulation.acceleration.name(),
        start: run.formulation.start.name(),
        stiffness: run.formulation.stiffness,
        order: resolution.order.number(),
        resolution: resolution.elements,
        freedoms: run.freedoms,
        retained: run.retained,
        outcome: solution.outcome.to_string(),
        steps: solution.work.steps,
        factorisations: solution.work.factorisations,
        back_substitutions: solution.work.back_substitutions,
        rejected: solution.work.rejected,
        coarser_steps: solution.coarser.steps,
        seconds: run.seconds.iter().copied().collect(),
        residuals,
        contacts,
        reactions,
        oracles: oracles(problem, run),
        accuracy,
    };
    serde_json::to_string_pretty(&document).expect("numbers, strings and lists can be written as JSON")
}

fn of_contact<'a>(problem: &'a Problem, run: &Run, contact: usize) -> Contact<'a> {
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
        note: run.note(contact),
        peak_pressure: measures.peak.pressure,
        peak_position: measures.peak.position,
        resultant: found.transmitted,
        profile: run.solution.points_of(contact).iter().map(point).collect(),
    }
}

/// Readings of the problem's oracle for the quantities it knows; on arcs the half-width is the same functional of both.
pub fn oracles(problem: &Problem, run: &Run) -> Vec<OracleReading> {
    let Some(oracle) = &problem.oracle else { return Vec::new() };
    let on_arc = matches!(problem.scene.contact().path, Path::Arc(_));
    let moment = profile::half_width_of(&run.solution.points, |s| problem.reference_pressure(s));
    let half_width = if on_arc { moment } else { Reference::read(oracle.as_ref(), Quantity::HalfWidth).value };
    let read = |quantity| Reference::read(oracle.as_ref(), quantity).value;
    let resultant = read(Quantity::Resultant) * problem.scene.thickness;
    let all = [
        ("half_width", run.measures().half_width, half_width),
        ("peak_pressure", run.measures().peak.pressure, read(Quantity::PeakPressure)),
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
