//! The record: what was judged, counted and stated, as tables that two commits can be compared by.
//!
//! Rows are sorted by their keys; numbers have four significant digits, and what is round-off is 0, so that every
//! machine writes the same bytes.

use std::collections::BTreeMap;
use std::path::Path;

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

pub use crate::case::judged::{EVERY_RUN, Mark};
use crate::case::{Judged, Quantity, Relation, Verdict, judged};
use crate::error::Error;
use crate::markdown::Column;
use crate::oracle::ReferenceKind;
use crate::report::matrix;
use crate::report::{statements, study_page};
use crate::solve::Run;
use crate::study::paper::statement::Statement;
use crate::study::records::rounded;
use crate::study::{Finding, Room};

/// The record of checks.
pub const CHECKS: &str = "snapshots/checks.csv";
/// The record of runs.
pub const RUNS: &str = "snapshots/runs.csv";
/// The record of statements.
pub const STATEMENTS: &str = "snapshots/statements.csv";

/// Errors are written in steps of this: below half of it they are round-off, which differs from machine to machine, and
/// 0.
pub const ROUND_OFF: f64 = 1e-9;

/// The record as files: their paths below the project folder, and their texts.
pub fn files(findings: &[Finding]) -> Result<Vec<(String, String)>, Error> {
    let ran = findings.iter().filter(|finding| matrix::run(finding).is_some());
    let statements = statements::judge(findings);
    let mut runs = cells(&RUN, ran);
    runs[1..].sort();
    Ok(vec![
        (CHECKS.into(), text(Path::new(CHECKS), &rows(findings))?),
        (RUNS.into(), text(Path::new(RUNS), &runs)?),
        (STATEMENTS.into(), text(Path::new(STATEMENTS), &cells(&STATEMENT, &statements))?),
    ])
}

/// Rows as a table, a line each; records below the names of their fields.
pub fn text<T: Serialize>(file: &Path, rows: &[T]) -> Result<String, Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in rows {
        writer.serialize(row).map_err(|error| Error::unwritable(file, error))?;
    }
    let bytes = writer.into_inner().map_err(|error| Error::unwritable(file, error))?;
    String::from_utf8(bytes).map_err(|error| Error::unwritable(file, error))
}

/// Rows of a table; what is wrong with it where it cannot be read.
pub fn parsed<T: DeserializeOwned>(text: &str) -> Result<Vec<T>, String> {
    csv::Reader::from_reader(text.as_bytes()).deserialize().collect::<Result<_, _>>().map_err(|error| error.to_string())
}

/// The names of columns, and below them a row each.
pub fn cells<'a, T: 'a>(columns: &[Column<T>], rows: impl IntoIterator<Item = &'a T>) -> Vec<Vec<String>> {
    let head = columns.iter().map(|(name, _)| (*name).to_owned()).collect();
    let rows = rows.into_iter().map(|row| columns.iter().map(|(_, cell)| cell(row)).collect());
    std::iter::once(head).chain(rows).collect()
}

/// A statement of the paper, in the order of the page.
const STATEMENT: [Column<Statement>; 3] = [
    ("statement", |one| one.text.into()),
    ("judgement", |one| one.judgement.to_string()),
    ("measured", |one| one.measured.clone()),
];

/// The run of a case: how it ended and, where it converged, the work it took.
const RUN: [Column<Finding>; 9] = [
    ("case", |finding| finding.case.clone()),
    ("trial", |finding| finding.name.clone()),
    ("outcome", |finding| of_run(finding, |run| run.solution.outcome.to_string())),
    ("iterations", |finding| counted(finding, |run| run.solution.work.iterations)),
    ("factorisations", |finding| counted(finding, |run| run.solution.work.factorisations)),
    // Terms of rank one by which a factor was updated instead.
    ("updates", |finding| counted(finding, |run| run.solution.work.updates)),
    ("back_substitutions", |finding| counted(finding, |run| run.solution.work.back_substitutions)),
    ("dofs", |finding| of_run(finding, |run| run.dofs.to_string())),
    ("retained", |finding| of_run(finding, |run| run.retained.to_string())),
];

fn of_run(finding: &Finding, of: fn(&Run) -> String) -> String {
    matrix::run(finding).map(of).unwrap_or_default()
}

/// Work of a run that converged.
fn counted(finding: &Finding, of: fn(&Run) -> usize) -> String {
    let run = matrix::run(finding).filter(|run| run.solution.converged());
    run.map(|run| of(run).to_string()).unwrap_or_default()
}

/// A check as the record has it, of one that several runs are asked for that of the worst; the first six columns are
/// its key, and no two checks have the same.
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
    pub kind: ReferenceKind,
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

impl CheckRow {
    /// What the check is told by.
    pub fn key(&self) -> [&str; 6] {
        [&self.study, &self.case, &self.trial, &self.quantity, &self.place, &self.against]
    }

    fn of(finding: &Finding, judged: &Judged) -> Self {
        let Judged { check, reference, .. } = judged;
        let verdict = judged.verdict.mark();
        // An error that fails is shown, however small it is.
        let shown = if verdict == Mark::Fail && judged.error < ROUND_OFF { four } else { floored };
        let error = shown(judged.error);
        Self {
            study: finding.study.into(),
            case: finding.case.clone(),
            trial: finding.name.clone(),
            quantity: check.quantity.name().into(),
            place: place(&check.quantity, check.contact),
            against: reference.name.clone(),
            kind: reference.kind,
            relation: check.relation,
            value: if check.relation == Relation::Near { four(judged.value) } else { shown(judged.value) },
            reference: four(reference.value),
            error,
            tolerance: four(check.tolerance),
            share: four(share(judged, error)),
            bar: judged.bar_as_error().map(floored),
            uncertainty: judged.uncertainty.map(four),
            verdict,
            why: if let Verdict::NotRun(why) = &judged.verdict { why.clone() } else { String::new() },
            runs: check.number,
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
        // Checks against a truth have one place.
        let is_there = runs.iter().all(|(_, one)| place(&one.check.quantity, one.check.contact) == own.place);
        let of_case = runs.iter().all(|(one, _)| one.case == finding.case);
        let at = [&own.trial, &own.place].into_iter().filter(|at| !at.is_empty()).map(String::as_str);
        let worst = format!("{} × {}", own.case, at.collect::<Vec<_>>().join(", "));
        let case = if of_case { own.case.clone() } else { EVERY_RUN.into() };
        let place = if is_there { own.place.clone() } else { String::new() };
        Self {
            case,
            trial: String::new(),
            place,
            runs: runs.iter().map(|(_, one)| one.check.number).sum(),
            worst,
            ..own
        }
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
        let own = study_page::of(room.name, findings);
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

/// Four significant digits, and nothing finer than round-off.
pub fn floored(number: f64) -> f64 {
    // Above, four digits are coarser than the step.
    let steps = number / ROUND_OFF;
    let coarse = if number.abs() < 1e3 * ROUND_OFF { steps.round() * ROUND_OFF } else { number };
    // Minus nothing is nothing.
    four(coarse) + 0.0
}

/// Four significant digits.
fn four(number: f64) -> f64 {
    if number.is_finite() { rounded(number) } else { number }
}
