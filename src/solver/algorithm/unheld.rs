//! Springs and bodies that make no system which can be solved.

use crate::algorithm::{ContactProblem, Springs};
use crate::error::{Error, Kind, Place};
use crate::solution::Work;

/// Decades by which springs may be too soft.
const DECADES: i32 = 18;
/// Factor above the softest springs that hold, for digits.
const MARGIN: f64 = 100.0;

/// Why no system of springs and bodies could be solved: springs that are lost in the round-off of S, or none left.
pub(super) fn why(problem: &ContactProblem, springs: &Springs, iterations: usize) -> Error {
    if iterations > 0 || springs.stiffness.iter().all(|k| *k <= 0.0) {
        let message = format!(
            "only contact fixes the bodies, and no contact spring is left after iteration {iterations}: the load pulls the bodies apart, the start is too soft, or the contact is smaller than two elements"
        );
        let remedy = "reverse the load, add a support, raise the initial stiffness or refine the mesh";
        return Error { kind: Kind::NoSpringLeft { iterations }, ..Error::at(Place::Nowhere, message, remedy) };
    }
    let stiffer = |times: f64| springs.stiffness.iter().map(|k| k * times).collect::<Vec<_>>();
    let holds = |times: &f64| problem.factorise(&stiffer(*times), &mut Work::default()).is_some();
    let decades = (1..=DECADES).map(|k| 10f64.powi(k));
    let enough = decades.into_iter().find(holds).map(|times| times * MARGIN).unwrap_or(f64::NAN);
    let message = "only contact fixes the bodies, and the initial springs are lost in the round-off of the stiffness of the bodies";
    let remedy = format!("raise `stiffness` {enough:.0e} times");
    Error { kind: Kind::SpringsTooSoft, ..Error::at(Place::Nowhere, message, remedy) }
}
