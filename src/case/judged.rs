//! A check that was held against what was found.

use std::collections::BTreeMap;
use std::fmt;

use crate::case::check::{Against, Check, Reference, Relation};
use crate::case::quantity::Quantity;
use crate::markdown;
use crate::oracle::ReferenceKind;
use crate::uncertainty::{COVERAGE, Comparison};

/// A verdict.
#[derive(Clone, Debug, Default, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Verdict {
    /// The error is within the tolerance.
    Pass,
    /// It is not, or it is no number.
    #[default]
    Fail,
    /// The reference is absent.
    #[serde(rename = "not run")]
    NotRun(#[serde(skip)] String),
}

/// A verdict without its words, from good to bad.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Mark {
    /// The error is within the tolerance.
    Pass,
    /// There was no reference.
    NotRun,
    /// The error is not within the tolerance.
    Fail,
}

/// A check with the value found, the reference, the error and the verdict.
#[derive(Clone, Debug)]
pub struct Judged {
    /// What was asked.
    pub check: Check,
    /// The value found.
    pub value: f64,
    /// Its standard uncertainty, in its unit; none where it is not known.
    pub uncertainty: Option<f64>,
    /// How far the value may be from the truth of the scene, in its unit; none where it has no error bar, or was asked
    /// for none.
    pub bar: Option<f64>,
    /// What it was held against.
    pub reference: Reference,
    /// The error, relative to the reference or to the scale the quantity names.
    pub error: f64,
    /// The verdict.
    pub verdict: Verdict,
}

impl Check {
    /// Judges a value where the reference is one; without, the error is not a number.
    pub fn judge(self, value: f64) -> Judged {
        let reference = match &self.against {
            Against::Value(reference) => reference.clone(),
            Against::Oracle | Against::Verification => Reference::own("none", f64::NAN),
        };
        self.judge_by(value, reference)
    }

    /// Judges a value by the reference that was found for it; of nothing there is none.
    pub fn judge_by(self, value: f64, reference: Reference) -> Judged {
        let value = if self.number > 0 { value } else { f64::NAN };
        let error = match self.relation {
            Relation::Near => (value - reference.value).abs() / reference.value.abs(),
            Relation::NearAbsolutely => (value - reference.value).abs(),
            Relation::Error => value,
            Relation::AtLeast if value >= reference.value => 0.0,
            Relation::AtMost if value <= reference.value => 0.0,
            Relation::AtLeast => reference.value - value,
            Relation::AtMost => value - reference.value,
        };
        let verdict = if error <= self.tolerance { Verdict::Pass } else { Verdict::Fail };
        Judged { check: self, value, uncertainty: None, bar: None, reference, error, verdict }
    }

    /// A check whose reference is absent, and why.
    pub fn not_run(self, kind: ReferenceKind, name: &str, why: String) -> Judged {
        let reference = Reference { name: name.into(), kind, value: f64::NAN, uncertainty: None };
        let [value, error] = [f64::NAN; 2];
        Judged { check: self, value, uncertainty: None, bar: None, reference, error, verdict: Verdict::NotRun(why) }
    }
}

impl Judged {
    /// The same, not judged where it misses its tolerance by no more than an iteration error that was accepted
    /// beforehand.
    pub fn as_far_as(self, iteration: f64) -> Self {
        let is_relative = matches!(self.check.relation, Relation::Near | Relation::Error);
        let may_be_the_iteration = is_relative && self.error <= self.check.tolerance + iteration;
        if self.verdict != Verdict::Fail || !may_be_the_iteration {
            return self;
        }
        let [asked, accepted] = [self.check.tolerance, iteration].map(markdown::tolerance);
        let why = format!("not judged: it asks for {asked}, and the iteration may leave {accepted}; give --tolerance");
        Self { verdict: Verdict::NotRun(why), ..self }
    }

    /// The sentence of what shall hold.
    pub fn requirement(&self) -> String {
        self.check.requirement(&self.reference)
    }

    /// Why it did not pass; none where it did.
    pub fn reason(&self) -> Option<String> {
        let Self { check, value, reference, error, verdict, .. } = self;
        Some(match verdict {
            Verdict::Pass => return None,
            Verdict::NotRun(why) => why.clone(),
            Verdict::Fail if value.is_nan() => "the value is not a number".into(),
            Verdict::Fail if reference.value.is_nan() => "the reference is not a number".into(),
            Verdict::Fail => {
                let (error, tolerance) = (markdown::error(*error), markdown::tolerance(check.tolerance));
                format!("the error {error} is not within the tolerance {tolerance}")
            }
        })
    }

    /// The error over the tolerance; 0 or infinite where nothing is tolerated, NaN where the error is no number.
    pub fn share_of_tolerance(&self) -> f64 {
        match self.error {
            error if error <= 0.0 => 0.0,
            error => error / self.check.tolerance,
        }
    }
}

/// `|E| ≤ k u_val` of the difference E with k = 2 (ASME V&V 20-2009, 1-5), for a quantity against a reference; what the
/// uncertainty is made of is said.
pub fn covered(of: &str, reference: Reference, comparison: Comparison, sources: &str) -> Judged {
    let Comparison { error, uncertainty } = comparison;
    let because = format!(
        "ASME V&V 20: difference {}, u_val = {} ({sources})",
        markdown::signed(error, 2),
        markdown::significant(uncertainty, 2)
    );
    let quantity = Quantity::at("difference over its standard uncertainty u_val", of);
    let reference = Reference { value: 0.0, uncertainty: None, ..reference };
    Check::error(quantity, reference, COVERAGE, because).judge(comparison.ratio())
}

/// The worst of some verdicts: a failure, else one that was not run, else a pass; none of nothing.
pub fn worst<'a>(judged: impl IntoIterator<Item = &'a Judged>) -> Option<&'a Verdict> {
    judged.into_iter().map(|judged| &judged.verdict).max_by_key(|verdict| verdict.mark())
}

/// Errors below are round-off, and shares of the tolerance that differ by less are alike: which of such runs is worst,
/// machines disagree.
const ROUND_OFF: f64 = 5e-10;
const ALIKE: f64 = 1e-6;

/// Case of a check that runs of several cases are asked for, in the record of checks.
pub const EVERY_RUN: &str = "every run";

/// What is asked, once each, with its runs, the worst first: checks that hold the same quantity to the same tolerance
/// of the same reference ask one thing of several runs; of a self-consistency the runs may have places, references and
/// tolerances of their own.
pub fn requirements<'a, T>(checks: impl IntoIterator<Item = (T, &'a Judged)>) -> Vec<Vec<(T, &'a Judged)>> {
    let mut all: Vec<Vec<(T, &Judged)>> = Vec::new();
    let mut known = BTreeMap::new();
    for (run, one) in checks {
        let Judged { check, reference, .. } = one;
        let is_shared = reference.kind == ReferenceKind::SelfConsistency;
        let numbers = [reference.value, check.tolerance].map(f64::to_bits);
        let own = (!is_shared).then(|| (check.quantity.place(), check.contact, numbers));
        let place = *known.entry((check.quantity.name(), &reference.name, own)).or_insert(all.len());
        match all.get_mut(place) {
            Some(runs) => runs.push((run, one)),
            None => all.push(vec![(run, one)]),
        }
    }
    for runs in &mut all {
        let share = |one: &Judged| match one.error < ROUND_OFF {
            true => 0.0,
            false => (one.share_of_tolerance() / ALIKE).round(),
        };
        let is_worse = |a: &Judged, b: &Judged| {
            let severity = a.verdict.mark().cmp(&b.verdict.mark());
            severity.then(share(a).total_cmp(&share(b)))
        };
        runs.sort_by(|(_, a), (_, b)| is_worse(b, a));
    }
    all
}

impl Verdict {
    /// The same without its words.
    pub fn mark(&self) -> Mark {
        match self {
            Self::Pass => Mark::Pass,
            Self::NotRun(_) => Mark::NotRun,
            Self::Fail => Mark::Fail,
        }
    }
}

impl Mark {
    /// Its sign and its word.
    pub fn told(self) -> [&'static str; 2] {
        match self {
            Self::Pass => ["✓", "pass"],
            Self::NotRun => ["○", "not run"],
            Self::Fail => ["✗", "FAIL"],
        }
    }
}

/// A sign and a word, or why it was not run.
impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [sign, word] = self.mark().told();
        write!(f, "{sign} {}", if let Self::NotRun(why) = self { why } else { word })
    }
}
