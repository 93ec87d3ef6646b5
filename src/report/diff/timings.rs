//! Recorded seconds, apart from everything that does not depend on the machine.

use super::recorded;
use super::table::{self, Cells, Difference};
use super::told::Told;
use super::tree::Moved;
use super::words::{counted, factor};
use crate::markdown::significant;

/// Columns of what is measured once, without a spread.
const ONCE: [&str; 4] = ["seconds", "report", "memory_ratio", "ratio_quartile"];
/// Columns of a spread: the median first.
const SPREAD: [&str; 3] = ["median", "least", "most"];

/// A measured number before and after; its least and most where it has a spread.
struct Timing<'a> {
    name: &'a str,
    value: [f64; 2],
    spread: Option<[[f64; 2]; 2]>,
}

/// Medians within noise, slower and faster; then whether anything else in the files moved.
pub fn told(moved: &[Moved]) -> Option<Told> {
    let read = moved.iter().filter_map(|(path, texts)| {
        let [before, after] = *texts;
        Some((*path, table::versions(path, [before?, after?])?))
    });
    let versions: Vec<(&str, [Cells; 2])> = read.collect();
    let timings: Vec<Timing> = versions.iter().flat_map(|(_, both)| timings(both)).collect();
    let noise = noise(&timings);
    let mut beyond: Vec<&Timing> = timings.iter().filter(|one| !one.is_within(noise)).collect();
    let slower = beyond.iter().filter(|one| one.factor() > 1.0).count();
    let mut rows: Vec<String> = versions.iter().filter_map(|(path, both)| others(path, both)).collect();
    rows.extend(moved.iter().filter(|(_, texts)| texts.contains(&None)).map(recorded::survey));
    if rows.is_empty() {
        rows.push("no count, error or machine beside the seconds moved".into());
    }
    beyond.sort_by(|a, b| b.factor().ln().abs().total_cmp(&a.factor().ln().abs()));
    rows.extend(beyond.iter().map(|one| one.row()));
    let heading = format!(
        "Timings measured anew: {} of {} within noise (spreads overlap; without a spread of their own within × {}), {slower} slower, {} faster",
        timings.len() - beyond.len(),
        timings.len(),
        significant(noise, 3),
        beyond.len() - slower,
    );
    (!moved.is_empty()).then(|| Told::new(heading, rows))
}

fn timings([before, after]: &[Cells; 2]) -> impl Iterator<Item = Timing<'_>> {
    after.keys().filter_map(|[row, column]| {
        let number = |cells: &Cells, column: &str| cells.get(&[row.clone(), column.into()])?.parse::<f64>().ok();
        let both = |column: &str| Some([number(before, column)?, number(after, column)?]);
        let [median, least, most] = SPREAD;
        let spread = if column == median { both(least).zip(both(most)) } else { None };
        let wanted = spread.is_some() || ONCE.contains(&column.as_str());
        let spread = spread.map(|(least, most)| [0, 1].map(|side| [least[side], most[side]]));
        both(column).filter(|_| wanted).map(|value| Timing { name: row, value, spread })
    })
}

/// The median of most over least of all spreads: what one measurement may be off; 1 where none has a spread.
fn noise(timings: &[Timing]) -> f64 {
    let spreads = timings.iter().filter_map(|one| one.spread).flatten();
    let mut all: Vec<f64> = spreads.map(|[least, most]| most / least).collect();
    all.sort_by(f64::total_cmp);
    all.get(all.len() / 2).copied().unwrap_or(1.0)
}

impl Timing<'_> {
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
        let shown = |side: usize| {
            let spread = self.spread.map(|both| format!(" [{}]", both[side].map(|x| significant(x, 3)).join(", ")));
            significant(self.value[side], 3) + &spread.unwrap_or_default()
        };
        format!("{}: {} → {}, {}", self.name, shown(0), shown(1), factor(self.factor()))
    }
}

/// What else moved in the file: how many values, and the first that was there before.
fn others(path: &str, versions: &[Cells; 2]) -> Option<String> {
    let changes = Difference::of(versions).changes;
    let others = changes.iter().filter(|one| !ONCE.contains(&one.column) && !SPREAD.contains(&one.column));
    let gone = others.clone().filter(|one| one.values[1].is_none()).count();
    let moved = others.clone().count() - gone;
    let first = others.into_iter().find(|one| one.values.iter().all(Option::is_some));
    let first = first.map(|one| format!("; {} {}: {}", one.row, one.column, one.arrow())).unwrap_or_default();
    let told = || format!("{path}, beside the seconds: {} moved or new, {gone} gone{first}", counted(moved, "value"));
    (moved + gone > 0).then(told)
}
