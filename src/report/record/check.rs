//! A row per check: what was judged, with its numbers; of a self-consistency that every run is asked for, those of the worst.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::rounding::{ROUND_OFF, floored, four};
use crate::case::{Judged, Quantity, Relation, Verdict, judged};
use crate::study::{Finding, Room};

/// A verdict without its words, from good to bad.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Mark {
    /// The error is within the tolerance.
    Pass,
    /// There was no reference.
    NotRun,
    /// The error is not within the tolerance.
    Fail,
}

impl std::fmt::Display for Mark {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Pass => "pass",
            Self::NotRun => "not run",
            Self::Fail => "FAIL",
        })
    }
}

/// A check as the record has it; the first six columns are its key, and no two checks have the same.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct CheckRow {
    /// The study.
    pub study: String,
    /// The case.
    pub case: String,
    /// The trial, mostly a formulation.
    pub trial: String,
    /// Name of the quantity.
    pub quantity: String,
    /// Where, of what, in which contact, and which of several.
    pub place: String,
    /// Name of the reference.
    pub against: String,
    /// Kind of the reference.
    pub kind: String,
    /// How the value shall stand to the reference.
    pub relation: Relation,
    /// The value.
    pub value: f64,
    /// What it is held against.
    pub reference: f64,
    /// The error.
    pub error: f64,
    /// The largest error accepted.
    pub tolerance: f64,
    /// The error over the tolerance; of a bound, how much of it is used: 1 at the bound.
    pub share: f64,
    /// Error bar of the value in terms of the error, where it has one.
    pub bar: Option<f64>,
    /// Standard uncertainty of the value, where it is known.
    pub uncertainty: Option<f64>,
    /// The verdict.
    pub verdict: Mark,
    /// Why it was not run.
    pub why: String,
    /// How many runs are asked for it.
    #[serde(default = "one")]
    pub runs: usize,
    /// Where it is worst, of several.
    #[serde(default)]
    pub worst: String,
}

fn one() -> usize {
    1
}

/// Case of a check that several runs are asked for.
pub const EVERY_RUN: &str = "every run";

impl CheckRow {
    /// Columns of the key by name.
    pub const KEY: [&str; 6] = ["study", "case", "trial", "quantity", "place", "reference"];

    /// What the check is told by.
    pub fn key(&self) -> [&str; 6] {
        [&self.study, &self.case, &self.trial, &self.quantity, &self.place, &self.against]
    }

    fn of(finding: &Finding, judged: &Judged) -> Self {
        let Judged { check, reference, .. } = judged;
        let (verdict, why) = match &judged.verdict {
            Verdict::Pass => (Mark::Pass, String::new()),
            Verdict::Fail => (Mark::Fail, String::new()),
            Verdict::NotRun(why) => (Mark::NotRun, why.clone()),
        };
        // An error that fails is shown, however small it is.
        let shown = if verdict == Mark::Fail && judged.error < ROUND_OFF { four } else { floored };
        let error = shown(judged.error);
        Self {
            study: finding.room.name().into(),
            case: finding.case.clone(),
            trial: finding.name.clone(),
            quantity: check.quantity.name().into(),
            place: place(&check.quantity, check.contact),
            against: reference.name.clone(),
            kind: reference.kind.to_string(),
            relation: check.relation,
            value: if check.relation == Relation::Near { four(judged.value) } else { shown(judged.value) },
            reference: four(reference.value),
            error,
            tolerance: four(check.tolerance),
            share: four(share(judged, error)),
            bar: judged.bar_as_error().map(floored),
            uncertainty: judged.uncertainty.map(four),
            verdict,
            why,
            runs: 1,
            worst: String::new(),
        }
    }

    /// The worst of some runs, in place of them all.
    fn of_all(runs: &[(&Finding, &Judged)]) -> Self {
        let (finding, judged) = runs[0];
        let own = Self::of(finding, judged);
        if runs.len() == 1 {
            return own;
        }
        let places = [&own.trial, &own.place].into_iter().filter(|place| !place.is_empty());
        let at: Vec<&str> = places.map(String::as_str).collect();
        let worst = format!("{} × {}", own.case, at.join(", "));
        let [trial, place] = [String::new(), String::new()];
        Self { case: EVERY_RUN.into(), trial, place, runs: runs.len(), worst, ..own }
    }
}

/// Where the quantity is, without its name and unit; contacts count from 1, and the first is not named.
fn place(quantity: &Quantity, contact: usize) -> String {
    let of = (contact > 0).then(|| format!("contact {}", contact + 1));
    [quantity.place(), of].into_iter().flatten().collect::<Vec<_>>().join(", ")
}

/// The error over the tolerance; of a bound that is not 0, how much of it is used.
fn share(judged: &Judged, error: f64) -> f64 {
    let (value, bound) = (judged.value, judged.reference.value);
    match judged.check.relation {
        Relation::AtMost if bound > 0.0 => value / bound,
        Relation::AtLeast if bound > 0.0 => bound / value,
        _ if error <= 0.0 => 0.0,
        _ => error / judged.check.tolerance,
    }
}

/// The rows of all checks, sorted by their keys; checks that nothing else tells apart are numbered.
pub fn rows(findings: &[Finding]) -> Vec<CheckRow> {
    let of_room = |room: &Room| {
        let own = findings.iter().filter(|finding| finding.room == *room);
        judged::requirements(own.flat_map(|finding| finding.judged.iter().map(move |one| (finding, one))))
    };
    numbered(Room::ALL.iter().flat_map(of_room).map(|runs| CheckRow::of_all(&runs)).collect())
}

/// The same rows, sorted, no two with one key.
pub fn numbered(mut rows: Vec<CheckRow>) -> Vec<CheckRow> {
    let mut seen: BTreeMap<[String; 6], usize> = BTreeMap::new();
    for row in &mut rows {
        let count = seen.entry(row.key().map(String::from)).or_default();
        *count += 1;
        if *count > 1 {
            row.place = format!("{} #{count}", row.place).trim_start().into();
        }
    }
    rows.sort_by(|a, b| a.key().cmp(&b.key()));
    rows
}
