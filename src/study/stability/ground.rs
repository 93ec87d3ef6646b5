//! What the predictions are made on: truncated Hertz, condensed, and the contact that an iteration ends in.

use crate::algorithm::ContactProblem;
use crate::case::library::TruncatedHertz;
use crate::error::Error;
use crate::solve::Discretisation;
use crate::stability::Limit;

/// Truncated Hertz whose contact edge lies on no node: on one, a point neither open nor closed converges at no rate at all.
pub fn discretised() -> Result<Discretisation, Error> {
    let case = TruncatedHertz { stretch: 1.9, ..Default::default() }.case();
    Discretisation::of(case.scene, case.resolution)
}

/// The limit of a problem.
pub fn limit(problem: &ContactProblem) -> Result<Limit, Error> {
    Limit::of(problem).ok_or_else(|| {
        Error::at(
            "stability",
            "the problem on which rates are predicted has no discrete solution",
            "give it a scene whose contact holds its bodies",
        )
    })
}
