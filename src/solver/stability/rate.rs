//! Asymptotic rates: the factor by which an error shrinks in an iteration, on the final active set.
//!
//! All follow from the flexibility of the contact, `C_ij = b_i (S + Σ A k b bᵀ)⁻¹ b_j A_j`: a unit of pressure carried
//! at point j lessens the approach of point i by `C_ij`. An iteration whose error obeys `δ⁺ = M δ` converges if and
//! only if the spectral radius `ρ(M)` is below 1, and then gains `−log₁₀ ρ` decades an iteration.

use faer::Mat;

use crate::algorithm::ContactProblem;
use crate::solution::Work;
use crate::stability::Limit;

/// Constant stiffness with fixed target springs `k*` and no gap, `(S + K₀) u⁺ = f̂ + (K₀ − K*) u`.
///
/// `M = I − (S + K₀)⁻¹ (S + K*)`, whose eigenvalues other than 0 are those of `C diag(k₀ − k*)`. It converges if and
/// only if `S + K* ≻ 0` and `S + 2K₀ − K* ≻ 0`. None where `S + K₀` is not positive definite.
pub fn fixed_target(problem: &ContactProblem, initial: &[f64], target: &[f64]) -> Option<f64> {
    let flexibility = flexibility(problem, initial)?;
    let n = initial.len();
    spectral_radius(&Mat::from_fn(n, n, |i, j| flexibility[(i, j)] * (initial[j] - target[j])))
}

/// Whether `S + Σ A k b bᵀ` is positive definite.
pub fn holds(problem: &ContactProblem, stiffness: &[f64]) -> bool {
    problem.factorise(stiffness, &mut Work::default()).is_some()
}

/// Constant stiffness with the rule `correction`, `κ = k₀`, on the final active set.
///
/// A closed point has `r⁺ = r + k₀ (w − g)`, an open one `r⁺ = −k₀ w`, and `δw = −C δr`:
/// `M = I − k₀ C` in the rows of closed points, `+k₀ C` in those of open ones.
///
/// Whatever the active set, `M = (I + Q (I − 2 k₀ C))/2` with `Q = ±1` on the diagonal. In the inner product weighted
/// with A/k₀ the eigenvalues of k₀ C lie between 0 and 1, so that neither factor lengthens an error: the iteration is
/// an averaged map (of the kind of Douglas and Rachford's): from no κ₀ > 0 does it diverge or cycle, it comes no
/// farther from a limit at any step, and it ends in one. Where more contact points than displacements let pressures be
/// that no displacement feels, that need not be the limit without them. All this is known before the contact is solved;
/// how fast it goes is not.
pub fn correction(problem: &ContactProblem, closed: &[bool]) -> Option<f64> {
    spectral_radius(&correction_step(problem, &flexibility(problem, &problem.initial)?, closed))
}

/// The matrix M of [`correction`].
pub(super) fn correction_step(problem: &ContactProblem, flexibility: &Mat<f64>, closed: &[bool]) -> Mat<f64> {
    let n = closed.len();
    Mat::from_fn(n, n, |i, j| {
        let returned = problem.initial[i] * flexibility[(i, j)];
        let unit = if i == j { 1.0 } else { 0.0 };
        if closed[i] { unit - returned } else { returned }
    })
}

/// Constant stiffness with the rule `secant`, `p⁺ = p max(w, 0)/g`, at its limit.
///
/// A closed point has `r⁺ = r + p (w/g − 1)`, so that `M = I − diag(k*) C` with `k* = p/g`: it converges if and only if
/// `2 (S + K₀) − K* ≻ 0` on the closed points, in effect `k₀ ≥ k*/2`. In an open one `M = diag(w/g) + (1 − w/g) k₀ C`.
/// A point that starts closed, `g = 0`, asks for the ceiling of k*: no start below half of that converges.
pub fn secant_force(problem: &ContactProblem, limit: &Limit) -> Option<f64> {
    let flexibility = flexibility(problem, &problem.initial)?;
    let n = limit.closed.len();
    let gap = |i: usize| problem.scale.above_zero(problem.points[i].gap);
    let target = |i: usize| problem.scale.clip(limit.pressure[i] / gap(i));
    spectral_radius(&Mat::from_fn(n, n, |i, j| {
        let unit = if i == j { 1.0 } else { 0.0 };
        if limit.closed[i] {
            return unit - target(i) * flexibility[(i, j)];
        }
        let ratio = limit.approach[i].max(0.0) / gap(i);
        ratio * unit + (1.0 - ratio) * problem.initial[i] * flexibility[(i, j)]
    }))
}

/// Varying stiffness with the rule `correction`, `p⁺ = max(0, p + max(k, k₀) (w − g))`, `k⁺ = p⁺/w`, at its
/// limit.
///
/// A closed point has `δk⁺ = δk + (κ/w) δw` and `δw = −C diag(w) δk` with C at the springs `k* = p/w`: up to a
/// similarity `M = I − diag(κ) C`. It converges if and only if `2 (S + K*) − K ≻ 0` on the closed points,
/// `K = max(K*, K₀)`: near the contact edge, where k* → 0, `k₀` must stay below about twice the stiffness of the
/// bodies. An open point stops at once.
pub fn varying_correction(problem: &ContactProblem, limit: &Limit) -> Option<f64> {
    let target = limit.target(problem);
    let flexibility = flexibility(problem, &target)?;
    let closed: Vec<usize> = (0..target.len()).filter(|&i| limit.closed[i]).collect();
    spectral_radius(&Mat::from_fn(closed.len(), closed.len(), |i, j| {
        let (i, j) = (closed[i], closed[j]);
        let unit = if i == j { 1.0 } else { 0.0 };
        unit - problem.scale.clip(target[i]).max(problem.initial[i]) * flexibility[(i, j)]
    }))
}

/// Varying stiffness with the rule `secant`, `k⁺ = k w/g`, at its limit: stiffnesses `k` and approaches `w`.
///
/// `δk⁺ = (w/g) δk + (k/g) δw` and `δw = −C diag(w) δk`: `M = diag(w/g) − diag(k/g) C diag(w)`. A point outside the
/// contact (k → 0) contributes its own `w/g < 1`; one at the ceiling does not move, and where the gap left, `g − w`, is
/// no more than `slack`, nothing is left to iterate away.
pub fn secant(problem: &ContactProblem, stiffness: &[f64], approach: &[f64], slack: f64) -> Option<f64> {
    let flexibility = flexibility(problem, stiffness)?;
    let n = stiffness.len();
    let scale = &problem.scale;
    spectral_radius(&Mat::from_fn(n, n, |i, j| {
        let near = stiffness[i] <= 0.0 && problem.points[i].gap - approach[i] <= slack;
        if near || scale.is_hard(stiffness[i]) {
            return 0.0;
        }
        let gap = scale.above_zero(problem.points[i].gap);
        let own = if i == j { approach[i].max(0.0) / gap } else { 0.0 };
        own - stiffness[i] / gap * flexibility[(i, j)] * approach[j]
    }))
}

/// Rate of varying stiffness with `secant` before anything is solved: `w/g` of Hertz's contact at a place
/// `ξ = x/a > 1`.
///
/// Outside the contact Hertz's gap is `g − w = g (ξ √(ξ² − 1) − arcosh ξ)/ξ²`, `g = x²/2R` (Johnson 1985, §4.2). The
/// slowest spring to let go is the one next to the contact edge.
pub fn outside_hertz(place: f64) -> f64 {
    1.0 - (place * (place * place - 1.0).sqrt() - place.acosh()) / (place * place)
}

/// Iterations `ln τ / ln ρ` in which an error of order 1 falls below τ; infinite where it does not shrink.
pub fn iterations(rate: f64, tolerance: f64) -> f64 {
    if rate < 1.0 { (tolerance.ln() / rate.ln()).max(1.0) } else { f64::INFINITY }
}

/// The flexibility of the contact with some springs; none where the matrix is not positive definite.
pub(super) fn flexibility(problem: &ContactProblem, stiffness: &[f64]) -> Option<Mat<f64>> {
    Some(problem.flexibility(&problem.factorise(stiffness, &mut Work::default())?))
}

/// Largest modulus of the eigenvalues.
fn spectral_radius(matrix: &Mat<f64>) -> Option<f64> {
    let eigenvalues = matrix.eigenvalues().ok()?;
    Some(eigenvalues.iter().map(|value| value.re.hypot(value.im)).fold(0.0, f64::max))
}
