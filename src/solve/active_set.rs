//! Which points were open, closed or hard on another mesh of the same bodies, and what springs start as from there.

use std::ops::Range;

use crate::algorithm::{ContactProblem, Springs, parts};
use crate::contact::ContactPoint;
use crate::solution::Solution;

/// States of the contact points of a mesh.
pub struct ActiveSet {
    /// Points of each contact.
    contacts: Vec<Range<usize>>,
    /// Contact coordinate and state of every point.
    points: Vec<(f64, State)>,
}

/// State of a contact point.
#[derive(Clone, Copy)]
enum State {
    /// It carries nothing.
    Open,
    /// It carries pressure, on whatever spring.
    Closed,
    /// Its spring is as stiff as springs become [MPa/mm].
    Hard(f64),
}

impl ActiveSet {
    /// The pressed points of a solution.
    pub fn of_solution(solution: &Solution) -> Self {
        let state = |pressure: f64| if pressure <= 0.0 { State::Open } else { State::Closed };
        Self {
            contacts: solution.contacts.iter().map(|share| share.points.clone()).collect(),
            points: solution.points.iter().map(|point| (point.position, state(point.pressure))).collect(),
        }
    }

    /// The springs of a problem as an iteration left them.
    pub fn of_springs(problem: &ContactProblem, springs: &Springs) -> Self {
        let state = |stiffness: f64| match stiffness {
            open if open <= 0.0 => State::Open,
            hard if problem.scale.is_hard(hard) => State::Hard(hard),
            _ => State::Closed,
        };
        let points = problem.points.iter().zip(&springs.stiffness);
        Self {
            contacts: parts::points(problem.points).collect(),
            points: points.map(|(point, k)| (point.position, state(*k))).collect(),
        }
    }

    /// Springs of a problem whose points start as the nearest point of their contact was; none where nothing is closed.
    pub fn springs(&self, problem: &ContactProblem) -> Option<Springs> {
        let mut springs = problem.initial_springs();
        for (k, point) in springs.stiffness.iter_mut().zip(problem.points) {
            match self.nearest(point) {
                State::Open => *k = 0.0,
                State::Closed => {}
                State::Hard(hard) => *k = hard,
            }
        }
        springs.stiffness.iter().any(|k| *k > 0.0).then_some(springs)
    }

    /// State of the point nearest to one of another mesh.
    fn nearest(&self, point: &ContactPoint) -> State {
        let own = self.contacts.get(point.contact).map_or(&[][..], |own| &self.points[own.clone()]);
        let apart = |(position, _): &(f64, State)| (position - point.position).abs();
        own.iter().min_by(|a, b| apart(a).total_cmp(&apart(b))).map_or(State::Open, |(_, state)| *state)
    }
}
