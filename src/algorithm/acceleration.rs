//! Acceleration of the fixed point of constant stiffness, with a safeguard: an option, not an algorithm of the paper.
//!
//! With the rule `correction` the iteration `x → G(x)` of the carried forces is Douglas–Rachford splitting of elasticity and
//! contact (Lions & Mercier 1979). In the norm `‖f‖² = Σ A f²/k₀` it is firmly nonexpansive, so the residual
//! `f = G(x) − x` never grows in a plain iteration, whatever κ₀, and crossed secant never takes a shorter step than it.

use std::collections::VecDeque;

use nalgebra::{DMatrix, DVector};

use crate::named::named_enum;

named_enum! {
    /// How the fixed point is approached.
    pub enum Acceleration {
        /// `x⁺ = G(x)`: the paper's own iteration.
        None = "none",
        /// `x⁺ = x − (Δx·Δf/‖Δf‖²) f`, from the last two residuals (Ramière & Helfer 2015).
        CrossedSecant = "crossed-secant",
        /// `x⁺ = x + f − Σ γ (Δx + Δf)`, γ minimising `‖f − Σ γ Δf‖` over the last differences (Walker & Ni 2011).
        Anderson = "anderson",
    }
}

impl Acceleration {
    /// Differences remembered.
    fn depth(self) -> usize {
        match self {
            Self::None => 0,
            Self::CrossedSecant => 1,
            Self::Anderson => DEPTH,
        }
    }
}

/// Differences that Anderson acceleration remembers. Of 3, 5, 8, 12 and 20, five reach the most starts at tolerance 1e-3:
/// more of them reach back to active sets that are no longer the present one.
const DEPTH: usize = 5;
/// Singular values of the scaled differences below this part of the largest are left out.
const CONDITION: f64 = 1e-8;
/// The safeguard's factor and exponent: accelerated iteration number n may lead to residuals up to `100 F (n + 1)^−1.1`.
const SAFEGUARD: (f64, f64) = (100.0, 1.1);

/// The last states of a fixed-point iteration, and what is made of them.
///
/// Three safeguards. A state reached by acceleration is given up for the plain iteration before it where
/// `‖f‖ > 100 F (n + 1)^−1.1`, n accelerated iterations so far, F the residual of the first state: a summable bound, which with
/// nonexpansive plain iterations leaves no way but to converge (Zhang, O'Donoghue & Boyd 2020). A plain iteration follows where
/// the residual rose, and after every Anderson iteration. A step that is not finite is not made.
#[derive(Clone, Debug)]
pub struct Accelerator {
    /// How.
    pub kind: Acceleration,
    /// Weight of each component in the inner product, `A/k₀`.
    pub weights: Vec<f64>,
    /// F: residuals are measured against that of the first state.
    first: Option<f64>,
    /// States `x` with their residuals `f`, the latest last.
    history: VecDeque<[Vec<f64>; 2]>,
    /// `G` of the state before, where the present one was reached by acceleration.
    plain: Option<Vec<f64>>,
    accelerated: usize,
    size: f64,
}

impl Accelerator {
    /// Nothing remembered yet.
    pub fn new(kind: Acceleration, weights: Vec<f64>) -> Self {
        Self { kind, weights, first: None, history: VecDeque::new(), plain: None, accelerated: 0, size: f64::INFINITY }
    }

    /// The state after `x`, whose residual is `f = G(x) − x`; adds to `rejected` where `x` is given up.
    pub fn next(&mut self, x: &[f64], f: &[f64], rejected: &mut usize) -> Vec<f64> {
        let size = self.dot(f, f).sqrt();
        let before = self.plain.take();
        let within = size <= self.bound(size);
        if let Some(plain) = before.as_ref().filter(|_| !within) {
            *rejected += 1;
            self.keep(1);
            return plain.clone();
        }
        let rose = size > self.size;
        self.size = size;
        self.history.push_back([x.to_vec(), f.to_vec()]);
        self.keep(self.kind.depth() + 1);
        let plain: Vec<f64> = x.iter().zip(f).map(|(x, f)| x + f).collect();
        let rests = rose || (self.kind == Acceleration::Anderson && before.is_some());
        let accelerated = if rests { None } else { self.extrapolated(x, f) };
        match accelerated.filter(|next| next.iter().all(|x| x.is_finite())) {
            Some(next) => {
                self.accelerated += 1;
                self.plain = Some(plain);
                next
            }
            None => plain,
        }
    }

    /// Largest residual of a state reached by acceleration that is accepted.
    fn bound(&mut self, size: f64) -> f64 {
        let (factor, exponent) = SAFEGUARD;
        factor * *self.first.get_or_insert(size) * (self.accelerated as f64 + 1.0).powf(-exponent)
    }

    /// Forgets all but the latest states.
    fn keep(&mut self, states: usize) {
        self.history.drain(..self.history.len().saturating_sub(states));
    }

    /// The accelerated iteration from the states remembered; none where there is only one.
    fn extrapolated(&self, x: &[f64], f: &[f64]) -> Option<Vec<f64>> {
        let changes: Vec<[Vec<f64>; 2]> = self
            .history
            .iter()
            .zip(self.history.iter().skip(1))
            .map(|(a, b)| [0, 1].map(|k| minus(&b[k], &a[k])))
            .collect();
        let [dx, df] = changes.last()?;
        if self.kind == Acceleration::CrossedSecant {
            let factor = self.dot(dx, df) / self.dot(df, df);
            return Some(x.iter().zip(f).map(|(x, f)| x - factor * f).collect());
        }
        let gamma = self.least_squares(&changes, f)?;
        let mut next: Vec<f64> = x.iter().zip(f).map(|(x, f)| x + f).collect();
        for (gamma, [dx, df]) in gamma.iter().zip(&changes) {
            next.iter_mut().zip(dx.iter().zip(df)).for_each(|(x, (dx, df))| *x -= gamma * (dx + df));
        }
        Some(next)
    }

    /// γ of least `‖f − Σ γ Δf‖`, by singular values of the differences brought to length one.
    fn least_squares(&self, changes: &[[Vec<f64>; 2]], f: &[f64]) -> Option<Vec<f64>> {
        let roots: Vec<f64> = self.weights.iter().map(|weight| weight.sqrt()).collect();
        let lengths: Vec<f64> = changes.iter().map(|[_, df]| self.dot(df, df).sqrt()).collect();
        let columns = DMatrix::from_fn(f.len(), changes.len(), |i, j| roots[i] * changes[j][1][i] / lengths[j]);
        let rhs = DVector::from_fn(f.len(), |i, _| roots[i] * f[i]);
        if columns.iter().any(|entry| !entry.is_finite()) {
            return None;
        }
        let values = columns.svd(true, true);
        let solution = values.solve(&rhs, CONDITION * values.singular_values.max()).ok()?;
        Some(solution.iter().zip(&lengths).map(|(y, length)| y / length).collect())
    }

    fn dot(&self, a: &[f64], b: &[f64]) -> f64 {
        self.weights.iter().zip(a.iter().zip(b)).map(|(weight, (a, b))| weight * a * b).sum()
    }
}

fn minus(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}
