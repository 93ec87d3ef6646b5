//! Scripts of other codes that share nothing but the scene and the names of its quantities: mesh, forms, contact, iteration and measures
//! are each script's own. What they answered is frozen in `oracles/frozen/independent.json`.

use std::collections::BTreeMap;
use std::fmt;
use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use crate::checkout::root;
use crate::error::Error;
use crate::oracle::cross_code::frozen::{REFREEZE, hash_of, read_json, write_json};
use crate::oracle::cross_code::{PhysicalAnswer, PhysicalScene};

/// A folder under `oracles`: one code, and a script that shares nothing with those of the others.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Folder {
    /// scikit-fem.
    ScikitFem,
    /// dolfinx, the solver of FEniCSx.
    Dolfinx,
    /// The half-plane's influence function, in numpy alone.
    Boundary,
    /// GetFEM.
    Getfem,
    /// CalculiX.
    Calculix,
}

impl Folder {
    /// All.
    pub const ALL: [Self; 5] = [Self::ScikitFem, Self::Dolfinx, Self::Boundary, Self::Getfem, Self::Calculix];

    /// The code.
    pub fn name(self) -> &'static str {
        match self {
            Self::ScikitFem => "scikit-fem",
            Self::Dolfinx => "dolfinx",
            Self::Boundary => "numpy",
            Self::Getfem => "GetFEM",
            Self::Calculix => "CalculiX",
        }
    }

    /// Where it is.
    pub fn path(self) -> PathBuf {
        let name = match self {
            Self::ScikitFem => "scikit_fem",
            Self::Dolfinx => "dolfinx",
            Self::Boundary => "boundary",
            Self::Getfem => "getfem",
            Self::Calculix => "calculix",
        };
        root().join("oracles").join(name)
    }

    /// Whether the set-up of the tests installs the code; the others answer in a process of their own, when the answers are frozen.
    pub fn is_set_up(self) -> bool {
        !matches!(self, Self::Getfem | Self::Calculix)
    }
}

/// A script by one of its methods.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Script {
    /// dolfinx: a penalty written in UFL.
    Ufl,
    /// dolfinx 0.11: the same between two bodies, on pairs of facets.
    Pairs,
    /// scikit-fem: a penalty in facet forms.
    Facets,
    /// scikit-fem: Nitsche's method, without penalty.
    Nitsche,
    /// numpy: a boundary method on the elastic half-plane.
    HalfPlane,
    /// GetFEM: an augmented Lagrangian in its weak form language.
    Augmented,
    /// CalculiX: gap elements between facing nodes.
    Gaps,
}

impl Script {
    /// All.
    pub const ALL: [Self; 7] =
        [Self::Ufl, Self::Pairs, Self::Facets, Self::Nitsche, Self::HalfPlane, Self::Augmented, Self::Gaps];

    /// Its folder.
    pub fn folder(self) -> Folder {
        match self {
            Self::Ufl | Self::Pairs => Folder::Dolfinx,
            Self::Facets | Self::Nitsche => Folder::ScikitFem,
            Self::HalfPlane => Folder::Boundary,
            Self::Augmented => Folder::Getfem,
            Self::Gaps => Folder::Calculix,
        }
    }

    /// Code and method in words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Ufl => "dolfinx, UFL penalty",
            Self::Pairs => "dolfinx, UFL penalty on facet pairs",
            Self::Facets => "scikit-fem, facet penalty",
            Self::Nitsche => "scikit-fem, Nitsche",
            Self::HalfPlane => "half-plane, boundary method",
            Self::Augmented => "GetFEM, augmented Lagrangian",
            Self::Gaps => "CalculiX, gap elements",
        }
    }

    /// The method that its module is asked for.
    pub fn method(self) -> &'static str {
        match self {
            Self::Ufl | Self::Facets => "penalty",
            Self::Pairs => "pairs",
            Self::Nitsche => "nitsche",
            Self::HalfPlane => "boundary",
            Self::Augmented => "augmented",
            Self::Gaps => "gaps",
        }
    }

    /// Whether its springs are of a finite stiffness that is felt.
    pub fn has_penalty(self) -> bool {
        matches!(self, Self::Ufl | Self::Pairs | Self::Facets)
    }

    /// Whether the set-up of the tests installs what it runs on everywhere: Debian's dolfinx 0.5.2 couples no facets of two bodies.
    pub fn is_set_up(self) -> bool {
        self.folder().is_set_up() && self != Self::Pairs
    }

    /// Whether it solves a scene: a script of one body solves no pin, the half-plane has no other surface, and GetFEM and CalculiX are
    /// asked where no closed form is exact.
    pub fn serves(self, scene: &PhysicalScene) -> bool {
        let cases: &[&str] = match self {
            Self::Ufl => &["cylinder", "truncated-hertz"],
            Self::Facets | Self::Nitsche => &["cylinder", "truncated-hertz", "pin-rod", "pin-plate"],
            Self::HalfPlane => &["truncated-hertz"],
            Self::Pairs | Self::Augmented | Self::Gaps => &["pin-rod", "pin-plate"],
        };
        cases.contains(&scene.case.as_str())
    }

    /// Its Python module.
    pub fn module(self) -> &'static str {
        match self {
            Self::Ufl => "ufl_penalty",
            Self::Pairs => "facet_pairs",
            Self::Facets | Self::Nitsche => "facet_forms",
            Self::HalfPlane => "half_plane",
            Self::Augmented => "augmented",
            Self::Gaps => "gap_elements",
        }
    }
}

impl fmt::Display for Script {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// What the scripts answered.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Independent {
    /// SHA-256 of the Python files of each folder.
    pub scripts: BTreeMap<Folder, String>,
    /// Versions of what the tests set up, by name.
    pub versions: BTreeMap<String, String>,
    /// Versions of the codes that answered in processes of their own.
    pub apart: BTreeMap<Folder, String>,
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

impl PhysicalAnswer {
    /// All numbers in groups of one unit and scale.
    pub fn numbers(&self) -> [(String, Vec<f64>); 5] {
        [
            ("half-width".into(), vec![self.half_width]),
            ("peak".into(), vec![self.peak]),
            ("resultant".into(), vec![self.resultant]),
            ("profile".into(), self.pressure.clone()),
            ("dofs".into(), vec![self.dofs as f64]),
        ]
    }
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
        match now.iter().find(|(folder, hash)| all.scripts.get(folder) != Some(hash)) {
            None => Ok(all),
            Some((folder, _)) => {
                let found = format!("not of the present scripts in {}", folder.path().display());
                Err(Error::refused(&file(), "scripts", found, REFREEZE))
            }
        }
    }

    /// The answers as they were frozen when the program was built, for which no checkout is needed.
    pub fn built_in() -> Result<Self, Error> {
        let text = include_str!("../../../oracles/frozen/independent.json");
        serde_json::from_str(text).map_err(|error| Error::unreadable(&file(), error, REFREEZE))
    }

    /// Reads the answers, of whatever scripts they are.
    pub fn load() -> Result<Self, Error> {
        read_json(&file(), REFREEZE)
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

/// SHA-256 of the Python files of each folder.
pub fn hashes() -> Result<BTreeMap<Folder, String>, Error> {
    Folder::ALL.into_iter().map(|folder| Ok((folder, hash_of(&folder.path())?))).collect()
}
