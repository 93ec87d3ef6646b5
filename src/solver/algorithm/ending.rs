//! How an increment ends whose criterion is not met: one small watcher an ending, asked in this order.

use std::collections::VecDeque;

use crate::algorithm::Iterate;
use crate::solution::{Iterated, Outcome};

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

/// All watchers of an increment.
#[derive(Default)]
pub(super) struct Watchers {
    errors: Errors,
    cycle: Cycle,
    still: Still,
    round_off: RoundOff,
}

impl Watchers {
    /// How the increment ends with its newest state; none where it goes on. It stands still only once the discrete solution was
    /// looked for, so that its error is known.
    pub(super) fn ended(&mut self, state: State, history: &[Iterated], looked: bool) -> Option<Outcome> {
        if let Some(period) = self.cycle.period(&state) {
            return Some(Outcome::Cycling { period });
        }
        let last = self.errors.seen(history);
        let newest = least(last);
        let before = self.cycle.earlier.front();
        let falls = newest < (1.0 - RoundOff::FALLS) * self.errors.least;
        let stands = [self.still.stands(before, &state), self.round_off.stands(before, &state, falls)];
        if looked && stands.contains(&true) {
            return Some(Outcome::Stalled);
        }
        if has_grown(last, self.errors.least.min(newest)) {
            return Some(Outcome::Diverged);
        }
        self.cycle.remember(state);
        None
    }
}

/// The least error of all iterations but the last; those stand, since errors are told a few iterations late, and are counted once.
struct Errors {
    least: f64,
    counted: usize,
}

impl Default for Errors {
    fn default() -> Self {
        Self { least: f64::INFINITY, counted: 0 }
    }
}

impl Errors {
    /// Counts a history that has grown; its last iterations.
    fn seen<'a>(&mut self, history: &'a [Iterated]) -> &'a [Iterated] {
        let (before, last) = history.split_at(history.len().saturating_sub(RoundOff::ITERATIONS));
        self.least = self.least.min(least(&before[self.counted..]));
        self.counted = before.len();
        last
    }
}

/// A state returns that was there before.
#[derive(Default)]
struct Cycle {
    /// Latest states, the newest first.
    earlier: VecDeque<State>,
}

impl Cycle {
    /// Two states closer than this are one that returned.
    const SAME: f64 = 1e-10;
    /// An iteration that changes the state by less is at rest, and no part of a cycle.
    const MOVING: f64 = 1e-6;
    /// Longest period looked for.
    const MEMORY: usize = 64;

    /// Period after which the state has returned, while the last iteration itself did change it.
    fn period(&self, state: &State) -> Option<usize> {
        if state.is_within(Self::MOVING, self.earlier.front()?) {
            return None;
        }
        let same = self.earlier.iter().position(|other| state.is_within(Self::SAME, other));
        same.map(|index| index + 1).filter(|&period| period >= 2)
    }

    fn remember(&mut self, state: State) {
        self.earlier.push_front(state);
        self.earlier.truncate(Self::MEMORY);
    }
}

/// Nothing changes any more.
#[derive(Default)]
struct Still(usize);

impl Still {
    /// Iterations in a row without a larger change.
    const ITERATIONS: usize = 3;
    /// Two states closer than this are the same.
    const SAME: f64 = 1e-14;

    fn stands(&mut self, before: Option<&State>, state: &State) -> bool {
        let same = before.is_some_and(|before| state.is_within(Self::SAME, before));
        self.0 = if same { self.0 + 1 } else { 0 };
        self.0 >= Self::ITERATIONS
    }
}

/// What still changes may be round-off, and the error does not fall.
#[derive(Default)]
struct RoundOff(usize);

impl RoundOff {
    /// Iterations in a row that change no more.
    const ITERATIONS: usize = 50;
    /// Change of a state in an iteration that may be round-off of an ill-conditioned system.
    const NOISE: f64 = 1e-7;
    /// Part by which the error falls where it is not left to round-off.
    const FALLS: f64 = 1e-3;

    /// Given whether the least error of the last iterations is below that of all before them.
    fn stands(&mut self, before: Option<&State>, state: &State, falls: bool) -> bool {
        let noise = before.is_some_and(|before| state.is_within(Self::NOISE, before));
        self.0 = if noise { self.0 + 1 } else { 0 };
        self.0 >= Self::ITERATIONS && !falls
    }
}

/// Whether the error has grown far beyond its least, and stayed there.
fn has_grown(last: &[Iterated], least: f64) -> bool {
    /// Iterations for which it stays, and how many times beyond.
    const GROWN: (usize, f64) = (20, 1e3);
    let (iterations, times) = GROWN;
    let mut errors = last.iter().rev().take(iterations).map(|iteration| iteration.error.largest());
    last.len() > iterations && errors.all(|error| error > times * least)
}

/// Least error of some iterations.
fn least(history: &[Iterated]) -> f64 {
    history.iter().map(|iteration| iteration.error.largest()).fold(f64::INFINITY, f64::min)
}
