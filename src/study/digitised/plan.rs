//! What is run: every curve of a source's folder.

use crate::study::Planned;
use crate::study::digitised::run::{self, Numbers};

/// The source of the paper's Figures 14 and 15.
pub const GAERTNER: &str = "gaertner 1977";

/// The sources, and their folders under `oracles/digitised`.
const SOURCES: [(&str, &str); 2] = [(GAERTNER, "gaertner-1977"), ("ghosh 1982", "ghosh-1982")];

/// A trial a source.
pub fn plan() -> Vec<Planned<Numbers>> {
    let trial =
        |(source, folder)| Planned::new(source, "digitised curves", move || run::against(source, &run::folder(folder)));
    SOURCES.map(trial).into()
}
