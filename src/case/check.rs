//! A check: a quantity, what it is held against, a tolerance and the reason for it.

use std::borrow::Cow;

use crate::case::quantity::Quantity;
use crate::markdown;
use crate::measure;
use crate::oracle::{Oracle, Reading, ReferenceKind};
use crate::scene::Scene;

/// A reference value with its origin.
#[derive(Clone, Debug, PartialEq)]
pub struct Reference {
    /// Name of the oracle.
    pub name: String,
    /// What kind of truth it is.
    pub kind: ReferenceKind,
    /// The value; zero where an error is held against its tolerance.
    pub value: f64,
    /// Its standard uncertainty, in its unit; 0 where it is exact, none where it is not known.
    pub uncertainty: Option<f64>,
}

/// What a quantity is held against.
#[derive(Clone, Debug, PartialEq)]
pub enum Against {
    /// What the oracle of the case reads for the quantity.
    Oracle,
    /// What node elements under kinematic load find on the same mesh, iterated to 1e-8.
    Verification,
    /// A value.
    Value(Reference),
}

/// How a quantity shall stand to its reference.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Relation {
    /// `|value − reference| / |reference| ≤ tolerance`.
    Near,
    /// `|value − reference| ≤ tolerance`.
    NearAbsolutely,
    /// The quantity is itself an error: `value ≤ tolerance`.
    Error,
    /// `value ≥ reference`; the error is what is missing.
    AtLeast,
    /// `value ≤ reference`; the error is the excess.
    AtMost,
}

/// Of what a check is asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(rename = "Asked")]
pub enum Scope {
    /// Of the case, the scene file or the study that declares it.
    Own,
    /// Of every run.
    #[serde(rename = "every-run")]
    Universal,
}

/// A requirement, declared as data; its sentence is rendered.
#[derive(Clone, Debug, PartialEq)]
pub struct Check {
    /// What is measured.
    pub quantity: Quantity,
    /// How it shall stand to its reference.
    pub relation: Relation,
    /// What it is held against.
    pub against: Against,
    /// The largest error accepted.
    pub tolerance: f64,
    /// What a closed form itself may be off for this scene, as the case states it: relative to the reference, absolute
    /// where that is 0.
    pub model: f64,
    /// Why this tolerance.
    pub because: Cow<'static, str>,
    /// Of what it is asked.
    pub scope: Scope,
    /// Index of the contact it is asked of.
    pub contact: usize,
    /// How many runs, answers or faults it is asked of; of none nothing is known, and it fails.
    pub number: usize,
}

impl Reference {
    /// A value the code must reproduce when asked in another way.
    pub fn own(name: &str, value: f64) -> Self {
        Self { name: name.into(), kind: ReferenceKind::SelfConsistency, value, uncertainty: None }
    }

    /// A closed-form value.
    pub fn analytic(name: &str, value: f64) -> Self {
        Self { name: name.into(), kind: ReferenceKind::Analytic, value, uncertainty: Some(0.0) }
    }

    /// A multiple of it.
    pub fn times(self, factor: f64) -> Self {
        Self { value: factor * self.value, uncertainty: self.uncertainty.map(|u| factor.abs() * u), ..self }
    }

    /// What an oracle reads for a number of a contact of a scene, in its own unit; NaN, which no check passes, where it
    /// cannot say.
    pub fn of(oracle: &dyn Oracle, scene: &Scene, contact: usize, quantity: &measure::Quantity) -> Self {
        let (value, uncertainty) = match oracle.read(quantity.known_by(&scene.contacts[contact])) {
            Reading::Value { value, uncertainty } => (value, Some(uncertainty)),
            Reading::Silent | Reading::Unavailable(_) => (f64::NAN, None),
        };
        let factor = if quantity.grows_with_thickness() { scene.thickness } else { 1.0 };
        Self { name: oracle.name().into(), kind: oracle.kind(), value, uncertainty }.times(factor)
    }
}

impl From<Reference> for Against {
    fn from(reference: Reference) -> Self {
        Self::Value(reference)
    }
}

impl Check {
    /// A quantity that shall agree with its reference, relative to that.
    pub fn near(
        quantity: impl Into<Quantity>,
        against: impl Into<Against>,
        tolerance: f64,
        because: impl Into<Cow<'static, str>>,
    ) -> Self {
        Self::of(quantity.into(), Relation::Near, against.into(), tolerance, because.into())
    }

    /// A quantity that shall agree with its reference, in its own unit: where that is 0.
    pub fn absolute(
        quantity: impl Into<Quantity>,
        against: impl Into<Against>,
        tolerance: f64,
        because: impl Into<Cow<'static, str>>,
    ) -> Self {
        Self::of(quantity.into(), Relation::NearAbsolutely, against.into(), tolerance, because.into())
    }

    /// An error, or the norm of one, that shall not exceed the tolerance.
    pub fn error(
        quantity: impl Into<Quantity>,
        against: impl Into<Against>,
        tolerance: f64,
        because: impl Into<Cow<'static, str>>,
    ) -> Self {
        Self::of(quantity.into(), Relation::Error, against.into(), tolerance, because.into())
    }

    /// A quantity that shall reach a lower bound.
    pub fn at_least(quantity: impl Into<Quantity>, bound: Reference, because: impl Into<Cow<'static, str>>) -> Self {
        Self::of(quantity.into(), Relation::AtLeast, bound.into(), 0.0, because.into())
    }

    /// A quantity that shall not exceed an upper bound.
    pub fn at_most(quantity: impl Into<Quantity>, bound: Reference, because: impl Into<Cow<'static, str>>) -> Self {
        Self::of(quantity.into(), Relation::AtMost, bound.into(), 0.0, because.into())
    }

    /// Something, by its plural, of which there shall be none.
    pub fn none(quantity: impl Into<Quantity>, because: impl Into<Cow<'static, str>>) -> Self {
        Self::at_most(quantity, Reference::own("none", 0.0), because)
    }

    fn of(
        quantity: Quantity,
        relation: Relation,
        against: Against,
        tolerance: f64,
        because: Cow<'static, str>,
    ) -> Self {
        Self { quantity, relation, against, tolerance, model: 0.0, because, scope: Scope::Own, contact: 0, number: 1 }
    }

    /// The same, whose closed form may itself be off by so much.
    pub fn leaving(self, model: f64) -> Self {
        Self { model, ..self }
    }

    /// The same, asked of so many runs, answers or faults together.
    pub fn asked_of(self, number: usize) -> Self {
        Self { number, ..self }
    }

    /// The same, asked of every run.
    pub fn universal(self) -> Self {
        Self { scope: Scope::Universal, ..self }
    }

    /// The sentence of what shall hold against a reference.
    pub fn requirement(&self, reference: &Reference) -> String {
        let (name, origin) = (self.quantity.name(), &reference.name);
        let (bound, tolerance) = (markdown::bound(reference.value), markdown::tolerance(self.tolerance));
        let sentence = match self.relation {
            Relation::Near => format!("{name} shall agree with {origin} within {tolerance}"),
            Relation::NearAbsolutely => {
                let tolerance = markdown::value(self.tolerance);
                format!("{name} shall agree with {origin} ({bound}) within {tolerance} in its unit")
            }
            Relation::Error => format!("{name} shall be at most {tolerance} against {origin}"),
            Relation::AtLeast => format!("{name} shall be at least {bound} ({origin})"),
            Relation::AtMost if reference.value.abs() <= 0.0 => return format!("There shall be no {name}"),
            Relation::AtMost => format!("{name} shall be at most {bound} ({origin})"),
        };
        markdown::capitalised(&sentence)
    }
}
