//! From a discretisation to a solution: refusals before, the springs that the iteration starts from, the iteration,
//! refusals after.

use crate::algorithm::{ContactProblem, Iteration, Springs};
use crate::error::Error;
use crate::solution::Solution;
use crate::solve::{Change, Discretisation, Formulation, candidate_end};

impl Discretisation {
    /// Solves the contact problem by one formulation, from its own start.
    pub fn solve(&self, formulation: &Formulation) -> Result<Solution, Error> {
        self.solve_from(None, formulation, Change::NONE)
    }

    /// Solves it after a change of load or clearance, from the active set of an earlier solution on this mesh or on
    /// another one, whose candidates may end elsewhere.
    ///
    /// A point starts closed where the nearest point of the same contact was pressed. Only kinematic load has an active
    /// set to start from; the other algorithms, and load in increments, start as ever. Where the set leads nowhere, or
    /// the earlier solution is none, the scene is solved from its own start: the initial stiffness at every candidate.
    pub fn solve_from(
        &self,
        earlier: Option<&Solution>,
        formulation: &Formulation,
        change: Change,
    ) -> Result<Solution, Error> {
        self.refuse_undefined(formulation, change)?;
        let (points, load) = self.changed(formulation, change);
        let problem = self.problem_under(formulation, &points, &load);
        formulation.refuse_dense(&self.scene, points.len())?;
        self.refuse_nothing(&problem)?;
        let carried = earlier.and_then(|earlier| carried(earlier, formulation, &problem));
        let found = carried.and_then(|mut springs| formulation.iterate(&mut springs, &problem).ok());
        let iterated = match found.filter(Solution::converged) {
            Some(solution) => Ok(solution),
            None => formulation.iterate(&mut problem.initial_springs(), &problem),
        };
        let mut solution = iterated.map_err(|error| self.named(error, change.load))?;
        if solution.converged() {
            let displacement = self.displacement_under(change.load, &solution);
            let tolerance = formulation.settings.tolerance;
            solution.unseen = candidate_end::look(self, &solution, change, tolerance, &displacement)?;
        }
        Ok(solution)
    }
}

/// Springs that an earlier solution leaves to a problem, whose points start as the nearest point of their contact was;
/// none where there is none to start from, or nothing was closed.
fn carried(earlier: &Solution, formulation: &Formulation, problem: &ContactProblem) -> Option<Springs> {
    let carries = formulation.algorithm == Iteration::Kinematic && formulation.settings.increments == 1;
    if !carries || !earlier.converged() {
        return None;
    }
    let mut springs = problem.initial_springs();
    for (k, point) in springs.stiffness.iter_mut().zip(problem.points) {
        let own = earlier.contacts.get(point.contact).map_or(&[][..], |own| &earlier.points[own.points.clone()]);
        let nearest = own.iter().min_by(|a, b| {
            let [a, b] = [a, b].map(|other| (other.position - point.position).abs());
            a.total_cmp(&b)
        });
        if !nearest.is_some_and(|nearest| nearest.pressure > 0.0) {
            *k = 0.0;
        }
    }
    springs.stiffness.iter().any(|k| *k > 0.0).then_some(springs)
}
