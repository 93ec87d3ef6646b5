//! Varying stiffness by Newton's method, on the logarithms of the stiffnesses that press.
//!
//! Linearised, `k ← k w/g` with springs of areas A is `ln(w/g) ← (1 − M) ln(w/g)` in the variables
//! `√(A k) w · ln(w/g)`, with `M = (A K)^½ C (A K)^½`, `C = B (S + BᵀA K B)⁻¹ Bᵀ` what springs and bodies yield
//! together; its eigenvalues μ lie between 0 and 1. Two Gauss points on an edge carry a family of differences within
//! edges that the bodies feel only through their change from edge to edge: a one-dimensional Laplacian, whose μ fall
//! with the square of the number of edges, and the iteration takes as many times longer, whatever κ₀. As M is known
//! from the factor at hand, the step of the rule is multiplied by
//!
//! `(1 + δ) (M + δ)⁻¹`:
//!
//! the step of the rule itself where μ = 1, that of Newton's method where μ ≫ δ, and never more than `1 + 1/δ` times
//! the rule's. δ is the residual itself, the root mean square of `ln(w/g)` weighted by the forces: Levenberg's damping
//! in the form that keeps Newton's rate where M is singular (Yamashita & Fukushima 2001), as it is where points on a
//! fine side face a coarser one.

use nalgebra::{DMatrix, DVector};

use crate::algorithm::parts;
use crate::algorithm::{ContactProblem, Iterate};
use crate::condensation::stiffness::SystemFactor;
use crate::solution::Work;

/// Pressure over the largest of its contact above which a point takes part: below, k falls without end, and ln k has no
/// fixed point.
const PRESSES: f64 = 1e-4;
/// Approach over the gap above which a point takes part: below, w/g is far from the 1 that it tends to where it
/// presses.
const NEAR: f64 = 0.5;
/// Iterations for which the points that take part must have stood: the first ones, which move the edge of the contact,
/// are left to the rule.
pub const STOOD: usize = 4;
/// Largest change of ln k in an iteration: a factor e.
const LONGEST: f64 = 1.0;
/// Growth of the residual in an iteration after which one is left to the rule.
const GROWN: f64 = 2.0;

/// Which points take part, and for how long they have stood.
#[derive(Clone, Debug)]
pub struct Logarithms {
    pressing: Vec<bool>,
    stood: usize,
    /// Residual of the iteration before, in the norm of its own pressures.
    size: f64,
}

impl Default for Logarithms {
    fn default() -> Self {
        Self { pressing: Vec::new(), stood: 0, size: f64::INFINITY }
    }
}

impl Logarithms {
    /// Changes the stiffnesses that the rule made of those `before` where points have pressed for long enough; counts
    /// as rejected where the step before led astray.
    pub fn step(
        &mut self,
        (problem, factor): (&ContactProblem, &SystemFactor),
        iterate: &Iterate,
        before: &[f64],
        stiffness: &mut [f64],
        work: &mut Work,
    ) {
        let pressing = pressing(problem, iterate);
        if pressing != self.pressing {
            *self = Self { pressing, ..Self::default() };
            return;
        }
        self.stood += 1;
        if self.stood < STOOD {
            return;
        }
        let own: Vec<usize> = (0..stiffness.len()).filter(|&i| self.pressing[i]).collect();
        let force = |i: usize| problem.points[i].weight * iterate.pressure[i];
        let residual: Vec<f64> = own.iter().map(|&i| (stiffness[i] / before[i]).ln()).collect();
        let squares: f64 = own.iter().zip(&residual).map(|(&i, f)| force(i) * f * f).sum();
        let size = (squares / own.iter().map(|&i| force(i)).sum::<f64>()).sqrt();
        let grown = size > GROWN * self.size;
        self.size = size;
        if grown {
            work.rejected += 1;
            return;
        }
        let matrix = damped(problem, factor, &own, before, size, work);
        let scales: Vec<f64> =
            own.iter().map(|&i| (problem.points[i].weight * before[i]).sqrt() * iterate.approach[i]).collect();
        let Some(matrix) = matrix.cholesky() else { return };
        let step = matrix.solve(&DVector::from_fn(own.len(), |j, _| scales[j] * residual[j]));
        for ((&i, step), scale) in own.iter().zip(step.iter()).zip(&scales) {
            let change = ((1.0 + size) * step / scale).clamp(-LONGEST, LONGEST);
            stiffness[i] = problem.scale.clip(before[i] * change.exp());
        }
    }
}

/// `M + δ` of some points, δ the damping: a back-substitution for each.
fn damped(
    problem: &ContactProblem,
    factor: &SystemFactor,
    own: &[usize],
    stiffness: &[f64],
    damping: f64,
    work: &mut Work,
) -> DMatrix<f64> {
    let (m, n) = (own.len(), problem.load.len());
    let roots: Vec<f64> = own.iter().map(|&i| (problem.points[i].weight * stiffness[i]).sqrt()).collect();
    let mut matrix = DMatrix::zeros(m, m);
    for j in 0..m {
        let mut unit = vec![0.0; n];
        problem.points[own[j]].add_row(1.0, &mut unit);
        let yields = factor.solve(&unit);
        for i in 0..m {
            matrix[(i, j)] = roots[i] * roots[j] * problem.points[own[i]].approach(&yields);
        }
        matrix[(j, j)] += damping;
    }
    work.back_substitutions += m;
    work.operations += (2 * m) as f64 * (n as f64).powi(2) + (m as f64).powi(3) / 3.0;
    matrix
}

/// The points that take part.
fn pressing(problem: &ContactProblem, iterate: &Iterate) -> Vec<bool> {
    let near = problem.points.iter().zip(&iterate.approach).map(|(point, w)| *w > NEAR * point.gap);
    let pressed = parts::pressed(problem.points, &iterate.pressure, PRESSES);
    pressed.into_iter().zip(near).map(|(presses, near)| presses && near).collect()
}
