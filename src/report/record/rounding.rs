//! How the record writes numbers: the same bytes on every machine.

use crate::study::records::rounded;

/// Errors are written in steps of this: below half of it they are round-off, which differs from machine to machine, and 0.
pub const ROUND_OFF: f64 = 1e-9;

/// Four significant digits, and nothing finer than round-off.
pub fn floored(number: f64) -> f64 {
    // Above, four digits are coarser than the step.
    let steps = number / ROUND_OFF;
    let coarse = if number.abs() < 1e3 * ROUND_OFF { steps.round() * ROUND_OFF } else { number };
    // Minus nothing is nothing.
    four(coarse) + 0.0
}

/// Four significant digits.
pub fn four(number: f64) -> f64 {
    if number.is_finite() { rounded(number) } else { number }
}
