//! What a live run leaves: what each code told of its runs, beside the files that it wrote.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use crate::checkout::root;
use crate::error::Error;
use crate::referee::export::problem::SCRIPTS;
use crate::study::scoreboard::setting::Code;

/// Where it is.
pub const FOLDER: &str = "oracles/frozen/scoreboard";
/// What renews it.
pub const RENEW: &str = "run `bash oracles/peers/setup.sh && cargo run --release -- scoreboard`, and review the diff of oracles/frozen/scoreboard";

/// All runs.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Board {
    /// SHA-256 of the scripts, in hexadecimal digits.
    pub scripts: BTreeMap<String, String>,
    /// Processor that the seconds are of.
    pub processor: String,
    /// By case.
    pub cases: BTreeMap<String, Asked>,
}

/// A case as it was asked.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Asked {
    /// Displacement components of the exported mesh.
    pub dofs: usize,
    /// Runs, in the order of the settings.
    pub runs: Vec<Told>,
}

/// What was told of a run.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Told {
    /// The code.
    pub code: Code,
    /// Its contact, by the name in its script.
    pub method: String,
    /// Version of the code; none of a run that failed.
    pub version: Option<String>,
    /// Seconds: of the solution by the script's own account; of the whole process where it failed.
    pub seconds: f64,
    /// Seconds of one sparse Cholesky solve of the exported mesh, just before.
    pub cholesky: f64,
    /// How it ended.
    pub ended: Ended,
}

/// How a run ended.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub enum Ended {
    /// With an answer.
    Answered {
        /// The file it wrote, in the folder of the board.
        file: String,
        /// Iterations.
        iterations: usize,
        /// Peak pressure \[MPa\] and half-width \[mm, or rad\] as they were judged then.
        found: [f64; 2],
    },
    /// Without one: what it said.
    Failed(String),
}

impl Board {
    /// Reads it.
    pub fn load() -> Result<Self, Error> {
        let file = file();
        let text = fs::read_to_string(&file).map_err(|_| Error::missing_file(&file, RENEW))?;
        serde_json::from_str(&text).map_err(|error| Error::unreadable(&file, error, RENEW))
    }

    /// Writes it.
    pub fn write(&self) -> Result<(), Error> {
        let file = file();
        let text = serde_json::to_string_pretty(self).map_err(|error| Error::unwritable(&file, error))?;
        fs::write(&file, text + "\n").map_err(|error| Error::unwritable(&file, error))
    }

    /// The case; refused where it was not asked.
    pub fn of(&self, case: &str) -> Result<&Asked, Error> {
        self.cases.get(case).ok_or_else(|| Error::missing_key(&file(), case, "the cases that were asked", RENEW))
    }
}

/// The file.
pub fn file() -> PathBuf {
    folder().join("record.json")
}

/// Its folder.
pub fn folder() -> PathBuf {
    root().join(FOLDER)
}

/// SHA-256 of the scripts as they are now.
pub fn hashes() -> BTreeMap<String, String> {
    let of = |text: &str| Sha256::digest(text).iter().map(|byte| format!("{byte:02x}")).collect();
    SCRIPTS.into_iter().map(|(name, text, _)| (name.to_owned(), of(text))).collect()
}
