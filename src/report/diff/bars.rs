//! Error bars and uncertainties that moved.

use super::groups;
use super::pairs::Pair;
use super::told::Told;
use super::words::{counted, differ};
use crate::markdown;

/// Bars that moved, came or went, the largest factor first; then uncertainties of values.
pub fn told(pairs: &[Pair]) -> Vec<Told> {
    let bars = one("Error bars that moved", pairs, |pair| [pair.before.bar, pair.after.bar], markdown::error);
    let spread = |pair: &Pair| [pair.before.uncertainty, pair.after.uncertainty];
    let uncertainties = one("Standard uncertainties that moved", pairs, spread, |x| markdown::significant(x, 3));
    [bars, uncertainties].into_iter().flatten().collect()
}

fn one(
    name: &str,
    pairs: &[Pair],
    of: impl Fn(&Pair) -> [Option<f64>; 2],
    shown: impl Fn(f64) -> String,
) -> Option<Told> {
    let numbers = |pair: &Pair| of(pair).map(|bar| bar.unwrap_or(f64::NAN));
    let is_moved = |pair: &&Pair| {
        let [old, new] = numbers(pair);
        differ(old, new)
    };
    let own: Vec<Pair> = pairs.iter().filter(is_moved).copied().collect();
    let all = pairs.iter().filter(|pair| of(pair).iter().any(Option::is_some)).count();
    let wider = own.iter().map(numbers).filter(|[old, new]| new > old).count();
    let heading = format!("{name}: {} of {all}, {wider} wider", counted(own.len(), "check"));
    let size = |pair: &Pair| {
        let [old, new] = numbers(pair);
        let factor = (new / old).ln().abs();
        if factor.is_nan() { f64::INFINITY } else { factor }
    };
    let change = |pair: &Pair| {
        let [old, new] = numbers(pair).map(|x| if x.is_nan() { "none".into() } else { shown(x) });
        format!("{old} → {new}")
    };
    (!own.is_empty()).then(|| Told::new(heading, groups::rows(&own, |_| String::new(), size, change)))
}
