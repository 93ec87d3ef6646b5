//! How to find it: the three iterations, their rules, and one loop that counts, stops and judges.
//!
//! * [`problem`] — what an algorithm sees: matrices, points and scales, no geometry.
//! * [`rule`] — how the springs' strain drives their stiffness or force.
//! * [`varying`], [`constant`], [`kinematic`] — equations (3.2)–(3.14), one step each.
//! * [`acceleration`] — of the fixed point of constant stiffness; an option.
//! * [`kept`], [`settling`] — their factors, where few springs change and where most come to rest.
//! * [`exact`] — the discrete solution that all of them shall end in.
//! * [`target`] — how far an iterate is from it.
//! * [`bound`] — a bound on that, in the energy norm.
//! * [`parts`] — points and edges contact by contact, and the means over edges.
//! * [`mod@iterate`] — the loop.

pub mod acceleration;
pub mod bound;
pub mod constant;
pub mod exact;
pub mod iterate;
pub mod kept;
pub mod kinematic;
pub mod parts;
pub mod problem;
pub mod rule;
pub mod settling;
pub mod target;
pub mod varying;

use crate::named::named_enum;
use crate::solution::Work;

pub use acceleration::Acceleration;
pub use constant::Constant;
pub use exact::{Exact, Law};
pub use iterate::{Settings, iterate, iterate_from};
pub use kinematic::Kinematic;
pub use problem::{ContactProblem, Scale};
pub use rule::StiffnessRule;
pub use target::Target;
pub use varying::Varying;

named_enum! {
    /// Iteration algorithm, in the paper's order.
    pub enum Iteration {
        /// Varying stiffness: factorised at every step.
        Varying = "varying",
        /// Constant stiffness: one factorisation, changing forces.
        Constant = "constant",
        /// Kinematic load: the springs' unstrained length is the gap.
        Kinematic = "kinematic",
    }
}

impl Iteration {
    /// Rules the algorithm offers, the default first.
    pub fn rules(self) -> &'static [StiffnessRule] {
        match self {
            Self::Varying => &[StiffnessRule::Secant, StiffnessRule::Correction],
            Self::Constant => &[StiffnessRule::Correction, StiffnessRule::Secant, StiffnessRule::Literal],
            Self::Kinematic => &[StiffnessRule::Switching, StiffnessRule::Penalty],
        }
    }

    /// Default initial stiffness κ₀: that of the bodies, and under kinematic load one that hardly yields.
    pub fn default_stiffness(self) -> f64 {
        match self {
            Self::Varying | Self::Constant => 1.0,
            Self::Kinematic => 1e6,
        }
    }

    /// The algorithm before its first step.
    pub fn with(self, rule: StiffnessRule, acceleration: Acceleration, tolerance: f64) -> Box<dyn Algorithm> {
        match self {
            Self::Varying => Box::new(Varying::new(rule)),
            Self::Constant => Box::new(Constant::accelerated(rule, acceleration)),
            Self::Kinematic => Box::new(Kinematic::new(rule, tolerance)),
        }
    }
}

/// The springs as they stand between two steps.
#[derive(Clone, Debug)]
pub struct Springs {
    /// Stiffness `k` per area of each point [MPa/mm]; zero is open.
    pub stiffness: Vec<f64>,
    /// Force per area `r` carried by each point beside its spring \[MPa\].
    pub force: Vec<f64>,
}

/// What one step finds.
#[derive(Clone, Debug)]
pub struct Iterate {
    /// Displacements of the retained freedoms \[mm\].
    pub displacement: Vec<f64>,
    /// Approach of each point \[mm\].
    pub approach: Vec<f64>,
    /// Spring force per area of each point, tension negative \[MPa\].
    pub pressure: Vec<f64>,
    /// Internal force `S u` of the displacements \[N\].
    pub internal: Vec<f64>,
}

/// An iteration algorithm: one step from springs to an iterate and to the next springs.
pub trait Algorithm {
    /// Solves with the present springs under `load`, then lets the rule change them.
    ///
    /// None where `S + K_c` is not positive definite: no spring is left to hold a body.
    fn step(
        &mut self,
        problem: &ContactProblem,
        load: &[f64],
        springs: &mut Springs,
        work: &mut Work,
    ) -> Option<Iterate>;

    /// Told before the first step of each load increment: the load is no longer what it was.
    fn reload(&mut self) {}

    /// Whether penetration is the springs' own law (penalty) instead of an error to be iterated away.
    fn is_elastic(&self) -> bool {
        false
    }
}
