//! What the scripts of bodies of revolution in `oracles/revolution` answered, frozen in
//! `oracles/frozen/revolution.json`.

use std::path::PathBuf;

use serde::Deserialize;

use crate::checkout::root;
use crate::error::Error;
use crate::oracle::cross_code::PhysicalAnswer;
use crate::oracle::cross_code::frozen::{Answered, named, parsed};

/// What asks all scripts again.
pub const RENEW: &str = "run `python3 oracles/revolution/freeze.py`";

/// Each script: its module, what it is called, and whether its springs are of a finite stiffness that is felt.
const SCRIPTS: [(&str, &str, bool); 4] = [
    ("skfem_forms", "scikit-fem, forms of revolution", true),
    ("ufl_forms", "dolfinx, forms of revolution", true),
    ("calculix_gaps", "CalculiX, CAX8 and gap elements", false),
    ("half_space", "tamaas, half-space", false),
];

/// What a script is called, whether its springs are felt, and its answers from coarse to fine.
pub type Called = (&'static str, bool, Vec<PhysicalAnswer>);

/// What every script answers, by the name of its module.
pub type Revolution = Answered<String, Series<Answer>>;

/// What a script answers.
#[derive(Clone, Debug, Deserialize)]
pub struct Series<A> {
    /// Version of its code.
    pub version: String,
    /// On meshes from coarse to fine.
    pub series: Vec<A>,
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
    /// The answers as they were frozen when the program was built, for which no checkout is needed.
    pub fn built_in() -> Result<Self, Error> {
        parsed(&named("revolution"), include_str!("../../../oracles/frozen/revolution.json"), RENEW)
    }

    /// What was answered of a scene.
    pub fn of(&self, scene: &str) -> Vec<Called> {
        let answers = self.scenes.get(scene).map(|asked| &asked.answers);
        let of = |(module, called, is_felt): (&str, &'static str, bool)| {
            let series = &answers?.get(module)?.series;
            Some((called, is_felt, series.iter().map(|answer| answer.physical.clone()).collect()))
        };
        SCRIPTS.into_iter().filter_map(of).collect()
    }
}

/// The folder of the scripts.
pub fn folder() -> PathBuf {
    root().join("oracles/revolution")
}
