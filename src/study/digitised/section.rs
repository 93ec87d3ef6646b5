//! The title; the table of checks says the rest.

use crate::error::Error;
use crate::study::Found;
use crate::study::digitised::run::Numbers;

/// The title.
pub fn section(_: &[Found<Numbers>]) -> Result<String, Error> {
    Ok("Stresses along the pin of a rod (Gaertner 1977), and load against the angle of contact of a pin in a \
        large sheet (Ghosh, Dattaguru and Rao 1982), each held against the same pin of ours. The folders under `oracles/digitised` say what to \
        bring.\n\n"
        .into())
}

/// None.
pub fn pictures(_: &[Found<Numbers>]) -> Result<Vec<(String, crate::figure::Drawing)>, Error> {
    Ok(Vec::new())
}
