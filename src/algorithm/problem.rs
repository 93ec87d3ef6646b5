//! What an algorithm sees: the condensed system, the contact points, and scales that make residuals pure numbers.

use faer::{ColRef, Mat, MatMut};

use crate::algorithm::{Iterate, Springs};
use crate::condensation::dense::{DenseFactor, Padded};
use crate::contact::ContactPoint;
use crate::solution::{Residuals, Work};

/// `S u + Σ A p b = f̂` with the contact conditions at every point.
#[derive(Debug)]
pub struct ContactProblem<'a> {
    /// Condensed stiffness `S` [N/mm].
    pub stiffness: &'a Mat<f64>,
    /// Condensed load `f̂` \[N\].
    pub load: &'a [f64],
    /// Contact points.
    pub points: &'a [ContactPoint],
    /// Scales.
    pub scale: Scale,
    /// Initial stiffness of each point [MPa/mm].
    pub initial: Vec<f64>,
}

/// Reference values of the scene.
#[derive(Clone, Copy, Debug)]
pub struct Scale {
    /// `p_ref` \[MPa\].
    pub pressure: f64,
    /// `g_ref` \[mm\].
    pub gap: f64,
    /// `E*/ℓ`: the spring stiffness of κ = 1 [MPa/mm].
    pub stiffness: f64,
}

/// Softest and stiffest spring, in units of `E*/ℓ`.
pub const LIMITS: [f64; 2] = [1e-12, 1e6];

/// A load below this fraction of the reference pressure on all points is round-off of the condensation.
const UNLOADED: f64 = 1e-14;

/// Pressure over `k |g|` of the deepest interference above which it presses: hard springs give way to all but this part.
const PRESSED: f64 = 1e-9;

/// Springs whose `k |w|` and `k |γ|` are together more than so many times the forces lose a digit where they cancel.
const CANCELLING: f64 = 10.0;

impl Scale {
    /// Stiffness of a closed point, `k_hard = 1e6 E*/ℓ` [MPa/mm].
    pub fn hard(&self) -> f64 {
        LIMITS[1] * self.stiffness
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
        let mut matrix = self.stiffness.clone();
        self.add_springs(stiffness, matrix.as_mut());
        matrix
    }

    /// Factor of `S + Σ A k bᵀb`; none where that is not positive definite.
    pub fn factorise(&self, stiffness: &[f64], work: &mut Work) -> Option<DenseFactor> {
        self.factorise_in(Padded::default(), stiffness, work)
    }

    /// The same in memory at hand.
    pub fn factorise_in(&self, memory: Padded, stiffness: &[f64], work: &mut Work) -> Option<DenseFactor> {
        work.count_factorisation(self.load.len());
        let mut matrix = Padded::copy_of(self.stiffness, memory);
        self.add_springs(stiffness, matrix.as_mut());
        DenseFactor::of(matrix)
    }

    fn add_springs(&self, stiffness: &[f64], mut matrix: MatMut<'_, f64>) {
        for (point, k) in self.points.iter().zip(stiffness) {
            for &(i, b_i) in &point.row {
                for &(j, b_j) in &point.row {
                    matrix[(i, j)] += point.weight * k * b_i * b_j;
                }
            }
        }
    }

    /// Equilibrium of `S u + Σ A p b = load` with springs `p = r + k (w − γ)`, refined once where these nearly cancel.
    ///
    /// The refinement `S δu + Σ A k (b·δu) b = load − S u − Σ A p b` updates u and p together, so that the pressures
    /// balance the load to round-off even where `k (w − γ)` is the difference of nearly equal lengths.
    pub fn equilibrium(
        &self,
        factor: &DenseFactor,
        load: &[f64],
        springs: &Springs,
        unstrained: impl Fn(&ContactPoint) -> f64,
        work: &mut Work,
    ) -> Iterate {
        let stiffness = &springs.stiffness;
        let mut rhs = load.to_vec();
        for ((point, k), r) in self.points.iter().zip(stiffness).zip(&springs.force) {
            point.add_row(point.weight * (k * unstrained(point) - r), &mut rhs);
        }
        let mut u = factor.solve(&rhs);
        let (mut pressure, mut summands, mut sums) = (Vec::with_capacity(stiffness.len()), 0.0, 0.0);
        for ((point, k), r) in self.points.iter().zip(stiffness).zip(&springs.force) {
            let (w, rest) = (point.approach(&u), unstrained(point));
            let p = r + k * (w - rest);
            summands += point.weight * k * (w.abs() + rest.abs());
            sums += point.weight * p.abs();
            pressure.push(p);
        }
        let mut internal = self.internal_force(&u);
        let mut solves = 1;
        if summands > CANCELLING * (sums + absolute(load)) {
            let change = factor.solve(&self.imbalance(load, &internal, &pressure));
            u.iter_mut().zip(&change).for_each(|(u, du)| *u += du);
            for ((p, point), k) in pressure.iter_mut().zip(self.points).zip(stiffness) {
                *p += k * point.approach(&change);
            }
            internal = self.internal_force(&u);
            solves += 1;
        }
        work.back_substitutions += solves;
        work.operations += (2 * solves) as f64 * (rhs.len() as f64).powi(2);
        let approach = self.points.iter().map(|point| point.approach(&u)).collect();
        Iterate { approach, displacement: u, pressure, internal }
    }

    /// `S u` \[N\].
    pub fn internal_force(&self, u: &[f64]) -> Vec<f64> {
        (self.stiffness * ColRef::from_slice(u)).iter().copied().collect()
    }

    /// Whether the condensed load is no more than round-off.
    pub fn is_unloaded(&self) -> bool {
        self.is_round_off(absolute(self.load))
    }

    /// Whether interference presses with every point closed: not where the bodies are free to move out of it.
    pub fn interference_presses(&self) -> bool {
        let springs = self.initial_springs();
        let work = &mut Work::default();
        let Some(factor) = self.factorise(&springs.stiffness, work) else { return false };
        let iterate = self.equilibrium(&factor, self.load, &springs, |point| point.gap, work);
        let squeezed = |(point, k): (&ContactPoint, &f64)| k * (-point.gap).max(0.0);
        let largest = self.points.iter().zip(&springs.stiffness).map(squeezed).fold(0.0, f64::max);
        largest > 0.0 && iterate.pressure.iter().any(|p| *p > PRESSED * largest)
    }

    /// Whether a force is no more than round-off of the reference pressure on all points \[N\].
    fn is_round_off(&self, force: f64) -> bool {
        let reference: f64 = self.points.iter().map(|point| point.weight * self.scale.pressure).sum();
        force <= UNLOADED * reference
    }

    /// `load − S u − Σ A p b` from the internal force `S u` \[N\].
    fn imbalance(&self, load: &[f64], internal: &[f64], pressure: &[f64]) -> Vec<f64> {
        let mut residual: Vec<f64> = load.iter().zip(internal).map(|(f, s)| f - s).collect();
        for (point, p) in self.points.iter().zip(pressure) {
            point.add_row(-point.weight * p, &mut residual);
        }
        residual
    }

    /// The four residuals of an iterate, for the pressures as reported (projected to p ≥ 0).
    ///
    /// Where penetration is the springs' own law, only `k₀ (w − g)⁺` of open points counts as penetration.
    pub fn residuals(&self, load: &[f64], iterate: &Iterate, elastic: bool) -> Residuals {
        let reported: Vec<f64> = iterate.pressure.iter().map(|p| reported(*p)).collect();
        let (mut penetration, mut tension, mut complementarity) = (0.0, 0.0, 0.0);
        for (i, point) in self.points.iter().enumerate() {
            let (p, h) = (iterate.pressure[i], point.gap - iterate.approach[i]);
            let missing = if elastic { self.initial[i] * -h - p } else { 0.0 };
            let depth = if elastic { missing.max(0.0) / self.scale.pressure } else { -h / self.scale.gap };
            penetration = worse(penetration, depth);
            tension = worse(tension, -p / self.scale.pressure);
            complementarity = worse(complementarity, (p / self.scale.pressure).min(h / self.scale.gap));
        }
        let total: f64 = self.points.iter().zip(&reported).map(|(point, p)| point.weight * p).sum();
        let applied = absolute(load);
        let missing = absolute(&self.imbalance(load, &iterate.internal, &reported));
        // Where nothing presses, what springs pull by turns the imbalance into a pure number.
        let pulling = self.points.iter().zip(&iterate.pressure).map(|(point, p)| point.weight * p.abs());
        let pressing = total.max(applied);
        let scale = if self.is_round_off(pressing) { pulling.sum() } else { pressing };
        let balance = if missing > 0.0 || missing.is_nan() { missing / scale } else { 0.0 };
        Residuals { penetration, tension, complementarity, balance }
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

/// The larger one, NaN if either is.
fn worse(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.max(b) }
}
