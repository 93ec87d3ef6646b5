//! Starting from the contact set of another mesh of the same bodies.

use crate::algorithm::iterate_from;
use crate::error::Error;
use crate::solution::Solution;
use crate::solve::{Change, Discretisation, Formulation, Iteration, spill};

impl Discretisation {
    /// Solves from the contact set of a solution on another mesh, whose candidates may end elsewhere.
    ///
    /// A point starts closed where the nearest point of the other mesh is pressed. Only kinematic load has a contact set
    /// to start from; the other algorithms, and load in increments, start as ever. Where the carried set leads nowhere
    /// the scene is solved from its own start.
    pub fn solve_carrying(&self, formulation: &Formulation, earlier: &Solution) -> Result<Solution, Error> {
        let carries = formulation.algorithm == Iteration::Kinematic && formulation.settings.increments == 1;
        let pressed = earlier.points.iter().any(|point| point.pressure > 0.0);
        if !carries || !pressed || !earlier.converged() {
            return self.solve(formulation);
        }
        formulation.validate(&self.scene)?;
        formulation.refuse_interference(&self.scene, self.tightest_gap())?;
        let points = formulation.points(&self.interfaces);
        let problem = self.problem(formulation, &points);
        self.refuse_nothing(&problem)?;
        let mut springs = problem.initial_springs();
        for (k, point) in springs.stiffness.iter_mut().zip(&points) {
            let apart = |at: usize| (earlier.points[at].position - point.position).abs();
            let same = earlier.contacts[point.contact].points.clone();
            let nearest = same.min_by(|&a, &b| apart(a).total_cmp(&apart(b)));
            if nearest.is_some_and(|at| earlier.points[at].pressure <= 0.0) {
                *k = 0.0;
            }
        }
        if springs.stiffness.iter().all(|k| *k <= 0.0) {
            return self.solve(formulation);
        }
        let mut algorithm = formulation.algorithm();
        match iterate_from(&mut springs, &problem, algorithm.as_mut(), formulation.settings) {
            Ok(solution) if solution.converged() => {
                spill::refuse(self, &solution, Change::NONE, formulation.settings.tolerance)?;
                Ok(solution)
            }
            _ => self.solve(formulation),
        }
    }
}
