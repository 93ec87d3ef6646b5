//! What moved between two commits, for whoever reviews the change: what it means first, what it looks like last.
//!
//! * [`tree`] — committed results as texts by path; [`git`] — those of a commit.
//! * [`table`] — recorded tables and documents as cells, and their keyed difference.
//! * [`pairs`] — which check is which, renamed ones too; [`checks`] — their columns, and what a change in each means.
//! * [`recorded`] — runs, surveys and statements; [`timings`] — seconds; [`charts`].
//! * [`told`] — a heading with rows; [`words`] — changes in words; [`written`] — all of it as text or Markdown.

pub mod charts;
pub mod checks;
pub mod git;
pub mod pairs;
pub mod recorded;
pub mod table;
pub mod timings;
pub mod told;
pub mod tree;
pub mod words;
pub mod written;

use std::cmp::Reverse;
use std::collections::BTreeMap;

use crate::report::record::{self, CHECKS, CheckRow, RUNS, STATEMENTS};
use pairs::Pairs;
use recorded::Statement;
use told::Told;
use tree::{Moved, Tree};
use words::counted;

/// What moved from one tree to another.
#[derive(Clone, Debug)]
pub struct Difference {
    /// Names of both.
    pub names: [String; 2],
    /// What could not be compared, and why.
    pub notes: Vec<String>,
    /// What moved, the most important first.
    pub told: Vec<Told>,
    /// Whether a verdict got worse, or a new check fails.
    pub worse: bool,
    /// Whether a limit that no error bar explains got wider, or something is asked no longer, or of fewer runs.
    pub laxer: bool,
}

impl Difference {
    /// Compares two trees.
    pub fn of(before: &Tree, after: &Tree) -> Self {
        let (mut notes, trees) = (Vec::new(), [before, after]);
        let records: [Vec<CheckRow>; 2] =
            both(trees, CHECKS, "checks, verdicts, tolerances and bars", record::parsed, &mut notes);
        let runs = both(trees, RUNS, "runs of the suite", recorded::runs, &mut notes);
        let statements: [Vec<Statement>; 2] =
            both(trees, STATEMENTS, "statements of the paper", record::parsed, &mut notes);
        let pairs = Pairs::of(&records[0], &records[1]);
        let [mut surveys, mut timings, mut charts, mut others] = [const { Vec::<Moved>::new() }; 4];
        for one in tree::moved(trees) {
            let (path, texts) = one;
            let is_recorded = path.ends_with(".csv") || path.ends_with(".json");
            let is_frozen = texts.iter().flatten().any(|text| recorded::is_frozen_run(path, text));
            match path {
                CHECKS | RUNS | STATEMENTS => {}
                _ if is_frozen => {}
                _ if is_recorded && path.starts_with("snapshots/timings/") => timings.push(one),
                _ if is_recorded => surveys.push(one),
                _ if path.ends_with(".svg") => charts.push(one),
                _ => others.push(one),
            }
        }
        let frozen = trees.map(recorded::frozen);
        let mut told = checks::asked(&pairs);
        told.extend(recorded::statements(&statements));
        told.extend(checks::shares(&pairs));
        told.extend(checks::bars(&pairs));
        told.extend(recorded::of_runs("Runs of the suite", &runs));
        told.extend(recorded::of_runs("Snapshots of runs", &frozen));
        told.extend(recorded::surveys(&surveys));
        told.extend(charts::told(&charts));
        told.extend(pages(&others));
        told.extend(timings::told(&timings));
        told.extend(checks::stale(&pairs));
        Self {
            names: trees.map(|tree| tree.name.clone()),
            notes,
            told,
            worse: checks::worse(&pairs),
            laxer: checks::is_laxer(&pairs),
        }
    }
}

/// A record of both trees; nothing at all, and one note, where a tree has no such file or it cannot be read.
fn both<T: Default>(
    trees: [&Tree; 2],
    file: &str,
    what: &str,
    parsed: fn(&str) -> Result<T, String>,
    notes: &mut Vec<String>,
) -> [T; 2] {
    let read = |tree: &Tree| match tree.text(file) {
        None => Err(format!("{} has no {file}", tree.name)),
        Some(text) => parsed(text).map_err(|why| format!("{file} of {} cannot be read: {why}", tree.name)),
    };
    match trees.map(read) {
        [Ok(before), Ok(after)] => [before, after],
        [before, after] => {
            let whys: Vec<String> = [before.err(), after.err()].into_iter().flatten().collect();
            notes.push(format!("{}: {what} are not compared", whys.join(", ")));
            Default::default()
        }
    }
}

/// Generated pages and everything else that moved: how many lines, a row a file.
fn pages(moved: &[Moved]) -> Option<Told> {
    let row = |(path, texts): &Moved| {
        let mut lines: BTreeMap<&str, i64> = BTreeMap::new();
        for (text, step) in texts.iter().zip([-1, 1]) {
            text.unwrap_or_default().lines().for_each(|line| *lines.entry(line).or_default() += step);
        }
        let sum = |sign: i64| lines.values().map(|count| (sign * count).max(0)).sum::<i64>();
        let [added, removed] = [sum(1), sum(-1)];
        (added + removed, format!("{path}: {added} lines added, {removed} removed"))
    };
    let mut rows: Vec<(i64, String)> = moved.iter().map(row).collect();
    rows.sort_by_key(|(lines, _)| Reverse(*lines));
    let heading = format!("Pages and other files with other lines: {}", counted(rows.len(), "file"));
    (!rows.is_empty()).then(|| Told::new(heading, rows.into_iter().map(|(_, row)| row).collect()))
}
