//! Scripts of other codes that share nothing but the scene and the names of its quantities: mesh, forms, contact, iteration and measures
//! are each script's own. What they answered is frozen in `oracles/frozen/independent.json`.

use std::collections::BTreeMap;
use std::fmt;
use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use crate::checkout::root;
use crate::error::Error;
use crate::oracle::cross_code::frozen::{REFREEZE, hash_of, read_json, write_json};
use crate::oracle::cross_code::{Code, PhysicalAnswer, PhysicalScene};

/// A script by one of its methods.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Script {
    /// dolfinx: a penalty written in UFL.
    Ufl,
    /// scikit-fem: a penalty in facet forms.
    Facets,
    /// scikit-fem: Nitsche's method, without penalty.
    Nitsche,
}

impl Script {
    /// All.
    pub const ALL: [Self; 3] = [Self::Ufl, Self::Facets, Self::Nitsche];

    /// Its code.
    pub fn code(self) -> Code {
        match self {
            Self::Ufl => Code::Dolfinx,
            Self::Facets | Self::Nitsche => Code::ScikitFem,
        }
    }

    /// Code and method in words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Ufl => "dolfinx, UFL penalty",
            Self::Facets => "scikit-fem, facet penalty",
            Self::Nitsche => "scikit-fem, Nitsche",
        }
    }

    /// The method that its module is asked for.
    pub fn method(self) -> &'static str {
        match self {
            Self::Ufl | Self::Facets => "penalty",
            Self::Nitsche => "nitsche",
        }
    }

    /// Whether its springs are of finite stiffness.
    pub fn has_penalty(self) -> bool {
        self != Self::Nitsche
    }

    /// Whether it solves a scene: dolfinx 0.5 couples no facets of two bodies.
    pub fn serves(self, scene: &PhysicalScene) -> bool {
        match self {
            Self::Ufl => ["cylinder", "truncated-hertz"].contains(&scene.case.as_str()),
            Self::Facets | Self::Nitsche => true,
        }
    }

    /// Its Python module.
    pub fn module(self) -> &'static str {
        match self.code() {
            Code::Dolfinx => "ufl_penalty",
            Code::ScikitFem => "facet_forms",
        }
    }
}

impl fmt::Display for Script {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// The folder of a code's own script.
pub fn folder(code: Code) -> PathBuf {
    let name = match code {
        Code::ScikitFem => "scikit_fem",
        Code::Dolfinx => "dolfinx",
    };
    root().join("oracles").join(name)
}

/// What the scripts answered.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Independent {
    /// SHA-256 of the Python files of each code.
    pub scripts: BTreeMap<Code, String>,
    /// Versions by name.
    pub versions: BTreeMap<String, String>,
    /// The scenes, by name.
    pub scenes: BTreeMap<String, Asked>,
}

/// A scene with the refinement series of every script, coarse to fine.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Asked {
    /// The scene as it was given.
    pub scene: PhysicalScene,
    /// Of every script that serves it.
    pub series: BTreeMap<Script, Vec<PhysicalAnswer>>,
}

impl Asked {
    /// The numbers of a series in groups of one unit and scale.
    pub fn numbers(series: &[PhysicalAnswer]) -> Vec<(String, Vec<f64>)> {
        series.iter().flat_map(PhysicalAnswer::numbers).collect()
    }
}

impl Independent {
    /// The frozen answers; refused where a script has changed since.
    pub fn read() -> Result<Self, Error> {
        let all = Self::load()?;
        let now = hashes()?;
        match now.iter().find(|(code, hash)| all.scripts.get(code) != Some(hash)) {
            None => Ok(all),
            Some((code, _)) => {
                let found = format!("not of the present scripts in {}", folder(*code).display());
                Err(Error::refused(&file(), "scripts", found, REFREEZE))
            }
        }
    }

    /// Reads the answers, of whatever scripts they are.
    pub fn load() -> Result<Self, Error> {
        read_json(&file())
    }

    /// Writes the answers.
    pub fn write(&self) -> Result<(), Error> {
        write_json(&file(), self)
    }
}

/// The frozen file.
pub fn file() -> PathBuf {
    root().join("oracles/frozen/independent.json")
}

/// SHA-256 of the Python files of each code.
pub fn hashes() -> Result<BTreeMap<Code, String>, Error> {
    Code::ALL.into_iter().map(|code| Ok((code, hash_of(&folder(code))?))).collect()
}
