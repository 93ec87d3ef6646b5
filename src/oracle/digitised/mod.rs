//! Curves read off published figures, admitted only together with their scene and provenance.
//!
//! * [`scene`]: the dimensions, materials and load of the source.
//! * [`provenance`]: who read which figure, how, and what kind of curve it shows.
//! * [`curve`]: the points with all that is needed to compute their twins, and how far our curve may lie from them.
//! * [`fringes`]: dark fringes of a photoelastic disc.
//! * `columns`: the CSV file and its points, refused by column, or by line and column.
//! * `keys`: files that must be there, and required TOML keys, refused by name where missing or out of range.

use std::fs;
use std::path::{Path, PathBuf};

use crate::error::Error;

mod columns;
pub mod curve;
pub mod fringes;
mod keys;
pub mod provenance;
pub mod scene;

pub use columns::{Abscissa, CurvePoint, Ordinate};
pub use curve::{DigitisedCurve, OurPoint, compare, model_form, worst};
pub use provenance::CurveProvenance;
pub use scene::DigitisedScene;

/// Why a folder that holds only its README gives no reading.
pub const NOT_AT_HAND: &str = "not run: the figures are not at hand";

/// Every curve of a folder such as `oracles/digitised/gaertner-1977` that its provenance lists, in its order; why there
/// is none where the folder holds only its README: the figures are not at hand.
///
/// Files whose name starts with a dot and `README.md` do not count. Anything else must be complete.
///
/// # Errors
/// Names the file and the key, column or entry that is missing or refused, what was found, and the remedy.
pub fn load(folder: &Path) -> Result<Result<Vec<DigitisedCurve>, &'static str>, Error> {
    let files = files_of(folder)?;
    if files.is_empty() {
        return Ok(Err(NOT_AT_HAND));
    }
    let scene = DigitisedScene::read(&folder.join("scene.toml"))?;
    let curves = provenance::read(&folder.join("provenance.toml"))?;
    refuse_unlisted(folder, &files, &curves)?;
    curves.iter().map(|entry| DigitisedCurve::read(folder, entry, &scene)).collect::<Result<_, _>>().map(Ok)
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

fn refuse_unlisted(folder: &Path, files: &[PathBuf], curves: &[CurveProvenance]) -> Result<(), Error> {
    let listed = |file: &Path| {
        let known = ["scene.toml", "provenance.toml"].into_iter();
        let curves = curves.iter().map(|entry| entry["file"].as_str());
        known.chain(curves).any(|name| file == Path::new(name))
    };
    let Some(stray) = files.iter().find(|file| !listed(file)) else {
        return Ok(());
    };
    let message = "the file is not listed under `[[curves]]` in provenance.toml";
    let remedy = "list it with its figure, axis_calibration, kind and hand, or take it out";
    Err(Error::file(&folder.join(stray), message, remedy))
}
