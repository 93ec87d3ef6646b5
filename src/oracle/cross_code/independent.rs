//! Scripts of other codes that share the scene and the definitions of its quantities, and no line: mesh, forms, contact
//! and iteration are each script's own. What they answered is frozen in `oracles/frozen/independent.json`.

use std::collections::BTreeMap;
use std::fmt;
use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use crate::checkout::root;
use crate::error::Error;
use crate::named::named_enum;
use crate::oracle::cross_code::frozen::{self, REFREEZE, hash_of, named, parsed, read_json, write_json};
use crate::oracle::cross_code::{PhysicalAnswer, PhysicalScene};

named_enum! {
    /// A folder under `oracles`: one code, which is its title, and a script that shares nothing with those of the
    /// others.
    pub enum Folder {
        /// scikit-fem.
        ScikitFem = "scikit-fem",
        /// dolfinx.
        ///
        /// The solver of FEniCSx.
        Dolfinx = "dolfinx",
        /// numpy.
        ///
        /// The half-plane's influence function.
        Boundary = "boundary",
        /// GetFEM.
        Getfem = "getfem",
        /// CalculiX.
        Calculix = "calculix",
    }
}

impl Folder {
    /// Where it is.
    pub fn path(self) -> PathBuf {
        root().join("oracles").join(self.name().replace('-', "_"))
    }

    /// Whether the set-up of the tests installs the code; the others answer in a process of their own, when the answers
    /// are frozen.
    pub fn is_set_up(self) -> bool {
        !matches!(self, Self::Getfem | Self::Calculix)
    }
}

named_enum! {
    /// A script by one of its methods; its title is code and method in words.
    pub enum Script {
        /// dolfinx, UFL penalty.
        Ufl = "ufl",
        /// dolfinx, UFL penalty on facet pairs.
        ///
        /// Between two bodies; dolfinx 0.11.
        Pairs = "pairs",
        /// scikit-fem, facet penalty.
        Facets = "facets",
        /// scikit-fem, Nitsche.
        ///
        /// Without penalty.
        Nitsche = "nitsche",
        /// half-plane, boundary method.
        ///
        /// In numpy alone.
        HalfPlane = "half-plane",
        /// GetFEM, augmented Lagrangian.
        ///
        /// In its weak form language.
        Augmented = "augmented",
        /// CalculiX, gap elements.
        ///
        /// Between facing nodes.
        Gaps = "gaps",
    }
}

/// Scenes of one body, and pins.
const CYLINDERS: &[&str] = &["cylinder", "truncated-hertz"];
const PINS: &[&str] = &["pin-rod", "pin-plate"];
const ALL_CASES: &[&str] = &["cylinder", "truncated-hertz", "pin-rod", "pin-plate"];

impl Script {
    /// Folder, Python module, the method that this is asked for, and the cases that it solves: a script of one body
    /// solves no pin, the half-plane has no other surface, and GetFEM and CalculiX are asked where no closed form is
    /// exact.
    fn asked(self) -> (Folder, &'static str, &'static str, &'static [&'static str]) {
        match self {
            Self::Ufl => (Folder::Dolfinx, "ufl_penalty", "penalty", CYLINDERS),
            Self::Pairs => (Folder::Dolfinx, "facet_pairs", "pairs", PINS),
            Self::Facets => (Folder::ScikitFem, "facet_forms", "penalty", ALL_CASES),
            Self::Nitsche => (Folder::ScikitFem, "facet_forms", "nitsche", ALL_CASES),
            Self::HalfPlane => (Folder::Boundary, "half_plane", "boundary", &["truncated-hertz"]),
            Self::Augmented => (Folder::Getfem, "augmented", "augmented", PINS),
            Self::Gaps => (Folder::Calculix, "gap_elements", "gaps", PINS),
        }
    }

    /// Its folder.
    pub fn folder(self) -> Folder {
        self.asked().0
    }

    /// Its Python module.
    pub fn module(self) -> &'static str {
        self.asked().1
    }

    /// The method that its module is asked for.
    pub fn method(self) -> &'static str {
        self.asked().2
    }

    /// Whether it solves a scene.
    pub fn serves(self, scene: &PhysicalScene) -> bool {
        self.asked().3.contains(&scene.case.as_str())
    }

    /// Whether its springs are of a finite stiffness that is felt.
    pub fn has_penalty(self) -> bool {
        matches!(self, Self::Ufl | Self::Pairs | Self::Facets)
    }

    /// Whether the set-up of the tests installs what it runs on everywhere: Debian's dolfinx 0.5.2 couples no facets of
    /// two bodies.
    pub fn is_set_up(self) -> bool {
        self.folder().is_set_up() && self != Self::Pairs
    }
}

impl fmt::Display for Script {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.title())
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

/// A scene with the refinement series of every script that serves it, coarse to fine.
pub type Asked = frozen::Asked<Script, Vec<PhysicalAnswer>>;

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
        parsed(&file(), include_str!("../../../oracles/frozen/independent.json"), REFREEZE)
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
    named("independent")
}

/// SHA-256 of the Python files of each folder.
pub fn hashes() -> Result<BTreeMap<Folder, String>, Error> {
    Folder::ALL.into_iter().map(|folder| Ok((folder, hash_of(&folder.path())?))).collect()
}
