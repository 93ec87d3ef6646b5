//! What is run: curves over the clearance, and slopes at the default scene.

use crate::study::Planned;
use crate::study::family::run::{self, Numbers};

/// Name of the study.
const STUDY: &str = "dimensionless family, pin-rod";

/// Both trials.
pub fn plan() -> Vec<Planned<Numbers>> {
    vec![
        Planned::new(STUDY, "clearance and thickness", || run::curves().map(Numbers::Curves)),
        Planned::new(STUDY, "sensitivities", || run::sensitivities().map(Numbers::Sensitivities)),
    ]
}
