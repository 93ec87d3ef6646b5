//! Iteration with kinematic load, equations (3.11)–(3.14): the springs' unstrained length is the gap.

use crate::algorithm::kept::KeptFactor;
use crate::algorithm::rule::StiffnessRule;
use crate::algorithm::{Algorithm, ContactProblem, Iterate, Springs};
use crate::solution::Work;

/// `(S + K_c(k^j)) u_j = f̂ + Σ A k^j g b`, `p_j = k^j (w_j − g)`.
///
/// Tension opens a point; an open point that penetrates closes at `k_hard`; a closed point that penetrates by more than
/// the tolerance goes to `k_hard`. Where one is already there, all hard springs pass their force on to the carried force,
/// `r ← p`, so that the penetration `p/k_hard ≈ 1e-6 g_ref` falls below any tolerance (never needed at the default one).
#[derive(Clone, Debug)]
pub struct Kinematic {
    /// `Switching`, or `Penalty`: springs closed where w > g keep their initial stiffness.
    pub rule: StiffnessRule,
    /// Penetration over `g_ref` that is tolerated.
    pub tolerance: f64,
    kept: KeptFactor,
}

impl Kinematic {
    /// The algorithm before its first step.
    pub fn new(rule: StiffnessRule, tolerance: f64) -> Self {
        Self { rule, tolerance, kept: KeptFactor::default() }
    }
}

impl Algorithm for Kinematic {
    fn step(
        &mut self,
        problem: &ContactProblem,
        load: &[f64],
        springs: &mut Springs,
        work: &mut Work,
    ) -> Option<Iterate> {
        let factor = self.kept.renew(problem, &springs.stiffness, work)?;
        let iterate = problem.equilibrium(factor, load, springs, |point| point.gap, work);
        let depth = |i: usize| iterate.approach[i] - problem.points[i].gap;
        if self.rule == StiffnessRule::Penalty {
            for (i, k) in springs.stiffness.iter_mut().enumerate() {
                *k = if depth(i) > 0.0 { problem.initial[i] } else { 0.0 };
            }
            return Some(iterate);
        }
        let (hard, tolerated) = (problem.scale.hard(), self.tolerance * problem.scale.gap);
        let too_deep = |k: f64, i: usize| k > 0.0 && depth(i).abs() > tolerated;
        let carry = springs.stiffness.iter().enumerate().any(|(i, &k)| k >= hard && too_deep(k, i));
        for (i, &p) in iterate.pressure.iter().enumerate() {
            let (k, r) = (springs.stiffness[i], springs.force[i]);
            (springs.stiffness[i], springs.force[i]) = match () {
                _ if k > 0.0 && p < 0.0 => (0.0, 0.0),
                _ if k >= hard && carry => (hard, p),
                _ if k <= 0.0 && depth(i) > 0.0 => (hard, 0.0),
                _ if k < hard && too_deep(k, i) => (hard, 0.0),
                _ => (k, r),
            };
        }
        Some(iterate)
    }

    fn is_elastic(&self) -> bool {
        self.rule == StiffnessRule::Penalty
    }
}
