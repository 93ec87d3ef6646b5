//! Recorded tables and documents as cells, and what moved in them column by column.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use serde_json::Value;

use super::told::{Change, Told};
use super::tree::Tree;
use crate::study::grouped::joined;

/// Values by row and column; an empty one is none.
pub type Cells = BTreeMap<[String; 2], String>;

/// Digests of what a record was made of: another one moves no result.
const DIGEST: &str = "sources";
/// What names an entry of a list of a document.
const NAMES: [&str; 3] = ["name", "target", "mutant"];
/// Longest word that is counted \[characters\].
const WORD: usize = 30;
/// Columns of a number that has a spread or a bar: within these it has not moved.
const SPREAD: [&str; 4] = ["value", "median", "least", "most"];

/// Two versions of a recorded file, one of which may be missing; none where it cannot be read as what its name says.
pub fn versions(path: &str, texts: [Option<&str>; 2]) -> Option<[Cells; 2]> {
    match Path::new(path).extension()?.to_str()? {
        "json" => return both(texts.map(|text| text.map_or_else(|| Some(Cells::new()), document))),
        "csv" => {}
        _ => return None,
    }
    let tables = both(texts.map(|text| text.map_or_else(|| Some(Vec::new()), rows)))?;
    let width = tables.iter().filter_map(|rows| Some(rows.first()?.len())).min()?;
    // Rows are told apart by the fewest first columns that have no duplicate in either.
    let is_unique = |rows: &[Vec<String>], key: usize| {
        rows.iter().map(|row| &row[..key]).collect::<BTreeSet<_>>().len() == rows.len()
    };
    let key = (1..=width).find(|key| tables.iter().all(|rows| is_unique(rows, *key)))?;
    Some(tables.map(|rows| cells(&rows, key)))
}

fn both<T>([before, after]: [Option<T>; 2]) -> Option<[T; 2]> {
    Some([before?, after?])
}

fn rows(text: &str) -> Option<Vec<Vec<String>>> {
    let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(text.as_bytes());
    reader.deserialize().collect::<Result<_, _>>().ok()
}

fn cells(rows: &[Vec<String>], key: usize) -> Cells {
    let of_row = |row: &Vec<String>| {
        let columns = rows[0].iter().zip(row).skip(key).filter(|(_, value)| !value.is_empty());
        columns.map(|(column, value)| ([row[..key].join(" × "), column.clone()], value.clone())).collect::<Vec<_>>()
    };
    rows.iter().skip(1).flat_map(of_row).collect()
}

/// Whether a file is the snapshot of a run.
pub fn is_frozen(path: &str, text: &str) -> bool {
    path.ends_with(".snap") && text.contains("\noutcome: ")
}

/// All snapshots of runs as one table: lines `column: value` below their heads.
pub fn frozen(tree: &Tree) -> Cells {
    let of_run = |(path, text): (&String, &String)| {
        let run = path.trim_start_matches("snapshots/").trim_end_matches(".snap").replace('@', " × ");
        let lines = text.splitn(3, "---\n").nth(2).unwrap_or_default().lines();
        let cells = lines.filter_map(|line| line.split_once(": "));
        cells.map(|(column, value)| ([run.clone(), column.into()], value.into())).collect::<Cells>()
    };
    tree.files.iter().filter(|(path, text)| is_frozen(path, text)).flat_map(of_run).collect()
}

/// Every number and text of a document by where it is and its key, without digests.
fn document(text: &str) -> Option<Cells> {
    let value: Value = serde_json::from_str(text).ok()?;
    let mut cells = Cells::new();
    flatten(&value, [String::new(), String::new()], &mut cells);
    Some(cells)
}

fn flatten(value: &Value, [row, column]: [String; 2], cells: &mut Cells) {
    let within = if row.is_empty() { column.clone() } else { format!("{row} › {column}") };
    match value {
        Value::Object(members) => {
            for (key, child) in members.iter().filter(|(key, _)| *key != DIGEST) {
                flatten(child, [within.clone(), key.clone()], cells);
            }
        }
        Value::Array(entries) => {
            for (index, entry) in entries.iter().enumerate() {
                let name = NAMES.iter().find_map(|name| entry.get(name)?.as_str());
                flatten(entry, [within.clone(), name.map_or_else(|| index.to_string(), String::from)], cells);
            }
        }
        leaf => {
            cells.insert([row, column], leaf.as_str().map_or_else(|| leaf.to_string(), String::from));
        }
    }
}

/// Rows that changed, went and came, column by column; numbers that stay within what they may be off are counted alone.
pub fn told(name: &str, versions: &[Cells; 2]) -> Told {
    let [old, new] = versions.each_ref().map(|cells| cells.keys().map(|[row, _]| row).collect::<BTreeSet<_>>());
    let lost = |one: &BTreeSet<&String>, other: &BTreeSet<&String>, of: &str| {
        let change = |row: &&String| Change { of: of.into(), at: (*row).clone(), ..Change::default() };
        (one - other).iter().map(change).collect::<Vec<_>>()
    };
    let [gone, came] = [lost(&old, &new, "gone"), lost(&new, &old, "new")];
    let is_kept = |row: &String| old.contains(row) && new.contains(row);
    let moved = joined(versions.each_ref()).into_iter().filter(|([row, _], [old, new])| old != new && is_kept(row));
    let (within, beyond): (Vec<_>, Vec<_>) = moved.partition(|(key, _)| is_within_spread(versions, key));
    let changed: BTreeSet<&String> = beyond.iter().map(|([row, _], _)| row).collect();
    let apart = [("gone", gone.len()), ("new", came.len()), ("within error bars or spreads", within.len())];
    let apart: String = apart.iter().filter(|(_, n)| *n > 0).map(|(what, n)| format!(", {n} {what}")).collect();
    let heading = format!("{name}: {} of {} rows changed{apart}", changed.len(), old.intersection(&new).count());
    Told::new(heading, "row", beyond.into_iter().map(|(key, values)| change(key, values)).chain(gone).chain(came))
}

/// Whether a number and what it was differ by less than both may be off: their bars, or the least and the most that
/// were measured, overlap.
fn is_within_spread(versions: &[Cells; 2], [row, column]: &[String; 2]) -> bool {
    let span = |cells: &Cells| {
        let number = |column: &str| cells.get(&[row.clone(), column.into()])?.parse::<f64>().ok();
        let about = |bar: f64| Some([number("value")? - bar, number("value")? + bar]);
        number("bar").and_then(about).or_else(|| Some([number("least")?, number("most")?]))
    };
    let overlap = || both(versions.each_ref().map(span)).is_some_and(|[old, new]| old[0] <= new[1] && new[0] <= old[1]);
    SPREAD.contains(&column.as_str()) && overlap()
}

/// A cell before and after: numbers by their factor, short words that changed alike together.
///
/// How a run ends comes before what it took, new columns come last.
fn change([row, column]: &[String; 2], values: [Option<&String>; 2]) -> Change {
    let size = if values.contains(&None) { 0.0 } else { f64::INFINITY };
    let shown = values.map(|value| value.map_or("–".into(), String::clone));
    if let Some(numbers) = both(values.map(|value| value?.parse::<f64>().ok())) {
        return Change::number(column.clone(), row.clone(), numbers, shown);
    }
    let is_short = shown.iter().all(|value| value.chars().count() <= WORD);
    let arrow = shown.join(" → ");
    let (of, how) = if is_short { (format!("{column}: {arrow}"), String::new()) } else { (column.clone(), arrow) };
    Change { of, at: row.clone(), size, how, ..Change::default() }
}
