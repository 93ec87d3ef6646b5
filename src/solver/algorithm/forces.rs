//! Constant stiffness by Newton's method, on the forces that its springs carry.
//!
//! With the factor that all iterations share, `C = B (S + BᵀA K₀ B)⁻¹ Bᵀ`, a change of the carried forces r changes
//! approaches and pressures by
//!
//! `dw = −C A dr`, `dp = dr + k₀ dw = Q dr`, `Q = 1 − K₀ C A`,
//!
//! whatever k₀ is. What is sought is `p = p⁺`, `p⁺ = max(0, p + c (w − g))`, the contact conditions in one equation for
//! any c > 0. Where p⁺ is positive a step closes the point, elsewhere it takes the pressure away:
//!
//! `c C A dr + δ Q dr = c (w − g)` (closed), `Q dr = −p` (open):
//!
//! the semismooth Newton method, which is the primal–dual active set strategy (Hintermüller, Ito & Kunisch 2003),
//! damped by what is left of the residual, since points on a fine side that face a coarser one press in ways that no
//! body feels. There is one factorisation as without it; a step solves a system of the size of the contact.

use faer::linalg::solvers::Solve;
use faer::{Col, Mat};

use crate::algorithm::{ContactProblem, Iterate, StiffnessUnit};
use crate::condensation::stiffness::SystemFactor;
use crate::solution::Work;

/// Largest damping: δ is this times the root of `‖p⁺ − p‖/‖p‖`, in the norm `‖p‖² = Σ A p²/c`. With the residual itself
/// in place of its root, steps along pressures that no body feels are residual over damping: of order one, however
/// small both are.
const DAMPING: f64 = 1e-2;

/// What springs and bodies yield together, the same for all iterations.
#[derive(Clone, Debug)]
pub struct Forces {
    /// `C A`: approach of a point by the pressure on another [mm/MPa].
    yields: Mat<f64>,
    /// c: what bodies resist [MPa/mm].
    resists: Vec<f64>,
}

impl Forces {
    /// A back-substitution for each point.
    pub fn of(problem: &ContactProblem, factor: &SystemFactor, work: &mut Work) -> Self {
        let (m, n) = (problem.points.len(), problem.load.len());
        work.back_substitutions += m;
        work.operations += (2 * m) as f64 * (n as f64).powi(2);
        Self { yields: problem.flexibility(factor), resists: StiffnessUnit::Bodies.of(problem) }
    }

    /// Change of the carried forces; none where no point is to be closed, or the step is not finite.
    pub fn step(&self, problem: &ContactProblem, iterate: &Iterate, work: &mut Work) -> Option<Vec<f64>> {
        let (points, c, p) = (problem.points, &self.resists, &iterate.pressure);
        let m = points.len();
        let opening: Vec<f64> = (0..m).map(|i| c[i] * (iterate.approach[i] - points[i].gap)).collect();
        let closed = |i: usize| p[i] + opening[i] > 0.0;
        if !(0..m).any(closed) {
            return None;
        }
        let residual = |i: usize| if closed(i) { opening[i] } else { -p[i] };
        let norm = |of: &dyn Fn(usize) -> f64| (0..m).map(|i| points[i].weight / c[i] * of(i).powi(2)).sum::<f64>();
        let damping = DAMPING * (norm(&residual) / norm(&|i| p[i])).powf(0.25).min(1.0);
        let matrix = Mat::from_fn(m, m, |i, j| {
            let yields = self.yields[(i, j)];
            let changes = f64::from(u8::from(i == j)) - problem.initial[i] * yields;
            if closed(i) { c[i] * yields + damping * changes } else { changes }
        });
        work.operations += 2.0 / 3.0 * (m as f64).powi(3);
        let step = matrix.partial_piv_lu().solve(&Col::from_fn(m, residual));
        let step: Vec<f64> = step.iter().copied().collect();
        step.iter().all(|change| change.is_finite()).then_some(step)
    }
}
