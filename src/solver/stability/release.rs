//! Varying stiffness: how many iterations the points near the contact edge take to find their pressure.
//!
//! Each is followed alone, with its own flexibility C on the final active set: `w = w* − C (p − p*)`. Its force changes
//! by the factor `w/g` at each iteration (`secant`), or by `max(p/w, k₀) (w − g)` (`correction`). A point that
//! ends open, `p* = 0`, lets go fast while `C p` holds it off, and at last by `w*/g` alone, which just outside the
//! contact is next to 1.

use crate::algorithm::{ContactProblem, StiffnessRule};
use crate::stability::{Limit, rate};

/// Iterations that are followed.
const STEPS: usize = 100_000;
/// The error is looked at again after so many more iterations, over those taken.
const LOOKS: f64 = 0.02;

/// Iterations until the iteration error of all points together falls below a tolerance; none where the limit's springs
/// do not hold the bodies.
pub fn iterations(problem: &ContactProblem, limit: &Limit, rule: StiffnessRule, tolerance: f64) -> Option<f64> {
    let target = limit.target(problem);
    let flexibility = rate::flexibility(problem, &target)?;
    // A spring at the ceiling does not move any more.
    let moving = |i: usize| !problem.scale.is_hard(target[i]) && limit.approach[i] > 0.0;
    let largest = limit.pressure.iter().copied().fold(0.0, f64::max);
    // What more force there was is gone in an iteration or two.
    let start = |i: usize| largest.min(limit.pressure[i] + 0.5 * limit.approach[i] / flexibility[(i, i)]);
    let mut pressure: Vec<f64> =
        (0..target.len()).map(|i| if moving(i) { start(i) } else { limit.pressure[i] }).collect();
    let approach = |i: usize, p: f64| limit.approach[i] - flexibility[(i, i)] * (p - limit.pressure[i]);
    let mut look = 0;
    for step in 0..STEPS {
        if step >= look {
            let approaches = pressure.iter().enumerate().map(|(i, p)| approach(i, *p)).collect();
            if limit.error(problem, pressure.clone(), approaches).largest() <= tolerance {
                return Some(1.0 + step as f64);
            }
            look = step + 1 + (LOOKS * step as f64) as usize;
        }
        for i in (0..target.len()).filter(|&i| moving(i)) {
            let (p, gap) = (pressure[i], problem.points[i].gap);
            let w = approach(i, p);
            pressure[i] = match rule {
                StiffnessRule::Correction => (p - (p / w).max(problem.initial[i]) * (gap - w)).max(0.0),
                _ => p * w / gap,
            };
        }
    }
    Some(STEPS as f64)
}
