//! Asymptotic rates: the factor by which an error shrinks in a step, on the final contact set.
//!
//! All three follow from the flexibility of the contact, `C_ij = b_i (S + Σ A k b bᵀ)⁻¹ b_j A_j`: a unit of pressure carried at
//! point j lessens the approach of point i by `C_ij`. An iteration whose error obeys `δ⁺ = M δ` converges if and only if the
//! spectral radius `ρ(M)` is below 1, and then gains `−log₁₀ ρ` decades a step.

use faer::Mat;

use crate::algorithm::ContactProblem;
use crate::solution::Work;

/// Constant stiffness with fixed target springs `k*` and no gap, `(S + K₀) u⁺ = f̂ + (K₀ − K*) u`.
///
/// `M = I − (S + K₀)⁻¹ (S + K*)`, whose eigenvalues other than 0 are those of `C diag(k₀ − k*)`. It converges if and only if
/// `S + K* ≻ 0` and `S + 2K₀ − K* ≻ 0`. None where `S + K₀` is not positive definite.
pub fn fixed_target(problem: &ContactProblem, initial: &[f64], target: &[f64]) -> Option<f64> {
    let flexibility = flexibility(problem, initial)?;
    let n = initial.len();
    spectral_radius(&Mat::from_fn(n, n, |i, j| flexibility[(i, j)] * (initial[j] - target[j])))
}

/// Whether `S + Σ A k b bᵀ` is positive definite.
pub fn holds(problem: &ContactProblem, stiffness: &[f64]) -> bool {
    problem.factorise(stiffness, &mut Work::default()).is_some()
}

/// Constant stiffness with the rule `correction`, `κ = k₀`, on the final contact set.
///
/// A closed point has `r⁺ = r + k₀ (w − g)`, an open one `r⁺ = −k₀ w`, and `δw = −C δr`:
/// `M = I − k₀ C` in the rows of closed points, `+k₀ C` in those of open ones.
pub fn correction(problem: &ContactProblem, closed: &[bool]) -> Option<f64> {
    let flexibility = flexibility(problem, &problem.initial)?;
    let n = closed.len();
    spectral_radius(&Mat::from_fn(n, n, |i, j| {
        let returned = problem.initial[i] * flexibility[(i, j)];
        let unit = if i == j { 1.0 } else { 0.0 };
        if closed[i] { unit - returned } else { returned }
    }))
}

/// Varying stiffness with the rule `secant`, `k⁺ = k w/g`, at its limit: stiffnesses `k` and approaches `w`.
///
/// `δk⁺ = (w/g) δk + (k/g) δw` and `δw = −C diag(w) δk`: `M = diag(w/g) − diag(k/g) C diag(w)`. A point outside the contact
/// (k → 0) contributes its own `w/g < 1`; one at the ceiling does not move.
pub fn secant(problem: &ContactProblem, stiffness: &[f64], approach: &[f64]) -> Option<f64> {
    let flexibility = flexibility(problem, stiffness)?;
    let n = stiffness.len();
    let scale = &problem.scale;
    spectral_radius(&Mat::from_fn(n, n, |i, j| {
        if stiffness[i] >= scale.hard() {
            return 0.0;
        }
        let gap = scale.above_zero(problem.points[i].gap);
        let own = if i == j { approach[i].max(0.0) / gap } else { 0.0 };
        own - stiffness[i] / gap * flexibility[(i, j)] * approach[j]
    }))
}

/// `C_ij = b_i (S + Σ A k b bᵀ)⁻¹ b_j A_j` [mm/MPa]; none where the matrix is not positive definite.
fn flexibility(problem: &ContactProblem, stiffness: &[f64]) -> Option<Mat<f64>> {
    let factor = problem.factorise(stiffness, &mut Work::default())?;
    let n = problem.points.len();
    let mut flexibility = Mat::zeros(n, n);
    for (j, point) in problem.points.iter().enumerate() {
        let mut force = vec![0.0; problem.load.len()];
        point.add_row(point.weight, &mut force);
        let moved = factor.solve(&force);
        for (i, other) in problem.points.iter().enumerate() {
            flexibility[(i, j)] = other.approach(&moved);
        }
    }
    Some(flexibility)
}

/// Largest modulus of the eigenvalues.
fn spectral_radius(matrix: &Mat<f64>) -> Option<f64> {
    let eigenvalues = matrix.eigenvalues().ok()?;
    Some(eigenvalues.iter().map(|value| value.re.hypot(value.im)).fold(0.0, f64::max))
}
