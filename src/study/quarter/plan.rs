//! What is run: both models, by a/R.

use crate::study::Planned;
use crate::study::quarter::run::{self, Numbers};

/// The one trial.
pub fn plan() -> Vec<Planned<Numbers>> {
    vec![Planned::new("half cylinder against quarter", "node.kinematic", run::changes)]
}
