//! What is run: the record is read and judged.

use crate::study::Planned;
use crate::study::faults::run::{self, Numbers};

/// The one trial.
pub fn plan() -> Vec<Planned<Numbers>> {
    vec![Planned::new("planted faults", "the record", run::record)]
}
