//! What one contact came to, as JSON.

use schemars::JsonSchema;
use serde::Serialize;

use crate::case::Case;
use crate::solution::PointState;
use crate::solve::Run;
use crate::solve::run::Errors;

/// What a contact coordinate is, on a straight path and on an arc.
const COORDINATES: [&str; 2] = ["length", "angle"];

/// What one contact came to; half-widths, centre and positions are lengths, or angles on an arc.
#[derive(Serialize, JsonSchema)]
pub struct Contact<'a> {
    /// Its name.
    name: &'a str,
    /// What its coordinate is: along a straight path in the unit `length`, along an arc in the unit `angle`.
    #[schemars(extend("enum" = COORDINATES))]
    coordinate: &'static str,
    /// Half-width: half of what lies between where the contact begins and ends.
    half_width: f64,
    /// Second-moment width.
    second_moment_width: f64,
    /// Half-width by counting pressed points.
    half_width_nodes: f64,
    /// Centre of pressure, of a contact on both sides of s = 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    centre: Option<f64>,
    /// Pressed points.
    active_points: usize,
    /// Where every closed stretch begins and ends.
    closed: Vec<[f64; 2]>,
    /// What to know before quoting it.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    notes: Vec<String>,
    /// Largest pressure; null where it has no limit.
    peak_pressure: Option<f64>,
    /// Where it is.
    peak_position: f64,
    /// Growth of a peak without a limit at the last halving of the elements.
    #[serde(skip_serializing_if = "Option::is_none")]
    peak_growth: Option<f64>,
    /// Pressure at s = 0.
    pressure_at_zero: f64,
    /// Largest pressure of a contact point.
    largest_point_pressure: f64,
    /// Where that is.
    largest_point_position: f64,
    /// Force on the whole contact, both halves.
    resultant: f64,
    /// Against the solution of the same discrete problem; null where that was not found.
    iteration_error: Option<Errors>,
    /// What the springs of a penalty change of the discrete solution.
    #[serde(skip_serializing_if = "Option::is_none")]
    penalty_error: Option<Errors>,
    /// Every contact point.
    profile: &'a [PointState],
}

impl<'a> Contact<'a> {
    /// One of a run.
    pub fn of(problem: &'a Case, run: &'a Run, contact: usize, notes: Vec<String>) -> Self {
        let (pair, found) = (&problem.scene.contacts[contact], &run.contacts[contact]);
        let measures = &found.measures;
        Self {
            name: &pair.name,
            coordinate: COORDINATES[usize::from(!pair.path.is_straight())],
            half_width: measures.half_width(),
            second_moment_width: measures.second_moment_width,
            half_width_nodes: measures.half_width_nodes,
            centre: pair.path.has_both_sides().then_some(measures.centre),
            active_points: measures.active,
            closed: measures.stretches.iter().map(|one| [one.begin, one.end]).collect(),
            notes,
            peak_pressure: found.unbounded.is_none().then_some(measures.peak.pressure),
            peak_position: measures.peak.position,
            peak_growth: found.unbounded.map(|unbounded| unbounded.growth),
            pressure_at_zero: measures.pressure_at_origin,
            largest_point_pressure: measures.largest.pressure,
            largest_point_position: measures.largest.position,
            resultant: found.transmitted,
            iteration_error: found.iteration,
            penalty_error: found.penalty,
            profile: run.solution.points_of(contact),
        }
    }
}
