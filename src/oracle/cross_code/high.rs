//! Reference answers of high order by scripts that share nothing with ours but the scene. What they answered is frozen
//! in `oracles/frozen/high.json`; `oracles/high/freeze.py` asks them.

use std::collections::BTreeMap;

use serde::Deserialize;

use crate::error::Error;
use crate::named::named_enum;
use crate::oracle::cross_code::frozen::{Answered, named, parsed};

/// What asks the scripts again.
pub const ASK_AGAIN: &str = "run `/usr/bin/python3 oracles/high/freeze.py`, and review the diff";

named_enum! {
    /// A way to an answer of high order; its title is code and method in words.
    pub enum Way {
        /// numpy, complex potentials.
        ///
        /// Potentials of discs and holes in closed form, and pressures that are a root times a polynomial.
        Boundary = "boundary",
        /// NGSolve, order 8.
        ///
        /// Curved cells, a vertex at the end of the contact, multipliers.
        FiniteElements = "finite_elements",
    }
}

/// What the scripts answered.
pub type High = Answered<Way, Answer>;

/// An answer.
#[derive(Clone, Debug, Deserialize)]
pub struct Answer {
    /// Versions of what it was found with.
    pub versions: BTreeMap<String, String>,
    /// How long it took with all its settings \[s\].
    pub seconds: f64,
    /// Its numbers and how far they may be off, by the key of a quantity \[mm, MPa, N, rad\]: twice the largest
    /// difference between settings.
    pub numbers: BTreeMap<String, [f64; 2]>,
}

impl High {
    /// The answers as they were frozen when the program was built.
    pub fn built_in() -> Result<Self, Error> {
        parsed(&named("high"), include_str!("../../../oracles/frozen/high.json"), ASK_AGAIN)
    }

    /// What is known of a number of a scene: value and how far it may be off.
    pub fn of(&self, scene: &str, key: &str) -> Vec<(Way, [f64; 2])> {
        let answers = self.scenes.get(scene).into_iter().flat_map(|asked| &asked.answers);
        answers.filter_map(|(way, answer)| Some((*way, *answer.numbers.get(key)?))).collect()
    }
}
