//! What an initial stiffness κ₀ is a multiple of.

use crate::algorithm::{ContactProblem, parts};
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
    /// Stiffness of κ₀ = 1 at every point [MPa/mm].
    pub fn of(self, problem: &ContactProblem) -> Vec<f64> {
        if self == Self::Reference {
            return problem.points.iter().map(|point| problem.scale.stiffness * point.relative_stiffness).collect();
        }
        let mut unit = vec![0.0; problem.points.len()];
        for own in parts::points(problem.points) {
            let points = &problem.points[own.clone()];
            let sum = |of: &dyn Fn(usize) -> f64| own.clone().map(of).sum::<f64>();
            let area = sum(&|i| problem.points[i].weight);
            let relative = sum(&|i| problem.points[i].weight * problem.points[i].relative_stiffness) / area;
            let yields = sum(&|i| problem.points[i].weight.powi(2) / problem.resistance(&problem.points[i])) / area;
            let stretched = problem.compliance[points[0].contact] * area;
            let mean = 1.0 / (stretched * yields).sqrt();
            own.zip(points).for_each(|(i, point)| unit[i] = mean * point.relative_stiffness / relative);
        }
        unit
    }
}
