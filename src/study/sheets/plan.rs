//! What is run: every case of the library.

use crate::case::library::NAMES;
use crate::study::Planned;
use crate::study::sheets::run::{Numbers, solve};

/// One trial a case.
pub fn plan() -> Vec<Planned<Numbers>> {
    NAMES.map(|(name, _)| Planned::new("benchmark sheets", name, move || solve(name))).into()
}
