//! A check that was held against what was found.

use std::fmt;

use crate::case::check::{Check, Reference};

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

/// A check with the value found, the reference, the error and the verdict.
#[derive(Clone, Debug)]
pub struct Judged {
    /// What was asked.
    pub check: Check,
    /// The value found.
    pub value: f64,
    /// What it was held against.
    pub reference: Reference,
    /// The error, relative to the reference or to the scale the quantity names.
    pub error: f64,
    /// The verdict.
    pub verdict: Verdict,
}

impl Judged {
    /// The sentence of what shall hold.
    pub fn requirement(&self) -> String {
        self.check.requirement(&self.reference)
    }

    /// The error over the tolerance; 0 or infinite where nothing is tolerated, NaN where the error is no number.
    pub fn share_of_tolerance(&self) -> f64 {
        match self.error {
            error if error <= 0.0 => 0.0,
            error => error / self.check.tolerance,
        }
    }
}

/// The worst of some verdicts: a failure, else one that was not run, else a pass; none of nothing.
pub fn worst<'a>(judged: impl IntoIterator<Item = &'a Judged>) -> Option<&'a Verdict> {
    let severity = |verdict: &&Verdict| match verdict {
        Verdict::Pass => 0,
        Verdict::NotRun(_) => 1,
        Verdict::Fail => 2,
    };
    judged.into_iter().map(|judged| &judged.verdict).max_by_key(severity)
}

/// A sign and a word.
impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Pass => f.write_str("✓ pass"),
            Self::Fail => f.write_str("✗ FAIL"),
            Self::NotRun(why) => write!(f, "○ {why}"),
        }
    }
}
