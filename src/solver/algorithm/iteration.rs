//! The choice of the algorithm.

use crate::algorithm::rule::Leeway;
use crate::algorithm::{Acceleration, Algorithm, Constant, Kinematic, StiffnessRule, Varying};
use crate::named::named_enum;

named_enum! {
    /// Iteration algorithm, in the paper's order.
    pub enum Iteration {
        /// Varying stiffness: factorised at every iteration.
        Varying = "varying",
        /// Constant stiffness: one factorisation, changing forces.
        Constant = "constant",
        /// Kinematic load: the springs' unstrained length is the gap.
        Kinematic = "kinematic",
    }
}

impl Iteration {
    /// Rules of the algorithm, the default first, whose convergence is predicted.
    pub fn rules(self) -> &'static [StiffnessRule] {
        match self {
            Self::Varying => &[StiffnessRule::Secant, StiffnessRule::Correction],
            Self::Constant => &[StiffnessRule::Correction, StiffnessRule::Secant, StiffnessRule::Literal],
            Self::Kinematic => &[StiffnessRule::Switching, StiffnessRule::Penalty],
        }
    }

    /// Further rules by which the paper can have changed its stiffnesses: offered, and compared as readings of it
    /// alone.
    pub fn further_rules(self) -> &'static [StiffnessRule] {
        match self {
            Self::Varying => &[StiffnessRule::Squared, StiffnessRule::Step, StiffnessRule::Doubling],
            Self::Constant | Self::Kinematic => &[],
        }
    }

    /// Default initial stiffness κ₀: that of the bodies, and under kinematic load one that hardly yields.
    pub fn default_stiffness(self) -> f64 {
        match self {
            Self::Varying | Self::Constant => 1.0,
            Self::Kinematic => 1e6,
        }
    }

    /// The algorithm before its first iteration.
    pub fn with(
        self,
        rule: StiffnessRule,
        leeway: Leeway,
        acceleration: Acceleration,
        tolerance: f64,
    ) -> Box<dyn Algorithm> {
        match self {
            Self::Varying => Box::new(Varying::accelerated(rule, leeway, acceleration)),
            Self::Constant => Box::new(Constant::accelerated(rule, acceleration)),
            Self::Kinematic => Box::new(Kinematic::new(rule, tolerance)),
        }
    }
}
