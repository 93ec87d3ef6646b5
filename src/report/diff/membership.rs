//! Checks and cases that came, went, are asked of fewer runs, or were renamed.

use std::collections::{BTreeMap, BTreeSet};

use super::pairs::{Pair, Pairs};
use super::told::Told;
use super::words::{counted, some};
use crate::report::record::{CheckRow, Mark};

/// What went, what came, what was renamed.
pub fn told(pairs: &Pairs) -> Vec<Told> {
    let [before, after] = [cases(&pairs.both, &pairs.gone, |p| p.before), cases(&pairs.both, &pairs.came, |p| p.after)];
    let gone = of("Checks that are GONE", &pairs.gone, &after, "the whole case is gone");
    let came = of("New checks", &pairs.came, &before, "a new case");
    [gone, came, fewer(&pairs.both), renamed(&pairs.renamed)].into_iter().flatten().collect()
}

/// Checks that fewer runs are asked for.
fn fewer(pairs: &[Pair]) -> Option<Told> {
    let fewer = pairs.iter().filter(|pair| pair.after.runs < pair.before.runs);
    let row = |pair: &Pair| format!("{}: {} → {} runs", pair.after.quantity, pair.before.runs, pair.after.runs);
    let rows: Vec<String> = fewer.map(row).collect();
    (!rows.is_empty()).then(|| Told::new(format!("Asked of FEWER runs: {}", counted(rows.len(), "check")), rows))
}

/// Studies with their cases.
type Cases<'a> = BTreeSet<[&'a str; 2]>;

fn cases<'a>(both: &[Pair<'a>], others: &[&'a CheckRow], side: fn(&Pair<'a>) -> &'a CheckRow) -> Cases<'a> {
    both.iter().map(side).chain(others.iter().copied()).map(|row| [row.study.as_str(), row.case.as_str()]).collect()
}

fn of(name: &str, rows: &[&CheckRow], others: &Cases, whole: &str) -> Option<Told> {
    let mut by_case: BTreeMap<[&str; 2], Vec<&CheckRow>> = BTreeMap::new();
    for row in rows {
        by_case.entry([&row.study, &row.case]).or_default().push(row);
    }
    let mut groups: Vec<([&str; 2], Vec<&CheckRow>)> = by_case.into_iter().collect();
    groups.sort_by_key(|(_, own)| std::cmp::Reverse(own.len()));
    let told = groups.iter().map(|(case, own)| {
        let failed = own.iter().filter(|row| row.verdict == Mark::Fail).count();
        let failed = if failed > 0 { format!(", {failed} FAIL") } else { String::new() };
        let whole = if others.contains(case) { String::new() } else { format!(", {whole}") };
        let quantities: BTreeSet<&str> = own.iter().map(|row| row.quantity.as_str()).collect();
        let quantities = some(&quantities.into_iter().collect::<Vec<_>>());
        format!("{}: {}{failed}{whole}: {quantities}", case[1], counted(own.len(), "check"))
    });
    let heading = format!("{name}: {} of {}", rows.len(), counted(groups.len(), "case"));
    (!rows.is_empty()).then(|| Told::new(heading, told.collect()))
}

/// Renamed checks, those of one change together.
fn renamed(pairs: &[Pair]) -> Option<Told> {
    let mut groups: BTreeMap<Vec<(usize, &str, &str)>, usize> = BTreeMap::new();
    for pair in pairs {
        let parts = pair.before.key().into_iter().zip(pair.after.key()).enumerate();
        let changed = parts.filter(|(_, (old, new))| old != new).map(|(part, (old, new))| (part, old, new)).collect();
        *groups.entry(changed).or_default() += 1;
    }
    let mut groups: Vec<_> = groups.into_iter().collect();
    groups.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
    let rows = groups.iter().map(|(changed, count)| {
        let parts = changed.iter().map(|(part, old, new)| format!("{} `{old}` → `{new}`", CheckRow::KEY[*part]));
        format!("{}: {}", counted(*count, "check"), parts.collect::<Vec<_>>().join(", "))
    });
    let heading = format!("Renamed, with the same numbers: {}", counted(pairs.len(), "check"));
    (!pairs.is_empty()).then(|| Told::new(heading, rows.collect()))
}
