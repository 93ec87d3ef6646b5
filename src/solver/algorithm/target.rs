//! What an iteration shall end in, and how far it is from there, on the scale of the solution itself and contact by
//! contact.
//!
//! A residual needs a scale, and one that is guessed beforehand (a pressure, a gap, a stretch) calls answers converged
//! that are far off where the guess is. Here the discrete solution is known ([`exact`](crate::algorithm::exact)), so
//! that the error itself is: of peak, forces, width and approach, each over the solution's own. The algorithms do not
//! see it: it stops the clock, for all of them at the same accuracy.
//!
//! Peak and forces are those of edges, not of points: pressures at the Gauss points of stiff springs alternate in a
//! mode that no node feels.

use std::ops::Range;

use crate::algorithm::exact::{Exact, Law};
use crate::algorithm::parts;
use crate::algorithm::problem::reported;
use crate::algorithm::{ContactProblem, Iterate};
use crate::contact::ContactPoint;
use crate::measure::{peak, profile};
use crate::solution::{EdgeState, IterationError, PointState, States};

/// The discrete solution of a problem, with what errors are measured by.
#[derive(Clone, Debug)]
pub struct Target {
    /// The solution.
    pub exact: Exact,
    contacts: Vec<OfContact>,
    /// Approach that the own force of each contact makes, `Σ F*/(E* t)` \[mm\].
    approaches: Vec<f64>,
    /// Largest force of a contact; of the load where no contact carries one \[N\].
    largest_force: f64,
}

/// What an iterate says of one contact.
#[derive(Clone, Debug)]
struct OfContact {
    points: Range<usize>,
    means: Vec<EdgeState>,
    /// Largest pressure, as it is quoted \[MPa\].
    peak: f64,
    /// `Σ A p` \[N\].
    force: f64,
    /// `Σ A p s/Σ A p`; 0 where the contact begins at s = 0.
    centre: f64,
    /// Second-moment width about it; 0 on a single point.
    width: f64,
}

impl OfContact {
    /// Contact by contact.
    fn all(problem: &ContactProblem, states: &[PointState]) -> Vec<Self> {
        let ranges = parts::points(problem.points).zip(parts::edges(problem.edges));
        let one = |(points, edges): (Range<usize>, Range<usize>)| {
            let own = &states[points.clone()];
            let across = own.first().is_some_and(|state| state.position < 0.0);
            let centre = if across { profile::centre(own) } else { 0.0 };
            let means = parts::means(&problem.edges[edges], &problem.points[points.clone()], own);
            Self {
                points,
                peak: peak::of(&means, centre).pressure,
                means,
                force: own.iter().map(|state| state.weight * state.pressure).sum(),
                centre,
                width: profile::second_moment_width(own, centre),
            }
        };
        ranges.map(one).collect()
    }

    /// The larger of the errors of width and centre, over the wanted width; 0 where that vanishes.
    fn apart(&self, wanted: &Self) -> f64 {
        let far = (self.width - wanted.width).abs().max((self.centre - wanted.centre).abs());
        match () {
            _ if self.width.is_nan() || self.centre.is_nan() => f64::NAN,
            _ if wanted.width > 0.0 => far / wanted.width,
            _ => 0.0,
        }
    }
}

impl Target {
    /// Looks for the discrete solution from a set of closed points.
    pub fn of(problem: &ContactProblem, law: Law, start: &[bool]) -> Option<Self> {
        let mut exact = Exact::of(problem, law, start)?;
        let states = told_states(problem, &exact.iterate);
        // What is round-off of a contact's force is none, wherever the solution is asked.
        let told = exact.iterate.pressure.iter_mut().zip(&states);
        told.filter(|(_, state)| state.pressure <= 0.0).for_each(|(pressure, _)| *pressure = pressure.min(0.0));
        let contacts = OfContact::all(problem, &states);
        let approaches =
            contacts.iter().zip(&problem.compliance).map(|(contact, compliance)| contact.force * compliance);
        let approaches = approaches.collect();
        let largest = contacts.iter().map(|contact| contact.force).fold(0.0, f64::max);
        let applied: f64 = problem.load.iter().map(|f| f.abs()).sum();
        let largest_force = if largest > 0.0 { largest } else { applied };
        Some(Self { exact, contacts, approaches, largest_force })
    }

    /// How far an iterate is from the solution, at the worst contact.
    pub fn error(&self, problem: &ContactProblem, iterate: &Iterate) -> IterationError {
        let states = states(problem.points, iterate);
        let each = OfContact::all(problem, &states).into_iter().enumerate();
        let each = each.map(|(contact, found)| self.error_of(contact, &found, problem, iterate, &states));
        each.fold(IterationError::NONE, IterationError::worse)
    }

    fn error_of(
        &self,
        index: usize,
        found: &OfContact,
        problem: &ContactProblem,
        iterate: &Iterate,
        states: &[PointState],
    ) -> IterationError {
        let contact = &self.contacts[index];
        if contact.force <= 0.0 {
            let own_contact = problem.points[contact.points.start].contact;
            let carried = contact.points.clone().map(|i| problem.points[i].weight * iterate.pressure[i].abs());
            let force: f64 = carried.sum();
            let round_off = problem.round_off(&iterate.displacement)[own_contact];
            let force = if force <= round_off { 0.0 } else { force / self.largest_force };
            return IterationError { force, ..IterationError::NONE };
        }
        let OfContact { means, peak, .. } = found;
        let (mut work, mut force, mut cut) = (0.0, 0.0, 0.0);
        for i in contact.points.clone() {
            let weight = problem.points[i].weight;
            let carried = weight * self.exact.iterate.pressure[i].max(0.0);
            work += carried * (iterate.approach[i] - self.exact.iterate.approach[i]).abs();
            force += carried;
            // Tension is cut from the pressures told, and felt by the displacements all the same.
            cut += weight * (states[i].pressure - iterate.pressure[i]);
        }
        IterationError {
            peak: (peak / contact.peak - 1.0).abs(),
            force: profile::misplaced(means, &contact.means) + cut / force,
            width: found.apart(contact),
            approach: work / (force * self.approaches[index]),
        }
    }

    /// Approach that the own force of a contact makes \[mm\].
    pub fn approach(&self, contact: usize) -> f64 {
        self.approaches[contact]
    }

    /// Points and edges as a solution tells them.
    pub fn told(&self, problem: &ContactProblem) -> States {
        told(problem, &self.exact.iterate)
    }
}

/// Points and edges as a solution tells them.
pub(super) fn told(problem: &ContactProblem, iterate: &Iterate) -> States {
    let states = told_states(problem, iterate);
    let ranges = parts::points(problem.points).zip(parts::edges(problem.edges));
    let means = ranges.flat_map(|(points, edges)| {
        parts::means(&problem.edges[edges], &problem.points[points.clone()], &states[points])
    });
    let edges = means.collect();
    States { points: states, edges }
}

/// Points with their reported pressures and remaining gaps.
fn states(points: &[ContactPoint], iterate: &Iterate) -> Vec<PointState> {
    let each = points.iter().zip(&iterate.pressure).zip(&iterate.approach);
    each.map(|((point, p), w)| PointState {
        position: point.position,
        weight: point.weight,
        pressure: reported(*p),
        gap: point.gap - w,
    })
    .collect()
}

/// The same, in which a contact whose force is no more than round-off presses nowhere.
fn told_states(problem: &ContactProblem, iterate: &Iterate) -> Vec<PointState> {
    let mut states = states(problem.points, iterate);
    let round_off = problem.round_off(&iterate.displacement);
    for own in parts::points(problem.points) {
        let force: f64 = states[own.clone()].iter().map(|state| state.weight * state.pressure).sum();
        if force <= round_off[problem.points[own.start].contact] {
            states[own].iter_mut().for_each(|state| state.pressure = 0.0);
        }
    }
    states
}

/// Pressure over the largest of its contact from which on a point is a closed one to begin the search with.
const PRESSED: f64 = 1e-3;

/// The points that an iterate presses, by the largest pressure of their contact.
pub(super) fn pressed(problem: &ContactProblem, iterate: &Iterate) -> Vec<bool> {
    parts::pressed(problem.points, &iterate.pressure, PRESSED)
}
