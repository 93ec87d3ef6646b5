//! Every planted fault shall turn a check against a truth red.

use crate::case::{Check, Judged, Quantity};
use crate::error::Error;
use crate::study::faults::run::{Fault, Numbers};

/// Kinds of the references of truth locks; a trial that broke off with an error is counted beside them.
const TRUTHS: [&str; 3] = ["analytic", "cross-code", "self-consistency"];

/// The check.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    let missed = numbers.faults.iter().filter(|fault| !is_caught(fault)).count();
    let quantity =
        Quantity::at("planted fault that turns no check against a truth red", format!("of {}", numbers.faults.len()));
    Ok(vec![Check::none(quantity, "snapshots alone verify nothing").judge(missed as f64)])
}

/// Whether a check against a truth turned red; a run that broke off shows none.
pub fn is_caught(fault: &Fault) -> bool {
    TRUTHS.iter().any(|kind| fault.red.get(*kind).is_some_and(|&number| number > 0))
}
