//! The checks that a scene file declares itself, as far as pressures tell.

use crate::case::quantity::Quantity as Asked;
use crate::case::{Against, Check, Judged, Reference, Relation};
use crate::measure::{Quantity, profile};
use crate::oracle::ReferenceKind;
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
            (Some(value), Against::Value(reference)) if !is_own_equilibrium(check, reference) => {
                let check = of_digits(check);
                // Straight lines between pressures hold no more digits of the force than are asked of them.
                let is_force = check.quantity.number() == Some(&Quantity::Resultant);
                let is_of_lines = is_force && check.relation == Relation::Near && !bench.profile.has_forces;
                let least = if is_of_lines { bench.tolerance } else { 0.0 };
                let check = Check { tolerance: check.tolerance.max(least), ..check };
                judged.push(check.judge_by(value, reference.clone()))
            }
            // What the oracle reads is judged above, as is equilibrium.
            (Some(_), _) => {}
            // Numbers of a mesh or of an iteration are not asked of others.
            (None, _) if matches!(check.quantity, Asked::EdgeMeans | Asked::Named { .. }) => {}
            (None, _) => missing.push(not_handed_in(check)),
        }
    }
    judged
}

/// A number of the pressures handed in, in the unit of the check; none where they do not tell it.
fn value(bench: &Bench, quantity: &Asked) -> Option<f64> {
    let number = match quantity {
        Asked::Number { of, .. } => of,
        Asked::Profile | Asked::Departure => return Some(f64::NAN),
        _ => return None,
    };
    let value = match number {
        Quantity::Pressure { at } => {
            Some(profile::interpolate(&bench.profile.points, bench.profile.pair().stretch, *at))
        }
        other => Some(other.of(bench.measures)).filter(|_| other.is_of_pressures()),
    };
    Some(quantity.factor() * value?)
}

/// The check as declared, but for the model error that is stated of its truth, and for a tolerance that is round-off of this code: files of
/// other codes carry six or seven digits.
fn of_digits(check: &Check) -> Check {
    let with_model = Check { tolerance: check.tolerance + check.model, ..check.clone() };
    if with_model.tolerance >= DIGITS || check.tolerance <= 0.0 {
        return with_model;
    }
    Check { tolerance: DIGITS, because: "the digits that files of other codes carry".into(), ..with_model }
}

/// Whether a check holds the force of the contact against the load within the round-off of this code, which is asked of no other.
fn is_own_equilibrium(check: &Check, reference: &Reference) -> bool {
    let is_of_force = check.quantity.number() == Some(&Quantity::Resultant);
    is_of_force && reference.kind == ReferenceKind::SelfConsistency && check.tolerance < DIGITS
}

/// Relative error that these digits explain.
const DIGITS: f64 = 1e-5;

fn not_handed_in(check: &Check) -> [String; 2] {
    let how = match check.quantity.number() {
        Some(
            Quantity::Displacement(_)
            | Quantity::Approach
            | Quantity::Reaction { .. }
            | Quantity::Shear { .. }
            | Quantity::ShearDepth { .. }
            | Quantity::VonMises { .. },
        ) => GRID,
        _ => "nothing: no reader takes it from an answer, `contact-vv solve` tells it",
    };
    [check.quantity.to_string(), how.into()]
}
