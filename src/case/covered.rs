//! A comparison that its uncertainties must cover.

use crate::case::check::{Check, Reference};
use crate::case::judged::Judged;
use crate::case::quantity::Quantity;
use crate::markdown;
use crate::uncertainty::{COVERAGE, Comparison};

/// `|E| ≤ k u_val` with k = 2 (ASME V&V 20-2009, 1-5), for a quantity against a reference; what the uncertainty is made of is said.
pub fn covered(of: &str, reference: Reference, comparison: Comparison, sources: &str) -> Judged {
    let Comparison { error, uncertainty } = comparison;
    let because = format!(
        "ASME V&V 20: E = {}, u_val = {} ({sources})",
        markdown::signed(error, 2),
        markdown::significant(uncertainty, 2)
    );
    let quantity = Quantity::at("comparison error |E| over its standard uncertainty u_val", of);
    let reference = Reference { value: 0.0, uncertainty: None, ..reference };
    Check::error(quantity, reference, COVERAGE, because).judge(comparison.ratio())
}
