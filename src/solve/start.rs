//! The springs from which the contact iteration starts.

use crate::algorithm::{ContactProblem, Iteration, Springs};
use crate::error::Error;
use crate::mesh::Resolution;
use crate::solution::{Solution, Work};
use crate::solve::active_set::ActiveSet;
use crate::solve::{Change, Discretisation, Formulation, Origin, Start};

impl Origin<'_> {
    /// Springs that an earlier solution leaves to a problem; none where there is none to start from.
    fn springs(self, formulation: &Formulation, problem: &ContactProblem) -> Option<Springs> {
        let Self::From(earlier) = self else { return None };
        let carries = formulation.algorithm == Iteration::Kinematic && formulation.settings.increments == 1;
        if carries && earlier.converged() { ActiveSet::of_solution(earlier).springs(problem) } else { None }
    }
}

impl Discretisation {
    /// Iterates a problem of this mesh from its start.
    pub(super) fn iterated(
        &self,
        problem: &ContactProblem,
        formulation: &Formulation,
        origin: Origin,
        change: Change,
    ) -> Result<Solution, Error> {
        let carried = origin.springs(formulation, problem);
        let found = carried.and_then(|mut springs| formulation.iterate(&mut springs, problem).ok());
        match found.filter(Solution::converged) {
            Some(solution) => Ok(solution),
            None => {
                let (mut springs, coarser) = self.springs_of_start(problem, formulation, change)?;
                Ok(Solution { coarser, ..formulation.iterate(&mut springs, problem)? })
            }
        }
    }

    /// Springs where the formulation starts, and the work that coarser meshes took to find them.
    fn springs_of_start(
        &self,
        problem: &ContactProblem,
        formulation: &Formulation,
        change: Change,
    ) -> Result<(Springs, Work), Error> {
        let (set, work) = match self.coarser(formulation)? {
            None => (None, Work::default()),
            Some(coarse) => coarse.active_set(formulation, change)?,
        };
        let springs = set.and_then(|set| set.springs(problem));
        Ok((springs.unwrap_or_else(|| problem.initial_springs()), work))
    }

    /// The active set in which a formulation ends on this mesh, none where it does not converge, and the work that took.
    fn active_set(&self, formulation: &Formulation, change: Change) -> Result<(Option<ActiveSet>, Work), Error> {
        let (points, load) = self.changed(formulation, change);
        let problem = self.problem_under(formulation, &points, &load);
        let (mut springs, mut work) = self.springs_of_start(&problem, formulation, change)?;
        let solution = formulation.iterate(&mut springs, &problem)?;
        work += solution.work;
        Ok((solution.converged().then(|| ActiveSet::of_springs(&problem, &springs)), work))
    }

    /// The same scene half as fine, where the start is nested; none below one element per half-width.
    fn coarser(&self, formulation: &Formulation) -> Result<Option<&Self>, Error> {
        let Resolution { elements, refinement, .. } = self.resolution;
        let halved = match refinement {
            0 => Resolution { elements: elements / 2, ..self.resolution },
            _ => Resolution { refinement: refinement - 1, ..self.resolution },
        };
        if formulation.start == Start::Closed || halved.elements == 0 {
            return Ok(None);
        }
        if self.coarser.get().is_none() {
            let coarse = Self::of(self.scene.clone(), halved)?;
            return Ok(Some(self.coarser.get_or_init(|| Box::new(coarse))));
        }
        Ok(self.coarser.get().map(Box::as_ref))
    }
}
