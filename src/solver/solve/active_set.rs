//! Which points were pressed on another mesh of the same bodies, and what springs start as from there.

use std::ops::Range;

use crate::algorithm::{ContactProblem, Springs};
use crate::contact::ContactPoint;
use crate::solution::Solution;

/// The pressed contact points of a mesh.
pub struct ActiveSet {
    /// Points of each contact.
    contacts: Vec<Range<usize>>,
    /// Contact coordinate of every point, and whether it was pressed.
    points: Vec<(f64, bool)>,
}

impl ActiveSet {
    /// The pressed points of a solution.
    pub fn of_solution(solution: &Solution) -> Self {
        Self {
            contacts: solution.contacts.iter().map(|share| share.points.clone()).collect(),
            points: solution.points.iter().map(|point| (point.position, point.pressure > 0.0)).collect(),
        }
    }

    /// Springs of a problem whose points start as the nearest point of their contact was; none where nothing is closed.
    pub fn springs(&self, problem: &ContactProblem) -> Option<Springs> {
        let mut springs = problem.initial_springs();
        for (k, point) in springs.stiffness.iter_mut().zip(problem.points) {
            if !self.is_pressed(point) {
                *k = 0.0;
            }
        }
        springs.stiffness.iter().any(|k| *k > 0.0).then_some(springs)
    }

    /// Whether the point nearest to one of another mesh was pressed.
    fn is_pressed(&self, point: &ContactPoint) -> bool {
        let own = self.contacts.get(point.contact).map_or(&[][..], |own| &self.points[own.clone()]);
        let apart = |(position, _): &(f64, bool)| (position - point.position).abs();
        own.iter().min_by(|a, b| apart(a).total_cmp(&apart(b))).is_some_and(|(_, pressed)| *pressed)
    }
}
