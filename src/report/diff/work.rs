//! Runs: how they end, the work they take, what is frozen of them; those that changed alike in one row.

use std::collections::BTreeMap;

use super::told::Told;
use super::tree::Tree;
use super::words::{counted, factor, factors, some, tally};
use crate::report::record::RunRow;

/// A run by its name, and what is known of it by the names of the columns.
type Runs = BTreeMap<String, BTreeMap<String, String>>;

/// The column of how a run ends, and its key in a snapshot.
const OUTCOME: &str = "outcome";

/// What changed in the recorded runs, and in the snapshots.
pub fn told(rows: [&[RunRow]; 2], trees: [&Tree; 2]) -> Vec<Told> {
    let recorded = of("Runs of the suite", &rows.map(recorded));
    let frozen = of("Snapshots of runs", &trees.map(frozen));
    [recorded, frozen].into_iter().flatten().collect()
}

fn recorded(rows: &[RunRow]) -> Runs {
    let columns = |row: &RunRow| {
        let count = |count: Option<usize>| count.map_or_else(|| "–".into(), |count| count.to_string());
        [
            (OUTCOME, row.outcome.clone()),
            ("iterations", count(row.iterations)),
            ("factorisations", count(row.factorisations)),
            ("updates", count(row.updates)),
            ("back-substitutions", count(row.back_substitutions)),
            ("dofs", row.dofs.to_string()),
            ("retained", row.retained.to_string()),
        ]
        .map(|(name, value)| (name.to_string(), value))
        .into()
    };
    rows.iter().map(|row| (format!("{} × {}", row.case, row.trial), columns(row))).collect()
}

/// Whether a path is that of a frozen run.
pub fn is_frozen_run(path: &str, text: &str) -> bool {
    path.ends_with(".snap") && text.contains(&format!("\n{OUTCOME}: "))
}

/// Frozen runs: lines `name: value` below the head.
fn frozen(tree: &Tree) -> Runs {
    let own = tree.files.iter().filter(|(path, text)| is_frozen_run(path, text));
    let run = |(path, text): (&String, &String)| {
        let name = path.trim_start_matches("snapshots/").trim_end_matches(".snap").replace('@', " × ");
        let body = text.splitn(3, "---\n").nth(2).unwrap_or_default();
        let lines = body.lines().filter_map(|line| line.split_once(": "));
        (name, lines.map(|(key, value)| (key.to_string(), value.to_string())).collect())
    };
    own.map(run).collect()
}

fn of(name: &str, [before, after]: &[Runs; 2]) -> Option<Told> {
    let both: Vec<(&str, [&BTreeMap<String, String>; 2])> =
        before.iter().filter_map(|(run, old)| Some((run.as_str(), [old, after.get(run)?]))).collect();
    let columns: Vec<&String> = ordered(&both);
    let mut rows: Vec<String> = columns.into_iter().flat_map(|column| changes(column, &both)).collect();
    let changed = both.iter().filter(|(_, [old, new])| old != new).count();
    let lacking =
        |one: &Runs, other: &Runs| one.keys().filter(|run| !other.contains_key(*run)).cloned().collect::<Vec<_>>();
    for (word, names) in [("gone", lacking(before, after)), ("new", lacking(after, before))] {
        if !names.is_empty() {
            let names: Vec<&str> = names.iter().map(String::as_str).collect();
            rows.push(format!("{} {word}: {}", counted(names.len(), "run"), some(&names)));
        }
    }
    let heading = format!("{name} that changed: {changed} of {}", both.len());
    (!rows.is_empty() && !before.is_empty()).then(|| Told::new(heading, rows))
}

/// Names of columns, the outcome first, the others as they are met.
fn ordered<'a>(both: &[(&str, [&'a BTreeMap<String, String>; 2])]) -> Vec<&'a String> {
    let mut columns: Vec<&String> = Vec::new();
    for column in both.iter().flat_map(|(_, sides)| sides.iter().flat_map(|side| side.keys())) {
        if !columns.contains(&column) {
            columns.push(column);
        }
    }
    // How a run ends comes before what it took.
    columns.sort_by_key(|column| *column != OUTCOME);
    columns
}

/// What changed in a column: numbers by their factors, fewer and more apart; words counted.
fn changes(column: &str, both: &[(&str, [&BTreeMap<String, String>; 2])]) -> Vec<String> {
    let [mut fewer, mut more]: [Vec<(f64, &str, String)>; 2] = Default::default();
    let mut words: Vec<(&str, String)> = Vec::new();
    for (run, sides) in both {
        let [old, new] = sides.map(|side| side.get(column).map_or("–", String::as_str));
        let ratio = |old: &str, new: &str| Some(new.parse::<f64>().ok()? / old.parse::<f64>().ok()?);
        match ratio(old, new).filter(|ratio| ratio.is_finite() && *ratio > 0.0) {
            _ if old == new => (),
            Some(ratio) if ratio < 1.0 => fewer.push((ratio, run, format!("{old} → {new}"))),
            Some(ratio) => more.push((ratio, run, format!("{old} → {new}"))),
            None => words.push((run, format!("{old} → {new}"))),
        }
    }
    let numbers = [fewer, more].into_iter().filter_map(|all| numbers(column, all));
    numbers.chain(spelt(column, &words)).collect()
}

/// `27 runs: back-substitutions halved`, or the span of factors with the run that changed most.
fn numbers(column: &str, all: Vec<(f64, &str, String)>) -> Option<String> {
    let (most, run, change) = all.iter().max_by(|a, b| a.0.ln().abs().total_cmp(&b.0.ln().abs()))?;
    let ratios: Vec<f64> = all.iter().map(|(ratio, ..)| *ratio).collect();
    if all.len() == 1 {
        return Some(format!("{column} of {run}: {change} ({})", factor(*most)));
    }
    Some(format!("{}: {column} {}; most {run}: {change}", counted(all.len(), "run"), factors(&ratios)))
}

/// Changes that are no factors: the like ones counted, long ones not repeated.
fn spelt(column: &str, words: &[(&str, String)]) -> Option<String> {
    let short = words.iter().all(|(_, change)| change.chars().count() < 60);
    match words {
        [] => None,
        [(run, change)] if short => Some(format!("{column} of {run}: {change}")),
        _ if short => {
            Some(format!("{}: {column} {}", counted(words.len(), "run"), tally(words.iter().map(|w| w.1.clone()))))
        }
        _ => Some(format!(
            "{}: {column} otherwise: {}",
            counted(words.len(), "run"),
            some(&words.iter().map(|w| w.0).collect::<Vec<_>>())
        )),
    }
}
