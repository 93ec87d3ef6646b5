//! The checks that a scene file declares itself, as far as pressures tell.

use crate::case::quantity::Quantity as Asked;
use crate::case::{Against, Check, Judged, Reference, Relation};
use crate::measure::{Measures, Quantity, profile};
use crate::oracle::ReferenceKind;
use crate::referee::bench::Bench;
use crate::solution::PointState;

/// What to hand in for displacements.
pub(super) const GRID: &str =
    "a VTK grid or a .frd of all bodies with the displacement of every node, and --unit displacement=UNIT";

/// Those that a profile answers; of the others what to hand in.
pub(super) fn checks(bench: &Bench, missing: &mut Vec<[String; 2]>) -> Vec<Judged> {
    let own = bench.truth.case.checks.iter().filter(|check| check.contact == bench.profile.contact);
    let mut judged = Vec::new();
    for check in own {
        let with_model = Check { tolerance: check.tolerance + check.model, ..check.clone() };
        let asked = of_another_mesh(&with_model, bench.tolerance * scale(bench, check));
        match (value(bench, &asked), &check.against) {
            (Some(value), Against::Value(reference)) if !is_own_equilibrium(check, reference) => {
                judged.push(asked.judge_by(value, reference.clone()))
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

/// A check as declared, within no less than what was asked for: what is judged is of another mesh.
pub(super) fn of_another_mesh(check: &Check, least: f64) -> Check {
    match check.tolerance < least && matches!(check.relation, Relation::Near | Relation::NearAbsolutely) {
        true => Check { tolerance: least, because: BECAUSE.into(), ..check.clone() },
        false => check.clone(),
    }
}

/// Why.
const BECAUSE: &str =
    "the tolerance asked for, which is more than that of the scene file: the answer is that of another mesh";

/// What the tolerance of a check is relative to: in its unit the size of the contact, or its peak, where the reference
/// is 0.
fn scale(bench: &Bench, check: &Check) -> f64 {
    let size = match check.quantity.number() {
        Some(Quantity::Pressure { .. } | Quantity::PeakPressure) => {
            bench.truth.known(bench.profile.contact, &Quantity::PeakPressure)
        }
        _ => bench.half_width_known(),
    };
    if check.relation == Relation::NearAbsolutely { check.quantity.factor() * size.reference.value } else { 1.0 }
}

/// The number of a check by the pressures handed in, in its unit, as the rows above read it; none where they do not
/// tell it.
fn value(bench: &Bench, check: &Check) -> Option<f64> {
    let number = match &check.quantity {
        Asked::Number { of, .. } => of,
        Asked::Profile | Asked::Departure => return Some(f64::NAN),
        _ => return None,
    };
    let factor = check.quantity.factor();
    let (truth, allowed) = match (&check.against, check.relation) {
        (Against::Value(known), Relation::Near) => (known.value, check.tolerance * known.value.abs()),
        (Against::Value(known), Relation::NearAbsolutely) => (known.value, check.tolerance),
        _ => (f64::NAN, f64::NAN),
    };
    let read = |of: &dyn Fn(&Measures, &[PointState]) -> f64| bench.read(number, of, truth / factor, allowed / factor);
    let value = match number {
        Quantity::Pressure { at } => {
            let stretch = bench.profile.pair().stretch;
            Some(read(&|_, points| profile::interpolate(points, stretch, *at)))
        }
        Quantity::PeakPressure => Some(bench.peak_pressure()),
        Quantity::Resultant | Quantity::SecondMomentWidth | Quantity::Centre => Some(read(&|own, _| number.of(own))),
        other => Some(other.of(bench.measures)).filter(|_| other.is_of_pressures()),
    };
    Some(factor * value?)
}

/// Whether a check holds the force of the contact against the load within the round-off of this code, which is asked of
/// no other.
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
