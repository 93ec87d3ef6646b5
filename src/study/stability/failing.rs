//! Why `secant` and `literal` fail with constant stiffness.

use serde::Serialize;

use crate::algorithm::StiffnessRule;
use crate::contact::ContactPoint;
use crate::error::Error;
use crate::solution::{Outcome, Solution};
use crate::solve::{Discretisation, Element, Formulation, Iteration};
use crate::stability::{Limit, rate};
use crate::study::stability::ground;

/// Initial stiffnesses that are shown.
const STARTS: [f64; 5] = [0.1, 1.0, 1e2, 1e4, 1e6];

/// A start with both rules.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Start {
    /// Initial stiffness κ₀.
    pub stiffness: f64,
    /// Half of the largest κ* that `secant` asks for.
    pub needed: f64,
    /// Spectral radius of `secant`; NaN where there is none.
    pub predicted: f64,
    /// How `secant` ends.
    pub secant: Outcome,
    /// How `literal` ends.
    pub literal: Outcome,
    /// Largest force that `literal` leaves in a point that is open in the limit, over the limit's largest.
    pub left: f64,
}

/// Every start with an element.
pub fn failing(element: Element) -> Result<Vec<Start>, Error> {
    let discretisation = ground::discretised()?;
    STARTS.into_iter().map(|stiffness| start(&discretisation, element, stiffness)).collect()
}

fn start(discretisation: &Discretisation, element: Element, stiffness: f64) -> Result<Start, Error> {
    let with = |rule| Formulation { rule, stiffness, ..Formulation::new(element, Iteration::Constant) };
    let secant = with(StiffnessRule::Secant);
    let points: Vec<ContactPoint> = discretisation.points(&secant);
    let problem = discretisation.problem(&secant, &points);
    let limit = ground::limit(&problem)?;
    let asked = limit.target(&problem).into_iter().map(|k| problem.scale.clip(k)).fold(0.0, f64::max);
    let literal = discretisation.solve(&with(StiffnessRule::Literal))?;
    Ok(Start {
        stiffness,
        needed: 0.5 * asked / problem.scale.stiffness,
        predicted: rate::secant_force(&problem, &limit).unwrap_or(f64::NAN),
        secant: discretisation.solve(&secant)?.outcome,
        literal: literal.outcome,
        left: force_left(&literal, &limit),
    })
}

/// Largest force that the last iteration left in a point that is open in the limit, over the limit's largest.
fn force_left(solution: &Solution, limit: &Limit) -> f64 {
    let open = solution.spring_pressures.iter().zip(&limit.closed).filter(|(_, closed)| !**closed);
    open.map(|(p, _)| p.abs()).fold(0.0, f64::max) / limit.pressure.iter().copied().fold(0.0, f64::max)
}
