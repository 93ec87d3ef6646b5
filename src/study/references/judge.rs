//! Five digits of every number, and 8-node cells within their own error bars of it.

use crate::accuracy::reference::Known;
use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::study::references::run::Numbers;

/// Bound of a number over its scale.
const DIGITS: f64 = 1e-5;

/// The checks.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    Ok(numbers.known.iter().flat_map(of).collect())
}

fn of((one, eight): &(Known, Option<[f64; 2]>)) -> Vec<Judged> {
    let at = |name: &'static str| Quantity::at(name, one.measured.name());
    let because = "what other codes are measured against has five digits";
    let meshes = Reference::own("the other meshes", 0.0);
    let bound =
        Check::error(at("relative bound of a reference answer"), meshes, DIGITS, because).judge(one.bound / one.scale);
    let eight = eight.map(|[value, bar]| {
        let because = "the error bar of 8-node cells, and the bound";
        let quantity = at("difference of 8-node cells over what both may be off");
        Check::error(quantity, Reference::own("8-node cells", 0.0), 1.0, because)
            .judge((value - one.value).abs() / (bar + one.bound))
    });
    [bound].into_iter().chain(eight).collect()
}
