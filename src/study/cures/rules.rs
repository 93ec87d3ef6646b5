//! Every rule of constant stiffness with every acceleration on the drawn plane, node element.

use serde::Serialize;

use crate::algorithm::{Acceleration, StiffnessRule};
use crate::error::Error;
use crate::solution::{Outcome, Solution};
use crate::solve::{Element, Formulation, Iteration, Settings};
use crate::study::cures::record::{DRAWN, ITERATIONS, PLANES, discretised};

/// A rule from one start.
#[derive(Clone, Debug, Serialize)]
pub struct Rule {
    /// The rule.
    pub rule: StiffnessRule,
    /// Initial stiffness κ₀.
    pub stiffness: f64,
    /// How each acceleration ended, in the order of [`Acceleration::OF_FORCES`].
    pub ended: Vec<Ended>,
}

/// How a run ended.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Ended {
    /// How.
    pub outcome: Outcome,
    /// Iterations made.
    pub iterations: usize,
}

impl Ended {
    /// Of a solution.
    pub(super) fn of(solution: &Solution) -> Self {
        Self { outcome: solution.outcome, iterations: solution.work.iterations }
    }

    /// Iterations to convergence; none where there was none.
    ///
    /// Whether a run that does not converge uses up its iterations or diverges depends on round-off.
    pub fn converged(&self) -> Option<usize> {
        (self.outcome == Outcome::Converged).then_some(self.iterations)
    }
}

/// Every rule from two starts.
pub(super) fn run() -> Result<Vec<Rule>, Error> {
    let discretisation = discretised(PLANES[DRAWN])?;
    let base = Formulation::new(Element::Node, Iteration::Constant);
    let settings = Settings { max_iterations: ITERATIONS, ..Settings::default() };
    let starts = Iteration::Constant.rules().iter().flat_map(|&rule| [1.0, 10.0].map(|stiffness| (rule, stiffness)));
    let of = |(rule, stiffness): (StiffnessRule, f64)| {
        let ended = |&acceleration: &Acceleration| {
            let formulation = Formulation { rule, stiffness, acceleration, settings, ..base.clone() };
            Ok(Ended::of(&discretisation.solve(&formulation)?))
        };
        Ok(Rule { rule, stiffness, ended: Acceleration::OF_FORCES.iter().map(ended).collect::<Result<_, Error>>()? })
    };
    starts.map(of).collect()
}
