//! How it is told what differs: one row for everything that differs in the same, the largest first.

use std::collections::BTreeSet;

use crate::markdown::{counted, significant};
use crate::study::grouped::largest_first;

/// One thing that differs.
#[derive(Clone, Debug, Default)]
pub struct Change {
    /// In what: all that differ in the same are told in one row, those that became less and more apart.
    pub of: String,
    /// The case it is part of, where there are cases.
    pub case: String,
    /// What differs.
    pub at: String,
    /// How much: of a row the largest is shown; what is no number is the largest.
    pub size: f64,
    /// The number after over that before, where both are numbers of one sign.
    pub factor: Option<f64>,
    /// What it was and is.
    pub how: String,
}

impl Change {
    /// A number before and after with how they are written: by their factor.
    pub fn number(of: String, at: String, [before, after]: [f64; 2], shown: [String; 2]) -> Self {
        let ratio = Some(after / before).filter(|ratio| ratio.is_finite() && *ratio > 0.0);
        let by = ratio.map(|ratio| format!(" ({})", factor(ratio))).unwrap_or_default();
        let size = ratio.map_or(f64::INFINITY, |ratio| ratio.ln().abs());
        Self { of, at, size, factor: ratio, how: shown.join(" → ") + &by, ..Self::default() }
    }
}

/// A heading that counts, rows from the most to the least important, charts to look at.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Told {
    /// What differs and how much of it: complete without the rows.
    pub heading: String,
    /// The rows, the most important first.
    pub rows: Vec<String>,
    /// Paths of charts to be seen before and after.
    pub charts: Vec<String>,
}

impl Told {
    /// Changes under a heading, counted as `noun`.
    pub fn new(heading: String, noun: &str, changes: impl IntoIterator<Item = Change>) -> Self {
        let is_less = |change: &Change| change.factor.is_some_and(|factor| factor < 1.0);
        let groups = largest_first(changes.into_iter().map(|one| ((one.of.clone(), is_less(&one)), one)));
        let mut groups: Vec<Vec<Change>> = groups.into_iter().map(|(_, changes)| changes).collect();
        groups.iter_mut().for_each(|changes| changes.sort_by(|a, b| b.size.total_cmp(&a.size)));
        groups.sort_by(|a, b| b[0].size.total_cmp(&a[0].size));
        Self { heading, rows: groups.iter().map(|changes| row(changes, noun)).collect(), charts: Vec::new() }
    }

    /// Changes under what they have in common and their number; nothing where nothing differs.
    pub fn counted(what: &str, noun: &str, changes: Vec<Change>) -> Option<Self> {
        let heading = format!("{what}: {}", counted(changes.len(), noun));
        (!changes.is_empty()).then(|| Self::new(heading, noun, changes))
    }
}

/// `10 checks of 2 cases, half-width against Hertz, doubled; most pin × run 4: pass → FAIL`.
fn row(changes: &[Change], noun: &str) -> String {
    let Change { of, at, size, how, .. } = &changes[0];
    let how = if how.is_empty() { String::new() } else { format!(": {how}") };
    if changes.len() == 1 {
        return if at.is_empty() { format!("{of}{how}") } else { format!("{at}, {of}{how}") };
    }
    let cases = changes.iter().map(|one| &one.case).collect::<BTreeSet<_>>().len();
    let cases = if cases > 1 { format!(" of {cases} cases") } else { String::new() };
    let ratios: Option<Vec<f64>> = changes.iter().map(|one| one.factor).collect();
    let ratios = ratios.map(|all| format!(", {}", factors(&all))).unwrap_or_default();
    let first = if *size > 0.0 && size.is_finite() { "most" } else { "first" };
    format!("{}{cases}, {of}{ratios}; {first} {at}{how}", counted(changes.len(), noun))
}

/// A factor in a word where there is one.
fn factor(factor: f64) -> String {
    match factor {
        half if (half - 0.5).abs() < 0.005 => "halved".into(),
        twice if (twice - 2.0).abs() < 0.02 => "doubled".into(),
        other => format!("× {}", significant(other, 3)),
    }
}

/// One factor, or the span of several.
fn factors(all: &[f64]) -> String {
    let [least, most] = [f64::min, f64::max].map(|end| all.iter().copied().reduce(end).unwrap_or(f64::NAN));
    if most - least <= 0.02 * most { factor(most) } else { format!("{} to {}", factor(least), factor(most)) }
}
