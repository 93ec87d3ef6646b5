//! The loop: it alone counts, stops and decides how an iteration ended.

use std::collections::VecDeque;

use crate::algorithm::problem::reported;
use crate::algorithm::{Algorithm, ContactProblem, Iterate, Springs};
use crate::contact::ContactPoint;
use crate::error::Error;
use crate::solution::{Outcome, PointState, Residuals, Share, Solution, Step, Work};

/// When to stop.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    /// Largest residual accepted.
    pub tolerance: f64,
    /// Load increments.
    pub increments: usize,
    /// Steps over all increments.
    pub max_steps: usize,
}

impl Default for Settings {
    fn default() -> Self {
        Self { tolerance: 1e-3, increments: 1, max_steps: 2000 }
    }
}

/// A residual beyond this, or NaN, is divergence.
const DIVERGED: f64 = 1e6;
/// Two states closer than this are the same.
const SAME: f64 = 1e-10;
/// A step larger than this is still a step.
const MOVING: f64 = 1e-6;
/// Longest period looked for.
const MEMORY: usize = 64;

/// Applies the load in increments and lets the algorithm step until the residuals are within the tolerance.
///
/// Increment n of N applies `(n/N) f̂` and starts from the springs of the one before; the gap enters whole, once.
pub fn iterate(problem: &ContactProblem, algorithm: &mut dyn Algorithm, settings: Settings) -> Result<Solution, Error> {
    iterate_from(&mut problem.initial_springs(), problem, algorithm, settings)
}

/// The same from given springs, which are left as they stand after the last step.
pub fn iterate_from(
    springs: &mut Springs,
    problem: &ContactProblem,
    algorithm: &mut dyn Algorithm,
    settings: Settings,
) -> Result<Solution, Error> {
    let mut run = Run { problem, settings, work: Work::default(), history: Vec::new(), last: None };
    let mut outcome = Outcome::Exhausted;
    for increment in 1..=settings.increments {
        outcome = run.increment(increment, algorithm, springs)?;
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
    history: Vec<Step>,
    last: Option<Iterate>,
}

impl Run<'_> {
    fn increment(
        &mut self,
        increment: usize,
        algorithm: &mut dyn Algorithm,
        springs: &mut Springs,
    ) -> Result<Outcome, Error> {
        let fraction = increment as f64 / self.settings.increments as f64;
        let load: Vec<f64> = self.problem.load.iter().map(|f| f * fraction).collect();
        let mut earlier = VecDeque::new();
        algorithm.reload();
        while self.work.steps < self.settings.max_steps {
            let stiffness = springs.stiffness[0];
            let Some(iterate) = algorithm.step(self.problem, &load, springs, &mut self.work) else {
                if springs.stiffness.iter().any(|k| !k.is_finite()) {
                    return Ok(Outcome::Diverged);
                }
                return Err(Error::NoSpringLeft { bodies: "the bodies".into(), steps: self.work.steps });
            };
            self.work.steps += 1;
            let residuals = self.problem.residuals(&load, &iterate, algorithm.is_elastic());
            self.record(increment, residuals, &iterate, stiffness);
            let state = self.state(&iterate);
            self.last = Some(iterate);
            let largest = residuals.largest();
            if largest <= self.settings.tolerance {
                return Ok(Outcome::Converged);
            }
            if largest.is_nan() || largest > DIVERGED {
                return Ok(Outcome::Diverged);
            }
            if let Some(period) = returned(&earlier, &state) {
                return Ok(Outcome::Cycling { period });
            }
            earlier.push_front(state);
            earlier.truncate(MEMORY);
        }
        Ok(Outcome::Exhausted)
    }

    fn record(&mut self, increment: usize, residuals: Residuals, iterate: &Iterate, stiffness: f64) {
        let floor = self.settings.tolerance * self.problem.scale.pressure;
        self.history.push(Step {
            increment,
            residuals,
            active: iterate.pressure.iter().filter(|p| **p > floor).count(),
            first_point: [iterate.approach[0], iterate.pressure[0], stiffness],
        });
    }

    /// Pressures and gaps as pure numbers.
    fn state(&self, iterate: &Iterate) -> Vec<f64> {
        let scale = &self.problem.scale;
        let pressures = iterate.pressure.iter().map(|p| p / scale.pressure);
        pressures.chain(iterate.approach.iter().map(|w| w / scale.gap)).collect()
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
        let mut contact_force = vec![0.0; n];
        let states = points.iter().zip(&last.pressure).zip(&last.approach).map(|((point, p), w)| {
            let pressure = reported(*p);
            point.add_row(-point.weight * pressure, &mut contact_force);
            PointState { position: point.position, weight: point.weight, pressure, gap: point.gap - w }
        });
        let states: Vec<PointState> = states.collect();
        let (mut edges, mut contacts) = (Vec::new(), Vec::new());
        let mut first = 0;
        for group in points.chunk_by(|a, b| a.contact == b.contact) {
            let own = first..first + group.len();
            let means = edge_means(group, &states[own.clone()]);
            contacts.push(Share { points: own, edges: edges.len()..edges.len() + means.len() });
            edges.extend(means);
            first += group.len();
        }
        Solution {
            outcome,
            edges,
            contacts,
            points: states,
            spring_pressures: last.pressure,
            displacement: last.displacement,
            contact_force,
            history: self.history,
            work: self.work,
            coarser: Work::default(),
        }
    }
}

/// `p̄ = Σ A_ie p_i / Σ A_ie` over each edge e, from the parts of the points' areas that belong to it.
fn edge_means(points: &[ContactPoint], states: &[PointState]) -> Vec<PointState> {
    let count = points.iter().flat_map(|point| &point.shares).map(|(edge, _)| edge + 1).max().unwrap_or(0);
    let mut means = vec![PointState { position: 0.0, weight: 0.0, pressure: 0.0, gap: 0.0 }; count];
    for (point, state) in points.iter().zip(states) {
        for &(edge, area) in &point.shares {
            let mean = &mut means[edge];
            mean.weight += area;
            mean.position += area * state.position;
            mean.pressure += area * state.pressure;
            mean.gap += area * state.gap;
        }
    }
    for mean in &mut means {
        mean.position /= mean.weight;
        mean.pressure /= mean.weight;
        mean.gap /= mean.weight;
    }
    means
}

/// Period after which the state has returned, while the last step itself was a real one.
fn returned(earlier: &VecDeque<Vec<f64>>, state: &[f64]) -> Option<usize> {
    let size = state.iter().map(|x| x.abs()).fold(1.0, f64::max);
    let within = |other: &Vec<f64>, share: f64| other.iter().zip(state).all(|(a, b)| (a - b).abs() <= share * size);
    if within(earlier.front()?, MOVING) {
        return None;
    }
    earlier.iter().position(|other| within(other, SAME)).map(|index| index + 1).filter(|&period| period >= 2)
}
