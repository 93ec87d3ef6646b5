//! Tolerances and bounds that were loosened or tightened.

use super::groups;
use super::pairs::Pair;
use super::told::Told;
use super::words::{counted, differ};
use crate::case::Relation;
use crate::markdown;

/// Digits that the record has.
const DIGITS: usize = 4;

/// Loosened ones, told before everything else; then tightened ones.
pub fn told(pairs: &[Pair]) -> Vec<Told> {
    let moved: Vec<Pair> = pairs.iter().filter(|pair| limits(pair).is_some()).copied().collect();
    let (looser, tighter): (Vec<Pair>, Vec<Pair>) = moved.into_iter().partition(is_loosened);
    let one = |pairs: Vec<Pair>, how: &str| {
        let heading = format!("Tolerances {how}: {}", counted(pairs.len(), "check"));
        let rows = groups::rows(&pairs, change, size, change);
        (!pairs.is_empty()).then(|| Told::new(heading, rows))
    };
    [one(looser, "LOOSENED"), one(tighter, "tightened")].into_iter().flatten().collect()
}

/// The limit before and after, where it moved: the tolerance, or the bound of what is held against a bound.
fn limits(pair: &Pair) -> Option<[f64; 2]> {
    let (before, after) = (pair.before, pair.after);
    let bound = matches!(after.relation, Relation::AtLeast | Relation::AtMost);
    let bounds = [before.reference, after.reference];
    let tolerances = [before.tolerance, after.tolerance];
    let moved = |[old, new]: [f64; 2]| differ(old, new).then_some([old, new]);
    moved(tolerances).or_else(|| moved(bounds).filter(|_| bound)).or_else(|| {
        let same = std::mem::discriminant(&before.relation) == std::mem::discriminant(&after.relation);
        (!same).then_some(tolerances)
    })
}

/// Whether the check now accepts more: what cannot be compared counts as loosened.
fn is_loosened(pair: &Pair) -> bool {
    let Some([old, new]) = limits(pair) else { return false };
    let lower = pair.after.relation == Relation::AtLeast && !differ(pair.before.tolerance, pair.after.tolerance);
    if pair.before.relation != pair.after.relation {
        return true;
    }
    // NaN is looser.
    let kept = if lower { new >= old } else { new <= old };
    !kept
}

/// How much wider, whichever way.
fn size(pair: &Pair) -> f64 {
    limits(pair).map_or(0.0, |[old, new]| (new / old).ln().abs())
}

fn change(pair: &Pair) -> String {
    let (before, after) = (pair.before, pair.after);
    if before.relation != after.relation {
        return format!("now held {:?}, before {:?}", after.relation, before.relation);
    }
    let word = if differ(before.tolerance, after.tolerance) { "tolerance" } else { "bound" };
    let [old, new] = limits(pair).unwrap_or([f64::NAN; 2]);
    let shown = |x: f64| if word == "bound" { markdown::bound(x) } else { markdown::tolerance(x) };
    let [before, after] = [old, new].map(shown);
    // What differs in later digits only.
    let [before, after] =
        if before == after { [old, new].map(|x| markdown::significant(x, DIGITS)) } else { [before, after] };
    format!("{word} {before} → {after}")
}
