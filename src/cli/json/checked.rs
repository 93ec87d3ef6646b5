//! A check with its numbers and its verdict as JSON.

use schemars::JsonSchema;
use serde::Serialize;

use crate::case::{Judged, Scope, Verdict};
use crate::error::Error;
use crate::oracle::ReferenceKind;
use crate::uncertainty::COVERAGE;

/// A check of a trial, or of a scene file: a line of `verdicts` and of `verify --json`.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Line {
    /// The trial, or the name of the scene file; of one that broke off, all else is null but the requirement, the
    /// verdict and the reason.
    trial: String,
    /// The check.
    #[serde(flatten)]
    check: Checked,
}

/// A check; its numbers are in its unit, angles in degrees.
#[derive(Clone, Debug, Default, Serialize, JsonSchema)]
pub struct Checked {
    /// The contact, of an answer that is judged.
    #[serde(skip_serializing_if = "Option::is_none")]
    contact: Option<String>,
    /// What is measured, with its place and unit.
    quantity: Option<String>,
    /// Unit of value, bar, reference and uncertainties; null of a pure number.
    unit: Option<&'static str>,
    /// The sentence of what shall hold.
    requirement: String,
    /// Of what it is asked.
    scope: Option<Scope>,
    /// The value found.
    value: Option<f64>,
    /// Standard uncertainty of the value; null where it is not known.
    uncertainty: Option<f64>,
    /// How far the value may be from the truth of the scene; null where it is not known.
    bar: Option<f64>,
    /// What it is held against; 0 where the value is itself an error.
    reference: Option<f64>,
    /// Standard uncertainty of the reference; null where it is not known.
    reference_uncertainty: Option<f64>,
    /// How far the reference may be off; null where that is not known.
    reference_bar: Option<f64>,
    /// Name of the reference.
    source: Option<String>,
    /// What kind of truth the reference is.
    kind: Option<ReferenceKind>,
    /// The error, relative to the reference or to the scale that the quantity names; absolute where the reference is 0.
    error: Option<f64>,
    /// The largest error accepted.
    tolerance: Option<f64>,
    /// Why this tolerance.
    because: Option<String>,
    /// Whether it passed, failed or was not run.
    #[schemars(with = "String", extend("enum" = ["pass", "fail", "not run"]))]
    verdict: Verdict,
    /// Why it did not pass; null where it did.
    reason: Option<String>,
    /// Whether it passed.
    passed: bool,
}

impl Line {
    /// A check of a trial.
    pub fn of(trial: &str, check: &Judged) -> Self {
        Self { trial: trial.into(), check: Checked::of(check) }
    }

    /// A trial that broke off, which fails.
    pub fn broken(trial: &str, error: &Error) -> Self {
        let why = error.to_string();
        let check = Checked { requirement: why.clone(), reason: Some(why), ..Checked::default() };
        Self { trial: trial.into(), check }
    }

    /// Whether it failed.
    pub fn failed(&self) -> bool {
        self.check.verdict == Verdict::Fail
    }
}

impl Checked {
    /// A check that was judged.
    pub fn of(judged: &Judged) -> Self {
        let Judged { check, value, uncertainty, bar, reference, error, verdict } = judged;
        Self {
            contact: None,
            quantity: Some(check.quantity.to_string()),
            unit: check.quantity.unit(),
            requirement: judged.requirement(),
            scope: Some(check.scope),
            value: (*value).into(),
            uncertainty: *uncertainty,
            bar: *bar,
            reference: reference.value.into(),
            reference_uncertainty: reference.uncertainty,
            reference_bar: reference.uncertainty.map(|standard| COVERAGE * standard),
            source: Some(reference.name.clone()),
            kind: Some(reference.kind),
            error: (*error).into(),
            tolerance: check.tolerance.into(),
            because: Some(check.because.to_string()),
            verdict: verdict.clone(),
            reason: judged.reason(),
            passed: *verdict == Verdict::Pass,
        }
    }

    /// The same, of a contact.
    pub fn of_contact(self, name: &str) -> Self {
        Self { contact: Some(name.into()), ..self }
    }
}
