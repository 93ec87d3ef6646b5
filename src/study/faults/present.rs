//! Whether the faults were planted on the present sources.
//!
//! A terminal is told, not the page: that shall be the same before and after an edit that changes no number.

use crate::case::{Check, Judged, Quantity, Verdict};
use crate::checkout::{digest, root};
use crate::error::Error;
use crate::study::faults::run::{Numbers, REPLANT, record};

/// The check of the committed record against the checkout.
pub fn check() -> Result<Judged, Error> {
    let numbers = record()?;
    let unreadable = |error| Error::unreadable(&root(), error, "restore the checkout that the program was built in");
    let present = digest(&root(), &numbers.sources).map_err(unreadable)?;
    Ok(judge(&numbers, &present))
}

/// Not run where a fault was planted on other sources than those of this digest: nothing is known of it on these.
pub fn judge(numbers: &Numbers, present: &str) -> Judged {
    let is_old = |sources: &Option<String>| sources.as_deref() != Some(present);
    let old = numbers.faults.iter().filter(|fault| is_old(&fault.sources)).count();
    let all = numbers.faults.len();
    let quantity = Quantity::at("fault planted on other sources than the present ones", format!("of {all}"));
    let judged = Check::none(quantity, "what caught a fault then need not catch it now").judge(old as f64);
    let why = format!("{old} of {all} faults were planted on other sources: {REPLANT}");
    match old {
        0 => judged,
        _ => Judged { verdict: Verdict::NotRun(why), ..judged },
    }
}
