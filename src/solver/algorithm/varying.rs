//! Iteration with varying stiffness, equations (3.2)–(3.5): the system is factorised at every iteration.

use crate::algorithm::logarithms::Logarithms;
use crate::algorithm::rule::{self, Acceleration, Leeway, Spring, StiffnessRule};
use crate::algorithm::settling::Settling;
use crate::algorithm::{Algorithm, ContactProblem, Iterate, Springs};
use crate::contact::ContactPoint;
use crate::solution::Work;

/// `(S + K_c(k^j)) u_j = f̂`, `p_j = k^j w_j`; the rule gives k^{j+1}.
#[derive(Clone, Debug)]
pub struct Varying {
    /// A factor on the stiffness ([`rule::factor`]), or `Correction` by `max(k^j, k_0)` and then `k^{j+1} = p⁺ / w`.
    pub rule: StiffnessRule,
    /// How far the rule may go in an iteration; `Correction` asks no bound.
    pub leeway: Leeway,
    /// How the fixed point of a factor is approached; none is the paper's own iteration.
    pub acceleration: Acceleration,
    logarithms: Logarithms,
    kept: Settling,
}

impl Varying {
    /// The algorithm before its first iteration.
    pub fn new(rule: StiffnessRule) -> Self {
        Self::accelerated(rule, Leeway::default(), Acceleration::None)
    }

    /// The same with another bound, or stiffnesses of elements, and an acceleration.
    pub fn accelerated(rule: StiffnessRule, leeway: Leeway, acceleration: Acceleration) -> Self {
        Self { rule, leeway, acceleration, logarithms: Logarithms::default(), kept: Settling::default() }
    }
}

/// Factors on the stiffnesses: `Σ A w` and `Σ A g` of what has one stiffness put into the rule, over `Σ A`.
fn factors(
    rule: StiffnessRule,
    Leeway { bound, spring }: Leeway,
    problem: &ContactProblem,
    approach: &[f64],
) -> Vec<f64> {
    let is_one = |a: &ContactPoint, b: &ContactPoint| spring == Spring::Element && in_one_element(a, b);
    let mut factors = Vec::with_capacity(approach.len());
    for own in problem.points.chunk_by(is_one) {
        let first = factors.len();
        let area: f64 = own.iter().map(|point| point.weight).sum();
        let w: f64 = own.iter().zip(&approach[first..]).map(|(point, w)| point.weight * w).sum();
        let g: f64 = own.iter().map(|point| point.weight * point.gap).sum();
        let factor = rule::factor(rule, &problem.scale, w / area, g / area).clamp(1.0 / bound, bound);
        factors.resize(first + own.len(), factor);
    }
    factors
}

/// Whether two points are quadrature points of one edge; a node, which neighbouring edges share, is an element of its
/// own.
fn in_one_element(a: &ContactPoint, b: &ContactPoint) -> bool {
    match (a.shares.as_slice(), b.shares.as_slice()) {
        ([(own, _)], [(other, _)]) => a.contact == b.contact && own == other,
        _ => false,
    }
}

impl Algorithm for Varying {
    fn next(&mut self, problem: &ContactProblem, springs: &mut Springs, work: &mut Work) -> Option<Iterate> {
        let factor = self.kept.renew(problem, &springs.stiffness, work)?;
        let iterate = problem.equilibrium(factor, springs, |_| 0.0, work);
        let scale = &problem.scale;
        if self.rule != StiffnessRule::Correction {
            let factors = factors(self.rule, self.leeway, problem, &iterate.approach);
            let before = springs.stiffness.clone();
            springs.stiffness.iter_mut().zip(factors).for_each(|(k, factor)| *k = scale.clip(*k * factor));
            if self.acceleration != Acceleration::None {
                self.logarithms.step((problem, factor), &iterate, &before, &mut springs.stiffness, work);
            }
            return Some(iterate);
        }
        for (i, point) in problem.points.iter().enumerate() {
            let (k, w, p) = (springs.stiffness[i], iterate.approach[i], iterate.pressure[i]);
            let wanted = rule::correction(p, k.max(problem.initial[i]), w, point.gap);
            springs.stiffness[i] = scale.clip(wanted / scale.above_zero(w));
        }
        Some(iterate)
    }

    /// Accelerated, springs that were open under the load before start as they did at first: by the rule alone they
    /// would take as many iterations to press again as they took to fall.
    fn reload(&mut self, problem: &ContactProblem, springs: &mut Springs) {
        if self.acceleration != Acceleration::None {
            self.logarithms = Logarithms::default();
            springs.stiffness.iter_mut().zip(&problem.initial).for_each(|(k, initial)| *k = k.max(*initial));
        }
    }
}
