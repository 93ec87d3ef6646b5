//! The rule: how the strain of a spring drives its stiffness or its force. The paper points to its ref. 12 for it.

use crate::algorithm::Scale;
use crate::named::named_enum;

named_enum! {
    /// A named rule; which algorithm offers which is decided by [`Iteration`](crate::algorithm::Iteration).
    pub enum StiffnessRule {
        /// `k ← k max(w, 0) / g`: the spring's own strain drives it until w = g (gap element; Stadter & Weiss 1979).
        Secant = "secant",
        /// `p ← max(0, p + κ (w − g))`: projected correction (Uzawa, augmented Lagrangian).
        Correction = "correction",
        /// Equation (3.10) taken literally, with the secant rule on stored stiffnesses.
        Literal = "literal",
        /// The kinematic algorithm's own: tension opens, penetration closes and hardens.
        Switching = "switching",
        /// Springs stay as they are, closed where w > g: the discrete problem of penalty codes.
        Penalty = "penalty",
    }
}

/// Secant: `k max(w, 0) / max(g, 1e-9 g_ref)`, within the limits [MPa/mm].
pub fn secant(scale: &Scale, stiffness: f64, approach: f64, gap: f64) -> f64 {
    scale.clip(stiffness * positive_part(approach) / scale.above_zero(gap))
}

/// Correction: `max(0, p + κ (w − g))` \[MPa\].
pub fn correction(pressure: f64, stiffness: f64, approach: f64, gap: f64) -> f64 {
    positive_part(pressure + stiffness * (approach - gap))
}

/// `max(x, 0)`, NaN staying NaN.
fn positive_part(x: f64) -> f64 {
    if x < 0.0 { 0.0 } else { x }
}
