//! The result of a solve as JSON; units are millimetre, newton, megapascal and radian.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::case::{Problem, Reference, Run};
use crate::cli::accuracy;
use crate::cli::reactions::ReactionReading;
use crate::measure::profile;
use crate::mesh::Resolution;
use crate::oracle::Quantity;
use crate::scene::Path;

#[derive(Serialize)]
struct Document<'a> {
    case: &'a str,
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
    half_width: f64,
    half_width_nodes: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    centre: Option<f64>,
    active_points: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    note: Option<String>,
    peak_pressure: f64,
    resultant: f64,
    residuals: Residuals,
    reactions: &'a [ReactionReading],
    profile: Vec<Point>,
    oracles: Vec<OracleReading>,
    #[serde(skip_serializing_if = "Option::is_none")]
    accuracy: Option<accuracy::Document>,
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
    let (solution, measures) = (&run.solution, &run.measures);
    let nan = f64::NAN;
    let last = solution.history.last().map(|step| step.residuals);
    let residuals =
        last.map_or(Residuals { penetration: nan, tension: nan, complementarity: nan, balance: nan }, |r| Residuals {
            penetration: r.penetration,
            tension: r.tension,
            complementarity: r.complementarity,
            balance: r.balance,
        });
    let point = |p: &crate::solution::PointState| Point { position: p.position, pressure: p.pressure, gap: p.gap };
    let document = Document {
        case: &problem.name,
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
        half_width: measures.half_width,
        half_width_nodes: measures.half_width_nodes,
        centre: problem.scene.contact.path.has_both_sides().then_some(measures.centre),
        active_points: measures.active,
        note: run.note(),
        peak_pressure: measures.peak.pressure,
        resultant: run.transmitted,
        residuals,
        reactions,
        profile: solution.points.iter().map(point).collect(),
        oracles: oracles(problem, run),
        accuracy,
    };
    serde_json::to_string_pretty(&document).expect("numbers, strings and lists can be written as JSON")
}

/// Readings of the problem's oracle for the quantities it knows; on arcs the half-width is the same functional of both.
pub fn oracles(problem: &Problem, run: &Run) -> Vec<OracleReading> {
    let Some(oracle) = &problem.oracle else { return Vec::new() };
    let on_arc = matches!(problem.scene.contact.path, Path::Arc(_));
    let moment = profile::half_width_of(&run.solution.points, |s| problem.reference_pressure(s));
    let half_width = if on_arc { moment } else { Reference::read(oracle.as_ref(), Quantity::HalfWidth).value };
    let read = |quantity| Reference::read(oracle.as_ref(), quantity).value;
    let resultant = read(Quantity::Resultant) * problem.scene.thickness;
    let all = [
        ("half_width", run.measures.half_width, half_width),
        ("peak_pressure", run.measures.peak.pressure, read(Quantity::PeakPressure)),
        ("resultant", run.transmitted, resultant),
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
