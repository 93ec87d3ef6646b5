//! Generated pages and everything else that moved: how many lines.

use std::collections::BTreeMap;

use super::told::Told;
use super::tree::Moved;
use super::words::counted;

/// A row per file.
pub fn told(moved: &[&Moved]) -> Option<Told> {
    let mut rows: Vec<(usize, String)> = moved.iter().map(|one| row(one)).collect();
    rows.sort_by_key(|(lines, _)| std::cmp::Reverse(*lines));
    let heading = format!("Pages and other files with other lines: {}", counted(rows.len(), "file"));
    (!rows.is_empty()).then(|| Told::new(heading, rows.into_iter().map(|(_, row)| row).collect()))
}

fn row((path, before, after): &Moved) -> (usize, String) {
    let mut lines: BTreeMap<&str, i64> = BTreeMap::new();
    for (text, step) in [(before, -1), (after, 1)] {
        for line in text.unwrap_or_default().lines() {
            *lines.entry(line).or_default() += step;
        }
    }
    let sum = |sign: i64| lines.values().map(|count| (sign * count).max(0)).sum::<i64>();
    let [added, removed] = [sum(1), sum(-1)];
    ((added + removed) as usize, format!("{path}: {added} lines added, {removed} removed"))
}
