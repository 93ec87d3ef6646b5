//! Iteration with kinematic load, equations (3.11)–(3.14): the springs' unstrained length is the gap.

use crate::algorithm::kept::KeptFactor;
use crate::algorithm::rule::StiffnessRule;
use crate::algorithm::{Algorithm, ContactProblem, Iterate, Law, Springs};
use crate::solution::Work;

/// Part of the tolerance that penetrations may take: where pressures alternate, they feel a penetration several times
/// over.
const SHARE: f64 = 0.1;

/// `(S + K_c(k^j)) u_j = f̂ + Σ A k^j g b`, `p_j = k^j (w_j − g)`.
///
/// Tension opens a point; an open point that penetrates closes at `k_hard`; a closed point that penetrates by more than
/// the tolerance goes to `k_hard`. Where one is already there, all hard springs pass their force on to the carried
/// force, `r ← p`, so that the penetration `p/k_hard` falls below any tolerance (never needed at the default one).
#[derive(Clone, Debug)]
pub struct Kinematic {
    /// `Switching`, or `Penalty`: springs closed where w > g keep their initial stiffness.
    pub rule: StiffnessRule,
    /// Iteration error that is accepted: penetrations of a tenth of it are tolerated, over the approach that the
    /// contact's own force makes.
    pub tolerance: f64,
    kept: KeptFactor,
}

impl Kinematic {
    /// The algorithm before its first iteration.
    pub fn new(rule: StiffnessRule, tolerance: f64) -> Self {
        Self { rule, tolerance, kept: KeptFactor::default() }
    }

    /// Penetration that is tolerated in each contact, `SHARE · tolerance · Σ A p⁺/(E* t)` \[mm\].
    fn tolerated(&self, problem: &ContactProblem, iterate: &Iterate) -> Vec<f64> {
        let mut tolerated = vec![0.0; problem.compliance.len()];
        for (point, p) in problem.points.iter().zip(&iterate.pressure) {
            tolerated[point.contact] +=
                SHARE * self.tolerance * point.weight * p.max(0.0) * problem.compliance[point.contact];
        }
        tolerated
    }
}

impl Algorithm for Kinematic {
    fn next(&mut self, problem: &ContactProblem, springs: &mut Springs, work: &mut Work) -> Option<Iterate> {
        let factor = self.kept.renew(problem, &springs.stiffness, work)?;
        let iterate = problem.equilibrium(factor, springs, |point| point.gap, work);
        let depth = |i: usize| iterate.approach[i] - problem.points[i].gap;
        if self.rule == StiffnessRule::Penalty {
            for (i, k) in springs.stiffness.iter_mut().enumerate() {
                *k = if depth(i) > 0.0 { problem.initial[i] } else { 0.0 };
            }
            return Some(iterate);
        }
        let (scale, tolerated) = (&problem.scale, self.tolerated(problem, &iterate));
        let hard = scale.hard();
        let too_deep = |k: f64, i: usize| k > 0.0 && depth(i).abs() > tolerated[problem.points[i].contact];
        let next = |carry: bool, i: usize| {
            let (k, r, p) = (springs.stiffness[i], springs.force[i], iterate.pressure[i]);
            match () {
                _ if k > 0.0 && p < 0.0 => [0.0, 0.0],
                _ if scale.is_hard(k) && carry => [hard, p],
                _ if k <= 0.0 && depth(i) > 0.0 => [hard, 0.0],
                _ if !scale.is_hard(k) && too_deep(k, i) => [hard, 0.0],
                _ => [k, r],
            }
        };
        let all = |carry: bool| (0..problem.points.len()).map(|i| next(carry, i)).collect::<Vec<_>>();
        let changes = |to: &[[f64; 2]]| {
            let is_other = |(i, [k, r]): (usize, &[f64; 2])| *k != springs.stiffness[i] || *r != springs.force[i];
            to.iter().enumerate().any(is_other)
        };
        let carry = springs.stiffness.iter().enumerate().any(|(i, &k)| scale.is_hard(k) && too_deep(k, i));
        // What would not change and is asked for once more is not yet right: what penetration is left matters.
        let to = Some(all(carry)).filter(|to| changes(to)).unwrap_or_else(|| all(true));
        for (i, [k, r]) in to.into_iter().enumerate() {
            (springs.stiffness[i], springs.force[i]) = (k, r);
        }
        Some(iterate)
    }

    fn law(&self) -> Law {
        if self.rule == StiffnessRule::Penalty { Law::Springs } else { Law::Rigid }
    }
}
