//! Verdicts that changed.

use super::groups;
use super::pairs::{Pair, Pairs};
use super::told::Told;
use super::words::{counted, tally};
use crate::markdown;
use crate::report::record::{CheckRow, Mark};

/// Verdicts that got worse, then those that got better.
pub fn told(pairs: &[Pair]) -> Vec<Told> {
    let of = |how: &str, is_one: fn(&Pair) -> bool| {
        let own: Vec<Pair> = pairs.iter().filter(|pair| is_one(pair)).copied().collect();
        let kinds = tally(own.iter().map(|pair| pair.after.kind.clone()));
        let heading = format!("Verdicts that got {how}: {} ({kinds})", counted(own.len(), "check"));
        (!own.is_empty())
            .then(|| Told::new(heading, groups::rows(&own, marks, |pair| finite(pair.after.share), change)))
    };
    [of("WORSE", is_worse), of("better", |pair| pair.after.verdict < pair.before.verdict)]
        .into_iter()
        .flatten()
        .collect()
}

fn is_worse(pair: &Pair) -> bool {
    pair.after.verdict > pair.before.verdict
}

/// Whether a verdict got worse, or what came fails.
pub fn worse(pairs: &Pairs) -> bool {
    pairs.both.iter().any(is_worse) || pairs.came.iter().any(|row| row.verdict == Mark::Fail)
}

/// What is no number is the worst.
fn finite(share: f64) -> f64 {
    if share.is_nan() { f64::INFINITY } else { share }
}

fn marks(pair: &Pair) -> String {
    format!("{} → {}", pair.before.verdict, pair.after.verdict)
}

fn change(pair: &Pair) -> String {
    let why = if pair.after.why.is_empty() { String::new() } else { format!(" ({})", pair.after.why) };
    format!("{}{why}; {}", marks(pair), errors(pair))
}

/// The error before and after, beside what is accepted.
pub fn errors(pair: &Pair) -> String {
    let CheckRow { relation, tolerance, reference, .. } = pair.after;
    use crate::case::Relation::{AtLeast, AtMost};
    if matches!(relation, AtLeast | AtMost) {
        let [old, new] = [pair.before.value, pair.after.value].map(|x| markdown::significant(x, 4));
        let sign = if *relation == AtLeast { "≥" } else { "≤" };
        return format!("{old} → {new}, wanted {sign} {}", markdown::bound(*reference));
    }
    let [old, new] = [pair.before.error, pair.after.error].map(markdown::error);
    format!("error {old} → {new}, tolerance {}", markdown::tolerance(*tolerance))
}
