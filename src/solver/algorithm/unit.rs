//! What an initial stiffness κ₀ is a multiple of.

use crate::algorithm::{ContactProblem, parts};
use crate::contact::ContactPoint;
use crate::named::named_enum;

named_enum! {
    /// What an initial stiffness κ₀ is a multiple of.
    pub enum StiffnessUnit {
        /// `E*/ℓ` of the reference: the stiffness of the paper, made a pure number.
        Reference = "reference",
        /// `√(E*/L · s)` of each contact, L its candidate stretch, 1/s the mean over it of what the bodies yield under a pressure on one
        /// point alone: between the softest pressure that they see and the sharpest one, whatever the reference.
        Bodies = "bodies",
    }
}

impl StiffnessUnit {
    /// Stiffness of κ₀ = 1 of every point [MPa/mm], where its relative stiffness is 1.
    pub fn of(self, problem: &ContactProblem) -> Vec<f64> {
        if self == Self::Reference {
            return vec![problem.scale.stiffness; problem.points.len()];
        }
        let mut unit = vec![0.0; problem.points.len()];
        for own in parts::points(problem.points) {
            let points = &problem.points[own.clone()];
            let sum = |of: &dyn Fn(&ContactPoint) -> f64| points.iter().map(of).sum::<f64>();
            let area = sum(&|point| point.weight);
            let relative = sum(&|point| point.weight * point.relative_stiffness) / area;
            let yields = sum(&|point| point.weight.powi(2) / problem.resistance(point)) / area;
            let stretched = problem.compliance[points[0].contact] * area;
            unit[own].fill(1.0 / ((stretched * yields).sqrt() * relative));
        }
        unit
    }
}
