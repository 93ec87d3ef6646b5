//! Steps of constant stiffness: linearised on the final contact set, from the error of its start and not only its rate; and
//! what the projection of hard springs costs before that.

use faer::Mat;

use crate::algorithm::ContactProblem;
use crate::stability::{Limit, rate};

/// Doublings of the number of steps that are followed: a million steps.
const DOUBLINGS: usize = 20;

/// Steps in which the linear iteration `δr⁺ = M δr` of [`rate::correction`], started without carried forces,
/// `δr₀ = k₀ w* − p*`, brings penetration and the force of open points below a tolerance; infinite beyond a million.
///
/// Unlike `ln τ / ln ρ` it does not count modes that the start hardly holds or the residual hardly sees. M is squared again
/// and again, so that n steps cost log n products.
pub fn steps(problem: &ContactProblem, limit: &Limit, tolerance: f64) -> Option<f64> {
    let flexibility = rate::flexibility(problem, &problem.initial)?;
    let step = rate::correction_step(problem, &flexibility, &limit.closed);
    let each = problem.initial.iter().zip(&limit.approach).zip(&limit.pressure);
    let start: Vec<f64> = each.map(|((k, w), p)| k * w - p).collect();
    let start = Mat::from_fn(start.len(), 1, |i, _| start[i]);
    let left = |error: &Mat<f64>| residual(problem, limit, &flexibility, error, tolerance) > tolerance;
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

/// Steps `max k₀ g/p̄` over the closed points in which hard springs work off their gaps; p̄ is the mean pressure of the candidates.
///
/// Hard springs without a gap hold every candidate at w ≈ 0 with about p̄. As long as `k₀ g > p`, the rule wants less than
/// no force, and the projection `max(0, ·)` lets the carried force fall by no more than p a step: the gap opens by p/k₀.
pub fn worked_off(problem: &ContactProblem, limit: &Limit) -> f64 {
    let weights = || problem.points.iter().map(|point| point.weight);
    let mean = weights().zip(&limit.pressure).map(|(a, p)| a * p).sum::<f64>() / weights().sum::<f64>();
    let closed = (0..limit.closed.len()).filter(|&i| limit.closed[i]);
    closed.map(|i| problem.initial[i] * problem.points[i].gap / mean).fold(1.0, f64::max)
}

/// Largest penetration of a closed point over `g_ref`, or force of an open one over `p_ref`, that an error `δr` makes; open
/// points nearer than the tolerance owe nothing.
fn residual(problem: &ContactProblem, limit: &Limit, flexibility: &Mat<f64>, error: &Mat<f64>, tolerance: f64) -> f64 {
    let returned = flexibility * error;
    let scale = &problem.scale;
    let at = |i: usize| {
        let approach = -returned[(i, 0)];
        if limit.closed[i] {
            return approach.abs() / scale.gap;
        }
        let gap = problem.points[i].gap - limit.approach[i];
        let force = error[(i, 0)] + problem.initial[i] * approach;
        if gap > tolerance * scale.gap { force.abs() / scale.pressure } else { 0.0 }
    };
    (0..limit.closed.len()).map(at).fold(0.0, f64::max)
}
