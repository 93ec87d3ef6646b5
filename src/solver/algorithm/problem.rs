//! What an algorithm sees: the condensed system, the contact points, and its springs; and what an iteration with these
//! finds.

use faer::Mat;

use crate::condensation::stiffness::{Stiffness, SystemFactor};
use crate::contact::{ContactEdge, ContactPoint};
use crate::solution::Work;

/// `S u + Σ A p b = f̂` with the contact conditions at every point.
#[derive(Clone, Debug)]
pub struct ContactProblem<'a> {
    /// Condensed stiffness `S` [N/mm].
    pub stiffness: &'a Stiffness,
    /// Condensed load `f̂` \[N\].
    pub load: &'a [f64],
    /// Contact points.
    pub points: &'a [ContactPoint],
    /// Edges that they belong to, contact by contact.
    pub edges: &'a [ContactEdge],
    /// What springs start from and are kept within.
    pub scale: Scale,
    /// Compliance `1/(E* t)` of each contact [mm/N]: its force times this is the approach that its errors are measured
    /// by.
    pub compliance: Vec<f64>,
    /// Initial stiffness of each point [MPa/mm].
    pub initial: Vec<f64>,
}

/// The springs as they stand between two iterations.
#[derive(Clone, Debug)]
pub struct Springs {
    /// Stiffness `k` per area of each point [MPa/mm]; zero is open.
    pub stiffness: Vec<f64>,
    /// Force per area `r` carried by each point beside its spring \[MPa\].
    pub force: Vec<f64>,
}

/// What one iteration finds.
#[derive(Clone, Debug)]
pub struct Iterate {
    /// Displacements of the retained dofs \[mm\].
    pub displacement: Vec<f64>,
    /// Approach of each point \[mm\].
    pub approach: Vec<f64>,
    /// Spring force per area of each point, tension negative \[MPa\].
    pub pressure: Vec<f64>,
    /// Internal force `S u` of the displacements \[N\].
    pub internal: Vec<f64>,
}

/// Reference values of the scene, which springs start from; what has converged is told without them.
#[derive(Clone, Copy, Debug)]
pub struct Scale {
    /// `g_ref` \[mm\].
    pub gap: f64,
    /// `E*/ℓ`: the spring stiffness of κ = 1 [MPa/mm].
    pub stiffness: f64,
}

/// Softest and stiffest spring, in units of `E*/ℓ`.
pub const LIMITS: [f64; 2] = [1e-12, 1e6];

/// Pressure over `k |g|` of the deepest interference above which it presses: hard springs give way to all but this
/// part.
const PRESSED: f64 = 1e-9;

/// Part of the load that is a force, whatever rounding leaves.
const OF_LOAD: f64 = 1e-9;
/// Part of what bodies resist a displacement with that is no force.
const NO_FORCE: f64 = 1e-12;

/// Springs whose `k |b| |u|` and `k |γ|` are together more than so many times the forces lose a digit where they
/// cancel.
const CANCELLING: f64 = 10.0;

impl Scale {
    /// Stiffness of a closed point, `k_hard = 1e6 E*/ℓ` [MPa/mm].
    pub fn hard(&self) -> f64 {
        LIMITS[1] * self.stiffness
    }

    /// Whether a stiffness is that of a closed point, but for rounding.
    pub fn is_hard(&self, stiffness: f64) -> bool {
        stiffness >= self.hard() * (1.0 - 1e-9)
    }

    /// Keeps a stiffness within `1e-12 … 1e6 E*/ℓ`; NaN passes through.
    pub fn clip(&self, stiffness: f64) -> f64 {
        stiffness.clamp(LIMITS[0] * self.stiffness, LIMITS[1] * self.stiffness)
    }

    /// `max(x, 1e-9 g_ref)`: a length one may divide by \[mm\].
    pub fn above_zero(&self, length: f64) -> f64 {
        length.max(1e-9 * self.gap)
    }
}

impl ContactProblem<'_> {
    /// Springs at the start: the initial stiffness, no carried force.
    pub fn initial_springs(&self) -> Springs {
        Springs { stiffness: self.initial.clone(), force: vec![0.0; self.points.len()] }
    }

    /// `S + Σ A k bᵀb` [N/mm].
    pub fn matrix(&self, stiffness: &[f64]) -> Mat<f64> {
        let mut matrix = self.stiffness.to_dense();
        for (point, k) in self.points.iter().zip(stiffness) {
            for &(i, b_i) in &point.row {
                for &(j, b_j) in &point.row {
                    matrix[(i, j)] += point.weight * k * b_i * b_j;
                }
            }
        }
        matrix
    }

    /// Factor of `S + Σ A k bᵀb`; none where that is not positive definite.
    pub fn factorise(&self, stiffness: &[f64], work: &mut Work) -> Option<SystemFactor> {
        self.factorise_in(None, stiffness, work)
    }

    /// The same in the memory of a factor that is no longer needed.
    pub fn factorise_in(
        &self,
        memory: Option<SystemFactor>,
        stiffness: &[f64],
        work: &mut Work,
    ) -> Option<SystemFactor> {
        work.factorisations += 1;
        work.operations += self.stiffness.operations()[0];
        let springs = self.points.iter().zip(stiffness);
        let terms = springs.map(|(point, k)| (point.weight * k, point.row.as_slice()));
        self.stiffness.factorise(terms, memory)
    }

    /// Equilibrium of `S u + Σ A p b = f̂` with springs `p = r + k (w − γ)`, refined once where these nearly cancel.
    ///
    /// The refinement `S δu + Σ A k (b·δu) b = f̂ − S u − Σ A p b` updates u and p together, so that the pressures
    /// balance the load to round-off even where `k (w − γ)` is the difference of nearly equal lengths.
    pub fn equilibrium(
        &self,
        factor: &SystemFactor,
        springs: &Springs,
        unstrained: impl Fn(&ContactPoint) -> f64,
        work: &mut Work,
    ) -> Iterate {
        let stiffness = &springs.stiffness;
        let mut rhs = self.load.to_vec();
        for ((point, k), r) in self.points.iter().zip(stiffness).zip(&springs.force) {
            point.add_row(point.weight * (k * unstrained(point) - r), &mut rhs);
        }
        let mut u = factor.solve(&rhs);
        let (mut pressure, mut summands, mut sums) = (Vec::with_capacity(stiffness.len()), 0.0, 0.0);
        for ((point, k), r) in self.points.iter().zip(stiffness).zip(&springs.force) {
            let (w, rest) = (point.approach(&u), unstrained(point));
            let p = r + k * (w - rest);
            summands += point.weight * k * (point.size_of_approach(&u) + rest.abs());
            sums += point.weight * p.abs();
            pressure.push(p);
        }
        let mut internal = self.stiffness.times(&u);
        let mut solves = 1;
        if summands > CANCELLING * (sums + absolute(self.load)) {
            let change = factor.solve(&self.imbalance(&internal, &pressure));
            u.iter_mut().zip(&change).for_each(|(u, du)| *u += du);
            for ((p, point), k) in pressure.iter_mut().zip(self.points).zip(stiffness) {
                *p += k * point.approach(&change);
            }
            internal = self.stiffness.times(&u);
            solves += 1;
        }
        work.back_substitutions += solves;
        work.operations += solves as f64 * self.stiffness.operations()[1];
        let approach = self.points.iter().map(|point| point.approach(&u)).collect();
        Iterate { approach, displacement: u, pressure, internal }
    }

    /// `C_ij = b_i (S + Σ A k b bᵀ)⁻¹ b_j A_j` by a factor of that matrix: approach of a point by the pressure on
    /// another [mm/MPa].
    pub fn flexibility(&self, factor: &SystemFactor) -> Mat<f64> {
        let mut flexibility = Mat::zeros(self.points.len(), self.points.len());
        for (j, point) in self.points.iter().enumerate() {
            let mut force = vec![0.0; self.load.len()];
            point.add_row(point.weight, &mut force);
            let moved = factor.solve(&force);
            self.points.iter().enumerate().for_each(|(i, other)| flexibility[(i, j)] = other.approach(&moved));
        }
        flexibility
    }

    /// What both bodies resist at a point, one behind the other: `1/Σ (b²/S_dd)` of the diagonal of S [N/mm].
    pub fn resistance(&self, point: &ContactPoint) -> f64 {
        1.0 / point.row.iter().map(|&(dof, b)| b * b / self.stiffness[(dof, dof)]).sum::<f64>()
    }

    /// Force of each contact below which there is none, `1e-12 Σ s |b||u|` over its points, s their resistance: what
    /// rounding leaves where bodies just touch \[N\]. Gaps do not count: far candidates have wide ones, whatever small
    /// force the contact carries.
    ///
    /// Of equal bodies that is about `1e-12 Σ |S||u|`; of a stiff one on a soft one it knows that only the soft one's
    /// forces matter.
    pub fn round_off(&self, displacement: &[f64]) -> Vec<f64> {
        let mut forces = vec![0.0; self.compliance.len()];
        for point in self.points {
            forces[point.contact] += NO_FORCE * self.resistance(point) * point.size_of_approach(displacement);
        }
        // A body that hardly anything holds moves far, and its load is a force all the same.
        let most = OF_LOAD * absolute(self.load);
        forces.iter_mut().for_each(|force| *force = force.min(most));
        forces
    }

    /// Whether interference presses with every point closed: not where the bodies are free to move out of it.
    pub fn interference_presses(&self) -> bool {
        let springs = self.initial_springs();
        let work = &mut Work::default();
        let Some(factor) = self.factorise(&springs.stiffness, work) else { return false };
        let iterate = self.equilibrium(&factor, &springs, |point| point.gap, work);
        let squeezed = |(point, k): (&ContactPoint, &f64)| k * (-point.gap).max(0.0);
        let largest = self.points.iter().zip(&springs.stiffness).map(squeezed).fold(0.0, f64::max);
        largest > 0.0 && iterate.pressure.iter().any(|p| *p > PRESSED * largest)
    }

    /// `f̂ − S u − Σ A p b` from the internal force `S u` \[N\].
    fn imbalance(&self, internal: &[f64], pressure: &[f64]) -> Vec<f64> {
        let mut residual: Vec<f64> = self.load.iter().zip(internal).map(|(f, s)| f - s).collect();
        for (point, p) in self.points.iter().zip(pressure) {
            point.add_row(-point.weight * p, &mut residual);
        }
        residual
    }
}

/// `Σ |f|`; NaN if any is.
fn absolute(forces: &[f64]) -> f64 {
    forces.iter().map(|f| f.abs()).sum()
}

/// Pressure as reported: projected to p ≥ 0; NaN stays NaN.
pub fn reported(pressure: f64) -> f64 {
    if pressure < 0.0 { 0.0 } else { pressure }
}
