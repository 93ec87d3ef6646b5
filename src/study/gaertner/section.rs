//! The title; the table of checks says the rest.

use crate::error::Error;
use crate::study::Found;
use crate::study::gaertner::run::Numbers;

/// The title.
pub fn section(_: &[Found<Numbers>]) -> Result<String, Error> {
    Ok("## Against Gaertner\n\nDigitised curves of Gaertner (1977), each held against the pin–rod of its own dimensions.\n\n".into())
}

/// None.
pub fn pictures(_: &[Found<Numbers>]) -> Result<Vec<(String, String)>, Error> {
    Ok(Vec::new())
}
