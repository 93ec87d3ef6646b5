//! Which runs the study holds.

use crate::case::problem::{self, PROBLEMS, Problem};
use crate::case::scene_file::SceneFile;
use crate::error::Error;
use crate::formulation::Formulation;
use crate::oracle::cross_code::root;
use crate::scene::library::TruncatedHertz;

/// Candidate stretches over the half-width under the nominal load; 0 is the scene's own.
pub const STRETCHES: [f64; 7] = [0.0, 1.05, 2.0, 5.0, 20.0, 50.0, 150.0];
/// Loads over the nominal one.
pub const LOADS: [f64; 3] = [1.0, 1e-2, 1e-4];
/// Tolerances: the default and one that hardly any iteration but kinematic load reaches.
pub const TOLERANCES: [f64; 2] = [1e-3, 1e-6];
/// A block long enough for every stretch.
const LONG: &str = "long-block";
/// Its size over the half-width.
const SIZE: f64 = 400.0;

/// A scene on a candidate stretch.
#[derive(Clone, Debug, PartialEq)]
pub struct Site {
    /// Name of the scene: of the library, or the stem of a file.
    pub scene: String,
    /// One of [`STRETCHES`].
    pub stretch: f64,
}

/// Every scene on every stretch, in the order of the record.
pub fn sites() -> Result<Vec<Site>, Error> {
    let of = |scene: String| STRETCHES.map(|stretch| Site { scene: scene.clone(), stretch });
    Ok(scenes()?.into_iter().flat_map(of).collect())
}

/// Names of all scenes.
fn scenes() -> Result<Vec<String>, Error> {
    let library = PROBLEMS.iter().map(|(name, _)| name.to_string()).chain([LONG.to_string()]);
    let folder = root().join("tests/scenes");
    let failed = |error: std::io::Error| Error::File {
        path: folder.clone(),
        reason: error.to_string(),
        remedy: "run inside a checkout of the project".into(),
    };
    let mut files = Vec::new();
    for entry in std::fs::read_dir(&folder).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        if path.extension().is_some_and(|end| end == "toml") {
            files.extend(path.file_stem().map(|stem| stem.to_string_lossy().into_owned()));
        }
    }
    files.sort();
    Ok(library.chain(files.into_iter().map(|stem| format!("{stem}.toml"))).collect())
}

impl Site {
    /// The scene on its own stretch.
    pub fn problem(&self) -> Result<Problem, Error> {
        match self.scene.as_str() {
            LONG => {
                let numbers = TruncatedHertz { size: SIZE, ..Default::default() };
                Ok(Problem::new(LONG, "block of 400 half-widths", problem::truncated_hertz(numbers)))
            }
            file if file.ends_with(".toml") => Ok(SceneFile::read(&root().join("tests/scenes").join(file))?.problem),
            name => problem::problem(name, None),
        }
    }
}

/// All nine formulations under a tolerance.
pub fn formulations(tolerance: f64) -> Vec<Formulation> {
    Formulation::nine().into_iter().map(|formulation| formulation.tolerance(tolerance)).collect()
}
