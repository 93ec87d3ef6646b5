//! Iteration with constant stiffness, equations (3.6)–(3.10): one factorisation, changing forces.

use crate::algorithm::acceleration::{Acceleration, Accelerator};
use crate::algorithm::rule::{self, StiffnessRule};
use crate::algorithm::{Algorithm, ContactProblem, Iterate, Springs};
use crate::condensation::dense::DenseFactor;
use crate::solution::Work;

/// `(S + K_c0) u_j = f̂ − Σ A r_j b`, spring force `p_j = k_0 w_j + r_j`, `r_{j+1} = r_j + (p⁺ − p_j)`.
#[derive(Clone, Debug)]
pub struct Constant {
    /// `Correction` with κ = k_0, `Secant` on the spring force, or `Literal`.
    pub rule: StiffnessRule,
    /// How the fixed point of the carried forces is approached.
    pub acceleration: Acceleration,
    accelerator: Option<Accelerator>,
    factor: Option<DenseFactor>,
    /// Stiffnesses stored by the literal reading of (3.10).
    stored: Vec<f64>,
}

impl Constant {
    /// The paper's algorithm before its first iteration.
    pub fn new(rule: StiffnessRule) -> Self {
        Self::accelerated(rule, Acceleration::None)
    }

    /// The same with an acceleration.
    pub fn accelerated(rule: StiffnessRule, acceleration: Acceleration) -> Self {
        Self { rule, acceleration, accelerator: None, factor: None, stored: Vec::new() }
    }
}

impl Algorithm for Constant {
    fn next(
        &mut self,
        problem: &ContactProblem,
        load: &[f64],
        springs: &mut Springs,
        work: &mut Work,
    ) -> Option<Iterate> {
        if self.factor.is_none() {
            self.factor = Some(problem.factorise(&problem.initial, work)?);
            self.stored = problem.initial.clone();
        }
        let factor = self.factor.as_ref()?;
        let iterate = problem.equilibrium(factor, load, springs, |_| 0.0, work);
        let before = springs.force.clone();
        for (i, point) in problem.points.iter().enumerate() {
            let (w, p) = (iterate.approach[i], iterate.pressure[i]);
            springs.force[i] += match self.rule {
                StiffnessRule::Literal => self.literal_change(problem, i, w),
                StiffnessRule::Secant => secant_force(problem, p, w, point.gap) - p,
                _ => rule::correction(p, problem.initial[i], w, point.gap) - p,
            };
        }
        if self.acceleration != Acceleration::None {
            let change: Vec<f64> = springs.force.iter().zip(&before).map(|(after, before)| after - before).collect();
            let accelerator = self.accelerator.get_or_insert_with(|| accelerator(problem));
            springs.force = accelerator.next(&before, &change, &mut work.rejected);
        }
        Some(iterate)
    }

    fn reload(&mut self, _: &ContactProblem, _: &mut Springs) {
        self.accelerator = None;
    }

    fn remembers(&self) -> bool {
        self.acceleration != Acceleration::None
    }
}

/// Inner product `Σ A x y/k₀`, in which the rule `correction` is nonexpansive.
fn accelerator(problem: &ContactProblem) -> Accelerator {
    let terms = problem.points.iter().zip(&problem.initial);
    Accelerator::new(terms.map(|(point, k)| point.weight / k).collect())
}

impl Constant {
    /// `K_cj q_{j−1}` of (3.10) as it stands: the change of the stored stiffness times the approach.
    fn literal_change(&mut self, problem: &ContactProblem, i: usize, approach: f64) -> f64 {
        let before = self.stored[i];
        self.stored[i] = rule::secant(&problem.scale, before, approach, problem.points[i].gap);
        (self.stored[i] - before) * approach
    }
}

/// The secant rule on the spring force: `p⁺ = p max(w, 0)/g`, its stiffness `p⁺/w` kept within the limits.
fn secant_force(problem: &ContactProblem, pressure: f64, approach: f64, gap: f64) -> f64 {
    let scale = &problem.scale;
    if approach <= 0.0 {
        return 0.0;
    }
    let present = scale.clip(pressure / scale.above_zero(approach));
    rule::secant(scale, present, approach, gap) * approach
}
