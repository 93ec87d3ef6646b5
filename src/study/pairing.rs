//! Contact element × algorithm, by the name that records keep.

use std::fmt;

use serde::{Deserialize, Serialize};

use crate::error::{Error, Place};
use crate::solve::{Element, Formulation, Iteration};

/// One of the nine formulations, but for its settings.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct Pairing {
    /// Contact element.
    pub element: Element,
    /// Algorithm.
    pub algorithm: Iteration,
}

impl Pairing {
    /// All nine, element by element.
    pub fn all() -> Vec<Self> {
        Formulation::nine().iter().map(Self::of).collect()
    }

    /// Of a formulation.
    pub fn of(&Formulation { element, algorithm, .. }: &Formulation) -> Self {
        Self { element, algorithm }
    }

    /// The formulation at its defaults.
    pub fn formulation(self) -> Formulation {
        Formulation::new(self.element, self.algorithm)
    }
}

/// `element.algorithm`.
impl fmt::Display for Pairing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{}", self.element.name(), self.algorithm.name())
    }
}

impl From<Pairing> for String {
    fn from(pairing: Pairing) -> Self {
        pairing.to_string()
    }
}

/// The pairing of a name; refused where there is none.
impl TryFrom<String> for Pairing {
    type Error = Error;

    fn try_from(name: String) -> Result<Self, Error> {
        let all = Self::all();
        let known = || all.iter().map(Self::to_string).collect::<Vec<_>>().join(", ");
        let found = all.iter().find(|pairing| pairing.to_string() == name).copied();
        found.ok_or_else(|| {
            Error::at(Place::Nowhere, format!("`{name}` is no formulation"), format!("give one of {}", known()))
        })
    }
}
