//! Reference values shall be known well enough to be met, and be met by the codes that solved the case.

use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::oracle::ReferenceKind;
use crate::study::sheets::run::{Numbers, Other, Value};

/// What springs of the scripts with a penalty may leave, relative.
const PENALTY: f64 = 2e-4;

/// Standard uncertainties of another code that its value may be off: two hold for 95 of 100, and there are thirty comparisons.
const SPREAD: f64 = 3.0;

/// The checks.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    let known = numbers.values.iter().filter(|value| value.bound.is_finite() && value.value.is_finite()).count();
    let because = "a sheet without numbers can be met by nobody";
    let known =
        Check::at_least("reference values with a bound", Reference::own("at least", 2.0), because).judge(known as f64);
    let met = numbers.values.iter().flat_map(|value| value.others.iter().map(|other| met(value, other)));
    Ok(std::iter::once(known).chain(met).collect())
}

/// Another code within our bound and thrice its uncertainty, and what its springs leave.
fn met(value: &Value, other: &Other) -> Judged {
    let penalty = if other.script.has_penalty() { PENALTY * other.value.abs() } else { 0.0 };
    let round_off = 1e-9 * other.value.abs();
    let allowed = value.bound + SPREAD * other.uncertainty + penalty + round_off;
    let reference =
        Reference { name: other.script.name().into(), kind: ReferenceKind::CrossCode, value: 0.0, uncertainty: None };
    let quantity = Quantity::at("difference over what both may be off", format!("{}, {}", value.quantity, value.of));
    let because = "our bound, three standard uncertainties of theirs, and what their springs leave";
    Check::error(quantity, reference, 1.0, because).judge((value.value - other.value).abs() / allowed)
}
