//! The gap given in a contact against the gap between the bodies as they are drawn.

use crate::case::file::value::Value;
use crate::error::Error;
use crate::scene::{ContactPair, DrawnGap, Profile};

/// Difference, over the largest gap given on the stretch, up to which both are one.
const ALIKE: f64 = 0.02;
/// Gap, over the length of the stretch, up to which sides are drawn on one another: such a drawing tells no gap.
const FLAT: f64 = 1e-6;
/// Places along one side of s = 0 at which gaps are compared.
const PLACES: i32 = 64;

/// Refuses a gap that differs from the drawn one, unless the contact says that the drawing tells none.
pub(super) fn refuse_other(table: Value, pair: &ContactPair, drawn: &DrawnGap) -> Result<(), Error> {
    let length = table.units.length;
    let is_drawn = matches!(pair.profile, Profile::Drawn | Profile::Bodies(_));
    let given = table.asked("gap-only");
    let message = "`gap-only` is true, and the gap is that of the drawn bodies";
    Value::refuse(given.filter(|_| is_drawn), message, "leave it out, or give the gap as a function")?;
    if is_drawn || given.is_some() {
        return Ok(());
    }
    let first = if pair.path.has_both_sides() { -PLACES } else { 0 };
    let places = (first..=PLACES).map(|k| pair.stretch * f64::from(k) / f64::from(PLACES));
    // Bodies may be drawn with the clearance between them, or touching.
    let is_touching = (drawn.gap(0.0) - pair.profile.gap(0.0)).abs() <= ALIKE * pair.clearance;
    let clearance = if is_touching { 0.0 } else { pair.clearance };
    let gaps: Vec<[f64; 3]> = places.map(|s| [s, pair.profile.gap(s) + clearance, drawn.gap(s)]).collect();
    let told: Vec<&[f64; 3]> = gaps.iter().filter(|[_, given, drawn]| given.is_finite() && drawn.is_finite()).collect();
    let largest = |k: usize| told.iter().map(|gap| gap[k].abs()).fold(0.0, f64::max);
    let flat = FLAT * pair.stretch * pair.path.metric();
    let apart = |gap: &[f64; 3]| (gap[1] - gap[2]).abs();
    let Some([s, given, drawn]) = told.iter().max_by(|a, b| apart(a).total_cmp(&apart(b))) else { return Ok(()) };
    if largest(2) <= flat || (given - drawn).abs() <= ALIKE * (largest(1) - clearance).max(0.0) + flat {
        return Ok(());
    }
    let [given, drawn] = [given, drawn].map(|gap| rounded(gap / length));
    let place = if pair.path.is_straight() { rounded(s / length) } else { rounded(s.to_degrees()) };
    let (between, other) = match pair.second {
        Some(_) => ("between the drawn bodies", "where the drawing shall not tell it"),
        None => ("between the drawn body and a flat rigid side", "where the rigid side is not flat"),
    };
    let message = format!("at s = {place} the gap is {given} as given, and {drawn} {between}");
    let remedy = format!("correct it, give `gap = {{ from = \"bodies\" }}`, or add `gap-only = true` {other}");
    Err(table.at("gap").refused(message, remedy))
}

/// Five significant digits.
pub(super) fn rounded(x: f64) -> f64 {
    format!("{x:.4e}").parse().unwrap_or(x)
}
