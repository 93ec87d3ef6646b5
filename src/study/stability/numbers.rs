//! What came out of any of the predictions.

use serde::Serialize;

use crate::study::stability::{basin, before, failing, fixed_target, halving, rates};

/// What came out of a trial.
#[derive(Clone, Debug, Serialize)]
pub enum Numbers {
    /// Rates of a method.
    Rates(Vec<rates::Start>),
    /// Rates of varying stiffness before anything is solved.
    Before(Vec<before::Start>),
    /// Starts towards fixed springs.
    FixedTarget(Vec<fixed_target::Target>),
    /// Varying stiffness with `correction`.
    Basin(Vec<basin::Start>),
    /// Constant stiffness with `secant` and `literal`.
    Failing(Vec<failing::Start>),
    /// The halving law on a scene.
    Halving(halving::Law),
}
