//! The codes themselves, to be asked now instead of read from what is frozen.

use std::collections::BTreeMap;

use crate::error::Error;
use crate::oracle::cross_code::independent::Script;
use crate::oracle::cross_code::{Code, DiscreteAnswer, DiscreteProblem, PhysicalAnswer, PhysicalScene};

/// What asks them: three functions of the crate `contact-vv-live`, which holds all that needs Python.
#[derive(Clone, Copy, Debug)]
pub struct Live {
    /// Solves our discrete problem by another code.
    pub discrete: fn(Code, &DiscreteProblem) -> Result<DiscreteAnswer, Error>,
    /// Solves a scene on the mesh of a level by a script that shares nothing.
    pub independent: fn(Script, &PhysicalScene, usize) -> Result<PhysicalAnswer, Error>,
    /// Versions of Python and of the packages, by name.
    pub versions: fn() -> Result<BTreeMap<String, String>, Error>,
}
