//! Where kinematic load starts: every candidate closed, as in the paper, or the contact set of a coarser mesh.

use crate::algorithm::{ContactProblem, Springs, iterate_from};
use crate::contact::ContactPoint;
use crate::error::Error;
use crate::formulation::{Discretisation, Formulation};
use crate::mesh::Resolution;
use crate::solution::{Solution, Work};

/// Where kinematic load starts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Start {
    /// Every candidate point closed: the paper's own start.
    Closed,
    /// The contact set of a mesh half as fine, itself found from one half as fine, down to one element per half-width.
    ///
    /// A point starts as the nearest point of the coarser mesh ended: open, closed or hardened. The contact edge is then
    /// wrong by about a coarse point spacing, and a step or two set it right.
    Nested,
}

impl Start {
    /// Name on the command line and in results.
    pub fn name(self) -> &'static str {
        match self {
            Self::Closed => "closed",
            Self::Nested => "nested",
        }
    }
}

impl Discretisation {
    /// Solution of a formulation, and its points with their springs as they stand at the end.
    pub(super) fn solve_from_start(
        &self,
        formulation: &Formulation,
    ) -> Result<(Solution, Vec<ContactPoint>, Springs), Error> {
        let points = formulation.points(&self.interface);
        let problem = self.problem(formulation, &points);
        let (mut springs, coarser) = match (formulation.start, coarser(self.resolution)) {
            (Start::Nested, Some(resolution)) => self.nested(formulation, &problem, resolution)?,
            _ => (problem.initial_springs(), Work::default()),
        };
        let mut algorithm = formulation.algorithm();
        let solution = iterate_from(&mut springs, &problem, algorithm.as_mut(), formulation.settings);
        Ok((Solution { coarser, ..solution? }, points, springs))
    }

    /// Springs carried over from a coarser mesh of the same scene, and the work they took.
    fn nested(
        &self,
        formulation: &Formulation,
        problem: &ContactProblem,
        resolution: Resolution,
    ) -> Result<(Springs, Work), Error> {
        let coarse = Self::of(self.scene.clone(), resolution)?;
        let (solution, points, ended) = coarse.solve_from_start(formulation)?;
        let mut work = solution.coarser;
        work.steps += solution.work.steps;
        work.factorisations += solution.work.factorisations;
        work.back_substitutions += solution.work.back_substitutions;
        let mut springs = problem.initial_springs();
        for (k, point) in springs.stiffness.iter_mut().zip(problem.points) {
            let apart = |at: &usize| (points[*at].position - point.position).abs();
            let nearest = (0..points.len()).min_by(|a, b| apart(a).total_cmp(&apart(b)));
            *k = match nearest.map_or(0.0, |at| ended.stiffness[at]) {
                open if open <= 0.0 => 0.0,
                hard if hard >= problem.scale.hard() => hard,
                _ => *k,
            };
        }
        let lost = !solution.converged() || springs.stiffness.iter().all(|k| *k <= 0.0);
        Ok((if lost { problem.initial_springs() } else { springs }, work))
    }
}

/// Half as fine; none below one element per half-width.
fn coarser(resolution: Resolution) -> Option<Resolution> {
    if resolution.refinement > 0 {
        return Some(Resolution { refinement: resolution.refinement - 1, ..resolution });
    }
    let elements = resolution.elements / 2;
    (elements > 0).then_some(Resolution { elements, ..resolution })
}
