//! Another load or clearance on a condensation at hand: pressures only, at the price of a few dense steps.

use crate::algorithm::{ContactProblem, iterate_from};
use crate::error::Error;
use crate::solution::{PointState, Solution};
use crate::solve::{Discretisation, Formulation, Iteration, spill};

/// What has changed since the first solve; the bodies, their supports and the places of their loads have not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Change {
    /// All loads and prescribed displacements times this.
    pub load: f64,
    /// Added to the gap everywhere \[mm\].
    pub clearance: f64,
}

impl Change {
    /// Nothing has changed.
    pub const NONE: Self = Self { load: 1.0, clearance: 0.0 };
}

impl Discretisation {
    /// Solves once more after a change, from the contact set of an earlier solution by the same formulation.
    ///
    /// Only kinematic load has a contact set to start from; the other algorithms start as ever.
    pub fn solve_again(
        &self,
        formulation: &Formulation,
        change: Change,
        earlier: &Solution,
    ) -> Result<Solution, Error> {
        self.after(formulation, change, &earlier.points)
    }

    /// The same from every candidate closed.
    pub fn solve_changed(&self, formulation: &Formulation, change: Change) -> Result<Solution, Error> {
        self.after(formulation, change, &[])
    }

    fn after(&self, formulation: &Formulation, change: Change, earlier: &[PointState]) -> Result<Solution, Error> {
        formulation.validate(&self.scene)?;
        self.refuse_change(formulation, change)?;
        let mut points = formulation.points(&self.interfaces);
        points.iter_mut().for_each(|point| point.gap += change.clearance);
        let load: Vec<f64> = self.condensed.load.iter().map(|f| f * change.load).collect();
        let problem = ContactProblem { load: &load, ..self.problem(formulation, &points) };
        self.refuse_nothing(&problem)?;
        let mut springs = problem.initial_springs();
        let closed = |point: &PointState| point.pressure > 0.0;
        let carries = formulation.algorithm == Iteration::Kinematic && formulation.settings.increments == 1;
        if carries && earlier.len() == points.len() && earlier.iter().any(closed) {
            let open = springs.stiffness.iter_mut().zip(earlier).filter(|(_, point)| !closed(point));
            open.for_each(|(k, _)| *k = 0.0);
        }
        let mut algorithm = formulation.algorithm();
        let solution = iterate_from(&mut springs, &problem, algorithm.as_mut(), formulation.settings)
            .map_err(|error| self.named(error))?;
        if solution.converged() {
            spill::refuse(self, &solution, change, formulation.settings.tolerance)?;
        }
        Ok(solution)
    }

    /// Refuses numbers that are none, and an interference that the formulation cannot take.
    fn refuse_change(&self, formulation: &Formulation, change: Change) -> Result<(), Error> {
        for (key, value) in [("load factor", change.load), ("clearance", change.clearance)] {
            if !value.is_finite() {
                return Err(Error::value(&self.scene.name, key, value, "a finite number is needed", "give a number"));
            }
        }
        formulation.refuse_interference(&self.scene, self.tightest_gap() + change.clearance)
    }
}
