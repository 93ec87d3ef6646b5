//! Iterations of constant stiffness: linearised on the final active set, from the error of its start and not only its
//! rate; and what the projection of hard springs costs before that.

use faer::Mat;

use crate::algorithm::ContactProblem;
use crate::solution::IterationError;
use crate::stability::{Limit, rate};

/// Doublings of the number of iterations that are followed: a million iterations.
const DOUBLINGS: usize = 20;

/// Iterations in which the linear iteration `δr⁺ = M δr` of [`rate::correction`], started without carried forces,
/// `δr₀ = k₀ w* − p*`, brings a part of the iteration error below a tolerance; infinite beyond a million.
///
/// Unlike `ln τ / ln ρ` it does not count modes that the start hardly holds or the error hardly sees. M is squared
/// again and again, so that n iterations cost log n products.
pub fn iterations(
    problem: &ContactProblem,
    limit: &Limit,
    part: fn(&IterationError) -> f64,
    tolerance: f64,
) -> Option<f64> {
    let flexibility = rate::flexibility(problem, &problem.initial)?;
    let step = rate::correction_step(problem, &flexibility, &limit.closed);
    let each = problem.initial.iter().zip(&limit.approach).zip(&limit.pressure);
    let start: Vec<f64> = each.map(|((k, w), p)| k * w - p).collect();
    let start = Mat::from_fn(start.len(), 1, |i, _| start[i]);
    let left = |error: &Mat<f64>| part(&error_of(problem, limit, &flexibility, error)) > tolerance;
    if !left(&start) {
        return Some(1.0);
    }
    let mut powers = vec![step];
    while left(&(&powers[powers.len() - 1] * &start)) {
        if powers.len() > DOUBLINGS {
            return Some(f64::INFINITY);
        }
        let last = &powers[powers.len() - 1];
        powers.push(last * last);
    }
    let (mut error, mut taken) = (start, 0_usize);
    for (k, power) in powers.iter().enumerate().rev() {
        let further = power * &error;
        if left(&further) {
            (error, taken) = (further, taken + (1 << k));
        }
    }
    Some((taken + 2) as f64)
}

/// Iterations `max k₀ g/p̄` over the closed points in which hard springs work off their gaps; p̄ is the mean pressure
/// of the candidates.
///
/// Hard springs without a gap hold every candidate at w ≈ 0 with about p̄. As long as `k₀ g > p`, the rule wants less
/// than no force, and the projection `max(0, ·)` lets the carried force fall by no more than p an iteration: the gap
/// opens by p/k₀.
pub fn worked_off(problem: &ContactProblem, limit: &Limit) -> f64 {
    let weights = || problem.points.iter().map(|point| point.weight);
    let mean = weights().zip(&limit.pressure).map(|(a, p)| a * p).sum::<f64>() / weights().sum::<f64>();
    let closed = (0..limit.closed.len()).filter(|&i| limit.closed[i]);
    closed.map(|i| problem.initial[i] * problem.points[i].gap / mean).fold(1.0, f64::max)
}

/// The iteration error that an error `δr` of the carried forces makes: `δw = −C δr`, `δp = δr + k₀ δw`.
fn error_of(problem: &ContactProblem, limit: &Limit, flexibility: &Mat<f64>, error: &Mat<f64>) -> IterationError {
    let returned = flexibility * error;
    let approach: Vec<f64> = limit.approach.iter().enumerate().map(|(i, w)| w - returned[(i, 0)]).collect();
    let changed = |(i, p): (usize, &f64)| p + error[(i, 0)] - problem.initial[i] * returned[(i, 0)];
    limit.error(problem, limit.pressure.iter().enumerate().map(changed).collect(), approach)
}
