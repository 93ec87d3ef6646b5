//! How changes are put into words.

use crate::markdown;

/// Whether two numbers of a record differ; what is no number is like what is no number.
pub fn differ(before: f64, after: f64) -> bool {
    before.to_bits() != after.to_bits() && !(before.is_nan() && after.is_nan())
}

/// `1 check`, `2 checks`.
pub fn counted(count: usize, noun: &str) -> String {
    if count == 1 { format!("1 {noun}") } else { format!("{count} {noun}s") }
}

/// A factor in a word where there is one.
pub fn factor(factor: f64) -> String {
    match factor {
        half if (half - 0.5).abs() < 0.005 => "halved".into(),
        twice if (twice - 2.0).abs() < 0.02 => "doubled".into(),
        other => format!("× {}", markdown::significant(other, 3)),
    }
}

/// One factor, or the span of several.
pub fn factors(all: &[f64]) -> String {
    let [least, most] = span(all);
    if most - least <= 0.02 * most { factor(most) } else { format!("{} to {}", factor(least), factor(most)) }
}

/// The smallest and the largest.
pub fn span(all: &[f64]) -> [f64; 2] {
    all.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(*x), high.max(*x)])
}

/// Counted by how often, the most frequent first: `10 × converged → capped`.
pub fn tally(all: impl IntoIterator<Item = String>) -> String {
    let mut counts: std::collections::BTreeMap<String, usize> = std::collections::BTreeMap::new();
    for one in all {
        *counts.entry(one).or_default() += 1;
    }
    let mut counts: Vec<(String, usize)> = counts.into_iter().collect();
    counts.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
    let shown = counts.iter().take(NAMED).map(|(what, count)| format!("{count} {what}"));
    let more = counts.len().saturating_sub(NAMED);
    let more = (more > 0).then(|| format!("{more} other kinds"));
    shown.chain(more).collect::<Vec<_>>().join(", ")
}

/// Names that are listed before the rest is counted.
const NAMED: usize = 3;

/// The first names, and how many more.
pub fn some(names: &[&str]) -> String {
    let shown = names.iter().take(NAMED).map(|name| format!("`{name}`"));
    let more = (names.len() > NAMED).then(|| format!("{} more", names.len() - NAMED));
    shown.chain(more).collect::<Vec<_>>().join(", ")
}
