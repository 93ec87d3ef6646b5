//! Element stiffness of the isoparametric quadrilaterals.

use nalgebra::Matrix2;

use crate::elasticity::{quadrature, shape_functions};
use crate::mesh::Order;

/// `k = ∫ Bᵀ D B t dA` [N/mm] of 4-node (2×2 Gauss) or 8-node cells (3×3 Gauss); freedoms are u_x, u_y node by node.
///
/// The slopes of the shape functions at the Gauss points are the same for all cells and tabulated once.
#[derive(Clone, Debug)]
pub struct CellStiffness {
    /// Slopes `[∂N_a/∂ξ, ∂N_a/∂η]` and weight at each Gauss point.
    rule: Vec<(Vec<[f64; 2]>, f64)>,
    elasticity: [[f64; 3]; 3],
    thickness: f64,
    order: Order,
    processor: pulp::Arch,
}

impl CellStiffness {
    /// For cells of an order, with the plane stiffness D \[MPa\] and the thickness \[mm\].
    pub fn new(order: Order, elasticity: &[[f64; 3]; 3], thickness: f64) -> Self {
        let points = match order {
            Order::Linear => 2,
            Order::Quadratic => 3,
        };
        let at = |(at, weight)| (slopes(order.nodes_per_cell(), at), weight);
        let rule = quadrature::gauss_square(points).into_iter().map(at).collect();
        Self { rule, elasticity: *elasticity, thickness, order, processor: pulp::Arch::new() }
    }

    /// Entries of the matrix of a cell: 8² or 16².
    pub fn entries(&self) -> usize {
        4 * self.order.nodes_per_cell().pow(2)
    }

    /// Writes `k` row by row for the nodes at some points.
    ///
    /// A Jacobian determinant that is not positive is returned as the error.
    pub fn integrate(&self, points: impl Iterator<Item = [f64; 2]>, k: &mut [f64]) -> Result<(), f64> {
        match self.order {
            Order::Linear => self.integrate_pairs::<4>(points, k),
            Order::Quadratic => self.integrate_pairs::<8>(points, k),
        }
    }

    fn integrate_pairs<const N: usize>(
        &self,
        mut points: impl Iterator<Item = [f64; 2]>,
        k: &mut [f64],
    ) -> Result<(), f64> {
        let points: [[f64; 2]; N] = std::array::from_fn(|_| points.next().unwrap_or([f64::NAN; 2]));
        let mut pairs = [[[[0.0; N]; 2]; 2]; N];
        self.processor.dispatch(AddPairs { kernel: self, points: &points, pairs: &mut pairs })?;
        for (row, pair) in k.chunks_exact_mut(2 * N).zip(pairs.as_flattened()) {
            for (entries, b) in row.chunks_exact_mut(2).zip(0..N) {
                (entries[0], entries[1]) = (pair[0][b], pair[1][b]);
            }
        }
        Ok(())
    }

    /// `k_ab = Σ B_aᵀ D B_b t w det J` as `pairs[a][component of a][component of b][b]`.
    ///
    /// D is the same throughout a cell and stands outside the sums: only the four `∫ N_a,i N_b,j t dA` of a pair of
    /// nodes are summed over the Gauss points, and combined with D once.
    #[inline(always)]
    fn add_pairs<const N: usize>(
        &self,
        points: &[[f64; 2]; N],
        pairs: &mut [[[[f64; N]; 2]; 2]; N],
    ) -> Result<(), f64> {
        let [[dxx, dxy, dxs], [dyx, dyy, dys], [dsx, dsy, dss]] = self.elasticity;
        let mut at_points = [AtPoint { x: [0.0; N], y: [0.0; N], area: 0.0 }; MOST_POINTS];
        for ((slopes, weight), at) in self.rule.iter().zip(&mut at_points) {
            let (inverse, determinant) = jacobian(slopes, points)?;
            at.area = weight * determinant * self.thickness;
            for ((x, y), slope) in at.x.iter_mut().zip(&mut at.y).zip(slopes) {
                [*x, *y] = gradient(&inverse, slope);
            }
        }
        for (a, pair) in pairs.iter_mut().enumerate() {
            let ([mut xx, mut xy], [mut yx, mut yy]) = ([[0.0; N]; 2], [[0.0; N]; 2]);
            for at in &at_points[..self.rule.len()] {
                let (x, y) = (at.area * at.x[a], at.area * at.y[a]);
                add_scaled(&mut xx, x, &at.x);
                add_scaled(&mut xy, x, &at.y);
                add_scaled(&mut yx, y, &at.x);
                add_scaled(&mut yy, y, &at.y);
            }
            // Strains B_a = (N_a,x, 0, N_a,y) of a displacement along x, (0, N_a,y, N_a,x) of one along y.
            let row = |xx_by: f64, xy_by: f64, yx_by: f64, yy_by: f64| -> [f64; N] {
                std::array::from_fn(|b| xx_by * xx[b] + xy_by * xy[b] + yx_by * yx[b] + yy_by * yy[b])
            };
            *pair = [
                [row(dxx, dxs, dsx, dss), row(dxs, dxy, dss, dsy)],
                [row(dsx, dss, dyx, dys), row(dss, dsy, dys, dyy)],
            ];
        }
        Ok(())
    }
}

/// The sums of a cell on registers as wide as the processor's own; a closure's call would be a function of its own, compiled
/// for the narrowest.
struct AddPairs<'a, const N: usize> {
    kernel: &'a CellStiffness,
    points: &'a [[f64; 2]; N],
    pairs: &'a mut [[[[f64; N]; 2]; 2]; N],
}

impl<const N: usize> pulp::WithSimd for AddPairs<'_, N> {
    type Output = Result<(), f64>;

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) -> Self::Output {
        self.kernel.add_pairs(self.points, self.pairs)
    }
}

/// Gauss points of the largest rule.
const MOST_POINTS: usize = 9;

/// At a Gauss point: gradients `N_a,x`, `N_a,y`, and `t w det J`.
#[derive(Clone, Copy)]
struct AtPoint<const N: usize> {
    x: [f64; N],
    y: [f64; N],
    area: f64,
}

/// `z ← z + a x`.
#[inline(always)]
fn add_scaled<const N: usize>(z: &mut [f64; N], a: f64, x: &[f64; N]) {
    for (z, x) in z.iter_mut().zip(x) {
        *z = a.mul_add(*x, *z);
    }
}

/// Gradients `[∂N_a/∂x, ∂N_a/∂y]` and the Jacobian determinant at (ξ, η); a determinant ≤ 0 or NaN is the error.
pub fn gradients(points: &[[f64; 2]], at: [f64; 2]) -> Result<(Vec<[f64; 2]>, f64), f64> {
    let slopes = slopes(points.len(), at);
    let (inverse, determinant) = jacobian(&slopes, points)?;
    Ok((slopes.iter().map(|slope| gradient(&inverse, slope)).collect(), determinant))
}

/// `[∂N_a/∂ξ, ∂N_a/∂η]`.
fn slopes(nodes: usize, at: [f64; 2]) -> Vec<[f64; 2]> {
    shape_functions::cell(nodes, at).into_iter().map(|(_, slope)| slope).collect()
}

/// Inverse and determinant of `J = [∂x/∂ξ, ∂y/∂ξ; ∂x/∂η, ∂y/∂η]`.
#[inline(always)]
fn jacobian(slopes: &[[f64; 2]], points: &[[f64; 2]]) -> Result<(Matrix2<f64>, f64), f64> {
    let mut jacobian = Matrix2::zeros();
    for (slope, point) in slopes.iter().zip(points) {
        jacobian += Matrix2::new(slope[0] * point[0], slope[0] * point[1], slope[1] * point[0], slope[1] * point[1]);
    }
    let determinant = jacobian.determinant();
    match jacobian.try_inverse() {
        Some(inverse) if determinant > 0.0 => Ok((inverse, determinant)),
        _ => Err(determinant),
    }
}

/// `∇N = J⁻¹ [∂N/∂ξ, ∂N/∂η]`.
#[inline(always)]
fn gradient(inverse: &Matrix2<f64>, slope: &[f64; 2]) -> [f64; 2] {
    [inverse[(0, 0)] * slope[0] + inverse[(0, 1)] * slope[1], inverse[(1, 0)] * slope[0] + inverse[(1, 1)] * slope[1]]
}
