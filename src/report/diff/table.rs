//! Recorded tables and documents as cells, and their keyed difference: which rows came and went, which values moved in which column.

use std::collections::{BTreeMap, BTreeSet};

use serde_json::Value;

/// Values by row and column.
pub type Cells = BTreeMap<[String; 2], String>;

/// A value that differs, came, or went.
#[derive(Clone, Copy, Debug)]
pub struct Change<'a> {
    /// The row's key.
    pub row: &'a str,
    /// The column.
    pub column: &'a str,
    /// The value before and after; none where there is no such cell.
    pub values: [Option<&'a str>; 2],
}

impl Change<'_> {
    /// `before → after`.
    pub fn arrow(&self) -> String {
        self.values.map(|value| value.unwrap_or("–")).join(" → ")
    }

    /// The value after over that before; none where they are no numbers of one sign.
    pub fn factor(&self) -> Option<f64> {
        let [before, after] = self.values.map(|value| value?.parse::<f64>().ok());
        Some(after? / before?).filter(|factor| factor.is_finite() && *factor > 0.0)
    }
}

/// What became of a table.
#[derive(Clone, Debug)]
pub struct Difference<'a> {
    /// Rows of both versions.
    pub kept: BTreeSet<&'a str>,
    /// Rows before only, and rows after only.
    pub lost: [BTreeSet<&'a str>; 2],
    /// All cells that differ, row by row.
    pub changes: Vec<Change<'a>>,
}

impl<'a> Difference<'a> {
    /// Compares two versions.
    pub fn of([before, after]: &'a [Cells; 2]) -> Self {
        let rows = |cells: &'a Cells| cells.keys().map(|[row, _]| row.as_str()).collect::<BTreeSet<&str>>();
        let [old, new] = [rows(before), rows(after)];
        let keys: BTreeSet<&[String; 2]> = before.keys().chain(after.keys()).collect();
        let change = |key: &'a [String; 2]| Change {
            row: &key[0],
            column: &key[1],
            values: [before, after].map(|cells| cells.get(key).map(String::as_str)),
        };
        let changes = keys.into_iter().map(change).filter(|one| one.values[0] != one.values[1]);
        Self { kept: &old & &new, lost: [&old - &new, &new - &old], changes: changes.collect() }
    }

    /// Changes that are of interest, with their columns.
    pub fn columns(&self, is_one: impl Fn(&Change) -> bool) -> impl Iterator<Item = (&'a str, Change<'a>)> {
        self.changes.iter().filter(move |one| is_one(one)).map(|one| (one.column, *one))
    }
}

/// Digests of what a record was made of: another one moves no result.
const DIGEST: &str = "sources";
/// What names an entry of a list of a document.
const NAMES: [&str; 3] = ["name", "target", "mutant"];

/// Two versions of a recorded file; none where either cannot be read as what its name says.
pub fn versions(path: &str, texts: [&str; 2]) -> Option<[Cells; 2]> {
    if !path.ends_with(".csv") {
        let [before, after] = texts.map(document);
        return Some([before?, after?]);
    }
    let [before, after] = texts.map(|text| rows(text).ok().filter(|rows| !rows.is_empty()));
    let both = [before?, after?];
    // Rows are told apart by the fewest first columns that have no duplicate in either.
    let width = both[0][0].len().min(both[1][0].len());
    let key = (1..=width).find(|key| both.iter().all(|rows| is_unique(rows, *key)))?;
    Some(both.map(|rows| cells(&rows, key, ", ")))
}

/// A table whose first columns are its key, joined by a text; what is wrong with it where it cannot be read.
pub fn keyed(text: &str, key: usize, joint: &str) -> Result<Cells, String> {
    Ok(cells(&rows(text)?, key, joint))
}

fn rows(text: &str) -> Result<Vec<Vec<String>>, String> {
    let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(text.as_bytes());
    reader.deserialize().collect::<Result<_, _>>().map_err(|error| error.to_string())
}

fn is_unique(rows: &[Vec<String>], key: usize) -> bool {
    rows.iter().map(|row| &row[..key]).collect::<BTreeSet<_>>().len() == rows.len()
}

fn cells(rows: &[Vec<String>], key: usize, joint: &str) -> Cells {
    let mut cells = Cells::new();
    for row in rows.iter().skip(1) {
        let name = row[..key].join(joint);
        for (column, value) in rows[0].iter().zip(row).skip(key) {
            cells.insert([name.clone(), column.clone()], value.clone());
        }
    }
    cells
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
