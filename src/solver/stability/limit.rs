//! The contact an iteration shall end in, with what its errors are measured by.

use crate::algorithm::{ContactProblem, Iterate, Law, Target};
use crate::solution::IterationError;

/// Contact set, pressures and approaches of the discrete solution.
#[derive(Clone, Debug)]
pub struct Limit {
    /// Whether each point carries pressure.
    pub closed: Vec<bool>,
    /// Pressure of each point \[MPa\].
    pub pressure: Vec<f64>,
    /// Approach of each point \[mm\].
    pub approach: Vec<f64>,
    target: Target,
}

impl Limit {
    /// The limit of a problem; none where it has no discrete solution.
    pub fn of(problem: &ContactProblem) -> Option<Self> {
        let target = Target::of(problem, Law::Rigid, &vec![true; problem.points.len()])?;
        let exact = &target.exact;
        Some(Self {
            closed: exact.closed.clone(),
            pressure: exact.iterate.pressure.clone(),
            approach: exact.iterate.approach.clone(),
            target,
        })
    }

    /// How far pressures and approaches are from it.
    pub fn error(&self, problem: &ContactProblem, pressure: Vec<f64>, approach: Vec<f64>) -> IterationError {
        let [displacement, internal] = [Vec::new(), Vec::new()];
        self.target.error(problem, &Iterate { displacement, approach, pressure, internal })
    }

    /// Approach that the force of the first contact makes: what its lengths are measured by \[mm\].
    pub fn length(&self) -> f64 {
        self.target.approach(0)
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
