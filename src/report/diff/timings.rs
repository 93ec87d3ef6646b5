//! Recorded seconds, apart from everything that does not depend on the machine.

use super::surveys;
use super::table::{self, Cells};
use super::told::Told;
use super::tree::Moved;
use super::words::{counted, factors};
use crate::markdown::significant;

/// Columns of what is measured once, without a spread.
const ONCE: [&str; 4] = ["seconds", "report", "memory_ratio", "ratio_quartile"];
/// Columns of a spread.
const SPREAD: [&str; 3] = ["median", "least", "most"];

/// A measured number before and after; its own spread where it has one.
struct Timing {
    name: String,
    value: [f64; 2],
    spread: Option<[[f64; 2]; 2]>,
}

/// Medians within noise, slower and faster; then whether anything else in the files moved.
pub fn told(moved: &[&Moved]) -> Option<Told> {
    let versions: Vec<(&str, [Cells; 2])> = moved
        .iter()
        .filter_map(|(path, before, after)| Some((*path, table::versions(path, [(*before)?, (*after)?])?)))
        .collect();
    let timings: Vec<Timing> = versions.iter().flat_map(|(_, both)| timings(both)).collect();
    let noise = noise(&timings);
    let beyond: Vec<&Timing> = timings.iter().filter(|one| !one.is_within(noise)).collect();
    let slower = beyond.iter().filter(|one| one.factor() > 1.0).count();
    let mut rows: Vec<String> = versions.iter().filter_map(|(path, both)| others(path, both)).collect();
    rows.extend(
        moved
            .iter()
            .filter(|one| one.1.is_none() || one.2.is_none())
            .filter_map(|one| Some(surveys::told(&[one])?.rows.concat())),
    );
    if rows.is_empty() {
        rows.push("no count, error or machine beside the seconds moved".into());
    }
    let mut worst = beyond.clone();
    worst.sort_by(|a, b| b.factor().ln().abs().total_cmp(&a.factor().ln().abs()));
    rows.extend(worst.iter().map(|one| one.row()));
    let heading = format!(
        "Timings measured anew: {} of {} within noise (spreads overlap; without a spread of their own within × {}), {slower} slower, {} faster",
        timings.len() - beyond.len(),
        timings.len(),
        significant(noise, 3),
        beyond.len() - slower,
    );
    (!moved.is_empty()).then(|| Told::new(heading, rows))
}

fn timings([before, after]: &[Cells; 2]) -> Vec<Timing> {
    let number =
        |cells: &Cells, row: &str, column: &str| cells.get(&[row.to_string(), column.to_string()])?.parse::<f64>().ok();
    let mut found = Vec::new();
    for [row, column] in after.keys() {
        let both = |column: &str| Some([number(before, row, column)?, number(after, row, column)?]);
        let spread = if column == "median" { both("least").zip(both("most")) } else { None };
        let wanted = spread.is_some() || ONCE.contains(&column.as_str());
        if let Some(value) = both(column).filter(|_| wanted) {
            let spread = spread.map(|(least, most)| [[least[0], most[0]], [least[1], most[1]]]);
            found.push(Timing { name: row.clone(), value, spread });
        }
    }
    found
}

/// The median of most over least of all spreads: what one measurement may be off; 1 where none has a spread.
fn noise(timings: &[Timing]) -> f64 {
    let mut all: Vec<f64> =
        timings.iter().filter_map(|one| one.spread).flatten().map(|[least, most]| most / least).collect();
    all.sort_by(f64::total_cmp);
    all.get(all.len() / 2).copied().unwrap_or(1.0)
}

impl Timing {
    fn factor(&self) -> f64 {
        self.value[1] / self.value[0]
    }

    fn is_within(&self, noise: f64) -> bool {
        match self.spread {
            Some([old, new]) => old[0] <= new[1] && new[0] <= old[1],
            None => self.factor() <= noise && 1.0 / self.factor() <= noise,
        }
    }

    fn row(&self) -> String {
        let shown = |at: usize| {
            let spread = self.spread.map(|both| both[at].map(|x| significant(x, 3)));
            let spread = spread.map(|[least, most]| format!(" [{least}, {most}]")).unwrap_or_default();
            significant(self.value[at], 3) + &spread
        };
        format!("{}: {} → {}, {}", self.name, shown(0), shown(1), factors(&[self.factor()]))
    }
}

/// What else moved in the file.
fn others(path: &str, both: &[Cells; 2]) -> Option<String> {
    let is_other = |column: &str| !ONCE.contains(&column) && !SPREAD.contains(&column);
    let [before, after] =
        both.clone().map(|cells| cells.into_iter().filter(|([_, c], _)| is_other(c)).collect::<Cells>());
    let moved = after.iter().filter(|(key, value)| before.get(*key) != Some(value)).count();
    let gone = before.keys().filter(|key| !after.contains_key(*key)).count();
    (moved + gone > 0).then(|| {
        format!(
            "{path}, beside the seconds: {} moved or new, {gone} gone{}",
            counted(moved, "value"),
            first(&before, &after)
        )
    })
}

/// The first of them.
fn first(before: &Cells, after: &Cells) -> String {
    let change = after.iter().find_map(|(key, new)| Some((key, before.get(key).filter(|old| *old != new)?, new)));
    change.map_or_else(String::new, |([row, column], old, new)| format!("; {row} {column}: {old} → {new}"))
}
