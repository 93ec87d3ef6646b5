//! Varying stiffness with `correction`: stable where predicted when started next to the contact, and cycling from afar.

use serde::Serialize;

use crate::algorithm::{Algorithm, ContactProblem, Springs, StiffnessRule, Varying};
use crate::contact::ContactPoint;
use crate::error::{Error, Kind};
use crate::solution::{Outcome, Work};
use crate::solve::{Discretisation, Element, Formulation, Iteration};
use crate::stability::{Limit, rate};
use crate::study::stability::ground;

/// Initial stiffnesses around the boundary.
const STARTS: [f64; 10] = [0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0];
/// Relative change of the limit's springs at the start, iterations followed, and what error tells staying from leaving.
const NUDGE: f64 = 1e-3;
const STEPS: usize = 3000;
const LEFT: f64 = 1e-2;

/// A start next to the contact and from afar.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Start {
    /// Initial stiffness κ₀.
    pub stiffness: f64,
    /// Spectral radius next to the contact; NaN where there is none.
    pub predicted: f64,
    /// Whether it stays when started next to the contact.
    pub stays: bool,
    /// How it ends from equal springs.
    pub far: Far,
}

/// How a run from equal springs ends.
#[derive(Clone, Copy, Debug, Serialize)]
pub enum Far {
    /// With an outcome, after so many iterations.
    Ended(Outcome, usize),
    /// With the error that no spring is left, after so many iterations.
    NoSpringLeft(usize),
}

/// Every start with an element.
pub fn near_and_far(element: Element) -> Result<Vec<Start>, Error> {
    let discretisation = ground::discretised()?;
    STARTS.into_iter().map(|stiffness| start(&discretisation, element, stiffness)).collect()
}

fn start(discretisation: &Discretisation, element: Element, stiffness: f64) -> Result<Start, Error> {
    let base = Formulation::new(element, Iteration::Varying);
    let formulation = Formulation { rule: StiffnessRule::Correction, stiffness, ..base };
    let points: Vec<ContactPoint> = discretisation.points(&formulation);
    let problem = discretisation.problem(&formulation, &points);
    let limit = ground::limit(&problem)?;
    let far = match discretisation.solve(&formulation) {
        Ok(solution) => Far::Ended(solution.outcome, solution.work.iterations),
        Err(Error { kind: Kind::NoSpringLeft { iterations }, .. }) => Far::NoSpringLeft(iterations),
        Err(error) => return Err(error),
    };
    let predicted = rate::varying_correction(&problem, &limit).unwrap_or(f64::NAN);
    Ok(Start { stiffness, predicted, stays: stays(&problem, &limit), far })
}

/// Whether springs nudged off the limit's bring the error down, or away.
fn stays(problem: &ContactProblem, limit: &Limit) -> bool {
    let nudge =
        |(i, k): (usize, &f64)| problem.scale.clip(k * (1.0 + NUDGE * ((0.618 * (i + 1) as f64).fract() - 0.5)));
    let stiffness: Vec<f64> = limit.target(problem).iter().enumerate().map(nudge).collect();
    let mut springs = Springs { force: vec![0.0; stiffness.len()], stiffness };
    let mut algorithm = Varying::new(StiffnessRule::Correction);
    let mut error = f64::NAN;
    for _ in 0..STEPS {
        let Some(iterate) = algorithm.next(problem, problem.load, &mut springs, &mut Work::default()) else {
            return false;
        };
        error = limit.error(problem, iterate.pressure, iterate.approach).largest();
    }
    error < LEFT * NUDGE
}
