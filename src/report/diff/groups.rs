//! Changes of checks, those of one kind in one row.

use std::collections::BTreeMap;
use std::collections::BTreeSet;

use super::pairs::Pair;
use super::words::counted;
use crate::report::record::CheckRow;

/// Rows of changes: those of one quantity, reference and kind of change together, told by the largest, the largest first.
pub fn rows(
    pairs: &[Pair],
    kind: impl Fn(&Pair) -> String,
    size: impl Fn(&Pair) -> f64,
    change: impl Fn(&Pair) -> String,
) -> Vec<String> {
    let mut groups: BTreeMap<[String; 3], Vec<&Pair>> = BTreeMap::new();
    for pair in pairs {
        let CheckRow { quantity, against, .. } = pair.after;
        groups.entry([quantity.clone(), against.clone(), kind(pair)]).or_default().push(pair);
    }
    let mut rows: Vec<(f64, String)> = Vec::new();
    for members in groups.into_values() {
        if let Some(largest) = members.iter().max_by(|a, b| size(a).total_cmp(&size(b))) {
            rows.push((size(largest), format!("{}: {}", name(&members, largest.after), change(largest))));
        }
    }
    rows.sort_by(|(a, _), (b, _)| b.total_cmp(a));
    rows.into_iter().map(|(_, row)| row).collect()
}

/// What the members are, and which of them is the largest.
fn name(members: &[&Pair], largest: &CheckRow) -> String {
    let CheckRow { quantity, against, .. } = largest;
    let one = format!("{}, {}", at(largest), held(quantity, against));
    if members.len() == 1 {
        return one;
    }
    let cases: BTreeSet<&str> = members.iter().map(|pair| pair.after.case.as_str()).collect();
    let of = if cases.len() == 1 { format!("of `{}`", largest.case) } else { format!("of {} cases", cases.len()) };
    format!("{} {of}, {}; most {}", counted(members.len(), "check"), held(quantity, against), at(largest))
}

fn held(quantity: &str, against: &str) -> String {
    format!("{quantity} against {against}")
}

/// Case, trial and place of a check; of several runs those of the worst.
fn at(row: &CheckRow) -> String {
    if row.runs > 1 {
        return row.worst.clone();
    }
    let place = if row.place.is_empty() { String::new() } else { format!(", {}", row.place) };
    format!("{} × {}{place}", row.case, row.trial)
}
