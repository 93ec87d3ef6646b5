//! A check: what must hold, how far it is from holding, and the verdict.

use crate::oracle::{Oracle, Quantity, Reading, ReferenceKind};

/// Outcome of a check.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The error is within the tolerance.
    Pass,
    /// It is not, or it is not a number.
    Fail,
    /// The reference is absent, and why.
    NotRun(String),
}

/// A reference value with its origin.
#[derive(Clone, Debug)]
pub struct Reference {
    /// Name of the oracle.
    pub name: String,
    /// What kind of truth it is.
    pub kind: ReferenceKind,
    /// The value; zero where the requirement is that something vanishes.
    pub value: f64,
}

/// Of what a check is asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scope {
    /// Of the case, or the study, that declares it.
    Own,
    /// Of every run, whatever the case.
    Universal,
}

/// A requirement held against a reference.
#[derive(Clone, Debug)]
pub struct Check {
    /// What shall hold, in a sentence.
    pub requirement: String,
    /// Name of the quantity.
    pub quantity: String,
    /// The value found.
    pub value: f64,
    /// What it is held against.
    pub reference: Reference,
    /// The error, relative to the reference or to the scale the requirement names.
    pub error: f64,
    /// The largest error accepted.
    pub tolerance: f64,
    /// Why this tolerance.
    pub because: String,
    /// The verdict.
    pub verdict: Verdict,
    /// Of what it is asked.
    pub scope: Scope,
}

impl Reference {
    /// A value the code must reproduce when asked in another way.
    pub fn own(name: &str, value: f64) -> Self {
        Self { name: name.into(), kind: ReferenceKind::SelfConsistency, value }
    }

    /// A closed-form value.
    pub fn analytic(name: &str, value: f64) -> Self {
        Self { name: name.into(), kind: ReferenceKind::Analytic, value }
    }

    /// What an oracle reads for a quantity; NaN, which no check passes, where it cannot say.
    pub fn read(oracle: &dyn Oracle, quantity: Quantity) -> Self {
        let value = match oracle.read(quantity) {
            Reading::Value { value, .. } => value,
            Reading::Silent | Reading::Unavailable(_) => f64::NAN,
        };
        Self { name: oracle.name().into(), kind: oracle.kind(), value }
    }
}

impl Check {
    /// `|value − reference| / |reference| ≤ tolerance`.
    pub fn relative(
        requirement: impl Into<String>,
        quantity: impl Into<String>,
        value: f64,
        reference: Reference,
        tolerance: f64,
        because: impl Into<String>,
    ) -> Self {
        let error = (value - reference.value).abs() / reference.value.abs();
        Self::of_error(requirement, quantity, value, reference, error, tolerance, because)
    }

    /// An error norm that must not exceed the tolerance.
    pub fn norm(
        requirement: impl Into<String>,
        quantity: impl Into<String>,
        error: f64,
        reference: Reference,
        tolerance: f64,
        because: impl Into<String>,
    ) -> Self {
        Self::of_error(requirement, quantity, error, reference, error, tolerance, because)
    }

    /// A value that must reach a lower bound; the error is what is missing.
    pub fn at_least(
        requirement: impl Into<String>,
        quantity: impl Into<String>,
        value: f64,
        reference: Reference,
        because: impl Into<String>,
    ) -> Self {
        let missing = if value >= reference.value { 0.0 } else { reference.value - value };
        Self::of_error(requirement, quantity, value, reference, missing, 0.0, because)
    }

    /// A value that must not exceed an upper bound; the error is the excess.
    pub fn at_most(
        requirement: impl Into<String>,
        quantity: impl Into<String>,
        value: f64,
        reference: Reference,
        because: impl Into<String>,
    ) -> Self {
        let excess = if value <= reference.value { 0.0 } else { value - reference.value };
        Self::of_error(requirement, quantity, value, reference, excess, 0.0, because)
    }

    fn of_error(
        requirement: impl Into<String>,
        quantity: impl Into<String>,
        value: f64,
        reference: Reference,
        error: f64,
        tolerance: f64,
        because: impl Into<String>,
    ) -> Self {
        let verdict = if error <= tolerance { Verdict::Pass } else { Verdict::Fail };
        Self {
            requirement: requirement.into(),
            quantity: quantity.into(),
            value,
            reference,
            error,
            tolerance,
            because: because.into(),
            verdict,
            scope: Scope::Own,
        }
    }

    /// The same, asked of every run.
    pub fn universal(self) -> Self {
        Self { scope: Scope::Universal, ..self }
    }

    /// A check whose reference is absent.
    pub fn not_run(requirement: &str, quantity: &str, kind: ReferenceKind, name: &str, why: String) -> Self {
        Self {
            requirement: requirement.into(),
            quantity: quantity.into(),
            value: f64::NAN,
            reference: Reference { name: name.into(), kind, value: f64::NAN },
            error: f64::NAN,
            tolerance: f64::NAN,
            because: String::new(),
            verdict: Verdict::NotRun(why),
            scope: Scope::Own,
        }
    }
}
