//! Curves read off published figures, admitted only together with their scene and provenance.
//!
//! * [`scene`]: the dimensions, materials and load of the source.
//! * [`provenance`]: who read which figure, how, and what kind of curve it shows.
//! * [`curve`]: the points with all that is needed to compute their twins, and how far our curve may lie from them.
//! * [`point`]: a point, with the errors of both coordinates.
//! * [`fringes`]: dark fringes of a photoelastic disc.
//! * `columns`: the CSV file, refused by column, or by line and column.
//! * `keys`: files that must be there, and required TOML keys, refused by name where missing or out of range.

use std::fs;
use std::path::{Path, PathBuf};

use crate::error::Error;

mod columns;
pub mod curve;
pub mod fringes;
mod keys;
pub mod point;
pub mod provenance;
pub mod scene;

pub use curve::{DigitisedCurve, OurPoint, compare, model_form, worst};
pub use point::{Abscissa, CurvePoint, Ordinate};
pub use provenance::{CurveProvenance, Hand, Kind, Provenance};
pub use scene::{DigitisedScene, RodScene, SheetScene};

/// Why a folder that holds only its README gives no reading.
pub const NOT_AT_HAND: &str = "not run: the figures are not at hand";

/// What a folder of digitised figures holds.
#[derive(Debug, Clone, PartialEq)]
pub enum Digitised {
    /// Only the README: the figures are not at hand, and why.
    Absent(String),
    /// Every curve listed in the provenance, in its order.
    Present(Vec<DigitisedCurve>),
}

impl Digitised {
    /// Reads a folder such as `oracles/digitised/gaertner-1977`.
    ///
    /// Files whose name starts with a dot and `README.md` do not count. Anything else must be complete.
    ///
    /// # Errors
    /// Names the file and the key, column or entry that is missing or refused, what was found, and the remedy.
    pub fn load(folder: &Path) -> Result<Self, Error> {
        let files = files_of(folder)?;
        if files.is_empty() {
            return Ok(Self::Absent(NOT_AT_HAND.to_owned()));
        }

        let scene = DigitisedScene::read(&folder.join("scene.toml"))?;
        let provenance = Provenance::read(&folder.join("provenance.toml"))?;
        refuse_unlisted(folder, &files, &provenance)?;
        let curves = provenance
            .curves
            .iter()
            .map(|entry| DigitisedCurve::read(folder, entry, scene))
            .collect::<Result<_, _>>()?;
        Ok(Self::Present(curves))
    }
}

fn files_of(folder: &Path) -> Result<Vec<PathBuf>, Error> {
    let remedy = "give the path of a folder with a README.md";
    let unreadable = |cause: std::io::Error| Error::unreadable(folder, cause, remedy);
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).map_err(unreadable)? {
        let name = entry.map_err(unreadable)?.file_name();
        let shown = name.to_string_lossy();
        if !(shown.starts_with('.') || shown == "README.md") {
            files.push(PathBuf::from(&name));
        }
    }
    files.sort();
    Ok(files)
}

fn refuse_unlisted(folder: &Path, files: &[PathBuf], provenance: &Provenance) -> Result<(), Error> {
    let listed = |file: &Path| {
        let known = ["scene.toml", "provenance.toml"].into_iter();
        let curves = provenance.curves.iter().map(|entry| entry.file.as_str());
        known.chain(curves).any(|name| file == Path::new(name))
    };
    let Some(stray) = files.iter().find(|file| !listed(file)) else {
        return Ok(());
    };
    let message = "the file is not listed under `[[curves]]` in provenance.toml";
    let remedy = "list it with its figure, axis_calibration, kind and hand, or take it out";
    Err(Error::file(&folder.join(stray), message, remedy))
}
