//! What a number of a scene must be.

use crate::error::{Error, Place};

/// Part of a length by which it may seem to go beyond its end.
pub const ROUNDING: f64 = 1e-9;

/// Refuses a value that is not finite and positive.
pub fn positive(place: &Place, key: &str, value: f64) -> Result<(), Error> {
    if value.is_finite() && value > 0.0 {
        return Ok(());
    }
    Err(Error::value(place, key, value, "a finite value above 0 is needed", "give a positive number"))
}
