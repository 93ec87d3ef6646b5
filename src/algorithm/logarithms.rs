//! Acceleration of varying stiffness, on the logarithms of the stiffnesses that press.
//!
//! Linearised at the solution, `k ← k w/g` is `1 − μ` on `d(ln k)`, μ the eigenvalues of `K^½ C K^½` with
//! `C = B (S + BᵀKB)⁻¹ Bᵀ`. Two Gauss points on an edge carry a family of differences within edges that the bodies feel only
//! through their change from edge to edge: a one-dimensional Laplacian, whose μ fall with the square of the number of edges.
//! The iteration takes as many times longer, whatever κ₀; Anderson acceleration sees through it.

use crate::algorithm::acceleration::{Acceleration, History, dot};
use crate::algorithm::parts;
use crate::algorithm::{ContactProblem, Iterate};

/// Pressure over the largest of its contact above which a point takes part: below, k falls without end, and ln k has no fixed point.
const PRESSES: f64 = 1e-4;
/// Approach over the gap above which a point takes part: below, w/g is far from the 1 that it tends to where it presses.
const NEAR: f64 = 0.5;
/// Iterations for which the points that take part must have stood: of 1, 2, 4 and 8 all converge from every start, and four leave
/// the first iterations, which move the edge of the contact, to the rule.
const STOOD: usize = 4;
/// Largest change of ln k in an accelerated iteration: a factor e.
const LONGEST: f64 = 1.0;
/// Growth of the residual in an accelerated iteration by which the states before it are forgotten, for a plain one.
const GROWN: f64 = 2.0;

/// The last logarithms, and for how long the points that take part have stood.
#[derive(Clone, Debug)]
pub struct Logarithms {
    history: History,
    pressing: Vec<bool>,
    stood: usize,
    /// Residual of the iteration before, in the norm of its own pressures.
    size: f64,
}

impl Logarithms {
    /// Nothing remembered yet.
    pub fn new(kind: Acceleration) -> Self {
        Self { history: History::new(kind), pressing: Vec::new(), stood: 0, size: f64::INFINITY }
    }

    /// Changes the stiffnesses that the rule made of those `before` where points have pressed for long enough; adds to `rejected`
    /// where the states before led astray.
    pub fn accelerate(
        &mut self,
        problem: &ContactProblem,
        iterate: &Iterate,
        before: &[f64],
        stiffness: &mut [f64],
        rejected: &mut usize,
    ) {
        let pressing = pressing(problem, iterate);
        if pressing != self.pressing {
            (self.pressing, self.stood, self.size) = (pressing, 0, f64::INFINITY);
            self.history.keep(0);
            return;
        }
        self.stood += 1;
        if self.stood < STOOD {
            return;
        }
        let own: Vec<usize> = (0..stiffness.len()).filter(|&i| self.pressing[i]).collect();
        let weights: Vec<f64> = own.iter().map(|&i| problem.points[i].weight * iterate.pressure[i]).collect();
        let x: Vec<f64> = own.iter().map(|&i| before[i].ln()).collect();
        let f: Vec<f64> = own.iter().zip(&x).map(|(&i, x)| stiffness[i].ln() - x).collect();
        let size = (dot(&weights, &f, &f) / weights.iter().sum::<f64>()).sqrt();
        if size > GROWN * self.size {
            *rejected += 1;
            self.history.keep(0);
        }
        self.size = size;
        self.history.push(&x, &f);
        let Some(step) = self.history.step(&weights) else { return };
        for (&i, step) in own.iter().zip(step) {
            stiffness[i] = problem.scale.clip(before[i] * step.clamp(-LONGEST, LONGEST).exp());
        }
    }
}

/// The points that take part.
fn pressing(problem: &ContactProblem, iterate: &Iterate) -> Vec<bool> {
    let mut pressing = vec![false; problem.points.len()];
    for own in parts::points(problem.points) {
        let largest = own.clone().map(|i| iterate.pressure[i]).fold(0.0, f64::max);
        own.for_each(|i| {
            pressing[i] = iterate.pressure[i] > PRESSES * largest && iterate.approach[i] > NEAR * problem.points[i].gap;
        });
    }
    pressing
}
