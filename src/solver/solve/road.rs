//! From a discretisation to a solution: refusals before, the iteration, refusals after.

use crate::error::Error;
use crate::solution::Solution;
use crate::solve::{Change, Discretisation, Formulation, Origin, candidate_end};

impl Discretisation {
    /// Solves the contact problem by one formulation, from its own start.
    pub fn solve(&self, formulation: &Formulation) -> Result<Solution, Error> {
        self.solve_from(Origin::Own, formulation, Change::NONE)
    }

    /// Solves it from some start, after a change of load or clearance.
    pub fn solve_from(&self, origin: Origin, formulation: &Formulation, change: Change) -> Result<Solution, Error> {
        self.refuse_undefined(formulation, change)?;
        let (points, load) = self.changed(formulation, change);
        let problem = self.problem_under(formulation, &points, &load);
        formulation.refuse_dense(&self.scene, points.len())?;
        self.refuse_nothing(&problem)?;
        let iterated = formulation.iterated(&problem, origin);
        let mut solution = iterated.map_err(|error| self.named(error, change.load))?;
        if solution.converged() {
            let displacement = self.displacement_under(change.load, &solution);
            let tolerance = formulation.settings.tolerance;
            solution.unseen = candidate_end::look(self, &solution, change, tolerance, &displacement)?;
        }
        Ok(solution)
    }
}
