//! Runs, surveys and statements that moved.

use std::collections::BTreeSet;

use super::table::{self, Cells, Change, Difference};
use super::told::Told;
use super::tree::{self, Moved, Tree};
use super::words::{counted, factor, factors, some, tally};
use crate::report::grouped::{largest_first, sorted};

/// The column of how a run ends, and its key in a snapshot.
const OUTCOME: &str = "outcome";
/// Longest change that is repeated \[characters\].
const SHORT: usize = 60;
/// Columns that are told of a survey.
const COLUMNS: usize = 5;
/// What is shown of a value of a survey \[characters\].
const SHOWN: usize = 24;

/// The record of runs as cells: what was not counted has none.
pub fn runs(text: &str) -> Result<Cells, String> {
    let cells = table::keyed(text, 2, " × ")?.into_iter().filter(|(_, value)| !value.is_empty());
    Ok(cells.map(|([run, column], value)| ([run, column.replace('_', "-")], value)).collect())
}

/// Whether a path is that of a frozen run.
pub fn is_frozen_run(path: &str, text: &str) -> bool {
    path.ends_with(".snap") && text.contains(&format!("\n{OUTCOME}: "))
}

/// Frozen runs: lines `name: value` below the head.
pub fn frozen(tree: &Tree) -> Cells {
    let own = tree.files.iter().filter(|(path, text)| is_frozen_run(path, text));
    let cells = own.flat_map(|(path, text)| {
        let name = path.trim_start_matches("snapshots/").trim_end_matches(".snap").replace('@', " × ");
        let lines = text.splitn(3, "---\n").nth(2).unwrap_or_default().lines();
        lines.filter_map(move |line| {
            line.split_once(": ").map(|(key, value)| ([name.clone(), key.into()], value.into()))
        })
    });
    cells.collect()
}

/// How runs end, and the work they take: those that changed alike in one row.
pub fn of_runs(name: &str, versions: &[Cells; 2]) -> Option<Told> {
    let difference = Difference::of(versions);
    let is_kept = |one: &Change| difference.kept.contains(one.row);
    let known: BTreeSet<&str> = versions[0].keys().map(|[_, column]| column.as_str()).collect();
    // How a run ends comes before what it took, new columns come last.
    let rank = |column: &str| (column != OUTCOME, !known.contains(column));
    let columns = sorted(difference.columns(is_kept).map(|(column, one)| ((rank(column), column), one)));
    let told = columns.into_iter().flat_map(|((_, column), all)| column_of_runs(column, all));
    let mut rows: Vec<String> = told.collect();
    for (word, names) in ["gone", "new"].into_iter().zip(&difference.lost) {
        let told = || format!("{} {word}: {}", counted(names.len(), "run"), some(names.iter().copied()));
        rows.extend((!names.is_empty()).then(told));
    }
    let changed: BTreeSet<&str> = difference.columns(is_kept).map(|(_, one)| one.row).collect();
    let heading = format!("{name} that changed: {} of {}", changed.len(), difference.kept.len());
    (!rows.is_empty() && !versions[0].is_empty()).then(|| Told::new(heading, rows))
}

/// What changed in a column: numbers by their factors, fewer and more apart; words counted.
fn column_of_runs(column: &str, all: Vec<Change>) -> Vec<String> {
    let (numbers, words): (Vec<Change>, Vec<Change>) = all.into_iter().partition(|one| one.factor().is_some());
    let (fewer, more): (Vec<Change>, Vec<Change>) = numbers.into_iter().partition(|one| one.factor() < Some(1.0));
    [by_factor(column, &fewer), by_factor(column, &more), spelt(column, &words)].into_iter().flatten().collect()
}

/// `27 runs: back-substitutions halved`, or the span of factors with the run that changed most.
fn by_factor(column: &str, all: &[Change]) -> Option<String> {
    let ratios: Vec<f64> = all.iter().filter_map(Change::factor).collect();
    let size = |ratio: &f64| ratio.ln().abs();
    let (one, ratio) = all.iter().zip(&ratios).max_by(|(_, a), (_, b)| size(a).total_cmp(&size(b)))?;
    let (run, change) = (one.row, one.arrow());
    if all.len() == 1 {
        return Some(format!("{column} of {run}: {change} ({})", factor(*ratio)));
    }
    Some(format!("{}: {column} {}; most {run}: {change}", counted(all.len(), "run"), factors(&ratios)))
}

/// Changes that are no factors: the like ones counted, long ones not repeated.
fn spelt(column: &str, all: &[Change]) -> Option<String> {
    let runs = counted(all.len(), "run");
    let short = all.iter().all(|one| one.arrow().chars().count() < SHORT);
    match all {
        [] => None,
        [one] if short => Some(format!("{column} of {}: {}", one.row, one.arrow())),
        _ if short => Some(format!("{runs}: {column} {}", tally(all.iter().map(Change::arrow)))),
        _ => Some(format!("{runs}: {column} otherwise: {}", some(all.iter().map(|one| one.row)))),
    }
}

/// Recorded surveys, a row each.
pub fn surveys(moved: &[Moved]) -> Option<Told> {
    let rows: Vec<String> = moved.iter().map(survey).collect();
    (!rows.is_empty()).then(|| Told::new(format!("Recorded surveys that moved: {}", rows.len()), rows))
}

/// Rows of a survey that came and went, then the columns that moved.
pub fn survey((path, texts): &Moved) -> String {
    let [Some(before), Some(after)] = *texts else { return format!("{path}: {}", tree::came_or_went(texts)) };
    let Some(versions) = table::versions(path, [before, after]) else {
        return format!("{path}: moved; it cannot be compared row by row");
    };
    let difference = Difference::of(&versions);
    let lost = ["gone", "new"].into_iter().zip(&difference.lost).filter(|(_, rows)| !rows.is_empty());
    let mut told: Vec<String> = lost.map(|(word, rows)| format!("{} {word}", counted(rows.len(), "row"))).collect();
    let columns = largest_first(difference.columns(|one| one.values.iter().all(Option::is_some)));
    let shown = columns.iter().take(COLUMNS);
    told.extend(shown.map(|(column, all)| format!("{column} in {} ({})", all.len(), kind(all))));
    told.extend((columns.len() > COLUMNS).then(|| format!("{} other columns", columns.len() - COLUMNS)));
    let told = if told.is_empty() { "written otherwise, no value moved".into() } else { told.join(", ") };
    let rows = difference.kept.len() + difference.lost[1].len();
    format!("{path}: of {}: {told}", counted(rows, "row"))
}

/// Factors where all are numbers of one sign, else what became what.
fn kind(all: &[Change]) -> String {
    let short = |text: &str| text.chars().take(SHOWN).collect::<String>();
    let arrow = |one: &Change| one.values.map(|value| short(value.unwrap_or_default())).join(" → ");
    let ratios: Option<Vec<f64>> = all.iter().map(Change::factor).collect();
    ratios.map_or_else(|| tally(all.iter().map(arrow)), |ratios| factors(&ratios))
}

/// A statement of the paper, its judgement, and what was measured.
pub type Statement = [String; 3];

/// Changed judgements, then what went and came; a statement with another sentence and the same numbers was reworded.
pub fn statements([before, after]: &[Vec<Statement>; 2]) -> Option<Told> {
    let find = |rows: &[Statement], one: &Statement| rows.iter().position(|row| row[0] == one[0]);
    let mut rows = Vec::new();
    let mut gone: Vec<&Statement> = before.iter().filter(|one| find(after, one).is_none()).collect();
    for new in after {
        let [text, judgement, measured] = new;
        match find(before, new).map(|index| &before[index]) {
            Some(old) if old[1] != *judgement => rows.push(format!("“{text}”: {} → {judgement}", old[1])),
            Some(old) if old[2] != *measured => {
                rows.push(format!("“{text}”, still {judgement}: {} → {measured}", old[2]));
            }
            Some(_) => (),
            None => match gone.iter().position(|old| old[1..] == new[1..]) {
                Some(index) => rows.push(format!("reworded: “{}” → “{text}”", gone.remove(index)[0])),
                None => rows.push(format!("new: “{text}”: {judgement}")),
            },
        }
    }
    rows.extend(gone.iter().map(|[text, judgement, _]| format!("GONE: “{text}”: {judgement}")));
    (!rows.is_empty()).then(|| Told::new(format!("Statements of the paper: {}", counted(rows.len(), "change")), rows))
}
