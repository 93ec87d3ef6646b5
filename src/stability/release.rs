//! Varying stiffness: how many steps the points near the contact edge take to find their pressure.
//!
//! Each is followed alone, with its own flexibility C on the final contact set: `w = w* − C (p − p*)`. Its force changes by the
//! factor `w/g` at each step (`secant`), or by `κ (w − g)`, `κ = max(p/w, k₀)` (`correction`). A point that ends open,
//! `p* = 0`, lets go fast while `C p` holds it off, and at last by `w*/g` alone, which just outside the contact is next to 1.

use crate::algorithm::{ContactProblem, StiffnessRule};
use crate::stability::{Limit, rate};

/// Steps that are followed.
const STEPS: usize = 1_000_000;

/// Steps until every point carries less than `τ p_ref` or is off its surface by less than `τ g_ref`; none where the limit's
/// springs do not hold the bodies.
pub fn steps(problem: &ContactProblem, limit: &Limit, rule: StiffnessRule, tolerance: f64) -> Option<f64> {
    let target = limit.target(problem);
    let flexibility = rate::flexibility(problem, &target)?;
    // A spring at the ceiling does not move any more.
    let moving = (0..target.len()).filter(|&i| target[i] < problem.scale.hard() && limit.approach[i] > 0.0);
    let slowest = moving.map(|i| one_point(problem, limit, i, flexibility[(i, i)], rule, tolerance)).max();
    Some(1.0 + slowest.unwrap_or(0) as f64)
}

/// Steps of one point with the flexibility C [mm/MPa].
fn one_point(
    problem: &ContactProblem,
    limit: &Limit,
    i: usize,
    flexibility: f64,
    rule: StiffnessRule,
    tolerance: f64,
) -> usize {
    let (scale, gap) = (&problem.scale, problem.points[i].gap);
    // What more force there was is gone in a step or two.
    let mut pressure = scale.pressure.min(limit.pressure[i] + 0.5 * limit.approach[i] / flexibility);
    for step in 0..STEPS {
        let approach = limit.approach[i] - flexibility * (pressure - limit.pressure[i]);
        let off = gap - approach;
        if pressure <= tolerance * scale.pressure || off <= tolerance * scale.gap {
            return step;
        }
        pressure = match rule {
            StiffnessRule::Correction => pressure - (pressure / approach).max(problem.initial[i]) * off,
            _ => pressure * approach / gap,
        };
    }
    STEPS
}
