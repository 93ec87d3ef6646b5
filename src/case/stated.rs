//! Checks whose requirement is still a sentence.

use crate::case::{Check, Judged, Quantity, Reference};
use crate::oracle::ReferenceKind;

impl Judged {
    /// Near a reference.
    pub fn relative(
        requirement: impl Into<String>,
        quantity: impl Into<String>,
        value: f64,
        reference: Reference,
        tolerance: f64,
        because: impl Into<String>,
    ) -> Self {
        Check::near(Quantity::at(requirement.into(), quantity), reference, tolerance, because.into()).judge(value)
    }

    /// A norm.
    pub fn norm(
        requirement: impl Into<String>,
        quantity: impl Into<String>,
        error: f64,
        reference: Reference,
        tolerance: f64,
        because: impl Into<String>,
    ) -> Self {
        Check::error(Quantity::at(requirement.into(), quantity), reference, tolerance, because.into()).judge(error)
    }

    /// A lower bound.
    pub fn at_least(
        requirement: impl Into<String>,
        quantity: impl Into<String>,
        value: f64,
        reference: Reference,
        because: impl Into<String>,
    ) -> Self {
        Check::at_least(Quantity::at(requirement.into(), quantity), reference, because.into()).judge(value)
    }

    /// An upper bound.
    pub fn at_most(
        requirement: impl Into<String>,
        quantity: impl Into<String>,
        value: f64,
        reference: Reference,
        because: impl Into<String>,
    ) -> Self {
        Check::at_most(Quantity::at(requirement.into(), quantity), reference, because.into()).judge(value)
    }

    /// The same, asked of every run.
    pub fn universal(self) -> Self {
        Self { check: self.check.universal(), ..self }
    }

    /// A check whose reference is absent.
    pub fn not_run(requirement: &str, quantity: &str, kind: ReferenceKind, name: &str, why: String) -> Self {
        let check = Check::near(Quantity::at(requirement.to_owned(), quantity), Reference::own("", 0.0), f64::NAN, "");
        check.not_run(kind, name, why)
    }
}
