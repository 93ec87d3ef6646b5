//! What is run: the record is read, and a fixed part of its sites run again.

use crate::study::Planned;
use crate::study::readings::run::{self, Numbers};

/// The one trial.
pub fn plan() -> Vec<Planned<Numbers>> {
    vec![Planned::new("readings of the paper", "all sites", run::numbers)]
}
