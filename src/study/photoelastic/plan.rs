//! What is run: the one photograph.

use crate::oracle::digitised::fringes;
use crate::study::Planned;
use crate::study::photoelastic::run::{Numbers, compare};

/// The trial.
pub fn plan() -> Vec<Planned<Numbers>> {
    let run = || compare(&fringes::read(&fringes::file())?);
    vec![Planned::new("photoelastic disc between plates", "isochromatics of a photograph", run)]
}
