//! What is run: nothing. The checks of all other trials are looked at.

use crate::study::Planned;
use crate::study::barred::run::Numbers;

/// No trial of its own.
pub fn plan() -> Vec<Planned<Numbers>> {
    Vec::new()
}
