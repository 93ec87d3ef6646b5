//! Iteration with constant stiffness, equations (3.6)–(3.10): one factorisation, changing forces.

use crate::algorithm::forces::Forces;
use crate::algorithm::rule::{self, Acceleration, StiffnessRule};
use crate::algorithm::{Algorithm, ContactProblem, Iterate, Springs};
use crate::condensation::stiffness::SystemFactor;
use crate::solution::Work;

/// `(S + K_c0) u_j = f̂ − Σ A r_j b`, spring force `p_j = k_0 w_j + r_j`, `r_{j+1} = r_j + (p⁺ − p_j)`.
#[derive(Clone, Debug)]
pub struct Constant {
    /// `Correction` by k_0, `Secant` on the spring force, or `Literal`.
    pub rule: StiffnessRule,
    /// How the fixed point of the carried forces is approached.
    pub acceleration: Acceleration,
    factor: Option<SystemFactor>,
    forces: Option<Forces>,
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
        Self { rule, acceleration, factor: None, forces: None, stored: Vec::new() }
    }
}

impl Algorithm for Constant {
    fn next(&mut self, problem: &ContactProblem, springs: &mut Springs, work: &mut Work) -> Option<Iterate> {
        if self.factor.is_none() {
            self.factor = Some(problem.factorise(&problem.initial, work)?);
            self.stored = problem.initial.clone();
        }
        if self.acceleration != Acceleration::None && self.forces.is_none() {
            self.forces = self.factor.as_ref().map(|factor| Forces::of(problem, factor, work));
        }
        let factor = self.factor.as_ref()?;
        let iterate = problem.equilibrium(factor, springs, |_| 0.0, work);
        if let Some(step) = self.forces.as_ref().and_then(|forces| forces.step(problem, &iterate, work)) {
            springs.force.iter_mut().zip(step).for_each(|(force, change)| *force += change);
            return Some(iterate);
        }
        for (i, point) in problem.points.iter().enumerate() {
            let (w, p) = (iterate.approach[i], iterate.pressure[i]);
            springs.force[i] += match self.rule {
                StiffnessRule::Literal => self.literal_change(problem, i, w),
                StiffnessRule::Secant => secant_force(problem, p, w, point.gap) - p,
                _ => rule::correction(p, problem.initial[i], w, point.gap) - p,
            };
        }
        Some(iterate)
    }
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
