//! How an increment ends whose criterion is not met: its states return, stand still, or are left to round-off, or its
//! error grows; and why no system of springs and bodies could be solved.

use std::collections::VecDeque;

use crate::algorithm::{ContactProblem, Iterate, Springs};
use crate::error::{Error, Kind, Place};
use crate::solution::{Iterated, Outcome, Work};

/// Two states closer than this are one that returned.
const RETURNED: f64 = 1e-10;
/// An iteration that changes the state by less is at rest, and no part of a cycle.
const MOVING: f64 = 1e-6;
/// Longest period looked for.
const MEMORY: usize = 64;
/// Iterations in a row after which nothing changes any more, and how close two states are that are the same.
const STILL: (usize, f64) = (3, 1e-14);
/// Iterations in a row whose changes may be round-off of an ill-conditioned system, and how small these are.
const ROUND_OFF: (usize, f64) = (50, 1e-7);
/// Part by which the error falls where it is not left to round-off.
const FALLS: f64 = 1e-3;
/// Iterations for which an error stays far beyond its least, and how many times beyond.
const GROWN: (usize, f64) = (20, 1e3);

/// Pressures and approaches after an iteration.
pub(super) struct State([Vec<f64>; 2]);

impl State {
    pub(super) fn of(iterate: &Iterate) -> Self {
        Self([iterate.pressure.clone(), iterate.approach.clone()])
    }

    /// Whether two states differ nowhere by more than a share of the largest pressure, or of the largest approach.
    fn is_within(&self, share: f64, other: &Self) -> bool {
        self.0.iter().zip(&other.0).all(|(own, other)| {
            let size = own.iter().chain(other).map(|x| x.abs()).fold(0.0, f64::max);
            own.iter().zip(other).all(|(a, b)| (a - b).abs() <= share * size)
        })
    }
}

/// What is remembered of the states of an increment.
pub(super) struct Watch {
    /// Latest states, the newest first.
    earlier: VecDeque<State>,
    /// Iterations in a row that changed nothing, and no more than round-off may.
    unchanged: [usize; 2],
    /// The least error of all iterations but the last; those stand, since errors are told a few iterations late, and
    /// are counted once.
    least: f64,
    counted: usize,
}

impl Default for Watch {
    fn default() -> Self {
        Self { earlier: VecDeque::new(), unchanged: [0; 2], least: f64::INFINITY, counted: 0 }
    }
}

impl Watch {
    /// How the increment ends with its newest state; none where it goes on. It stands still only once the discrete
    /// solution was looked for, so that its error is known.
    pub(super) fn ended(&mut self, state: State, history: &[Iterated], looked: bool) -> Option<Outcome> {
        if let Some(period) = self.period(&state) {
            return Some(Outcome::Cycling { period });
        }
        let (before, last) = history.split_at(history.len().saturating_sub(ROUND_OFF.0));
        self.least = self.least.min(least(&before[self.counted..]));
        self.counted = before.len();
        let newest = least(last);
        for (unchanged, (_, share)) in self.unchanged.iter_mut().zip([STILL, ROUND_OFF]) {
            let is_same = self.earlier.front().is_some_and(|before| state.is_within(share, before));
            *unchanged = if is_same { *unchanged + 1 } else { 0 };
        }
        let [still, round_off] = [self.unchanged[0] >= STILL.0, self.unchanged[1] >= ROUND_OFF.0];
        let falls = newest < (1.0 - FALLS) * self.least;
        if looked && (still || round_off && !falls) {
            return Some(Outcome::Stalled);
        }
        if has_grown(last, self.least.min(newest)) {
            return Some(Outcome::Diverged);
        }
        self.earlier.push_front(state);
        self.earlier.truncate(MEMORY);
        None
    }

    /// Period after which the state has returned, while the last iteration itself did change it.
    fn period(&self, state: &State) -> Option<usize> {
        if state.is_within(MOVING, self.earlier.front()?) {
            return None;
        }
        let same = self.earlier.iter().position(|other| state.is_within(RETURNED, other));
        same.map(|index| index + 1).filter(|&period| period >= 2)
    }
}

/// Whether the error has grown far beyond its least, and stayed there.
fn has_grown(last: &[Iterated], least: f64) -> bool {
    let (iterations, times) = GROWN;
    let mut errors = last.iter().rev().take(iterations).map(|iteration| iteration.error.largest());
    last.len() > iterations && errors.all(|error| error > times * least)
}

/// Least error of some iterations.
fn least(history: &[Iterated]) -> f64 {
    history.iter().map(|iteration| iteration.error.largest()).fold(f64::INFINITY, f64::min)
}

/// Decades by which springs may be too soft.
const DECADES: i32 = 18;
/// Factor above the softest springs that hold, for digits.
const MARGIN: f64 = 100.0;

/// Why no system of springs and bodies could be solved: springs that are lost in the round-off of S, or none left.
pub(super) fn unsolved(problem: &ContactProblem, springs: &Springs, iterations: usize) -> Error {
    if iterations > 0 || springs.stiffness.iter().all(|k| *k <= 0.0) {
        let message = format!(
            "only contact fixes the bodies, and no contact spring is left after iteration {iterations}: the load pulls \
            the bodies apart, the start is too soft, or the contact is smaller than two elements"
        );
        let remedy = "reverse the load, add a support, raise the initial stiffness or refine the mesh";
        return Error { kind: Kind::NoSpringLeft { iterations }, ..Error::at(Place::Nowhere, message, remedy) };
    }
    let stiffer = |times: f64| springs.stiffness.iter().map(|k| k * times).collect::<Vec<_>>();
    let holds = |times: &f64| problem.factorise(&stiffer(*times), &mut Work::default()).is_some();
    let decades = (1..=DECADES).map(|k| 10f64.powi(k));
    let enough = decades.into_iter().find(holds).map(|times| times * MARGIN).unwrap_or(f64::NAN);
    let message = "only contact fixes the bodies, and the initial springs are lost in the round-off of the stiffness \
        of the bodies";
    let remedy = format!("raise `stiffness` {enough:.0e} times");
    Error { kind: Kind::SpringsTooSoft, ..Error::at(Place::Nowhere, message, remedy) }
}
