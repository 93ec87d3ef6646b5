//! The loop: it alone counts, stops and decides how an iteration ended.

use std::collections::VecDeque;
use std::ops::Range;

use crate::algorithm::exact::Law;
use crate::algorithm::target::{self, Target};
use crate::algorithm::{Algorithm, ContactProblem, Criterion, Iterate, Springs};
use crate::algorithm::{bound, criterion, parts};
use crate::error::{Error, Kind, Place};
use crate::solution::{Increment, Iterated, IterationError, Outcome, Share, Solution, States, Work};

/// When to stop.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Settings {
    /// What shall fall below the tolerance.
    pub criterion: Criterion,
    /// Largest iteration error accepted: of peak, force, width and approach of every contact, over the discrete solution's own.
    pub tolerance: f64,
    /// Load increments.
    pub increments: usize,
    /// Iterations over all increments.
    pub max_iterations: usize,
}

impl Default for Settings {
    fn default() -> Self {
        Self { criterion: Criterion::Error, tolerance: 1e-3, increments: 1, max_iterations: 2000 }
    }
}

/// Iterations in which an error that has grown this many times beyond its least stays there is divergence.
const GROWN: (usize, f64) = (20, 1e3);
/// Two states closer than this are the same, and after so many iterations without a larger change the iteration stands still.
const STILL: (usize, f64) = (3, 1e-14);
/// Iterations in which an error that does not fall by this part of it, while no iteration changes the state by more than [`NOISE`],
/// is left to round-off.
const FALLS: (usize, f64) = (50, 1e-3);
/// Change of a state in an iteration that may be round-off of an ill-conditioned system.
const NOISE: f64 = 1e-7;
/// Two states closer than this are one that returned.
const SAME: f64 = 1e-10;
/// An iteration that changes the state by less is at rest, and no part of a cycle.
const MOVING: f64 = 1e-6;
/// Decades by which springs may be too soft.
const DECADES: i32 = 18;
/// Factor above the softest springs that hold, for digits.
const MARGIN: f64 = 100.0;
/// Longest period looked for.
const MEMORY: usize = 64;
/// Iterations after which the discrete solution is looked for, unless the pressed points stood still before: from there it is
/// found in a few factorisations.
const LOOK: usize = 5;

/// Applies the load in increments and lets the algorithm iterate until the iteration error is within the tolerance.
///
/// Increment n of N applies `(n/N) f̂` and starts from the springs of the one before; the gap enters whole, once.
pub fn iterate(problem: &ContactProblem, algorithm: &mut dyn Algorithm, settings: Settings) -> Result<Solution, Error> {
    iterate_from(&mut problem.initial_springs(), problem, algorithm, settings)
}

/// The same from given springs, which are left as they stand after the last iteration.
pub fn iterate_from(
    springs: &mut Springs,
    problem: &ContactProblem,
    algorithm: &mut dyn Algorithm,
    settings: Settings,
) -> Result<Solution, Error> {
    let mut run = Run::of(problem, settings);
    let mut outcome = Outcome::Capped;
    for increment in 1..=settings.increments {
        outcome = run.increment(increment, algorithm, springs)?;
        run.keep(increment, outcome);
        if outcome != Outcome::Converged {
            break;
        }
    }
    Ok(run.solution(outcome))
}

struct Run<'a> {
    problem: &'a ContactProblem<'a>,
    settings: Settings,
    work: Work,
    history: Vec<Iterated>,
    increments: Vec<Increment>,
    last: Option<Iterate>,
    target: Option<Target>,
    rigid: Option<Target>,
}

/// What is remembered of the iterates of an increment.
#[derive(Default)]
struct Course {
    /// What is known of the discrete solution.
    known: Known,
    /// Latest states, the newest first.
    earlier: VecDeque<State>,
    /// Iterations in a row that changed next to nothing, and no more than round-off does.
    still: usize,
    noise: usize,
    /// Index of its first iteration in the history.
    first: usize,
    /// Least error of all but the last iterations that [`FALLS`] looks at, and how many they are.
    least: f64,
    counted: usize,
}

/// What is known of one increment.
#[derive(Default)]
struct Known {
    target: Option<Target>,
    /// Whether it was looked for.
    looked: bool,
    /// Iterates whose error is not yet known.
    waiting: Vec<Iterate>,
    pressed: Vec<bool>,
}

impl<'a> Run<'a> {
    fn of(problem: &'a ContactProblem, settings: Settings) -> Self {
        let (history, increments) = (Vec::new(), Vec::new());
        Self { problem, settings, work: Work::default(), history, increments, last: None, target: None, rigid: None }
    }

    /// Keeps the end of a load increment that is one of several.
    fn keep(&mut self, number: usize, outcome: Outcome) {
        let Some(last) = self.last.as_ref().filter(|_| self.settings.increments > 1) else { return };
        let states = target::told(self.problem, last);
        self.increments.push(Increment {
            number,
            outcome,
            iterations: self.history.iter().filter(|iteration| iteration.increment == number).count(),
            displacement: last.displacement.clone(),
            contact_force: contact_force(self.problem, &states),
            states,
        });
    }

    fn increment(
        &mut self,
        increment: usize,
        algorithm: &mut dyn Algorithm,
        springs: &mut Springs,
    ) -> Result<Outcome, Error> {
        let fraction = increment as f64 / self.settings.increments as f64;
        let load: Vec<f64> = self.problem.load.iter().map(|f| f * fraction).collect();
        let law = if algorithm.is_elastic() { Law::Springs } else { Law::Rigid };
        let mut course = Course { first: self.history.len(), least: f64::INFINITY, ..Course::default() };
        let mut outcome = Outcome::Capped;
        algorithm.reload(self.problem, springs);
        while self.work.iterations < self.settings.max_iterations {
            let stiffness = springs.stiffness[0];
            let Some(iterate) = algorithm.next(self.problem, &load, springs, &mut self.work) else {
                if springs.stiffness.iter().any(|k| !k.is_finite()) {
                    outcome = Outcome::Diverged;
                    break;
                }
                return Err(self.nothing_holds(springs));
            };
            self.work.iterations += 1;
            self.record(increment, &iterate, stiffness);
            let is_met = self.is_met();
            if !is_finite(&iterate) {
                self.last = Some(iterate);
                outcome = Outcome::Diverged;
                break;
            }
            self.judge(&mut course.known, &load, law, &iterate, is_met);
            let state = State::of(&iterate);
            self.last = Some(iterate);
            if let Some(ended) = self.ended(&mut course, state) {
                outcome = ended;
                break;
            }
        }
        if let (Law::Springs, Some(last)) = (law, &self.last) {
            self.rigid = Target::of(self.problem, &load, Law::Rigid, &target::pressed(self.problem, last));
        }
        self.target = course.known.target;
        Ok(outcome)
    }

    /// Whether the newest iteration meets a criterion that it shows itself.
    fn is_met(&self) -> bool {
        let seen = self.history.last().and_then(|iteration| self.settings.criterion.of(&iteration.seen));
        seen.is_some_and(|seen| seen <= self.settings.tolerance)
    }

    /// How the increment ends with its newest state; none where it goes on.
    fn ended(&self, course: &mut Course, state: State) -> Option<Outcome> {
        let error = self.history.last().map_or(f64::NAN, |iteration| iteration.error.largest());
        let within = error <= self.settings.tolerance;
        match self.settings.criterion {
            Criterion::Error if within => return Some(Outcome::Converged),
            _ if self.is_met() => return Some(if within { Outcome::Converged } else { Outcome::Stopped }),
            _ => {}
        }
        if let Some(period) = returned(&course.earlier, &state) {
            return Some(Outcome::Cycling { period });
        }
        // Errors are told a few iterations late: those before the last ones stand, and are counted once.
        let own = &self.history[course.first..];
        let (before, last) = own.split_at(own.len().saturating_sub(FALLS.0));
        course.least = course.least.min(least(&before[course.counted..]));
        course.counted = before.len();
        let newest = least(last);
        course.still = if changes_less(&course.earlier, &state, STILL.1) { course.still + 1 } else { 0 };
        course.noise = if changes_less(&course.earlier, &state, NOISE) { course.noise + 1 } else { 0 };
        let rests = course.noise >= FALLS.0 && newest >= (1.0 - FALLS.1) * course.least;
        if course.known.looked && (course.still >= STILL.0 || rests) {
            return Some(Outcome::Stalled);
        }
        if has_grown(last, course.least.min(newest)) {
            return Some(Outcome::Diverged);
        }
        course.earlier.push_front(state);
        course.earlier.truncate(MEMORY);
        None
    }

    /// Looks for the discrete solution once it is near, and tells the error of every iteration since.
    fn judge(&mut self, known: &mut Known, load: &[f64], law: Law, iterate: &Iterate, is_last: bool) {
        if known.target.is_none() && known.looked {
            return;
        }
        known.waiting.push(iterate.clone());
        if !known.looked {
            let pressed = target::pressed(self.problem, iterate);
            let is_last = is_last || self.work.iterations >= self.settings.max_iterations;
            known.looked = known.waiting.len() >= LOOK || pressed == known.pressed || is_last;
            known.pressed = pressed;
            if known.looked {
                known.target = Target::of(self.problem, load, law, &known.pressed);
            }
        }
        if let Some(target) = &known.target {
            let first = self.history.len() - known.waiting.len();
            for (iteration, iterate) in self.history[first..].iter_mut().zip(&known.waiting) {
                iteration.error = target.error(self.problem, iterate);
            }
            known.waiting.clear();
        }
    }

    /// Why no system of springs and bodies could be solved: springs that are lost in the round-off of S, or none left.
    fn nothing_holds(&self, springs: &Springs) -> Error {
        if self.work.iterations > 0 || springs.stiffness.iter().all(|k| *k <= 0.0) {
            let iterations = self.work.iterations;
            let message = format!(
                "only contact fixes the bodies, and no contact spring is left after iteration {iterations}: the load pulls the bodies apart, the start is too soft, or the contact is smaller than two elements"
            );
            let remedy = "reverse the load, add a support, raise the initial stiffness or refine the mesh";
            return Error { kind: Kind::NoSpringLeft { iterations }, ..Error::at(Place::Nowhere, message, remedy) };
        }
        let stiffer = |times: f64| springs.stiffness.iter().map(|k| k * times).collect::<Vec<_>>();
        let holds = |times: &f64| self.problem.factorise(&stiffer(*times), &mut Work::default()).is_some();
        let decades = (1..=DECADES).map(|k| 10f64.powi(k));
        let enough = decades.into_iter().find(holds).map(|times| times * MARGIN).unwrap_or(f64::NAN);
        let message = "only contact fixes the bodies, and the initial springs are lost in the round-off of the stiffness of the bodies";
        let remedy = format!("raise `stiffness` {enough:.0e} times");
        Error { kind: Kind::SpringsTooSoft, ..Error::at(Place::Nowhere, message, remedy) }
    }

    fn record(&mut self, increment: usize, iterate: &Iterate, stiffness: f64) {
        let mut active = 0;
        for own in parts::points(self.problem.points) {
            let pressures = || own.clone().map(|i| iterate.pressure[i]);
            let floor = self.settings.tolerance * pressures().fold(0.0, f64::max);
            active += pressures().filter(|p| *p > floor).count();
        }
        // The load of another increment moves what no iteration does.
        let again = self.history.last().is_some_and(|earlier| earlier.increment == increment);
        self.history.push(Iterated {
            increment,
            error: IterationError::UNKNOWN,
            seen: criterion::seen(self.problem, self.last.as_ref().filter(|_| again), iterate),
            active,
            first_point: [iterate.approach[0], iterate.pressure[0], stiffness],
        });
    }

    fn solution(self, outcome: Outcome) -> Solution {
        let points = self.problem.points;
        let n = self.problem.load.len();
        let nothing = || Iterate {
            displacement: vec![f64::NAN; n],
            approach: vec![f64::NAN; points.len()],
            pressure: vec![f64::NAN; points.len()],
            internal: vec![f64::NAN; n],
        };
        let last = self.last.unwrap_or_else(nothing);
        let states = target::told(self.problem, &last);
        let contact_force = contact_force(self.problem, &states);
        let ranges = parts::points(points).zip(parts::edges(self.problem.edges));
        let share = |(contact, (own, edges)): (usize, (Range<usize>, Range<usize>))| {
            let force: f64 = states.points[own.clone()].iter().map(|state| state.weight * state.pressure).sum();
            let target = self.target.as_ref().map(|target| target.approach(contact));
            let approach = target.unwrap_or(force * self.problem.compliance[contact]);
            let nodes = self.problem.edges.get(edges.start).map_or(0, |edge| edge.nodes);
            Share { points: own, edges, nodes, approach }
        };
        let contacts = ranges.enumerate().map(share).collect();
        let told = |target: &Option<Target>| -> Option<States> { target.as_ref().map(|t| t.told(self.problem)) };
        let rigid = self.rigid.as_ref().or(self.target.as_ref());
        Solution {
            outcome,
            energy: rigid.filter(|_| is_finite(&last)).and_then(|target| bound::of(self.problem, &target.exact, &last)),
            points: states.points,
            edges: states.edges,
            contacts,
            unseen: Vec::new(),
            round_off: self.problem.round_off(&last.displacement).iter().sum(),
            target: told(&self.target),
            rigid: told(&self.rigid),
            spring_pressures: last.pressure,
            displacement: last.displacement,
            contact_force,
            increments: self.increments,
            history: self.history,
            work: self.work,
        }
    }
}

/// Force of the contact on the retained dofs, `−Σ A p b` \[N\].
fn contact_force(problem: &ContactProblem, states: &States) -> Vec<f64> {
    let forces = parts::forces(problem.points, &states.points, problem.load.len());
    forces.into_iter().map(|force| -force).collect()
}

/// Whether every number of an iterate is one.
fn is_finite(iterate: &Iterate) -> bool {
    let all = iterate.pressure.iter().chain(&iterate.approach).chain(&iterate.displacement);
    all.into_iter().all(|x| x.is_finite())
}

/// Pressures and approaches after an iteration.
struct State([Vec<f64>; 2]);

impl State {
    fn of(iterate: &Iterate) -> Self {
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

/// Whether the last iteration changed no more than a share of the state.
fn changes_less(earlier: &VecDeque<State>, state: &State, share: f64) -> bool {
    earlier.front().is_some_and(|before| state.is_within(share, before))
}

/// The least error of some iterations; infinite where none is known.
fn least(iterations: &[Iterated]) -> f64 {
    iterations.iter().map(|iteration| iteration.error.largest()).fold(f64::INFINITY, f64::min)
}

/// Whether the error has grown far beyond its least, and stayed there.
fn has_grown(last: &[Iterated], least: f64) -> bool {
    let (iterations, times) = GROWN;
    let mut errors = last.iter().rev().take(iterations).map(|iteration| iteration.error.largest());
    last.len() > iterations && errors.all(|error| error > times * least)
}

/// Period after which the state has returned, while the last iteration itself did change it.
fn returned(earlier: &VecDeque<State>, state: &State) -> Option<usize> {
    if state.is_within(MOVING, earlier.front()?) {
        return None;
    }
    earlier.iter().position(|other| state.is_within(SAME, other)).map(|index| index + 1).filter(|&period| period >= 2)
}
