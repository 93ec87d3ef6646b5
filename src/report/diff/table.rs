//! Recorded tables and documents as cells: values by the row's key and the column's name.

use std::collections::{BTreeMap, BTreeSet};

use serde_json::Value;

/// Values by row and column.
pub type Cells = BTreeMap<[String; 2], String>;

/// Digests of what a record was made of: another one moves no result.
const DIGEST: &str = "sources";
/// What names an entry of a list of a document.
const NAMES: [&str; 3] = ["name", "target", "mutant"];

/// Two versions of a recorded file; none where either cannot be read as what its name says.
pub fn versions(path: &str, [before, after]: [&str; 2]) -> Option<[Cells; 2]> {
    if path.ends_with(".csv") { tables([before, after]) } else { Some([document(before)?, document(after)?]) }
}

/// Tables, their rows told apart by the fewest first columns that have no duplicate in either.
fn tables([before, after]: [&str; 2]) -> Option<[Cells; 2]> {
    let [before, after] = [rows(before)?, rows(after)?];
    let width = before[0].len().min(after[0].len());
    let key = (1..=width).find(|key| [&before, &after].iter().all(|rows| is_unique(rows, *key)))?;
    Some([cells(&before, key), cells(&after, key)])
}

fn rows(text: &str) -> Option<Vec<Vec<String>>> {
    let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(text.as_bytes());
    let rows: Result<Vec<csv::StringRecord>, _> = reader.records().collect();
    let rows: Vec<Vec<String>> = rows.ok()?.iter().map(|row| row.iter().map(String::from).collect()).collect();
    (!rows.is_empty()).then_some(rows)
}

fn is_unique(rows: &[Vec<String>], key: usize) -> bool {
    rows.iter().map(|row| &row[..key]).collect::<BTreeSet<_>>().len() == rows.len()
}

fn cells(rows: &[Vec<String>], key: usize) -> Cells {
    let mut cells = Cells::new();
    for row in &rows[1..] {
        let name = row[..key].join(", ");
        for (column, value) in rows[0][key..].iter().zip(&row[key..]) {
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
