//! Recorded surveys: which columns moved in how many rows.

use std::collections::{BTreeMap, BTreeSet};

use super::table::{self, Cells};
use super::told::Told;
use super::tree::Moved;
use super::words::{counted, factors, tally};

/// A row per survey that moved.
pub fn told(moved: &[&Moved]) -> Option<Told> {
    let rows: Vec<String> = moved.iter().map(|one| row(one)).collect();
    (!rows.is_empty()).then(|| Told::new(format!("Recorded surveys that moved: {}", rows.len()), rows))
}

fn row((path, before, after): &Moved) -> String {
    let (Some(before), Some(after)) = (before, after) else {
        return format!("{path}: {}", if after.is_some() { "new" } else { "GONE" });
    };
    match table::versions(path, [before, after]) {
        Some(versions) => format!("{path}: {}", changes(&versions)),
        None => format!("{path}: moved; it cannot be compared row by row"),
    }
}

/// Rows that came and went, then the columns that moved.
fn changes([before, after]: &[Cells; 2]) -> String {
    let names = |cells: &Cells| cells.keys().map(|[row, _]| row.clone()).collect::<BTreeSet<String>>();
    let [old, new] = [names(before), names(after)];
    let mut told: Vec<String> = Vec::new();
    for (word, count) in [("gone", old.difference(&new).count()), ("new", new.difference(&old).count())] {
        if count > 0 {
            told.push(format!("{} {word}", counted(count, "row")));
        }
    }
    let mut columns: BTreeMap<&str, Vec<[&str; 2]>> = BTreeMap::new();
    for (key, value) in after {
        if let Some(earlier) = before.get(key).filter(|earlier| *earlier != value) {
            columns.entry(&key[1]).or_default().push([earlier, value]);
        }
    }
    let mut columns: Vec<(&str, Vec<[&str; 2]>)> = columns.into_iter().collect();
    columns.sort_by_key(|(_, all)| std::cmp::Reverse(all.len()));
    let kinds = columns.len().saturating_sub(COLUMNS);
    told.extend(columns.iter().take(COLUMNS).map(|(column, all)| format!("{column} in {} ({})", all.len(), kind(all))));
    told.extend((kinds > 0).then(|| format!("{kinds} other columns")));
    let told = if told.is_empty() { "written otherwise, no value moved".into() } else { told.join(", ") };
    format!("of {}: {told}", counted(new.len(), "row"))
}

/// Columns that are told of a survey.
const COLUMNS: usize = 5;

/// Factors where all are numbers of one sign, else what became what.
fn kind(all: &[[&str; 2]]) -> String {
    let ratio = |[old, new]: &[&str; 2]| Some(new.parse::<f64>().ok()? / old.parse::<f64>().ok()?);
    let ratios: Option<Vec<f64>> = all.iter().map(|two| ratio(two).filter(|r| r.is_finite() && *r > 0.0)).collect();
    let short = |text: &str| text.chars().take(24).collect::<String>();
    ratios
        .map_or_else(|| tally(all.iter().map(|[old, new]| format!("{} → {}", short(old), short(new)))), |r| factors(&r))
}
