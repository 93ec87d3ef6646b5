//! The loop: it alone counts, stops and decides how an iteration ended.

use std::ops::Range;

use crate::algorithm::ending::{State, Watch, unsolved};
use crate::algorithm::exact::Law;
use crate::algorithm::target::{self, Target};
use crate::algorithm::{Algorithm, ContactProblem, Criterion, Iterate, Springs};
use crate::algorithm::{bound, criterion, parts};
use crate::error::Error;
use crate::solution::{Increment, Iterated, IterationError, Outcome, Share, Solution, States, Work};

/// When to stop.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Settings {
    /// What shall fall below the tolerance.
    pub criterion: Criterion,
    /// Largest iteration error accepted: of peak, force, width and approach of every contact, over the discrete
    /// solution's own.
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

/// Iterations after which the discrete solution is looked for, unless the pressed points stood still before: from there
/// it is found in a few factorisations.
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

/// What is known of an increment.
#[derive(Default)]
struct Course {
    /// The discrete solution, and whether it was looked for.
    target: Option<Target>,
    looked: bool,
    /// Iterates whose error is not yet known, and the points that the last of them presses.
    waiting: Vec<Iterate>,
    pressed: Vec<bool>,
    /// What its states show of an end.
    watch: Watch,
    /// Index of its first iteration in the history.
    first: usize,
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
        let problem = &ContactProblem { load: &load, ..self.problem.clone() };
        let law = algorithm.law();
        let mut course = Course { first: self.history.len(), ..Course::default() };
        let mut outcome = Outcome::Capped;
        algorithm.reload(problem, springs);
        while self.work.iterations < self.settings.max_iterations {
            let stiffness = springs.stiffness[0];
            let Some(iterate) = algorithm.next(problem, springs, &mut self.work) else {
                if springs.stiffness.iter().any(|k| !k.is_finite()) {
                    outcome = Outcome::Diverged;
                    break;
                }
                return Err(unsolved(problem, springs, self.work.iterations));
            };
            self.work.iterations += 1;
            self.record(increment, &iterate, stiffness);
            let is_met = self.is_met();
            if !is_finite(&iterate) {
                self.last = Some(iterate);
                outcome = Outcome::Diverged;
                break;
            }
            self.judge(&mut course, problem, law, &iterate, is_met);
            let state = State::of(&iterate);
            self.last = Some(iterate);
            if let Some(ended) = self.ended(&mut course, state) {
                outcome = ended;
                break;
            }
        }
        if let (Law::Springs, Some(last)) = (law, &self.last) {
            self.rigid = Target::of(problem, Law::Rigid, &target::pressed(problem, last));
        }
        self.target = course.target;
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
        course.watch.ended(state, &self.history[course.first..], course.looked)
    }

    /// Looks for the discrete solution once it is near, and tells the error of every iteration since.
    fn judge(&mut self, course: &mut Course, problem: &ContactProblem, law: Law, iterate: &Iterate, is_last: bool) {
        if course.target.is_none() && course.looked {
            return;
        }
        course.waiting.push(iterate.clone());
        if !course.looked {
            let pressed = target::pressed(problem, iterate);
            let is_last = is_last || self.work.iterations >= self.settings.max_iterations;
            course.looked = course.waiting.len() >= LOOK || pressed == course.pressed || is_last;
            course.pressed = pressed;
            if course.looked {
                course.target = Target::of(problem, law, &course.pressed);
            }
        }
        if let Some(target) = &course.target {
            let first = self.history.len() - course.waiting.len();
            for (iteration, iterate) in self.history[first..].iter_mut().zip(&course.waiting) {
                iteration.error = target.error(problem, iterate);
            }
            course.waiting.clear();
        }
    }

    fn record(&mut self, increment: usize, iterate: &Iterate, stiffness: f64) {
        let active = parts::pressed(self.problem.points, &iterate.pressure, self.settings.tolerance);
        // The load of another increment moves what no iteration does.
        let again = self.history.last().is_some_and(|earlier| earlier.increment == increment);
        self.history.push(Iterated {
            increment,
            error: IterationError::UNKNOWN,
            seen: criterion::seen(self.problem, self.last.as_ref().filter(|_| again), iterate),
            active: active.into_iter().filter(|presses| *presses).count(),
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
