//! The result of a solve as JSON, which names its units: millimetre, newton, megapascal, radian and second.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Serialize;

use crate::cli::solve::found::{Found, ReactionReading};
use crate::cli::{accuracy, bars};
use crate::solution::IterationError;
use crate::solve::{VonMises, WithoutLimit};

use super::contact::Contact;
use super::{Checked, OracleReading, oracle};

/// The result of a solve.
#[derive(Serialize, JsonSchema)]
pub struct Solved<'a> {
    /// Name of the case, or of the scene file.
    case: &'a str,
    /// Units of all numbers but those of checks, which name theirs.
    units: Units,
    /// Contact element.
    element: &'a str,
    /// Iteration algorithm.
    algorithm: &'a str,
    /// Its rule.
    rule: &'a str,
    /// Largest factor on a stiffness in an iteration; null where changes are not bounded.
    bound: f64,
    /// What has a stiffness of its own.
    spring: &'a str,
    /// What shall fall below the tolerance.
    criterion: &'a str,
    /// Acceleration of the iteration.
    acceleration: &'a str,
    /// Initial stiffness κ₀, in `stiffness_unit`.
    stiffness: f64,
    /// What the initial stiffness is a multiple of: `reference`, E*/ℓ, or `bodies`, √(E*/L · s).
    stiffness_unit: &'a str,
    /// Order of the elements: 1 or 2.
    order: u8,
    /// Elements on the length that the scene names.
    resolution: usize,
    /// Degrees of freedom.
    #[serde(rename = "freedoms")]
    dofs: usize,
    /// Normal degrees of freedom that the condensation retains.
    retained: usize,
    /// How the iteration ended.
    outcome: String,
    /// Iterations.
    #[serde(rename = "steps")]
    iterations: usize,
    /// Factorisations of the condensed stiffness.
    factorisations: usize,
    /// Back-substitutions with them.
    back_substitutions: usize,
    /// Accelerated iterations that were given up for the plain one.
    rejected: usize,
    /// Seconds by stage.
    seconds: BTreeMap<&'static str, f64>,
    /// What the iteration was judged by, at the worst contact; relative.
    iteration_error: IterationError,
    /// The contacts, in the order of the scene.
    contacts: Vec<Contact<'a>>,
    /// The bodies, in the order of the scene.
    bodies: Vec<Body<'a>>,
    /// What is left over of loads, contact and reactions of a body, over the largest of them, at the worst body.
    imbalance: f64,
    /// What the supports exert.
    reactions: &'a [ReactionReading],
    /// How far each number may be from the truth; left out where that was not asked for.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    error_bars: Vec<bars::Document>,
    /// Checks of the file, and that of the accuracy asked for.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    checks: Vec<Checked>,
    /// What the closed form of the case says.
    oracles: Vec<OracleReading>,
    /// What the closed forms of the case say that the run contradicts, with both numbers.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    notes: Vec<String>,
    /// What came of an accuracy that was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    accuracy: Option<accuracy::Document<'a>>,
}

/// Units of all numbers; errors and the spring stiffness κ are pure.
#[derive(Serialize, JsonSchema)]
struct Units {
    /// Of lengths.
    length: &'static str,
    /// Of forces.
    force: &'static str,
    /// Of stresses and pressures.
    stress: &'static str,
    /// Of angles.
    angle: &'static str,
    /// Of times.
    time: &'static str,
}

const UNITS: Units = Units { length: "mm", force: "N", stress: "MPa", angle: "rad", time: "s" };

impl<'a> Solved<'a> {
    /// The document of a run.
    pub fn of(found: &'a Found) -> Self {
        let Found { problem, run, reactions, checks, .. } = found;
        let (solution, formulation) = (&run.solution, &run.formulation);
        Self {
            case: &problem.name,
            units: UNITS,
            element: formulation.element.name(),
            algorithm: formulation.algorithm.name(),
            rule: formulation.rule.name(),
            bound: formulation.leeway.bound,
            spring: formulation.leeway.spring.name(),
            criterion: formulation.settings.criterion.name(),
            acceleration: formulation.acceleration.name(),
            stiffness: formulation.stiffness,
            stiffness_unit: formulation.stiffness_unit.name(),
            order: problem.resolution.order.number(),
            resolution: problem.resolution.elements,
            dofs: run.dofs,
            retained: run.retained,
            outcome: solution.outcome.to_string(),
            iterations: solution.work.iterations,
            factorisations: solution.work.factorisations,
            back_substitutions: solution.work.back_substitutions,
            rejected: solution.work.rejected,
            seconds: run.seconds.iter().map(|&(stage, seconds)| (stage.name(), seconds)).collect(),
            iteration_error: solution.error(),
            contacts: (0..run.contacts.len())
                .map(|contact| Contact::of(problem, run, contact, found.notes_of(contact)))
                .collect(),
            bodies: found.stresses.iter().map(|stress| Body::of(found, stress)).collect(),
            imbalance: run.imbalance(),
            reactions,
            error_bars: bars::Document::all(found),
            checks: checks.iter().map(Checked::of).collect(),
            oracles: oracle::readings(problem, run),
            notes: found.notes(),
            accuracy: found.accurate.as_ref().map(accuracy::Document::of),
        }
    }
}

/// What one body came to.
#[derive(Serialize, JsonSchema)]
struct Body<'a> {
    /// Its name.
    name: &'a str,
    /// Largest von Mises stress, with the stress across the plane; null where it lies beside a place at which stresses
    /// have no limit. Its bar is among `error_bars`.
    von_mises: Option<f64>,
    /// Where that is: x and y.
    #[serde(skip_serializing_if = "Option::is_none")]
    von_mises_at: Option<[f64; 2]>,
    /// Places at which the stress has no limit.
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    without_limit: &'a [WithoutLimit],
}

impl<'a> Body<'a> {
    /// One of a solve.
    fn of(found: &'a Found, VonMises { body, largest, without_limit }: &'a VonMises) -> Self {
        Self {
            name: &found.problem.scene.bodies[*body].name,
            von_mises: largest.map(|largest| largest.stress),
            von_mises_at: largest.map(|largest| largest.at),
            without_limit,
        }
    }
}
