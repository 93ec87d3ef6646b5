//! What moved between two commits, for whoever reviews the change: what it means first, what it looks like last.
//!
//! * [`tree`] — committed results as texts by path.
//! * [`checks`] — which check is which, and what a change in each of their columns means.
//! * [`table`] — whatever else is recorded: runs, statements, references, surveys, seconds; [`charts`].
//! * [`told`] — changes as rows under a heading.

pub mod charts;
pub mod checks;
pub mod table;
pub mod told;
pub mod tree;

use std::collections::BTreeMap;

use crate::markdown::folded;
use crate::report::record::{self, CHECKS, CheckRow, RUNS, STATEMENTS};
use checks::Pairs;
use table::Cells;
use told::{Change, Told};
use tree::{Moved, Tree};

/// What moved from one tree to another.
#[derive(Clone, Debug)]
pub struct Difference {
    /// Names of both.
    pub names: [String; 2],
    /// What could not be compared, and why.
    pub note: Option<String>,
    /// What moved, the most important first.
    pub told: Vec<Told>,
    /// Whether a verdict got worse, or a new check fails.
    pub worse: bool,
    /// Whether a limit that no error bar explains got wider, something is asked no longer, of fewer runs, or of this
    /// code where it was of a truth, or whether a record of checks cannot be read.
    pub laxer: bool,
}

/// Tables in the order in which they are told; other surveys come after them.
const TABLES: [&str; 4] = [STATEMENTS, RUNS, SNAPSHOTS, "snapshots/references.csv"];
/// The frozen runs, which are one table.
const SNAPSHOTS: &str = "snapshots of runs";
/// Folder of what depends on the machine, which is told last.
const TIMINGS: &str = "snapshots/timings/";
/// Lines that a difference has at most, where nothing else is asked for.
pub const LINES: usize = 40;

/// Rows of what is told first that come before any other.
const FIRST: usize = 8;
/// Longest row of a terminal \[characters\].
const WIDTH: usize = 220;

impl Difference {
    /// Compares two trees.
    pub fn of(before: &Tree, after: &Tree) -> Self {
        let trees = [before, after];
        let (records, note, is_unread) = checks_of(trees);
        let pairs = Pairs::of(&records[0], &records[1]);
        let mut told = checks::told(&pairs);
        let frozen = trees.map(table::frozen);
        let mut tables: Vec<(&str, [Cells; 2])> = Vec::new();
        tables.extend((frozen[0] != frozen[1]).then_some((SNAPSHOTS, frozen)));
        let (mut charts, mut others): (Vec<Moved>, Vec<Change>) = (Vec::new(), Vec::new());
        let is_told_as_table = |path: &str| {
            let stem = path.strip_suffix(".json");
            stem.is_some_and(|stem| after.text(&format!("{stem}.csv")).is_some())
        };
        for (path, texts) in tree::moved(trees) {
            match table::versions(path, texts).filter(|[old, new]| old != new) {
                _ if path == CHECKS && !told.is_empty() => {}
                _ if texts.iter().flatten().any(|text| table::is_frozen(path, text)) => {}
                Some(versions) if path != CHECKS && !is_told_as_table(path) => tables.push((path, versions)),
                None if path.ends_with(".svg") => charts.push((path, texts)),
                _ => others.push(lines(path, texts)),
            }
        }
        tables.sort_by_key(|(name, _)| TABLES.iter().position(|one| one == name).unwrap_or(TABLES.len()));
        let (timings, tables): (Vec<_>, Vec<_>) = tables.iter().partition(|(name, _)| name.starts_with(TIMINGS));
        told.extend(tables.into_iter().map(|(name, versions)| table::told(name, versions)));
        told.extend(charts::told(&charts));
        told.extend(Told::counted("Pages and files with other lines", "file", others));
        told.extend(timings.into_iter().map(|(name, versions)| table::told(name, versions)));
        told.extend(checks::stale(&pairs));
        let names = trees.map(|tree| tree.name.clone());
        Self { names, note, told, worse: checks::worse(&pairs), laxer: is_unread || checks::is_laxer(&pairs) }
    }

    /// Text of at most so many lines; every heading is among them, and the most important rows.
    pub fn text(&self, lines: usize) -> String {
        let short = |row: &str| match row.char_indices().nth(WIDTH) {
            Some((end, _)) => format!("{}…", &row[..end]),
            None => row.to_string(),
        };
        let told = self.shown(lines).into_iter().map(|(told, rows)| {
            let rows: String = told.rows.iter().take(rows).map(|row| format!("  {}\n", short(row))).collect();
            format!("{}\n{rows}", told.heading)
        });
        std::iter::once(self.head() + "\n").chain(told).collect()
    }

    /// The same as Markdown; charts are found at `addresses` followed by their paths.
    pub fn markdown(&self, lines: usize, addresses: &[String; 2]) -> String {
        let told = self.shown(lines).into_iter().map(|(told, rows)| {
            let more = told.rows.len() - rows;
            let rows: String = told.rows.iter().take(rows).map(|row| format!("* {}\n", escaped(row))).collect();
            let more = if more > 0 { format!("* … and {more} more rows\n") } else { String::new() };
            format!("**{}**\n\n{rows}{more}\n{}", escaped(&told.heading), charts(told, addresses))
        });
        std::iter::once(format!("### {}\n\n", escaped(&self.head()))).chain(told).collect()
    }

    /// What is said first, with everything that could not be compared: one line.
    fn head(&self) -> String {
        let [before, after] = &self.names;
        let verdict = match (&self.note, self.told.is_empty(), self.worse) {
            (Some(note), ..) => note,
            (None, true, _) => "nothing moved",
            (None, false, true) => "a verdict got WORSE",
            (None, false, false) => "no verdict got worse",
        };
        format!("{before} → {after}: {verdict}.")
    }

    /// What is told with the number of its rows that there is room for: a row each in turn, from the most important on.
    fn shown(&self, lines: usize) -> Vec<(&Told, usize)> {
        let mut shown: Vec<(&Told, usize)> = self.told.iter().map(|told| (told, 0)).collect();
        let mut room = lines.saturating_sub(1 + shown.len());
        if let Some((told, rows)) = shown.first_mut() {
            *rows = told.rows.len().min(FIRST).min(room);
            room -= *rows;
        }
        loop {
            let before = room;
            for (told, rows) in &mut shown {
                if room > 0 && *rows < told.rows.len() {
                    *rows += 1;
                    room -= 1;
                }
            }
            if room == before || room == 0 {
                return shown;
            }
        }
    }
}

/// The checks of both trees; none at all, and why, where a tree has no record or it cannot be read; and whether one
/// cannot be read, or went.
fn checks_of(trees: [&Tree; 2]) -> ([Vec<CheckRow>; 2], Option<String>, bool) {
    let read = |tree: &Tree| match tree.text(CHECKS) {
        None => Err(format!("{} has no {CHECKS}", tree.name)),
        // No two with one key, as they were written.
        Some(text) => record::parsed(text)
            .map(record::numbered)
            .map_err(|why| format!("{CHECKS} of {} cannot be read: {why}", tree.name)),
    };
    match trees.map(read) {
        [Ok(before), Ok(after)] => ([before, after], None, false),
        [before, after] => {
            let [had, has] = trees.map(|tree| tree.text(CHECKS).is_some());
            let is_unread = had || has && after.is_err();
            let whys: Vec<String> = [before.err(), after.err()].into_iter().flatten().collect();
            let note = format!("{}: checks, verdicts, tolerances and bars are not compared", whys.join(", "));
            (Default::default(), Some(note), is_unread)
        }
    }
}

/// How many lines of a file were added and removed, wherever they are.
fn lines(path: &str, texts: [Option<&str>; 2]) -> Change {
    let mut lines: BTreeMap<&str, i64> = BTreeMap::new();
    for (text, step) in texts.iter().zip([-1, 1]) {
        text.unwrap_or_default().lines().for_each(|line| *lines.entry(line).or_default() += step);
    }
    let [added, removed] = [1, -1].map(|sign| lines.values().map(|count| (sign * count).max(0)).sum::<i64>());
    let how = format!("{added} lines added, {removed} removed");
    Change { of: path.into(), size: (added + removed) as f64, how, ..Change::default() }
}

/// Charts side by side, folded.
fn charts(told: &Told, [before, after]: &[String; 2]) -> String {
    if told.charts.is_empty() {
        return String::new();
    }
    let image = |address: &str, path: &str| format!("![{path}]({address}{path})");
    let row = |path: &String| format!("| {} | {} |\n", image(before, path), image(after, path));
    let rows: String = told.charts.iter().map(row).collect();
    folded("before and after", &format!("| before | after |\n|---|---|\n{rows}"), false)
}

/// Text that Markdown takes as it is.
fn escaped(text: &str) -> String {
    text.replace('\\', "\\\\").replace('|', "\\|").replace('*', "\\*").replace('_', "\\_").replace('<', "&lt;")
}
