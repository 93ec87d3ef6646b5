//! The contact an iteration shall end in: found once, by an algorithm of its own start, before any other is judged.

use crate::algorithm::{Constant, ContactProblem, Settings, StiffnessRule, iterate};
use crate::error::Error;

/// κ₀ of the search, in units of `E*/ℓ`: near the stiffness of the contact itself, where constant stiffness is quickest.
const START: f64 = 3.0;
/// Residuals of the limit.
const TOLERANCE: f64 = 1e-8;
/// Steps of the search: ten times what the slowest scene of the suite takes.
const STEPS: usize = 20_000;

/// Contact set, pressures and approaches of the converged problem.
#[derive(Clone, Debug)]
pub struct Limit {
    /// Whether each point carries pressure.
    pub closed: Vec<bool>,
    /// Pressure of each point \[MPa\].
    pub pressure: Vec<f64>,
    /// Approach of each point \[mm\].
    pub approach: Vec<f64>,
}

impl Limit {
    /// The limit of a problem, by constant stiffness with the rule `correction` at κ = 3; none where that does not converge.
    pub fn of(problem: &ContactProblem) -> Result<Option<Self>, Error> {
        let stiffness = |relative: f64| START * problem.scale.stiffness * relative;
        let problem = ContactProblem {
            stiffness: problem.stiffness,
            load: problem.load,
            points: problem.points,
            scale: problem.scale,
            initial: problem.points.iter().map(|point| stiffness(point.relative_stiffness)).collect(),
        };
        let settings = Settings { tolerance: TOLERANCE, increments: 1, max_steps: STEPS };
        let solution = iterate(&problem, &mut Constant::new(StiffnessRule::Correction), settings)?;
        if !solution.converged() {
            return Ok(None);
        }
        let scale = &problem.scale;
        // An open point carries round-off, a closed one penetrates by round-off: the larger of the two pure numbers decides.
        let closed = |(p, state): (&f64, &crate::solution::PointState)| p / scale.pressure > state.gap / scale.gap;
        Ok(Some(Self {
            closed: solution.spring_pressures.iter().zip(&solution.points).map(closed).collect(),
            approach: problem.points.iter().zip(&solution.points).map(|(point, state)| point.gap - state.gap).collect(),
            pressure: solution.spring_pressures,
        }))
    }

    /// Contact coordinate of the last closed point; zero where none is.
    pub fn edge(&self, problem: &ContactProblem) -> f64 {
        let closed = problem.points.iter().zip(&self.closed).filter(|(_, closed)| **closed);
        closed.map(|(point, _)| point.position).fold(0.0, f64::max)
    }

    /// Stiffness `k* = p/w` with which a spring without gap carries the limit's pressure [MPa/mm]; zero in open points.
    pub fn target(&self, problem: &ContactProblem) -> Vec<f64> {
        let each = self.closed.iter().zip(&self.pressure).zip(&self.approach);
        each.map(|((closed, p), w)| if *closed { p / problem.scale.above_zero(*w) } else { 0.0 }).collect()
    }
}
