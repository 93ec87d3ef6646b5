//! What is run: every curve of the folder.

use crate::study::Planned;
use crate::study::gaertner::run::{self, Numbers};

/// The one trial.
pub fn plan() -> Vec<Planned<Numbers>> {
    vec![Planned::new("gaertner 1977", "digitised curves", || run::against(&run::folder()))]
}
