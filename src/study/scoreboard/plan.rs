//! Which cases are asked.

use crate::case::{Case, library};
use crate::checkout::root;
use crate::error::Error;
use crate::study::Planned;
use crate::study::scoreboard::board::Board;
use crate::study::scoreboard::run::{Numbers, numbers};

/// One body on a rigid one, flat and curved; two bodies, straight, curved, and conforming.
pub const CASES: [&str; 6] = ["cylinder", "truncated-hertz", "bars", "own-weight", "two-cylinders", "pin-rod"];

/// A case of the library, or of a scene file of the repository.
pub fn named(name: &str) -> Result<Case, Error> {
    let file = root().join("tests/cases").join(name).with_extension("toml");
    if library::NAMES.iter().any(|(known, _)| *known == name) { library::find(name, None) } else { Case::read(&file) }
}

/// One trial a case.
pub fn plan() -> Vec<Planned<Numbers>> {
    let planned =
        CASES.map(|name| Planned::new("scoreboard", name, move || numbers(name, &named(name)?, &Board::load()?)));
    planned.into()
}
