//! What the paper leaves open, axis by axis.

use serde::{Deserialize, Serialize};

use crate::algorithm::{Criterion, Leeway, Spring, StiffnessRule};
use crate::named::named_enum;
use crate::solve::{Element, Formulation, Iteration};

named_enum! {
    /// One of the paper's two examples.
    pub enum Example {
        /// Elastic cylinder on a rigid plane.
        Cylinder = "cylinder",
        /// Pin in a connecting rod.
        PinRod = "pin-rod",
    }
}

named_enum! {
    /// How far the candidates reach.
    pub enum Candidates {
        /// Beyond the contact: a "potential contact area".
        Wide = "wide",
        /// As far as the contact does.
        AtEdge = "at-edge",
    }
}

/// How an algorithm changes its springs.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rule {
    /// Algorithm.
    pub algorithm: Iteration,
    /// Rule.
    pub rule: StiffnessRule,
    /// Largest factor on a stiffness in an iteration; infinite is none.
    pub bound: f64,
    /// What has a stiffness of its own.
    pub spring: Spring,
}

/// Factors that a rule may be bounded by.
const BOUNDS: [f64; 4] = [2.0, 10.0, 100.0, f64::INFINITY];

/// Layer thicknesses over the length of an edge, the program's own first.
pub const THICKNESSES: [f64; 2] = [0.05, 0.005];

/// Initial stiffnesses κ₀: half decades from 1e-3 to 1e6.
pub fn starts() -> impl Iterator<Item = f64> {
    (-6..=12).map(|k| 10f64.powf(0.5 * f64::from(k)))
}

/// Caps of iterations.
pub const CAPS: [usize; 7] = [20, 30, 50, 100, 200, 500, 2000];

/// Tolerances of each criterion that has one.
pub const TOLERANCES: [f64; 6] = [1e-1, 1e-2, 5e-3, 1e-3, 1e-4, 1e-6];

/// A criterion with its tolerance.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Stop {
    /// Criterion.
    pub criterion: Criterion,
    /// Tolerance; of no meaning to the contact state.
    pub tolerance: f64,
}

impl Stop {
    /// All that can be had without the discrete solution, in the order of the record.
    pub fn all() -> Vec<Self> {
        let visible = Criterion::ALL.into_iter().filter(|criterion| *criterion != Criterion::Error);
        let of = |criterion: Criterion| {
            let tolerances = if criterion == Criterion::State { &TOLERANCES[..1] } else { &TOLERANCES[..] };
            tolerances.iter().map(move |&tolerance| Self { criterion, tolerance })
        };
        visible.flat_map(of).collect()
    }

    /// `residuals 1e-3`.
    pub fn name(&self) -> String {
        match self.criterion {
            Criterion::State => "contact state".into(),
            criterion => format!("{} {:.0e}", criterion.name(), self.tolerance),
        }
    }
}

impl Rule {
    /// Those of varying stiffness.
    pub fn varying() -> Vec<Self> {
        let of = |rule, bound, spring| Self { algorithm: Iteration::Varying, rule, bound, spring };
        let mut rules = vec![of(StiffnessRule::Correction, Leeway::default().bound, Spring::Point)];
        for spring in Spring::ALL {
            for rule in [StiffnessRule::Secant, StiffnessRule::Squared, StiffnessRule::Step] {
                rules.extend(BOUNDS.map(|bound| of(rule, bound, spring)));
            }
            rules.push(of(StiffnessRule::Doubling, BOUNDS[0], spring));
        }
        rules
    }

    /// Those of constant stiffness.
    pub fn constant() -> Vec<Self> {
        Iteration::Constant.rules().iter().map(|&rule| Self::of(Iteration::Constant, rule)).collect()
    }

    /// The one of kinematic load.
    pub fn kinematic() -> Self {
        Self::of(Iteration::Kinematic, StiffnessRule::Switching)
    }

    /// All.
    pub fn all() -> Vec<Self> {
        [Self::varying(), Self::constant(), vec![Self::kinematic()]].concat()
    }

    fn of(algorithm: Iteration, rule: StiffnessRule) -> Self {
        let Leeway { bound, spring } = Leeway::default();
        Self { algorithm, rule, bound, spring }
    }

    /// The rule with an element.
    pub fn formulation(&self, element: Element) -> Formulation {
        let &Self { algorithm, rule, bound, spring } = self;
        Formulation { rule, leeway: Leeway { bound, spring }, ..Formulation::new(element, algorithm) }
    }

    /// `squared, bound 2, per element`.
    pub fn name(&self) -> String {
        let mut name = self.rule.name().to_string();
        let bounded = [StiffnessRule::Secant, StiffnessRule::Squared, StiffnessRule::Step].contains(&self.rule);
        if self.algorithm == Iteration::Varying && bounded {
            name += &if self.bound.is_finite() { format!(", bound {}", self.bound) } else { ", unbounded".into() };
        }
        if self.spring == Spring::Element {
            name += ", per element";
        }
        name
    }
}
