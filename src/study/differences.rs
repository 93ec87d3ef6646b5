//! What is compared of runs, and how far two answers are apart; NaN, which no check passes, where they cannot be
//! compared. Answers of other codes are read from `oracles/frozen`, for which Rust alone suffices; live ones are asked
//! now, and held against the frozen ones as well.

use crate::case::{Check, Judged, Quantity, Reference};
use crate::measure::order::richardson;
use crate::measure::{larger, relative_error};
use crate::oracle::ReferenceKind;
use crate::oracle::cross_code::frozen::{Frozen, changed_versions};
use crate::oracle::cross_code::live::Live;
use crate::oracle::cross_code::{Code, PhysicalAnswer};
use crate::solve::Run;

/// Peak pressure and second-moment width of a run; NaN, which no check passes, where it did not converge.
pub fn peak_and_width(run: &Run) -> [f64; 2] {
    let measures = run.measures();
    if run.solution.converged() { [measures.peak.pressure, measures.second_moment_width] } else { [f64::NAN; 2] }
}

/// Relative errors of both against the truth, without their signs.
pub fn errors(run: &Run, truth: [f64; 2]) -> [f64; 2] {
    let found = peak_and_width(run);
    [0, 1].map(|k| relative_error(found[k], truth[k]))
}

/// A number on the finest of three meshes, coarse to fine, with its standard uncertainty by Richardson; none on other
/// series.
pub fn on_finest(series: &[PhysicalAnswer], of: fn(&PhysicalAnswer) -> f64) -> Option<[f64; 2]> {
    let [coarse, medium, fine] = series else { return None };
    let values = [coarse, medium, fine].map(of);
    Some([values[2], richardson(values).uncertainty()])
}

/// Numbers in groups of one unit and scale.
pub type Groups = [(String, Vec<f64>)];

/// Largest change of any number over the largest number of its group; NaN where the groups do not match.
pub fn largest_change(now: &Groups, kept: &Groups) -> f64 {
    let values = |groups: &Groups| groups.iter().map(|(_, values)| values.clone()).collect::<Vec<_>>();
    worst_difference(&values(now), &values(kept))
}

/// The largest [`relative_difference`] of lists of numbers; NaN where there are none or their numbers differ.
pub fn worst_difference(a: &[Vec<f64>], b: &[Vec<f64>]) -> f64 {
    if a.len() != b.len() || a.is_empty() {
        return f64::NAN;
    }
    a.iter().zip(b).map(|(a, b)| relative_difference(a, b)).fold(0.0, larger)
}

/// `max |a − b| / max |b|`; NaN where there is nothing to compare, the lengths differ or a number is none.
pub fn relative_difference(a: &[f64], b: &[f64]) -> f64 {
    if a.len() != b.len() || a.is_empty() {
        return f64::NAN;
    }
    let scale = b.iter().map(|x| x.abs()).fold(0.0, larger);
    let difference = a.iter().zip(b).map(|(x, y)| (x - y).abs()).fold(0.0, larger);
    if scale > 0.0 { difference / scale } else { difference }
}

/// What differs between two sets of frozen results: a line per version and per group of numbers.
pub fn changes(code: Code, old: &Frozen, new: &Frozen) -> Vec<String> {
    let code = code.name();
    let (before, after) = (old.numbers(), new.numbers());
    let mut lines = vec![format!("{code}: {}", changed_versions(&old.versions, &new.versions))];
    for (name, values) in &after {
        match before.get(name) {
            None => lines.push(format!("{code}, {name}: new")),
            Some(earlier) => {
                let change = relative_difference(values, earlier);
                if change.is_nan() || change > 0.0 {
                    lines.push(format!("{code}, {name}: largest relative change {change:.2e}"));
                }
            }
        }
    }
    lines.extend(before.keys().filter(|name| !after.contains_key(*name)).map(|name| format!("{code}, {name}: gone")));
    lines
}

/// Relative difference from the frozen answer that a live one may have.
const REPRODUCED: f64 = 1e-6;

/// What tells trials of live answers from those of frozen ones, which the page shows.
pub fn suffix(live: Option<Live>) -> &'static str {
    live.map_or("", |_| ", live")
}

/// A live answer is what was frozen; the versions that changed since are named.
pub fn reproduced(name: &str, now: &Groups, kept: &Groups, versions: &str) -> Judged {
    let frozen =
        Reference { name: "frozen results".into(), kind: ReferenceKind::CrossCode, value: 0.0, uncertainty: None };
    let because = format!("solvers and libraries differ in round-off; {versions}");
    let quantity = Quantity::at("largest relative change of a live answer", name);
    Check::error(quantity, frozen, REPRODUCED, because).judge(largest_change(now, kept))
}
