//! Contact element × algorithm × rule, by the name that records keep.

use std::fmt;

use serde::{Deserialize, Serialize};

use crate::algorithm::StiffnessRule;
use crate::error::Error;
use crate::solve::{Element, Formulation, Iteration};

/// A way of solving, but for its numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct Method {
    /// Contact element.
    pub element: Element,
    /// Algorithm.
    pub algorithm: Iteration,
    /// Rule.
    pub rule: StiffnessRule,
}

impl Method {
    /// All, element by element.
    pub fn all() -> Vec<Self> {
        Element::ALL.into_iter().flat_map(Self::of).collect()
    }

    /// All of an element.
    pub fn of(element: Element) -> Vec<Self> {
        let with = |algorithm: Iteration| algorithm.rules().iter().map(move |&rule| Self { element, algorithm, rule });
        Iteration::ALL.into_iter().flat_map(with).collect()
    }

    /// An element with an algorithm and its first rule.
    pub fn usual(element: Element, algorithm: Iteration) -> Self {
        Self { element, algorithm, rule: algorithm.rules()[0] }
    }

    /// The formulation at an initial stiffness.
    pub fn formulation(self, stiffness: f64) -> Formulation {
        Formulation { rule: self.rule, stiffness, ..Formulation::new(self.element, self.algorithm) }
    }
}

/// `element.algorithm.rule`, the rule always named.
impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{}.{}", self.element.name(), self.algorithm.name(), self.rule.name())
    }
}

impl From<Method> for String {
    fn from(method: Method) -> Self {
        method.to_string()
    }
}

/// The method of a name; refused where there is none.
impl TryFrom<String> for Method {
    type Error = Error;

    fn try_from(name: String) -> Result<Self, Error> {
        let all = Self::all();
        let known = || all.iter().map(Self::to_string).collect::<Vec<_>>().join(", ");
        let found = all.iter().find(|method| method.to_string() == name).copied();
        found.ok_or_else(|| {
            Error::at("formulation", format!("there is no method `{name}`"), format!("choose one of {}", known()))
        })
    }
}
