//! How changes are put into words.

use crate::markdown;
use crate::report::grouped::largest_first;

/// Whether two numbers of a record differ; what is no number is like what is no number.
pub fn differ([before, after]: [f64; 2]) -> bool {
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
    let [least, most] = [f64::min, f64::max].map(|end| all.iter().copied().reduce(end).unwrap_or(f64::NAN));
    if most - least <= 0.02 * most { factor(most) } else { format!("{} to {}", factor(least), factor(most)) }
}

/// Names that are listed before the rest is counted.
const NAMED: usize = 3;

/// Counted by how often, the most frequent first: `10 converged → capped`.
pub fn tally(all: impl IntoIterator<Item = String>) -> String {
    let counts = largest_first(all.into_iter().map(|what| (what, ())));
    let shown = counts.iter().take(NAMED).map(|(what, members)| format!("{} {what}", members.len()));
    let more = (counts.len() > NAMED).then(|| format!("{} other kinds", counts.len() - NAMED));
    shown.chain(more).collect::<Vec<_>>().join(", ")
}

/// The first names, and how many more.
pub fn some<'a>(names: impl IntoIterator<Item = &'a str>) -> String {
    let names: Vec<&str> = names.into_iter().collect();
    let shown = names.iter().take(NAMED).map(|name| format!("`{name}`"));
    let more = (names.len() > NAMED).then(|| format!("{} more", names.len() - NAMED));
    shown.chain(more).collect::<Vec<_>>().join(", ")
}
