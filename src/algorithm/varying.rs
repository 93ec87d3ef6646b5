//! Iteration with varying stiffness, equations (3.2)–(3.5): the system is factorised at every iteration.

use crate::algorithm::rule::{self, StiffnessRule};
use crate::algorithm::settling::Settling;
use crate::algorithm::{Algorithm, ContactProblem, Iterate, Springs};
use crate::solution::Work;

/// `(S + K_c(k^j)) u_j = f̂`, `p_j = k^j w_j`; the rule gives k^{j+1}.
#[derive(Clone, Debug)]
pub struct Varying {
    /// `Secant`, or `Correction` with `κ_j = max(k^j, k_0)` and `k^{j+1} = p⁺ / w`.
    pub rule: StiffnessRule,
    kept: Settling,
}

impl Varying {
    /// The algorithm before its first iteration.
    pub fn new(rule: StiffnessRule) -> Self {
        Self { rule, kept: Settling::default() }
    }
}

impl Algorithm for Varying {
    fn next(
        &mut self,
        problem: &ContactProblem,
        load: &[f64],
        springs: &mut Springs,
        work: &mut Work,
    ) -> Option<Iterate> {
        let factor = self.kept.renew(problem, &springs.stiffness, work)?;
        let iterate = problem.equilibrium(factor, load, springs, |_| 0.0, work);
        let scale = &problem.scale;
        for (i, point) in problem.points.iter().enumerate() {
            let (k, w, p) = (springs.stiffness[i], iterate.approach[i], iterate.pressure[i]);
            springs.stiffness[i] = match self.rule {
                StiffnessRule::Correction => {
                    let wanted = rule::correction(p, k.max(problem.initial[i]), w, point.gap);
                    scale.clip(wanted / scale.above_zero(w))
                }
                _ => rule::secant(scale, k, w, point.gap),
            };
        }
        Some(iterate)
    }
}
