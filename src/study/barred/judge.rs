//! How many checks may have a true error beyond their bars.

use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::study::barred::run::Numbers;

/// Share of the checks whose error may be beyond its bar.
pub const SHARE: f64 = 0.05;

/// The check; it fails where there is nothing to judge.
pub fn judge(Numbers { all, outside }: &Numbers) -> Result<Vec<Judged>, Error> {
    let share = outside.len() as f64 / *all as f64;
    let quantity =
        Quantity::at("share of checks against closed forms whose true error is beyond its bar", format!("of {all}"));
    let because = "a bar holds for 95 of 100 numbers; those beyond are listed";
    Ok(vec![Check::at_most(quantity, Reference::analytic("closed forms", SHARE), because).judge(share)])
}
