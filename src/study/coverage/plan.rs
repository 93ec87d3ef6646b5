//! What is run: the record is read, and a fixed part of its scenes solved again.

use crate::study::Planned;
use crate::study::coverage::run::{self, Numbers};

/// The one trial.
pub fn plan() -> Vec<Planned<Numbers>> {
    vec![Planned::new("coverage of error bars", "all scenes", run::numbers)]
}
