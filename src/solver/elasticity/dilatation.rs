//! Smoothed dilatation: what keeps nearly incompressible cells from locking.
//!
//! As ν tends to 0.5 in plane strain, Lamé's `λ = 2μν/(1 − 2ν)` grows without bound and holds the dilatation
//! `θ = ε_x + ε_y` at zero at every Gauss point: more conditions than a cell has displacements to spare. What λ has
//! beyond that of an ordinary material, `λ₁`, therefore acts on a smoothed dilatation `θ̄` (B-bar: Hughes 1980; for
//! 4-node cells the same as one-point integration of this part: Malkus & Hughes 1978):
//!
//! `W = ½ ∫ (εᵀ D₀ ε + λ₁ θ̄²) t dA`, `σ = D₀ ε + λ₁ θ̄ m`, `D₀ = D − λ₁ m mᵀ`, `m = [1, 1, 0]`,
//!
//! where θ̄ is the least-squares fit to θ over a cell of order p by polynomials of degree p − 1. Uniform strains are
//! their own fit, so that patch tests hold, and D₀ under full integration leaves no motion but the rigid ones free.
//!
//! Bodies of revolution have `θ = ε_r + ε_z + ε_θ`, m has a one for the hoop stress too, and t is `2πr`.
//!
//! In plane stress a body has the D of one in plane strain with `ν' = ν/(1 + ν)`, whose λ is `2μν/(1 − ν)`, and locks
//! as ν tends to 1: the same holds there by ν', from ν = 0.538 on.
//!
//! Splitting λ as Arnold & Brezzi (1993) split the shear of plates makes the cells of ordinary materials the plain
//! ones, and the answer a continuous function of ν: no threshold at which the cell changes.
//!
//! Why 1, x, y: on truncated Hertz at ν = 0.4999, 8 cells on the half-width, neighbouring nodal pressures depart from
//! one another by 0.7 % of p₀, as at ν = 0.3; with 2×2 Gauss points by 4 %, with plain cells by 90 %. A constant bends
//! too easily: the deflection of a cantilever two cells high is 5 % too large.

use crate::scene::{Material, PlaneHypothesis};

/// Poisson's ratio up to which cells in plane strain are the plain ones; `ν/(1 + ν)` in plane stress.
///
/// It covers the usual metals. A larger value brings back some of the locking of 4-node cells: their error of p₀ in
/// truncated Hertz at ν = 0.4999 is 0.15 % with 0.3, 0.25 % with 0.4.
pub const ORDINARY: f64 = 0.35;

/// Elasticity as cells integrate it: `σ = D₀ ε + λ₁ θ̄ m`.
#[derive(Clone, Copy, Debug)]
pub struct Split {
    /// `D₀` \[MPa\], on the strains at every point.
    pub plain: [[f64; 3]; 3],
    /// `λ₁ ≥ 0` \[MPa\], on the smoothed dilatation; zero up to ν = 0.35, in plane stress up to 0.538.
    pub excess: f64,
}

impl Split {
    /// `λ₁ = max(λ − λ(0.35), 0)`, with `λ = D₁₂` and `μ = D₃₃`.
    pub fn of(material: &Material, plane: PlaneHypothesis) -> Self {
        let mut plain = material.stiffness(plane);
        let ordinary = plain[2][2] * 2.0 * ORDINARY / (1.0 - 2.0 * ORDINARY);
        let excess = (plain[0][1] - ordinary).max(0.0);
        plain[..2].iter_mut().flat_map(|row| &mut row[..2]).for_each(|entry| *entry -= excess);
        Self { plain, excess }
    }
}

/// A Gauss point of a cell.
#[derive(Clone, Copy, Debug)]
pub struct Sample<const N: usize> {
    /// `N_a,x` and `N_a,y`; for dilatations of bodies of revolution `N_a,r + N_a/r` and `N_a,z`.
    pub gradients: [[f64; N]; 2],
    /// `t w det J`.
    pub area: f64,
}

impl<const N: usize> Sample<N> {
    /// Of no area.
    pub const EMPTY: Self = Self { gradients: [[0.0; N]; 2], area: 0.0 };
}

/// Fields `ψ_j`, orthonormal over a cell, that span `θ̄ = Σ ψ_j b_j·u` with `b_j = ∫ ψ_j ∇N t dA`.
#[derive(Clone, Debug)]
pub struct Modes<const N: usize> {
    /// Middle of the cell and its size, by which powers are scaled.
    centre: [f64; 2],
    size: f64,
    degree: i32,
    /// Coefficients of the powers of each field.
    fields: Vec<Vec<f64>>,
    /// `b_j` by component and node.
    rows: Vec<[[f64; N]; 2]>,
}

impl<const N: usize> Modes<N> {
    /// Fields up to a degree of the cell with Gauss points at some places: powers made orthonormal one after the other.
    pub fn of(degree: i32, samples: &[Sample<N>], places: &[[f64; 2]]) -> Self {
        let sum = |of: &dyn Fn(&[f64; 2]) -> f64| -> f64 {
            samples.iter().zip(places).map(|(at, place)| at.area * of(place)).sum()
        };
        let area = sum(&|_| 1.0);
        let centre = [0, 1].map(|k| sum(&|place| place[k]) / area);
        let size = places.iter().map(|[x, y]| (x - centre[0]).hypot(y - centre[1])).fold(0.0, f64::max);
        let mut modes = Self { centre, size, degree, fields: vec![], rows: vec![] };
        let powers: Vec<Vec<f64>> = places.iter().map(|place| modes.powers(*place)).collect();
        let mut values: Vec<Vec<f64>> = Vec::new();
        for k in 0..powers[0].len() {
            let mut own: Vec<f64> = powers.iter().map(|powers| powers[k]).collect();
            let mut field: Vec<f64> = (0..powers[0].len()).map(|other| f64::from(u8::from(other == k))).collect();
            let product = |a: &[f64], b: &[f64]| -> f64 {
                samples.iter().zip(a.iter().zip(b)).map(|(at, (a, b))| at.area * a * b).sum()
            };
            for (before, of_before) in modes.fields.iter().zip(&values) {
                let share = product(&own, of_before);
                own.iter_mut().zip(of_before).for_each(|(own, other)| *own -= share * other);
                field.iter_mut().zip(before).for_each(|(own, other)| *own -= share * other);
            }
            let norm = product(&own, &own).sqrt();
            own.iter_mut().chain(&mut field).for_each(|entry| *entry /= norm);
            let mut row = [[0.0; N]; 2];
            for (at, value) in samples.iter().zip(&own) {
                for (entry, gradient) in row.as_flattened_mut().iter_mut().zip(at.gradients.as_flattened()) {
                    *entry += at.area * value * gradient;
                }
            }
            modes.rows.push(row);
            modes.fields.push(field);
            values.push(own);
        }
        modes
    }

    /// Adds `λ₁ Σ b_j b_jᵀ` to a stiffness kept as `[a][component of a][component of b][b]`.
    pub fn add(&self, excess: f64, pairs: &mut [[[[f64; N]; 2]; 2]; N]) {
        for row in &self.rows {
            for (a, pair) in pairs.iter_mut().enumerate() {
                for (entries, of_a) in pair.iter_mut().zip(row.map(|component| excess * component[a])) {
                    for (entry, of_b) in entries.as_flattened_mut().iter_mut().zip(row.as_flattened()) {
                        *entry += of_a * of_b;
                    }
                }
            }
        }
    }

    /// `θ̄` at some places of the cell whose nodes have the given displacements.
    pub fn dilatation(
        &self,
        displacements: &[[f64; 2]; N],
        places: impl Iterator<Item = [f64; 2]>,
    ) -> impl Iterator<Item = f64> {
        let share = |[x, y]: &[[f64; N]; 2]| -> f64 {
            (0..N).map(|a| x[a] * displacements[a][0] + y[a] * displacements[a][1]).sum()
        };
        let shares: Vec<f64> = self.rows.iter().map(share).collect();
        let value = |powers: &[f64], field: &[f64]| -> f64 { powers.iter().zip(field).map(|(a, b)| a * b).sum() };
        places.map(move |place| {
            let powers = self.powers(place);
            self.fields.iter().zip(&shares).map(|(field, share)| value(&powers, field) * share).sum()
        })
    }

    /// `xⁱ yʲ`, i + j up to the degree, at a place, with x and y from the middle over the size.
    fn powers(&self, place: [f64; 2]) -> Vec<f64> {
        let [x, y] = [0, 1].map(|k| (place[k] - self.centre[k]) / self.size);
        (0..=self.degree).flat_map(|sum| (0..=sum).map(move |j| x.powi(sum - j) * y.powi(j))).collect()
    }
}
