//! Contact element × algorithm × rule by the name that records keep, and how a run of it ended.

use std::fmt;

use serde::{Deserialize, Serialize};

use crate::algorithm::{Acceleration, StiffnessRule};
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
    /// What the program adds to it, or nothing.
    pub acceleration: Acceleration,
}

impl Method {
    /// All, element by element.
    pub fn all() -> Vec<Self> {
        Element::ALL.into_iter().flat_map(Self::of).collect()
    }

    /// All of an element: the rules of each algorithm, the first of them as the program takes it beside its plain form.
    pub fn of(element: Element) -> Vec<Self> {
        let acceleration = Acceleration::None;
        let with = |algorithm: Iteration| {
            let mut own: Vec<Self> =
                algorithm.rules().iter().map(|&rule| Self { element, algorithm, rule, acceleration }).collect();
            let default = Self::default(element, algorithm);
            if default.is_accelerated() {
                own.insert(1, default);
            }
            own
        };
        Iteration::ALL.into_iter().flat_map(with).collect()
    }

    /// An element with an algorithm and its first rule, as it stands in the paper.
    pub fn usual(element: Element, algorithm: Iteration) -> Self {
        Self { element, algorithm, rule: algorithm.rules()[0], acceleration: Acceleration::None }
    }

    /// The same as the program takes it.
    pub fn default(element: Element, algorithm: Iteration) -> Self {
        let acceleration = Formulation::accelerated(element, algorithm).acceleration;
        Self { acceleration, ..Self::usual(element, algorithm) }
    }

    /// Whether the program adds something to the rule.
    pub fn is_accelerated(self) -> bool {
        self.acceleration != Acceleration::None
    }

    /// The formulation at an initial stiffness.
    pub fn formulation(self, stiffness: f64) -> Formulation {
        let Self { element, algorithm, rule, acceleration } = self;
        Formulation { rule, stiffness, acceleration, ..Formulation::new(element, algorithm) }
    }

    /// Its name without the element: `algorithm.rule`, with what is added.
    pub fn way(self) -> String {
        let added = if self.is_accelerated() { format!("+{}", self.acceleration.name()) } else { String::new() };
        format!("{}.{}{added}", self.algorithm.name(), self.rule.name())
    }
}

/// `element.algorithm.rule`, the rule always named.
impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{}", self.element.name(), self.way())
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
