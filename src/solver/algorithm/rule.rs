//! The rule: how the strain of a spring drives its stiffness or its force, and from which stiffness on. The paper
//! points to its ref. 12 for it.

use serde::Serialize;

use crate::algorithm::{ContactProblem, Scale, parts};
use crate::contact::ContactPoint;
use crate::named::named_enum;

named_enum! {
    /// A named rule; which algorithm offers which is decided by [`Iteration`](crate::algorithm::Iteration).
    pub enum StiffnessRule {
        /// `k ← k max(w, 0) / g`: the spring's own strain drives it until w = g (gap element; Stadter & Weiss 1979).
        Secant = "secant",
        /// `k ← k (max(w, 0) / g)²`: the same, twice as fast and half as stable.
        Squared = "squared",
        /// `k ← k max(0, 1 + 5 (w − g)/g_ref)`: in proportion to what is left of the gap, over that of the
        /// [reference](crate::scene::ReferenceValues).
        Step = "step",
        /// `k ← 2 k` where w > g, `k ← k/2` elsewhere.
        Doubling = "doubling",
        /// `p ← max(0, p + max(k, k₀) (w − g))`: projected correction (Uzawa, augmented Lagrangian).
        Correction = "correction",
        /// Equation (3.10) taken literally, with the secant rule on stored stiffnesses.
        Literal = "literal",
        /// The kinematic algorithm's own: tension opens, penetration closes and hardens.
        Switching = "switching",
        /// Springs stay as they are, closed where w > g: the discrete problem of penalty codes.
        Penalty = "penalty",
    }
}

named_enum! {
    /// How the fixed point of a rule is approached: what is not of the paper is named beside what it is added to.
    pub enum Acceleration {
        /// By the rule alone: the paper's own iteration.
        None = "none",
        /// By Newton's method, damped: on the logarithms of the stiffnesses (varying), on the forces of the springs
        /// (constant).
        Newton = "newton",
    }
}

named_enum! {
    /// What has a stiffness of its own, and changes it by its own approach and gap.
    pub enum Spring {
        /// Every contact point.
        Point = "point",
        /// Every contact element: its points change alike, by their mean approach over their mean gap.
        Element = "element",
    }
}

named_enum! {
    /// What an initial stiffness κ₀ is a multiple of.
    pub enum StiffnessUnit {
        /// `E*/ℓ` of the reference: the stiffness of the paper, made a pure number.
        Reference = "reference",
        /// `√(E*/L · s)` of each contact, L its candidate stretch, 1/s the mean over it of what the bodies yield under
        /// a pressure on one point alone: between the softest pressure that they see and the sharpest one, whatever the
        /// reference.
        Bodies = "bodies",
    }
}

impl StiffnessUnit {
    /// Stiffness of κ₀ = 1 of every point [MPa/mm], where its relative stiffness is 1.
    pub fn of(self, problem: &ContactProblem) -> Vec<f64> {
        if self == Self::Reference {
            return vec![problem.scale.stiffness; problem.points.len()];
        }
        let mut unit = vec![0.0; problem.points.len()];
        for own in parts::points(problem.points) {
            let points = &problem.points[own.clone()];
            let sum = |of: &dyn Fn(&ContactPoint) -> f64| points.iter().map(of).sum::<f64>();
            let area = sum(&|point| point.weight);
            let relative = sum(&|point| point.weight * point.relative_stiffness) / area;
            let yields = sum(&|point| point.weight.powi(2) / problem.resistance(point)) / area;
            let stretched = problem.compliance[points[0].contact] * area;
            unit[own].fill(1.0 / ((stretched * yields).sqrt() * relative));
        }
        unit
    }
}

/// How far varying stiffness lets its rule go.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Leeway {
    /// Factor B: an iteration changes a stiffness by no less than 1/B and no more than B; infinite is no bound.
    pub bound: f64,
    /// What has a stiffness of its own.
    pub spring: Spring,
}

impl Default for Leeway {
    /// Unbounded, the first factor of a stiff start raises every other Gauss point without end, which no node feels.
    fn default() -> Self {
        Self { bound: 100.0, spring: Spring::Point }
    }
}

/// Step: part of the reference gap by which a penetration doubles a stiffness.
const STEP: f64 = 0.2;

/// Factor by which a rule changes the stiffness of a spring of some approach and gap \[mm\].
pub fn factor(rule: StiffnessRule, scale: &Scale, approach: f64, gap: f64) -> f64 {
    let ratio = positive_part(approach) / scale.above_zero(gap);
    match rule {
        StiffnessRule::Squared => ratio * ratio,
        StiffnessRule::Step => positive_part(1.0 + (approach - gap) / (STEP * scale.gap)),
        StiffnessRule::Doubling if approach.is_nan() => f64::NAN,
        StiffnessRule::Doubling if approach > gap => 2.0,
        StiffnessRule::Doubling => 0.5,
        _ => ratio,
    }
}

/// Secant: `k max(w, 0) / max(g, 1e-9 g_ref)`, within the limits [MPa/mm].
pub fn secant(scale: &Scale, stiffness: f64, approach: f64, gap: f64) -> f64 {
    scale.clip(stiffness * factor(StiffnessRule::Secant, scale, approach, gap))
}

/// Correction: `max(0, p + k (w − g))`, k the larger of the own and the initial stiffness \[MPa\].
pub fn correction(pressure: f64, stiffness: f64, approach: f64, gap: f64) -> f64 {
    positive_part(pressure + stiffness * (approach - gap))
}

/// `max(x, 0)`, NaN staying NaN.
fn positive_part(x: f64) -> f64 {
    if x < 0.0 { 0.0 } else { x }
}
