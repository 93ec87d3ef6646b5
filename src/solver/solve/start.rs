//! The springs from which the contact iteration starts.

use crate::algorithm::{ContactProblem, Iteration, Springs};
use crate::error::Error;
use crate::solution::Solution;
use crate::solve::active_set::ActiveSet;
use crate::solve::{Formulation, Origin};

impl Origin<'_> {
    /// Springs that an earlier solution leaves to a problem; none where there is none to start from.
    fn springs(self, formulation: &Formulation, problem: &ContactProblem) -> Option<Springs> {
        let Self::From(earlier) = self else { return None };
        let carries = formulation.algorithm == Iteration::Kinematic && formulation.settings.increments == 1;
        if carries && earlier.converged() { ActiveSet::of_solution(earlier).springs(problem) } else { None }
    }
}

impl Formulation {
    /// Iterates a problem from a start.
    pub(super) fn iterated(&self, problem: &ContactProblem, origin: Origin) -> Result<Solution, Error> {
        let carried = origin.springs(self, problem);
        let found = carried.and_then(|mut springs| self.iterate(&mut springs, problem).ok());
        match found.filter(Solution::converged) {
            Some(solution) => Ok(solution),
            None => self.iterate(&mut problem.initial_springs(), problem),
        }
    }
}
