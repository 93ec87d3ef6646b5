//! Requirement by requirement: each check with its oracle, error, tolerance and reason.

use std::collections::BTreeMap;

use crate::case::{Judged, Relation, Scope, Verdict, judged};
use crate::markdown;

/// Column of the error bar, which only tables with one have.
const BAR: usize = 6;

/// Name of a trial with its checks.
pub type Named<'a> = (&'a str, &'a [Judged]);

/// The requirements of some trials, each once, and the table of their checks; requirements that every run must meet are
/// left to [`universal`].
pub fn of(members: &[Named]) -> String {
    let own: Vec<(&str, &Judged)> = members
        .iter()
        .flat_map(|(name, judged)| judged.iter().map(move |one| (*name, one)))
        .filter(|(_, one)| one.check.scope == Scope::Own)
        .collect();
    if own.is_empty() {
        return String::new();
    }
    let mut sentences: Vec<String> = Vec::new();
    for sentence in own.iter().map(|(_, one)| one.requirement()) {
        if !sentences.contains(&sentence) {
            sentences.push(sentence);
        }
    }
    let sentences: String = sentences.iter().map(|sentence| format!("* {sentence}.\n")).collect();
    format!("{sentences}\n{}", rows(&own))
}

fn rows(own: &[(&str, &Judged)]) -> String {
    let has_bars = own.iter().any(|(_, one)| one.bar.is_some());
    let head = ["trial", "quantity", "found", "reference", "kind", "error", "bar", "tolerance", "because", "verdict"];
    let shown = |row: Vec<String>| row.into_iter().enumerate().filter(|(k, _)| has_bars || *k != BAR);
    let cells = |row: Vec<String>| shown(row).map(|(_, cell)| cell).collect::<Vec<_>>();
    let count = |wanted: fn(&Verdict) -> bool| own.iter().filter(|(_, one)| wanted(&one.verdict)).count();
    let passed = count(|verdict| *verdict == Verdict::Pass);
    let summary = match (count(|verdict| *verdict == Verdict::Fail), own.len() - passed) {
        (0, 0) => format!("✓ {passed} checks passed"),
        (0, absent) => format!("○ {passed} checks passed, {absent} not run"),
        (failed, _) => format!("✗ {failed} of {} checks failed", own.len()),
    };
    let rows: Vec<Vec<String>> = own.iter().map(|(name, one)| cells(row(name, one))).collect();
    let head = cells(head.map(String::from).into());
    markdown::folded(&summary, &markdown::table(&head, &rows), passed < own.len())
}

fn row(name: &str, judged: &Judged) -> Vec<String> {
    let Judged { check, reference, .. } = judged;
    let found = match check.relation {
        Relation::Error => String::new(),
        _ => with_uncertainty(judged.value, judged.uncertainty),
    };
    let held = match reference.value.abs() > 0.0 {
        true => format!(" {}", with_uncertainty(reference.value, reference.uncertainty)),
        false => String::new(),
    };
    let error = match judged.verdict {
        Verdict::NotRun(_) => "–".into(),
        _ => markdown::error(judged.error),
    };
    let tolerance = if check.tolerance > 0.0 { markdown::tolerance(check.tolerance) } else { "–".into() };
    vec![
        name.into(),
        check.quantity.to_string(),
        found,
        reference.name.clone() + &held,
        reference.kind.to_string(),
        error,
        judged.bar_as_error().map_or_else(|| "–".into(), markdown::error),
        tolerance,
        check.because.to_string(),
        judged.verdict.to_string(),
    ]
}

/// A value, with its uncertainty where that is known and more than none.
fn with_uncertainty(value: f64, uncertainty: Option<f64>) -> String {
    match uncertainty.filter(|uncertainty| *uncertainty > 0.0) {
        Some(uncertainty) => format!("{} ± {}", markdown::value(value), markdown::significant(uncertainty, 2)),
        None => markdown::value(value),
    }
}

/// The universal requirements: number of runs, worst error over its tolerance, verdict.
pub fn universal<'a>(judged: impl Iterator<Item = &'a Judged>) -> String {
    let mut rows: BTreeMap<String, Vec<&Judged>> = BTreeMap::new();
    for one in judged.filter(|one| one.check.scope == Scope::Universal) {
        rows.entry(one.check.quantity.to_string()).or_default().push(one);
    }
    let head = ["every run", "runs", "worst error", "its tolerance", "because", "verdict"].map(String::from);
    let rows: Vec<Vec<String>> = rows.iter().map(|(quantity, all)| universal_row(quantity, all)).collect();
    markdown::table(&head, &rows)
}

/// What was not run has no error, and its number stands beside that of the runs.
fn universal_row(quantity: &str, all: &[&Judged]) -> Vec<String> {
    let (run, absent): (Vec<&Judged>, Vec<&Judged>) =
        all.iter().partition(|one| !matches!(one.verdict, Verdict::NotRun(_)));
    let worst = run.iter().max_by(|a, b| a.share_of_tolerance().total_cmp(&b.share_of_tolerance()));
    let [error, tolerance] = worst.map_or([f64::NAN; 2], |one| [one.error, one.check.tolerance]);
    let number = match absent.len() {
        0 => run.len().to_string(),
        absent => format!("{} and {absent} not run", run.len()),
    };
    vec![
        quantity.into(),
        number,
        markdown::error(error),
        markdown::tolerance(tolerance),
        worst.map_or(String::new(), |one| one.check.because.to_string()),
        judged::worst(run).map_or("–".into(), Verdict::to_string),
    ]
}
