//! Where kinematic load starts: every candidate closed, as in the paper, or the contact set of a coarser mesh.

use crate::algorithm::{ContactProblem, Springs, iterate_from};
use crate::contact::ContactPoint;
use crate::error::Error;
use crate::mesh::Resolution;
use crate::solution::{Solution, Work};
use crate::solve::{Discretisation, Formulation};

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
        let points = formulation.points(&self.interfaces);
        let problem = self.problem(formulation, &points);
        let (mut springs, coarser) = match self.coarser(formulation)? {
            Some(coarse) => coarse.carried(formulation, &problem)?,
            None => (problem.initial_springs(), Work::default()),
        };
        let mut algorithm = formulation.algorithm();
        let solution = iterate_from(&mut springs, &problem, algorithm.as_mut(), formulation.settings);
        Ok((Solution { coarser, ..solution? }, points, springs))
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

    /// Springs of a finer mesh's points as they ended on this one, and the work that took.
    fn carried(&self, formulation: &Formulation, finer: &ContactProblem) -> Result<(Springs, Work), Error> {
        let (solution, points, ended) = self.solve_from_start(formulation)?;
        let (own, mut work) = (solution.work, solution.coarser);
        work.steps += own.steps;
        work.factorisations += own.factorisations;
        work.updates += own.updates;
        work.back_substitutions += own.back_substitutions;
        work.operations += own.operations;
        let mut springs = finer.initial_springs();
        for (k, point) in springs.stiffness.iter_mut().zip(finer.points) {
            let apart = |at: &usize| (points[*at].position - point.position).abs();
            let same = (0..points.len()).filter(|&at| points[at].contact == point.contact);
            let nearest = same.min_by(|a, b| apart(a).total_cmp(&apart(b)));
            *k = match nearest.map_or(0.0, |at| ended.stiffness[at]) {
                open if open <= 0.0 => 0.0,
                hard if finer.scale.is_hard(hard) => hard,
                _ => *k,
            };
        }
        let lost = !solution.converged() || springs.stiffness.iter().all(|k| *k <= 0.0);
        Ok((if lost { finer.initial_springs() } else { springs }, work))
    }
}
