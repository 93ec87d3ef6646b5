//! Element stiffness of the isoparametric quadrilaterals.

use std::f64::consts::TAU;

use nalgebra::Matrix2;

use crate::elasticity::dilatation::{Modes, Sample, Split};
use crate::elasticity::{quadrature, shape_functions};
use crate::error::{Error, Kind};
use crate::mesh::Order;
use crate::scene::{Material, PlaneHypothesis, Scene};

/// `k = ∫ Bᵀ D B t dA` [N/mm] of cells of order p (p + 1 Gauss points each way); dofs are u_x, u_y node by node.
///
/// Of nearly incompressible bodies `k = ∫ Bᵀ D₀ B t dA + λ₁ Σ b_j b_jᵀ`
/// ([`dilatation`](crate::elasticity::dilatation)). The shape functions and their slopes at the Gauss points are the
/// same for all cells and tabulated once.
#[derive(Clone, Debug)]
pub struct CellStiffness {
    /// Slopes `[∂N_a/∂ξ, ∂N_a/∂η]` and weight at each Gauss point.
    rule: Vec<(Vec<[f64; 2]>, f64)>,
    /// Values `N_a` there.
    shapes: Vec<Vec<f64>>,
    split: Split,
    /// Thickness, or the circumference per radius of a body of revolution.
    thickness: f64,
    /// Which coordinate of a body of revolution is the radius.
    radial: Option<usize>,
    order: Order,
    processor: pulp::Arch,
}

impl CellStiffness {
    /// For plain cells of an order, with the plane stiffness D \[MPa\] and the thickness \[mm\].
    pub fn new(order: Order, elasticity: &[[f64; 3]; 3], thickness: f64) -> Self {
        Self::tabulated(order, Split { plain: *elasticity, excess: 0.0 }, thickness)
    }

    /// For cells of an order and a material, whose dilatation is smoothed where it is nearly incompressible.
    pub fn of(order: Order, material: &Material, plane: PlaneHypothesis, thickness: f64) -> Self {
        let plane_kernel = Self::tabulated(order, Split::of(material, plane), thickness);
        let radial = plane.radial();
        Self { radial, thickness: radial.map_or(plane_kernel.thickness, |_| TAU), ..plane_kernel }
    }

    fn tabulated(order: Order, split: Split, thickness: f64) -> Self {
        let points = usize::from(order.number()) + 1;
        let nodes = order.nodes_per_cell();
        let rule = quadrature::gauss_square(points);
        let shapes = rule.iter().map(|&(at, _)| shape_functions::values(nodes, at));
        Self {
            shapes: shapes.collect(),
            rule: rule.iter().map(|&(at, weight)| (slopes(nodes, at), weight)).collect(),
            split,
            thickness,
            radial: None,
            order,
            processor: pulp::Arch::new(),
        }
    }

    /// `k_ab = Σ B_aᵀ D B_b t w det J` as `pairs[a][component of a][component of b][b]`.
    ///
    /// D is the same throughout a cell and stands outside the sums: only the four `∫ N_a,i N_b,j t dA` of a pair of
    /// nodes are summed over the Gauss points, and combined with D once.
    #[inline(always)]
    fn add_pairs<const N: usize, const G: usize>(
        &self,
        points: &[[f64; 2]; N],
        pairs: &mut [[[[f64; N]; 2]; 2]; N],
    ) -> Result<(), f64> {
        let [[dxx, dxy, dxs], [dyx, dyy, dys], [dsx, dsy, dss]] = self.split.plain;
        let mut samples = [Sample::EMPTY; G];
        self.sample(points, &mut samples)?;
        for (a, pair) in pairs.iter_mut().enumerate() {
            let ([mut xx, mut xy], [mut yx, mut yy]) = ([[0.0; N]; 2], [[0.0; N]; 2]);
            for Sample { gradients: [along_x, along_y], area } in &samples {
                let (x, y) = (area * along_x[a], area * along_y[a]);
                add_scaled(&mut xx, x, along_x);
                add_scaled(&mut xy, x, along_y);
                add_scaled(&mut yx, y, along_x);
                add_scaled(&mut yy, y, along_y);
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
        if self.split.excess > 0.0 {
            self.modes(points, &samples).add(self.split.excess, pairs);
        }
        Ok(())
    }

    /// The same of a body of revolution, with strains `(N_a,r, 0, N_a,z, N_a/r)` of a displacement along r and
    /// `t = 2πr`.
    ///
    /// The hoop strain depends on the place, so that a stress of node a meets the strains of node b at each Gauss
    /// point.
    #[inline(always)]
    fn add_pairs_of_revolution<const N: usize, const G: usize>(
        &self,
        points: &[[f64; 2]; N],
        radial: usize,
        pairs: &mut [[[[f64; N]; 2]; 2]; N],
    ) -> Result<(), f64> {
        // `λ + 2μ`, `λ` and `μ`.
        let [[direct, across, _], _, [_, _, shear]] = self.split.plain;
        let mut samples = [Sample::EMPTY; G];
        self.sample(points, &mut samples)?;
        let hoops = self.revolve(points, radial, &mut samples);
        for (a, pair) in pairs.iter_mut().enumerate() {
            let [[xx, xy], [yx, yy]] = pair;
            let (rr, rz, zr, zz) = if radial == 0 { (xx, xy, yx, yy) } else { (yy, yx, xy, xx) };
            for (Sample { gradients, area }, hoop) in samples.iter().zip(&hoops) {
                let [along_r, along_z] = [&gradients[radial], &gradients[1 - radial]];
                let [r, z, h] = [along_r[a], along_z[a], hoop[a]].map(|strain| area * strain);
                add_scaled(rr, direct * r + across * h, along_r);
                add_scaled(rr, across * r + direct * h, hoop);
                add_scaled(rr, shear * z, along_z);
                add_scaled(rz, across * (r + h), along_z);
                add_scaled(rz, shear * z, along_r);
                add_scaled(zr, across * z, along_r);
                add_scaled(zr, across * z, hoop);
                add_scaled(zr, shear * r, along_z);
                add_scaled(zz, direct * z, along_z);
                add_scaled(zz, shear * r, along_r);
            }
        }
        if self.split.excess > 0.0 {
            self.modes(points, &dilating(samples, radial, &hoops)).add(self.split.excess, pairs);
        }
        Ok(())
    }

    /// Multiplies the areas by the radius, and returns `N_a/r`, at each Gauss point; none of them lies on the axis.
    #[inline(always)]
    fn revolve<const N: usize, const G: usize>(
        &self,
        points: &[[f64; 2]; N],
        radial: usize,
        samples: &mut [Sample<N>; G],
    ) -> [[f64; N]; G] {
        let mut hoops = [[0.0; N]; G];
        for ((sample, shapes), hoop) in samples.iter_mut().zip(&self.shapes).zip(&mut hoops) {
            let radius = place(shapes, points)[radial];
            sample.area *= radius;
            hoop.iter_mut().zip(shapes).for_each(|(hoop, value)| *hoop = value / radius);
        }
        hoops
    }

    /// Writes what the sums need at each Gauss point.
    #[inline(always)]
    fn sample<const N: usize, const G: usize>(
        &self,
        points: &[[f64; 2]; N],
        samples: &mut [Sample<N>; G],
    ) -> Result<(), f64> {
        for ((slopes, weight), at) in self.rule.iter().zip(samples) {
            let (inverse, determinant) = jacobian(slopes, points)?;
            at.area = weight * determinant * self.thickness;
            let [along_x, along_y] = &mut at.gradients;
            for ((x, y), slope) in along_x.iter_mut().zip(along_y).zip(slopes) {
                [*x, *y] = gradient(&inverse, slope);
            }
        }
        Ok(())
    }

    /// Entries of the matrix of a cell: `(2n)²` for n nodes.
    pub fn entries(&self) -> usize {
        4 * self.order.nodes_per_cell().pow(2)
    }

    /// Writes `k` row by row for the nodes at some points.
    ///
    /// A Jacobian determinant that is not positive is returned as the error.
    pub fn integrate(&self, points: impl Iterator<Item = [f64; 2]>, k: &mut [f64]) -> Result<(), f64> {
        match self.order {
            Order::Linear => self.integrate_pairs::<4, 4>(points, k),
            Order::Biquadratic => self.integrate_pairs::<9, 9>(points, k),
            Order::Quadratic => self.integrate_pairs::<8, 9>(points, k),
            Order::Quartic => self.integrate_pairs::<25, 25>(points, k),
            Order::Quintic => self.integrate_pairs::<36, 36>(points, k),
            Order::Sextic => self.integrate_pairs::<49, 49>(points, k),
            Order::Septic => self.integrate_pairs::<64, 64>(points, k),
            Order::Octic => self.integrate_pairs::<81, 81>(points, k),
        }
    }

    /// Stresses `σ = D₀ ε + λ₁ θ̄ m` \[MPa\] at some places of the cell with nodes at some points.
    ///
    /// A Jacobian determinant that is not positive is returned as the error.
    pub fn stresses(
        &self,
        points: &[[f64; 2]],
        displacements: &[[f64; 2]],
        at: &[Tabulated],
    ) -> Result<Vec<[f64; 3]>, f64> {
        let smoothed = match self.order {
            _ if self.split.excess <= 0.0 => vec![0.0; at.len()],
            Order::Linear => self.smoothed::<4, 4>(points, displacements, at)?,
            Order::Biquadratic => self.smoothed::<9, 9>(points, displacements, at)?,
            Order::Quadratic => self.smoothed::<8, 9>(points, displacements, at)?,
            Order::Quartic => self.smoothed::<25, 25>(points, displacements, at)?,
            Order::Quintic => self.smoothed::<36, 36>(points, displacements, at)?,
            Order::Sextic => self.smoothed::<49, 49>(points, displacements, at)?,
            Order::Septic => self.smoothed::<64, 64>(points, displacements, at)?,
            Order::Octic => self.smoothed::<81, 81>(points, displacements, at)?,
        };
        let mut stresses = vec![[0.0; 3]; at.len()];
        for ((Tabulated { shapes, slopes }, mean), stress) in at.iter().zip(smoothed).zip(&mut stresses) {
            let (inverse, _) = jacobian(slopes, points)?;
            let mut strain = [0.0; 3];
            for (slope, [u, v]) in slopes.iter().zip(displacements) {
                let [x, y] = gradient(&inverse, slope);
                strain[0] += x * u;
                strain[1] += y * v;
                strain[2] += y * u + x * v;
            }
            let d = &self.split.plain;
            *stress = std::array::from_fn(|i| (0..3).map(|j| d[i][j] * strain[j]).sum());
            if let Some(radial) = self.radial {
                let [radius, outwards] = [points, displacements].map(|of| place(shapes, of)[radial]);
                let hoop = hoop_strain(radius, outwards, strain[radial]);
                stress[..2].iter_mut().for_each(|stress| *stress += d[0][1] * hoop);
            }
            stress[..2].iter_mut().for_each(|stress| *stress += mean);
        }
        Ok(stresses)
    }

    /// `λ₁ θ̄` \[MPa\] at some places.
    fn smoothed<const N: usize, const G: usize>(
        &self,
        points: &[[f64; 2]],
        displacements: &[[f64; 2]],
        at: &[Tabulated],
    ) -> Result<Vec<f64>, f64> {
        let [points, displacements] =
            [points, displacements].map(|all| std::array::from_fn(|a| all.get(a).copied().unwrap_or([f64::NAN; 2])));
        let mut samples = [Sample::EMPTY; G];
        self.sample(&points, &mut samples)?;
        if let Some(radial) = self.radial {
            let hoops = self.revolve(&points, radial, &mut samples);
            samples = dilating(samples, radial, &hoops);
        }
        let modes = self.modes::<N, G>(&points, &samples);
        let places = at.iter().map(|at| place(&at.shapes, &points));
        Ok(modes.dilatation(&displacements, places).map(|theta| self.split.excess * theta).collect())
    }

    /// For N nodes and G Gauss points.
    fn integrate_pairs<const N: usize, const G: usize>(
        &self,
        mut points: impl Iterator<Item = [f64; 2]>,
        k: &mut [f64],
    ) -> Result<(), f64> {
        let points: [[f64; 2]; N] = std::array::from_fn(|_| points.next().unwrap_or([f64::NAN; 2]));
        let mut pairs = [[[[0.0; N]; 2]; 2]; N];
        self.processor.dispatch(AddPairs::<N, G> { kernel: self, points: &points, pairs: &mut pairs })?;
        for (row, pair) in k.chunks_exact_mut(2 * N).zip(pairs.as_flattened()) {
            for (entries, b) in row.chunks_exact_mut(2).zip(0..N) {
                (entries[0], entries[1]) = (pair[0][b], pair[1][b]);
            }
        }
        Ok(())
    }

    /// Smoothed dilatations; inlined into the sums, they slowed plain cells by an eighth.
    #[inline(never)]
    fn modes<const N: usize, const G: usize>(&self, points: &[[f64; 2]; N], samples: &[Sample<N>; G]) -> Modes<N> {
        let mut places = [[0.0; 2]; G];
        for (at, shapes) in places.iter_mut().zip(&self.shapes) {
            *at = place(shapes, points);
        }
        Modes::of(i32::from(self.order.number()) - 1, samples, &places)
    }
}

/// The shape functions of a cell and their slopes at a place of it, the same for all cells.
#[derive(Clone, Debug)]
pub struct Tabulated {
    /// `N_a`.
    shapes: Vec<f64>,
    /// `[∂N_a/∂ξ, ∂N_a/∂η]`.
    slopes: Vec<[f64; 2]>,
}

impl Tabulated {
    /// Those of a cell of so many nodes at (ξ, η).
    pub fn of(nodes: usize, at: [f64; 2]) -> Self {
        let (shapes, slopes) = shape_functions::cell(nodes, at).into_iter().unzip();
        Self { shapes, slopes }
    }
}

/// The sums of a cell on registers as wide as the processor's own; a closure's call would be a function of its own,
/// compiled for the narrowest.
struct AddPairs<'a, const N: usize, const G: usize> {
    kernel: &'a CellStiffness,
    points: &'a [[f64; 2]; N],
    pairs: &'a mut [[[[f64; N]; 2]; 2]; N],
}

impl<const N: usize, const G: usize> pulp::WithSimd for AddPairs<'_, N, G> {
    type Output = Result<(), f64>;

    #[inline(always)]
    fn with_simd<S: pulp::Simd>(self, _: S) -> Self::Output {
        match self.kernel.radial {
            Some(radial) => self.kernel.add_pairs_of_revolution::<N, G>(self.points, radial, self.pairs),
            None => self.kernel.add_pairs::<N, G>(self.points, self.pairs),
        }
    }
}

/// Samples whose gradients are those of the dilatation, `N_a,r + N_a/r` and `N_a,z`.
fn dilating<const N: usize, const G: usize>(
    mut samples: [Sample<N>; G],
    radial: usize,
    hoops: &[[f64; N]; G],
) -> [Sample<N>; G] {
    for (sample, hoop) in samples.iter_mut().zip(hoops) {
        sample.gradients[radial].iter_mut().zip(hoop).for_each(|(radial, hoop)| *radial += hoop);
    }
    samples
}

/// Hoop strain `u_r/r`, which on the axis tends to the radial one, `∂u_r/∂r`.
pub fn hoop_strain(radius: f64, outwards: f64, radial: f64) -> f64 {
    if radius > 0.0 { outwards / radius } else { radial }
}

/// Error of a cell turned inside out or of no area.
pub(super) fn degenerate(scene: &Scene, body: usize, cell: usize, jacobian: f64) -> Error {
    let message = format!("cell {cell} has Jacobian determinant {jacobian:.3e} at a quadrature point");
    let remedy = match scene.bodies[body].shape.has_given_mesh() {
        true => "repair the mesh: parts of a cell of its file are turned inside out, which halving shows",
        false => "make the grading gentler or the elements smaller",
    };
    Error { kind: Kind::DegenerateCell, ..Error::at(scene.place_of_body(body), message, remedy) }
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

/// `x = Σ N_a x_a`.
fn place(shapes: &[f64], points: &[[f64; 2]]) -> [f64; 2] {
    [0, 1].map(|k| shapes.iter().zip(points).map(|(value, point)| value * point[k]).sum())
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
