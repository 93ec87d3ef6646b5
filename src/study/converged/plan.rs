//! What is run: the record is read, a fixed part of its sites run again, and the bound of the energy error measured.

use crate::study::Planned;
use crate::study::converged::run::{self, Numbers};

/// The one trial.
pub fn plan() -> Vec<Planned<Numbers>> {
    vec![Planned::new("what is called converged", "all scenes", run::numbers)]
}
