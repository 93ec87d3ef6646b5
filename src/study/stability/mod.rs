//! Predicted against measured, one iteration at a time.
//!
//! * [`rates`] — asymptotic rates of constant and varying stiffness.
//! * [`fixed_target`] — constant stiffness towards given springs: whether and how fast.
//! * [`basin`] — varying stiffness with `correction`: what attracts nearby, and what happens from afar.
//! * [`failing`] — why `secant` and `literal` fail with constant stiffness.
//! * [`halving`] — steps of kinematic load.

pub mod basin;
pub mod failing;
pub mod fixed_target;
pub mod halving;
pub mod rates;

use crate::case::library::TruncatedHertz;
use crate::case::problem::{self, Problem};
use crate::study::unsorted::Trial;

/// All trials of the predictions.
pub fn trials() -> Vec<Trial> {
    [rates::trials(), fixed_target::trials(), basin::trials(), failing::trials(), halving::trials()]
        .into_iter()
        .flatten()
        .collect()
}

/// Truncated Hertz whose contact edge lies on no node: on one, a point neither open nor closed converges at no rate at all.
fn truncated() -> Problem {
    let numbers = TruncatedHertz { stretch: 1.9, ..Default::default() };
    Problem::new("truncated-hertz", "truncated Hertz", problem::truncated_hertz(numbers))
}
