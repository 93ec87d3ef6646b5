//! The sites of the survey: scenes, stretches, loads, tolerances and formulations.

use std::path::PathBuf;

use crate::case::Case;
use crate::case::file::files_in;
use crate::case::library::{self, NAMES, TruncatedHertz};
use crate::checkout::root;
use crate::error::Error;
use crate::solve::Formulation;

/// Candidate stretches over the half-width under the nominal load; 0 is the scene's own.
pub const STRETCHES: [f64; 7] = [0.0, 1.05, 2.0, 5.0, 20.0, 50.0, 150.0];
/// Loads over the nominal one.
pub const LOADS: [f64; 3] = [1.0, 1e-2, 1e-4];
/// Tolerances: the default and one that hardly any iteration but kinematic load reaches.
pub const TOLERANCES: [f64; 2] = [1e-3, 1e-6];
/// A block long enough for every stretch.
const LONG: &str = "long-block";
/// Its size over the half-width.
pub const SIZE: f64 = 400.0;

/// Scenes of the library on which the bound of the energy error is measured, under all nine formulations.
pub const BOUNDED: [&str; 5] = ["cylinder", "truncated-hertz", "pin-rod", "bars", "flat-punch"];

/// Where a scene comes from.
#[derive(Clone, Debug, PartialEq)]
pub enum Origin {
    /// The library, by its name there.
    Library(&'static str),
    /// The long block.
    Long,
    /// A scene file.
    File(PathBuf),
}

/// A scene on a candidate stretch.
#[derive(Clone, Debug, PartialEq)]
pub struct Site {
    /// The scene.
    pub origin: Origin,
    /// One of [`STRETCHES`].
    pub stretch: f64,
}

/// Every scene on every stretch, in the order of the record.
pub fn sites() -> Result<Vec<Site>, Error> {
    let of = |origin: Origin| STRETCHES.map(|stretch| Site { origin: origin.clone(), stretch });
    Ok(origins()?.into_iter().flat_map(of).collect())
}

/// All scenes: the library, the long block, the files.
fn origins() -> Result<Vec<Origin>, Error> {
    let files = files_in(&root().join("tests/cases"))?;
    let library = NAMES.iter().map(|(name, _)| Origin::Library(name));
    Ok(library.chain([Origin::Long]).chain(files.into_iter().map(Origin::File)).collect())
}

impl Site {
    /// Name of the scene.
    pub fn scene(&self) -> String {
        match &self.origin {
            Origin::Library(name) => (*name).into(),
            Origin::Long => LONG.into(),
            Origin::File(path) => path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned()),
        }
    }

    /// Name of its own.
    pub fn key(&self) -> String {
        format!("{}-{}", self.scene(), self.stretch)
    }

    /// The scene on its own stretch.
    pub fn case(&self) -> Result<Case, Error> {
        match &self.origin {
            Origin::Library(name) => library::find(name, None),
            Origin::Long => Ok(TruncatedHertz { size: SIZE, ..Default::default() }.case()),
            Origin::File(path) => Case::read(path),
        }
    }
}

/// All nine formulations under a tolerance.
pub fn formulations(tolerance: f64) -> Vec<Formulation> {
    Formulation::nine().into_iter().map(|formulation| formulation.tolerance(tolerance)).collect()
}
