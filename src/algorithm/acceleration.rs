//! Acceleration of a fixed point from its last states: not of the paper, and named beside what is accelerated.
//!
//! Constant stiffness is accelerated on its forces; varying stiffness by Newton's method on the
//! [logarithms](crate::algorithm::logarithms) of its stiffnesses. With the rule `correction` the iteration `x → G(x)` of the carried forces is Douglas–Rachford splitting of elasticity and
//! contact (Lions & Mercier 1979). In the norm `‖f‖² = Σ A f²/k₀` it is firmly nonexpansive, so the residual
//! `f = G(x) − x` never grows in a plain iteration, whatever κ₀.

use std::collections::VecDeque;

use nalgebra::{DMatrix, DVector};

use crate::named::named_enum;

named_enum! {
    /// How the fixed point is approached.
    pub enum Acceleration {
        /// `x⁺ = G(x)`: the paper's own iteration.
        None = "none",
        /// `x⁺ = x + f − Σ γ (Δx + Δf)`, γ minimising `‖f − Σ γ Δf‖` over the last differences (Walker & Ni 2011).
        Anderson = "anderson",
        /// `ln k⁺ = ln k + (1 + δ)(M + δ)⁻¹ ln(w/g)`, M what springs and bodies yield together: Newton's method, damped.
        Newton = "newton",
    }
}

/// Differences that Anderson acceleration remembers. Of 3, 5, 8, 12 and 20, five reach the most starts at tolerance 1e-3:
/// more of them reach back to active sets that are no longer the present one.
pub const DEPTH: usize = 5;
/// Singular values of the scaled differences below this part of the largest are left out.
const CONDITION: f64 = 1e-8;
/// A difference of residuals below this part of the latest is round-off: of bodies in free motion residuals stay as they are, and
/// there is no slope to follow.
const ROUND_OFF: f64 = 1e-9;
/// The safeguard's factor and exponent: accelerated iteration number n may lead to residuals up to `100 F (n + 1)^−1.1`.
const SAFEGUARD: (f64, f64) = (100.0, 1.1);

/// The last states `x` of a fixed-point iteration with their residuals `f = G(x) − x`, the latest last.
#[derive(Clone, Debug, Default)]
pub struct History {
    states: VecDeque<[Vec<f64>; 2]>,
}

impl History {
    /// Forgets all but the latest states.
    pub fn keep(&mut self, states: usize) {
        self.states.drain(..self.states.len().saturating_sub(states));
    }

    /// Remembers a state, and forgets what lies further back than the acceleration reaches.
    pub fn push(&mut self, x: &[f64], f: &[f64]) {
        self.states.push_back([x.to_vec(), f.to_vec()]);
        self.keep(DEPTH + 1);
    }

    /// The step from the latest state that the states remembered make of its residual, in the inner product of some weights; none
    /// where there is only one state, or no finite step.
    pub fn step(&self, weights: &[f64]) -> Option<Vec<f64>> {
        let pairs = self.states.iter().zip(self.states.iter().skip(1));
        let changes: Vec<[Vec<f64>; 2]> = pairs.map(|(a, b)| [0, 1].map(|k| minus(&b[k], &a[k]))).collect();
        let [_, f] = self.states.back().filter(|_| !changes.is_empty())?;
        let mut step = f.clone();
        for (gamma, [dx, df]) in least_squares(weights, &changes, f)?.iter().zip(&changes) {
            step.iter_mut().zip(dx.iter().zip(df)).for_each(|(x, (dx, df))| *x -= gamma * (dx + df));
        }
        step.iter().all(|x| x.is_finite()).then_some(step)
    }
}

/// γ of least `‖f − Σ γ Δf‖`, by singular values of the differences brought to length one; none where one of them is round-off of f.
fn least_squares(weights: &[f64], changes: &[[Vec<f64>; 2]], f: &[f64]) -> Option<Vec<f64>> {
    let roots: Vec<f64> = weights.iter().map(|weight| weight.sqrt()).collect();
    let lengths: Vec<f64> = changes.iter().map(|[_, df]| dot(weights, df, df).sqrt()).collect();
    let shortest = ROUND_OFF * dot(weights, f, f).sqrt();
    if !lengths.iter().all(|length| *length > shortest) {
        return None;
    }
    let columns = DMatrix::from_fn(f.len(), changes.len(), |i, j| roots[i] * changes[j][1][i] / lengths[j]);
    let rhs = DVector::from_fn(f.len(), |i, _| roots[i] * f[i]);
    if columns.iter().any(|entry| !entry.is_finite()) {
        return None;
    }
    let values = columns.svd(true, true);
    let solution = values.solve(&rhs, CONDITION * values.singular_values.max()).ok()?;
    Some(solution.iter().zip(&lengths).map(|(y, length)| y / length).collect())
}

/// `Σ A x y` of some weights A.
pub fn dot(weights: &[f64], x: &[f64], y: &[f64]) -> f64 {
    weights.iter().zip(x.iter().zip(y)).map(|(weight, (x, y))| weight * x * y).sum()
}

/// What is made of the states of constant stiffness.
///
/// Three safeguards. A state reached by acceleration is given up for the plain iteration before it where
/// `‖f‖ > 100 F (n + 1)^−1.1`, n accelerated iterations so far, F the residual of the first state: a summable bound, which with
/// nonexpansive plain iterations leaves no way but to converge (Zhang, O'Donoghue & Boyd 2020). A plain iteration follows where
/// the residual rose, and after every accelerated one. A step that is not finite is not made.
#[derive(Clone, Debug)]
pub struct Accelerator {
    /// Weight of each component in the inner product, `A/k₀`.
    pub weights: Vec<f64>,
    history: History,
    /// F: residuals are measured against that of the first state.
    first: Option<f64>,
    /// `G` of the state before, where the present one was reached by acceleration.
    plain: Option<Vec<f64>>,
    accelerated: usize,
    size: f64,
}

impl Accelerator {
    /// Nothing remembered yet.
    pub fn new(weights: Vec<f64>) -> Self {
        Self { weights, history: History::default(), first: None, plain: None, accelerated: 0, size: f64::INFINITY }
    }

    /// The state after `x`, whose residual is `f = G(x) − x`; adds to `rejected` where `x` is given up.
    pub fn next(&mut self, x: &[f64], f: &[f64], rejected: &mut usize) -> Vec<f64> {
        let size = dot(&self.weights, f, f).sqrt();
        let before = self.plain.take();
        let within = size <= self.bound(size);
        if let Some(plain) = before.as_ref().filter(|_| !within) {
            *rejected += 1;
            self.history.keep(1);
            return plain.clone();
        }
        let rose = size > self.size;
        self.size = size;
        self.history.push(x, f);
        let after = |step: &[f64]| -> Vec<f64> { x.iter().zip(step).map(|(x, step)| x + step).collect() };
        let step = if rose || before.is_some() { None } else { self.history.step(&self.weights) };
        let Some(step) = step else { return after(f) };
        self.accelerated += 1;
        self.plain = Some(after(f));
        after(&step)
    }

    /// Largest residual of a state reached by acceleration that is accepted.
    fn bound(&mut self, size: f64) -> f64 {
        let (factor, exponent) = SAFEGUARD;
        factor * *self.first.get_or_insert(size) * (self.accelerated as f64 + 1.0).powf(-exponent)
    }
}

fn minus(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}
