//! Requirement by requirement: what shall hold is stated once, and what was found stands below it, trial by trial.

use std::collections::BTreeMap;

use crate::case::{Judged, Quantity, Relation, Scope, Verdict, judged};
use crate::markdown;
use crate::oracle::ReferenceKind;
use crate::report::told;

/// Columns of what was found.
const COLUMNS: [&str; 7] = ["trial", "at", "found", "reference", "error", "bar", "verdict"];
/// Tables of more rows than this are folded.
const FOLDED: usize = 12;

/// Name of a trial with its checks.
pub type Named<'a> = (&'a str, &'a [Judged]);

/// A requirement with all that was held against it.
struct Requirement<'a> {
    sentence: String,
    kind: ReferenceKind,
    because: &'a str,
    rows: Vec<(Vec<&'a str>, [String; COLUMNS.len()])>,
    checks: usize,
    failed: bool,
}

/// The requirements of some trials with their checks; those that every run must meet are left to [`of_every_run`].
pub fn of(members: &[Named]) -> String {
    let named = members.iter().flat_map(|(name, judged)| judged.iter().map(move |one| (*name, one)));
    let own: Vec<(&str, &Judged)> = named.filter(|(_, one)| one.check.scope == Scope::Own).collect();
    if own.is_empty() {
        return String::new();
    }
    let (single, several): (Vec<_>, Vec<_>) = requirements(&own).into_iter().partition(|one| one.rows.len() == 1);
    let several: String = several.iter().map(|one| spread(one, members.len())).collect();
    format!("{}\n\n{}{several}", summary(&own), together(&single, members.len()))
}

fn summary(own: &[(&str, &Judged)]) -> String {
    match told::counts(own.iter().map(|(_, one)| *one)) {
        [passed, 0, 0] => format!("✓ {passed} checks passed"),
        [passed, 0, absent] => format!("○ {passed} checks passed, {absent} not run"),
        [_, failed, _] => format!("✗ {failed} of {} checks failed", own.len()),
    }
}

/// Each requirement once, in the order in which they come, with its rows; what is alike in several trials is one row.
fn requirements<'a>(own: &[(&'a str, &'a Judged)]) -> Vec<Requirement<'a>> {
    let mut all: Vec<Requirement> = Vec::new();
    for (name, one) in own {
        let (sentence, kind, because) = (one.requirement(), one.reference.kind, one.check.because.as_ref());
        let is_same = |other: &Requirement| (&other.sentence, other.kind, other.because) == (&sentence, kind, because);
        let index = all.iter().position(is_same).unwrap_or_else(|| {
            all.push(Requirement { sentence: sentence.clone(), kind, because, rows: Vec::new(), checks: 0, failed: false });
            all.len() - 1
        });
        let cells = cells(one);
        let requirement = &mut all[index];
        requirement.checks += 1;
        requirement.failed |= one.verdict == Verdict::Fail;
        match requirement.rows.iter_mut().find(|(names, other)| !names.contains(name) && *other == cells) {
            Some((names, _)) => names.push(name),
            None => requirement.rows.push((vec![name], cells)),
        }
    }
    all
}

/// Requirements of one row each, in one table.
fn together(single: &[Requirement], trials: usize) -> String {
    if single.is_empty() {
        return String::new();
    }
    let rows = single.iter().flat_map(|one| one.rows.iter().map(move |(names, cells)| {
        let shall = format!("{} ({}; {})", one.sentence, one.kind, one.because);
        std::iter::once(shall).chain(with_trials(names, cells, trials)).collect()
    }));
    let head = std::iter::once("what shall hold (kind; because)").chain(COLUMNS).map(String::from).collect();
    let (head, rows, told) = without_repeats(head, rows.collect(), single.len() > 1);
    let table = markdown::table(&head, &rows);
    let folded = rows.len() > FOLDED;
    let failed = single.iter().any(|one| one.failed);
    let table = if folded { markdown::folded(&format!("{} requirements", rows.len()), &table, failed) } else { table + "\n" };
    format!("{}{table}", if told.is_empty() { told } else { format!("In all rows: {told}.\n\n") })
}

/// A requirement of several rows: what is alike in all of them is told once.
fn spread(one: &Requirement, trials: usize) -> String {
    let rows = one.rows.iter().map(|(names, cells)| with_trials(names, cells, trials)).collect();
    let (head, rows, told) = without_repeats(COLUMNS.map(String::from).into(), rows, true);
    let table = markdown::table(&head, &rows);
    let table = if rows.len() > FOLDED { markdown::folded(&format!("{} rows", rows.len()), &table, one.failed) } else { table + "\n" };
    let told = if told.is_empty() { told } else { format!(" In all rows: {told}.") };
    format!("**{}** ({}; {}), {} checks.{told}\n\n{table}", one.sentence, one.kind, one.because, one.checks)
}

/// Cells with the names of the trials in front.
fn with_trials(names: &[&str], cells: &[String; COLUMNS.len()], trials: usize) -> Vec<String> {
    let told = match names {
        [_, _, ..] if names.len() == trials => format!("all {trials} trials"),
        _ => names.join(", "),
    };
    std::iter::once(told).chain(cells[1..].iter().cloned()).collect()
}

/// A table without its empty columns and, where that is wanted, without those that say the same in every row, but for the first; the latter are told.
fn without_repeats(head: Vec<String>, rows: Vec<Vec<String>>, lift: bool) -> (Vec<String>, Vec<Vec<String>>, String) {
    let same = |column: usize| rows.iter().all(|row| row[column] == rows[0][column]);
    let is_empty = |column: usize| same(column) && rows[0][column].is_empty();
    let lifted: Vec<usize> = (1..head.len()).filter(|&k| lift && same(k) && !is_empty(k)).collect();
    let kept = |k: &usize| !is_empty(*k) && !lifted.contains(k);
    let keep = |row: &[String]| (0..row.len()).filter(kept).map(|k| row[k].clone()).collect::<Vec<_>>();
    let named = |k: usize| if head[k] == COLUMNS[0] { rows[0][k].clone() } else { format!("{} {}", head[k], rows[0][k]) };
    let told: Vec<String> = lifted.iter().map(|&k| named(k)).collect();
    (keep(&head), rows.iter().map(|row| keep(row)).collect(), told.join(", "))
}

/// What was found by a check; the first cell is the trial's.
fn cells(one: &Judged) -> [String; COLUMNS.len()] {
    let found = match one.check.relation {
        Relation::Error => String::new(),
        _ => with_uncertainty(one.value, one.uncertainty),
    };
    let held = match one.reference.value.abs() > 0.0 {
        true => with_uncertainty(one.reference.value, one.reference.uncertainty),
        false => String::new(),
    };
    let error = match one.verdict {
        Verdict::NotRun(_) => "–".into(),
        _ => told::error(one),
    };
    let bar = one.bar_as_error().map_or_else(String::new, |bar| told::in_unit(one, bar));
    [String::new(), place(&one.check.quantity), found, held, error, bar, one.verdict.to_string()]
}

/// Where, or of how many, a number was found, and its unit.
fn place(quantity: &Quantity) -> String {
    let place = match quantity {
        Quantity::Pressure { at } => format!("s = {}", markdown::bound(*at)),
        Quantity::HoopStress { at } => format!("{:.0}°", at.to_degrees()),
        Quantity::Named { at, .. } => at.clone(),
        _ => String::new(),
    };
    match (quantity.unit(), place.is_empty()) {
        (None, _) => place,
        (Some(unit), true) => format!("[{unit}]"),
        (Some(unit), false) => format!("{place} [{unit}]"),
    }
}

/// A value, with its uncertainty where that is known and more than none.
fn with_uncertainty(value: f64, uncertainty: Option<f64>) -> String {
    match uncertainty.filter(|uncertainty| *uncertainty > 0.0) {
        Some(uncertainty) => format!("{} ± {}", markdown::value(value), markdown::significant(uncertainty, 2)),
        None => markdown::value(value),
    }
}

/// The universal requirements with their reasons: number of runs, worst error over its tolerance, verdict.
pub fn universal<'a>(judged: impl Iterator<Item = &'a Judged>) -> String {
    let head = ["every run", "runs", "worst error", "its tolerance", "verdict", "because"];
    worst_of_each(judged, &head)
}

/// The same without their reasons, which the page of all checks has.
pub fn of_every_run<'a>(judged: impl Iterator<Item = &'a Judged>) -> String {
    worst_of_each(judged, &["every run", "runs", "worst error", "its tolerance", "verdict"])
}

fn worst_of_each<'a>(judged: impl Iterator<Item = &'a Judged>, head: &[&str]) -> String {
    let mut rows: BTreeMap<String, Vec<&Judged>> = BTreeMap::new();
    for one in judged.filter(|one| one.check.scope == Scope::Universal) {
        rows.entry(one.check.quantity.to_string()).or_default().push(one);
    }
    if rows.is_empty() {
        return String::new();
    }
    let cells = |(quantity, all): (&String, &Vec<&Judged>)| universal_row(quantity, all).into_iter().take(head.len()).collect();
    let rows: Vec<Vec<String>> = rows.iter().map(cells).collect();
    markdown::table(&head.iter().map(|name| name.to_string()).collect::<Vec<_>>(), &rows)
}

/// What was not run has no error, and its number stands beside that of the runs.
fn universal_row(quantity: &str, all: &[&Judged]) -> [String; 6] {
    let (run, absent): (Vec<&Judged>, Vec<&Judged>) =
        all.iter().partition(|one| !matches!(one.verdict, Verdict::NotRun(_)));
    let worst = run.iter().max_by(|a, b| a.share_of_tolerance().total_cmp(&b.share_of_tolerance()));
    let [error, tolerance] = worst.map_or([f64::NAN; 2], |one| [one.error, one.check.tolerance]);
    let number = match absent.len() {
        0 => run.len().to_string(),
        absent => format!("{} and {absent} not run", run.len()),
    };
    [
        quantity.into(),
        number,
        if run.is_empty() { "–".into() } else { markdown::error(error) },
        if run.is_empty() { "–".into() } else { markdown::tolerance(tolerance) },
        judged::worst(run.iter().copied()).map_or("–".into(), Verdict::to_string),
        worst.map_or(String::new(), |one| one.check.because.to_string()),
    ]
}
