//! Checks that keep their verdict but use more, or less, of their tolerance.

use super::groups;
use super::pairs::Pair;
use super::told::Told;
use super::verdicts::errors;
use super::words::{counted, differ};
use crate::markdown::significant;

/// Checks whose numbers moved, those whose share of their tolerance moved most first.
pub fn told(pairs: &[Pair]) -> Option<Told> {
    let moved: Vec<Pair> = pairs.iter().filter(|pair| pair.moved()).copied().collect();
    let closer = moved.iter().filter(|pair| pair.after.share > pair.before.share).count();
    let heading = format!(
        "Numbers that moved: {} of {}, {closer} of them closer to their limit; by share of the tolerance used",
        counted(moved.len(), "check"),
        pairs.len(),
    );
    let same = moved.iter().filter(|pair| pair.before.verdict == pair.after.verdict && size(pair) > 0.0);
    let rows = groups::rows(&same.copied().collect::<Vec<_>>(), |_| String::new(), size, change);
    (!moved.is_empty()).then(|| Told::new(heading, rows))
}

/// By how much of its tolerance the error moved.
fn size(pair: &Pair) -> f64 {
    let [old, new] = [pair.before.share, pair.after.share];
    if differ(old, new) { (new - old).abs() } else { 0.0 }
}

fn change(pair: &Pair) -> String {
    let [old, new] = [pair.before.share, pair.after.share].map(|share| significant(100.0 * share, 2));
    format!("{old} % → {new} % of the limit; {}", errors(pair))
}
