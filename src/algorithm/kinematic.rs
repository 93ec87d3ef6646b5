//! Iteration with kinematic load, equations (3.11)–(3.14): the springs' unstrained length is the gap.

use crate::algorithm::rule::StiffnessRule;
use crate::algorithm::{Algorithm, ContactProblem, Iterate, Springs};
use crate::solution::Work;

/// `(S + K_c(k^j)) u_j = f̂ + Σ A k^j g b`, `p_j = k^j (w_j − g)`.
///
/// Tension opens a point; an open point that penetrates closes at `k_hard`; a closed point that penetrates by more than
/// the tolerance goes to `k_hard`. One that is already there passes its force on to the carried force, `r ← p`, so that
/// the penetration `p/k_hard ≈ 1e-6 g_ref` can be taken below any tolerance (it is never reached at the default one).
#[derive(Clone, Copy, Debug)]
pub struct Kinematic {
    /// `Switching`, or `Penalty`: springs closed where w > g keep their initial stiffness.
    pub rule: StiffnessRule,
    /// Penetration over `g_ref` that is tolerated.
    pub tolerance: f64,
}

impl Algorithm for Kinematic {
    fn step(&mut self, problem: &ContactProblem, load: &[f64], springs: &mut Springs, work: &mut Work) -> Option<Iterate> {
        let factor = problem.factorise(&springs.stiffness, work)?;
        let iterate = problem.equilibrium(&factor, load, springs, |point| point.gap, work);
        for (i, point) in problem.points.iter().enumerate() {
            let (depth, p) = (iterate.approach[i] - point.gap, iterate.pressure[i]);
            match self.rule {
                StiffnessRule::Penalty => {
                    springs.stiffness[i] = if depth > 0.0 { problem.initial[i] } else { 0.0 };
                }
                _ => self.switch(problem, springs, i, depth, p),
            }
        }
        Some(iterate)
    }

    fn is_elastic(&self) -> bool {
        self.rule == StiffnessRule::Penalty
    }
}

impl Kinematic {
    fn switch(&self, problem: &ContactProblem, springs: &mut Springs, i: usize, depth: f64, pressure: f64) {
        let hard = problem.scale.hard();
        let tolerated = self.tolerance * problem.scale.gap;
        let closed = springs.stiffness[i] > 0.0;
        if closed && pressure < 0.0 {
            (springs.stiffness[i], springs.force[i]) = (0.0, 0.0);
        } else if !closed && depth > 0.0 {
            (springs.stiffness[i], springs.force[i]) = (hard, 0.0);
        } else if closed && depth.abs() > tolerated {
            springs.force[i] = if springs.stiffness[i] < hard { 0.0 } else { pressure };
            springs.stiffness[i] = hard;
        }
    }
}
