//! Element stiffness of the isoparametric quadrilaterals.

use nalgebra::{Matrix2, Matrix3, SMatrix};

use crate::elasticity::{quadrature, shape_functions};

/// `k = ∫ Bᵀ D B t dA` [N/mm] of a 4-node (2×2 Gauss) or an 8-node cell (3×3 Gauss); freedoms are u_x, u_y node by node.
///
/// A Jacobian determinant that is not positive is returned as the error.
pub fn stiffness(points: &[[f64; 2]], elasticity: &[[f64; 3]; 3], thickness: f64) -> Result<Vec<Vec<f64>>, f64> {
    if points.len() == 4 {
        integrate::<8>(points, elasticity, thickness, 2)
    } else {
        integrate::<16>(points, elasticity, thickness, 3)
    }
}

fn integrate<const F: usize>(
    points: &[[f64; 2]],
    elasticity: &[[f64; 3]; 3],
    thickness: f64,
    rule: usize,
) -> Result<Vec<Vec<f64>>, f64> {
    let d = Matrix3::from_fn(|i, j| elasticity[i][j]);
    let mut k = SMatrix::<f64, F, F>::zeros();
    for (at, weight) in quadrature::gauss_square(rule) {
        let (gradients, determinant) = gradients(points, at)?;
        let mut b = SMatrix::<f64, 3, F>::zeros();
        for (a, [x, y]) in gradients.into_iter().enumerate() {
            b[(0, 2 * a)] = x;
            b[(1, 2 * a + 1)] = y;
            b[(2, 2 * a)] = y;
            b[(2, 2 * a + 1)] = x;
        }
        k += b.transpose() * (d * b) * (weight * determinant * thickness);
    }
    Ok((0..F).map(|i| k.row(i).iter().copied().collect()).collect())
}

/// Gradients `[∂N_a/∂x, ∂N_a/∂y]` and the Jacobian determinant at (ξ, η); a determinant ≤ 0 or NaN is the error.
pub fn gradients(points: &[[f64; 2]], at: [f64; 2]) -> Result<(Vec<[f64; 2]>, f64), f64> {
    let shapes = shape_functions::cell(points.len(), at);
    let mut jacobian = Matrix2::zeros();
    for ((_, slope), point) in shapes.iter().zip(points) {
        jacobian += Matrix2::new(slope[0] * point[0], slope[0] * point[1], slope[1] * point[0], slope[1] * point[1]);
    }
    let determinant = jacobian.determinant();
    let inverse = match jacobian.try_inverse() {
        Some(inverse) if determinant > 0.0 => inverse,
        _ => return Err(determinant),
    };
    let gradients = shapes.iter().map(|(_, s)| {
        [inverse[(0, 0)] * s[0] + inverse[(0, 1)] * s[1], inverse[(1, 0)] * s[0] + inverse[(1, 1)] * s[1]]
    });
    Ok((gradients.collect(), determinant))
}
