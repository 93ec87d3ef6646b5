//! What the scripts of bodies of revolution in `oracles/revolution` answered, frozen in `oracles/frozen/revolution.json`.

use std::path::PathBuf;

use serde::Deserialize;

use crate::checkout::root;
use crate::error::Error;
use crate::oracle::cross_code::PhysicalAnswer;
use crate::oracle::cross_code::frozen::{Answered, read_json};

/// What asks all scripts again.
pub const RENEW: &str = "run `python3 oracles/revolution/freeze.py`";

/// What every script answers, by the name of its module.
pub type Revolution = Answered<String, Series>;

/// What a script answers.
#[derive(Clone, Debug, Deserialize)]
pub struct Series {
    /// Version of its code.
    pub version: String,
    /// On meshes from coarse to fine.
    pub series: Vec<Answer>,
}

/// An answer on one mesh.
#[derive(Clone, Debug, Deserialize)]
pub struct Answer {
    /// Contact radius, peak, whole force and pressures.
    #[serde(flatten)]
    pub physical: PhysicalAnswer,
    /// Approach \[mm\].
    pub approach: f64,
}

impl Revolution {
    /// Reads it.
    pub fn read() -> Result<Self, Error> {
        read_json(&root().join("oracles/frozen/revolution.json"), RENEW)
    }
}

/// The folder of the scripts.
pub fn folder() -> PathBuf {
    root().join("oracles/revolution")
}
