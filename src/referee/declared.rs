//! The checks that a scene file declares itself, as far as pressures tell.

use crate::case::quantity::Quantity as Asked;
use crate::case::{Against, Check, Judged};
use crate::error::Coordinate;
use crate::measure::profile;
use crate::referee::bench::Bench;

/// What to hand in for displacements.
pub(super) const GRID: &str =
    "a VTK grid or a .frd of all bodies with the displacement of every node, and --unit displacement=UNIT";

/// Those that a profile answers; of the others what to hand in.
pub(super) fn checks(bench: &Bench, missing: &mut Vec<[String; 2]>) -> Vec<Judged> {
    let own = bench.truth.case.checks.iter().filter(|check| check.contact == bench.profile.contact);
    let mut judged = Vec::new();
    for check in own {
        match (value(bench, &check.quantity), &check.against) {
            (Some(value), Against::Value(reference)) => {
                judged.push(of_digits(check).judge_by(value, reference.clone()))
            }
            // What the oracle reads is judged above.
            (Some(_), _) => {}
            // Numbers of a mesh or of an iteration are not asked of others.
            (None, _) if matches!(check.quantity, Asked::Dofs | Asked::EdgeMeans | Asked::Named { .. }) => {}
            (None, _) => missing.push(not_handed_in(check)),
        }
    }
    judged
}

/// A number of the pressures handed in; none where they do not tell it.
fn value(bench: &Bench, quantity: &Asked) -> Option<f64> {
    let measures = bench.measures;
    match quantity {
        Asked::PeakPressure => Some(measures.peak.pressure),
        Asked::HalfWidth => Some(measures.half_width()),
        Asked::HalfAngle => Some(measures.half_width().to_degrees()),
        Asked::SecondMomentWidth => Some(measures.second_moment_width),
        Asked::SecondMomentAngle => Some(measures.second_moment_width.to_degrees()),
        Asked::Centre => Some(measures.centre),
        Asked::Resultant => Some(measures.resultant),
        Asked::Pressure { at: Coordinate::Length(at) | Coordinate::Angle(at) } => {
            Some(profile::interpolate(&bench.profile.points, bench.profile.pair().stretch, *at))
        }
        Asked::Profile | Asked::Departure => Some(f64::NAN),
        _ => None,
    }
}

/// The check as declared, but for a tolerance that is round-off of this code: files of other codes carry six or seven digits.
fn of_digits(check: &Check) -> Check {
    if check.tolerance >= DIGITS || check.tolerance <= 0.0 {
        return check.clone();
    }
    Check { tolerance: DIGITS, because: "the digits that files of other codes carry".into(), ..check.clone() }
}

/// Relative error that these digits explain.
const DIGITS: f64 = 1e-5;

fn not_handed_in(check: &Check) -> [String; 2] {
    let how = match check.quantity {
        Asked::Displacement(_)
        | Asked::Approach
        | Asked::Reaction { .. }
        | Asked::Shear { .. }
        | Asked::ShearDepth { .. } => GRID,
        _ => "nothing: no reader takes it from an answer, `contact-vv solve` tells it",
    };
    [check.quantity.to_string(), how.into()]
}
