//! Rates of constant stiffness with `correction` and varying stiffness with `secant`: predicted against measured.

use serde::Serialize;

use crate::algorithm::StiffnessRule;
use crate::contact::ContactPoint;
use crate::error::Error;
use crate::measure::profile::weighted_line;
use crate::solution::Solution;
use crate::solve::{Discretisation, Formulation, Iteration};
use crate::stability::{linear, rate};
use crate::study::method::Method;
use crate::study::stability::ground;

/// Initial stiffnesses of the rate studies: constant stiffness depends on them, varying stiffness does not.
const STARTS: [f64; 9] = [0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1000.0];
const FEW_STARTS: [f64; 3] = [0.1, 3.0, 100.0];
/// Misplaced force between which the rate is measured, in the latter half of the iterations: below the first the active set is
/// final, above the last is no round-off.
const WINDOW: [f64; 2] = [1e-5, 2e-12];
/// The least error of a run, times this, is still above what springs at their limit leave.
const ABOVE_LEAST: f64 = 20.0;
/// Iterations that half must hold.
const STEPS: usize = 20;
/// Tolerance and limit of iterations of a run whose rate is measured.
const TOLERANCE: f64 = 1e-12;
const LIMIT: usize = 12_000;

/// A start, predicted and measured.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Start {
    /// Initial stiffness κ₀.
    pub stiffness: f64,
    /// Spectral radius on the final active set; NaN where there is none.
    pub predicted: f64,
    /// Slope of the linearised iteration over the measured errors; constant stiffness alone has one.
    pub linearised: Option<f64>,
    /// Measured rate; none where there are too few iterations to measure it.
    pub measured: Option<f64>,
}

/// Every start of a method.
pub fn rates(method: Method) -> Result<Vec<Start>, Error> {
    let discretisation = ground::discretised()?;
    let starts: &[f64] = if method.algorithm == Iteration::Varying { &FEW_STARTS } else { &STARTS };
    starts.iter().map(|&stiffness| start(&discretisation, method, stiffness)).collect()
}

fn start(discretisation: &Discretisation, method: Method, stiffness: f64) -> Result<Start, Error> {
    let formulation = to_the_end(method, stiffness);
    let measured = measured(&discretisation.solve(&formulation)?);
    Ok(Start {
        stiffness,
        predicted: predicted(discretisation, &formulation)?,
        linearised: linearised(discretisation, &formulation, measured)?,
        measured: measured.map(|measured| measured.rate),
    })
}

/// A run that goes on until its rate can be measured.
pub(super) fn to_the_end(method: Method, stiffness: f64) -> Formulation {
    let mut formulation = method.formulation(stiffness).tolerance(TOLERANCE);
    formulation.settings.max_iterations = LIMIT;
    formulation
}

/// The predicted rate on the limit.
fn predicted(discretisation: &Discretisation, formulation: &Formulation) -> Result<f64, Error> {
    let points: Vec<ContactPoint> = discretisation.points(formulation);
    let problem = discretisation.problem(formulation, &points);
    let limit = ground::limit(&problem)?;
    let found = match formulation.rule {
        StiffnessRule::Correction => rate::correction(&problem, &limit.closed),
        _ => rate::secant(&problem, &limit.target(&problem), &limit.approach, 0.0),
    };
    Ok(found.unwrap_or(f64::NAN))
}

/// A slope of the errors, and between which of them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Measured {
    pub(super) rate: f64,
    from: f64,
    to: f64,
}

/// Slope of the errors in the latter half of the window; none where that holds too few iterations.
pub(super) fn measured(solution: &Solution) -> Option<Measured> {
    let errors: Vec<f64> = solution.history.iter().map(|iteration| iteration.error.force).collect();
    let least = errors.iter().copied().fold(f64::INFINITY, f64::min);
    let [from, to] = [WINDOW[0], WINDOW[1].max(ABOVE_LEAST * least)];
    let first = errors.iter().rposition(|r| *r > from).map_or(0, |index| index + 1);
    let within: Vec<f64> = errors[first..].iter().copied().take_while(|r| *r > to).collect();
    let latter = &within[within.len() / 2..];
    if latter.len() < STEPS {
        return None;
    }
    let line: Vec<[f64; 3]> = latter.iter().enumerate().map(|(step, r)| [step as f64, r.ln(), 1.0]).collect();
    Some(Measured { rate: weighted_line(&line).1.exp(), from: latter[0], to: latter[latter.len() - 1] })
}

/// Mean slope of constant stiffness linearised on its final active set, between the errors that were measured.
fn linearised(
    discretisation: &Discretisation,
    formulation: &Formulation,
    measured: Option<Measured>,
) -> Result<Option<f64>, Error> {
    let Some(Measured { from, to, .. }) = measured.filter(|_| formulation.algorithm == Iteration::Constant) else {
        return Ok(None);
    };
    let points: Vec<ContactPoint> = discretisation.points(formulation);
    let problem = discretisation.problem(formulation, &points);
    let limit = ground::limit(&problem)?;
    let iterations = |tolerance: f64| linear::iterations(&problem, &limit, |error| error.force, tolerance);
    Ok(iterations(from).zip(iterations(to)).map(|(first, last)| ((to / from).ln() / (last - first)).exp()))
}
