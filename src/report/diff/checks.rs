//! The record of checks, column by column: what a change in each means, the most important first.

use std::collections::BTreeSet;
use std::path::Path;

use super::pairs::{Pair, Pairs, is_moved};
use super::told::Told;
use super::words::{counted, differ, some, tally};
use crate::case::Relation;
use crate::markdown::{self, significant};
use crate::oracle::ReferenceKind;
use crate::report::grouped::{largest_first, sorted};
use crate::report::record::{CheckRow, Mark};

/// Folder of what is recorded.
const SNAPSHOTS: &str = "snapshots";
/// Digits that the record has.
const DIGITS: usize = 4;

/// Verdicts that got worse against a truth, limits, and other verdicts; then what went, came, is asked of fewer runs or was renamed.
///
/// Verdicts are told by error over tolerance; [`stale`] records apart.
pub fn asked(pairs: &Pairs) -> Vec<Told> {
    let both = &pairs.both;
    let limits = |is_one: fn(&Pair) -> bool, how: &str| {
        let heading = |own: &[Pair]| format!("Tolerances {how}: {}", counted(own.len(), "check"));
        changes(both, is_one, heading, moved_limit, wider, moved_limit)
    };
    let verdicts = |how: &str, is_one: fn(&Pair) -> bool| {
        let kinds = |own: &[Pair]| tally(own.iter().map(|[_, after]| after.kind.clone()));
        let heading =
            |own: &[Pair]| format!("Verdicts that got {how}: {} ({})", counted(own.len(), "check"), kinds(own));
        changes(both, is_one, heading, marks, |[_, after]| Some(finite(after.share)), moved_verdict)
    };
    let [before, after] =
        [cases(both.iter().map(|p| p[0]), &pairs.gone), cases(both.iter().map(|p| p[1]), &pairs.came)];
    let told = [
        verdicts("WORSE against closed forms, other codes and measurements", |pair| {
            is_worse(pair) && is_of_truth(pair)
        }),
        limits(is_loosened_by_hand, "LOOSENED"),
        verdicts("WORSE", |pair| is_worse(pair) && !is_of_truth(pair) && !is_of_record(pair)),
        limits(
            |pair| is_loosened(pair) == Some(true) && follows_from_bar(pair),
            "wider as the error bars that they follow",
        ),
        limits(|pair| is_loosened(pair) == Some(false), "tightened"),
        verdicts("better", |[before, after]| after.verdict < before.verdict),
        of_one_record("Checks that are GONE", &pairs.gone, &after, "the whole case is gone"),
        of_one_record("New checks", &pairs.came, &before, "a new case"),
        fewer_runs(both),
        renamed(&pairs.renamed),
    ];
    told.into_iter().flatten().collect()
}

/// Whether a verdict got worse, or what came fails.
pub fn worse(pairs: &Pairs) -> bool {
    pairs.both.iter().any(is_worse) || pairs.came.iter().any(|row| row.verdict == Mark::Fail)
}

/// Records that the present code no longer gives: one line.
pub fn stale(pairs: &Pairs) -> Option<Told> {
    let own = pairs.both.iter().filter(|pair| is_worse(pair) && is_of_record(pair));
    let records: BTreeSet<&str> = own.map(|[_, after]| after.against.as_str()).collect();
    let heading = format!("STALE records: {} ({})", records.len(), some(records.iter().copied()));
    (!records.is_empty()).then(|| Told::new(heading, Vec::new()))
}

/// Whether something is accepted now that was not, or is no longer asked: a limit that no bar explains, a check that is gone, fewer runs.
pub fn is_laxer(pairs: &Pairs) -> bool {
    let fewer = |[before, after]: &Pair| after.runs < before.runs;
    !pairs.gone.is_empty() || pairs.both.iter().any(|pair| is_loosened_by_hand(pair) || fewer(pair))
}

/// Shares of the tolerance.
pub fn shares(pairs: &Pairs) -> Option<Told> {
    let heading = |own: &[Pair]| {
        let closer = own.iter().filter(|[before, after]| after.share > before.share).count();
        let (moved, all) = (counted(own.len(), "check"), pairs.both.len());
        format!(
            "Numbers that moved: {moved} of {all}, {closer} of them closer to their limit; by share of the tolerance used"
        )
    };
    // Changed verdicts are told as such.
    let size = |pair: &Pair| {
        let [before, after] = pair.map(|row| row.share);
        let moved = (after - before).abs();
        (moved > 0.0 && pair[0].verdict == pair[1].verdict).then_some(moved)
    };
    let change = |pair: &Pair| {
        let [old, new] = pair.map(|row| significant(100.0 * row.share, 2));
        format!("{old} % → {new} % of the limit; {}", errors(pair))
    };
    changes(&pairs.both, is_moved, heading, |_| String::new(), size, change)
}

/// Error bars that moved, came or went, the largest factor first; then uncertainties of values.
pub fn bars(pairs: &Pairs) -> Vec<Told> {
    let one = |name: &str, of: fn(&CheckRow) -> Option<f64>, shown: fn(f64) -> String| {
        let numbers = |pair: &Pair| pair.map(|row| of(row).unwrap_or(f64::NAN));
        let heading = |own: &[Pair]| {
            let all = pairs.both.iter().filter(|pair| pair.iter().any(|row| of(row).is_some())).count();
            let wider = own.iter().map(numbers).filter(|[old, new]| new > old).count();
            format!("{name}: {} of {all}, {wider} wider", counted(own.len(), "check"))
        };
        let size = |pair: &Pair| {
            let [old, new] = numbers(pair);
            Some(finite((new / old).ln().abs()))
        };
        let change = |pair: &Pair| numbers(pair).map(|x| if x.is_nan() { "none".into() } else { shown(x) }).join(" → ");
        changes(&pairs.both, |pair| differ(numbers(pair)), heading, |_| String::new(), size, change)
    };
    let bars = one("Error bars that moved", |row| row.bar, markdown::error);
    let uncertainties = one("Standard uncertainties that moved", |row| row.uncertainty, |x| significant(x, 3));
    bars.into_iter().chain(uncertainties).collect()
}

/// Checks that changed in one respect: those of one quantity, reference and kind of change in one row, told by the largest change,
/// the largest first; what has no size is only counted.
fn changes<'a>(
    all: &[Pair<'a>],
    is_one: impl Fn(&Pair) -> bool,
    heading: impl Fn(&[Pair]) -> String,
    kind: impl Fn(&Pair) -> String,
    size: impl Fn(&Pair) -> Option<f64>,
    change: impl Fn(&Pair) -> String,
) -> Option<Told> {
    let own: Vec<Pair<'a>> = all.iter().filter(|pair| is_one(pair)).copied().collect();
    let sized = own.iter().filter_map(|pair| Some((size(pair)?, *pair)));
    let groups = sorted(sized.map(|(size, pair)| ((&pair[1].quantity, &pair[1].against, kind(&pair)), (size, pair))));
    let mut rows: Vec<(f64, String)> = Vec::new();
    for members in groups.into_values() {
        let largest = members.iter().max_by(|(a, _), (b, _)| a.total_cmp(b));
        rows.extend(largest.map(|(size, pair)| (*size, format!("{}: {}", name(&members, pair[1]), change(pair)))));
    }
    rows.sort_by(|(a, _), (b, _)| b.total_cmp(a));
    let rows = rows.into_iter().map(|(_, row)| row).collect();
    (!own.is_empty()).then(|| Told::new(heading(&own), rows))
}

/// What the members of a row are, and which of them is the largest.
fn name(members: &[(f64, Pair)], largest: &CheckRow) -> String {
    let CheckRow { quantity, against, case, .. } = largest;
    if members.len() == 1 {
        return format!("{}, {quantity} against {against}", at(largest));
    }
    let cases: BTreeSet<&str> = members.iter().map(|(_, [_, after])| after.case.as_str()).collect();
    let of = if cases.len() == 1 { format!("of `{case}`") } else { format!("of {} cases", cases.len()) };
    format!("{} {of}, {quantity} against {against}; most {}", counted(members.len(), "check"), at(largest))
}

/// Case, trial and place of a check; of several runs those of the worst.
fn at(row: &CheckRow) -> String {
    if row.runs > 1 {
        return row.worst.clone();
    }
    let place = if row.place.is_empty() { String::new() } else { format!(", {}", row.place) };
    format!("{} × {}{place}", row.case, row.trial)
}

/// What is no number is the worst.
fn finite(size: f64) -> f64 {
    if size.is_nan() { f64::INFINITY } else { size }
}

/// The limit before and after with its name: the tolerance, or the bound of what is held against a bound; none where it is the same.
fn limit(pair: &Pair) -> Option<(&'static str, [f64; 2])> {
    let tolerances = ("tolerance", pair.map(|row| row.tolerance));
    let bounds = ("bound", pair.map(|row| row.reference));
    let is_bound = matches!(pair[1].relation, Relation::AtLeast | Relation::AtMost);
    let moved = [(tolerances, true), (bounds, is_bound)].into_iter().find(|((_, both), held)| *held && differ(*both));
    moved.map(|(limit, _)| limit).or_else(|| (pair[0].relation != pair[1].relation).then_some(tolerances))
}

/// Whether the check now accepts more, where its limit moved: what cannot be compared counts as loosened.
fn is_loosened(pair: &Pair) -> Option<bool> {
    let (name, [old, new]) = limit(pair)?;
    let from_below = name == "bound" && pair[1].relation == Relation::AtLeast;
    // NaN is looser.
    let kept = if from_below { new >= old } else { new <= old };
    Some(pair[0].relation != pair[1].relation || !kept)
}

/// Relative difference that rounding leaves between a tolerance and a bar of four digits each.
const ROUNDING: f64 = 1e-3;

/// Whether tolerance and error bar of a check moved by one factor: the tolerance is a multiple of the bar.
fn follows_from_bar(pair: &Pair) -> bool {
    let [before, after] = pair.map(|row| row.bar.unwrap_or(f64::NAN) / row.tolerance);
    let is_tolerance = matches!(limit(pair), Some(("tolerance", _))) && pair[0].relation == pair[1].relation;
    is_tolerance && (after - before).abs() <= ROUNDING * before.abs()
}

fn is_loosened_by_hand(pair: &Pair) -> bool {
    is_loosened(pair) == Some(true) && !follows_from_bar(pair)
}

/// Whether a check is held against something that is not this code.
fn is_of_truth([_, after]: &Pair) -> bool {
    after.kind != ReferenceKind::SelfConsistency.to_string()
}

/// Whether a check holds this code against a record of its own.
fn is_of_record(pair: &Pair) -> bool {
    !is_of_truth(pair) && Path::new(&pair[1].against).starts_with(SNAPSHOTS)
}

/// How much wider, whichever way.
fn wider(pair: &Pair) -> Option<f64> {
    limit(pair).map(|(_, [old, new])| (new / old).ln().abs())
}

fn moved_limit(pair: &Pair) -> String {
    let [before, after] = pair.map(|row| row.relation);
    if before != after {
        return format!("now held {after:?}, before {before:?}");
    }
    let Some((name, both)) = limit(pair) else { return String::new() };
    let [old, new] = both.map(if name == "bound" { markdown::bound } else { markdown::tolerance });
    // What differs in later digits only.
    let [old, new] = if old == new { both.map(|x| significant(x, DIGITS)) } else { [old, new] };
    format!("{name} {old} → {new}")
}

fn is_worse([before, after]: &Pair) -> bool {
    after.verdict > before.verdict
}

fn marks(pair: &Pair) -> String {
    pair.map(|row| row.verdict.to_string()).join(" → ")
}

fn moved_verdict(pair: &Pair) -> String {
    let why = if pair[1].why.is_empty() { String::new() } else { format!(" ({})", pair[1].why) };
    format!("{}{why}; {}", marks(pair), errors(pair))
}

/// The error before and after, beside what is accepted.
fn errors(pair: &Pair) -> String {
    let CheckRow { relation, tolerance, reference, .. } = pair[1];
    let sign = match relation {
        Relation::AtLeast => "≥",
        Relation::AtMost => "≤",
        Relation::Near | Relation::NearAbsolutely | Relation::Error => {
            let [old, new] = pair.map(|row| markdown::error(row.error));
            return format!("error {old} → {new}, tolerance {}", markdown::tolerance(*tolerance));
        }
    };
    let [old, new] = pair.map(|row| significant(row.value, 4));
    format!("{old} → {new}, wanted {sign} {}", markdown::bound(*reference))
}

/// Studies with their cases.
type Cases<'a> = BTreeSet<[&'a str; 2]>;

fn case(row: &CheckRow) -> [&str; 2] {
    [&row.study, &row.case]
}

fn cases<'a>(both: impl Iterator<Item = &'a CheckRow>, others: &[&'a CheckRow]) -> Cases<'a> {
    both.chain(others.iter().copied()).map(case).collect()
}

/// Checks that are in one record only, case by case; whole cases are told as such.
fn of_one_record(name: &str, rows: &[&CheckRow], others: &Cases, whole: &str) -> Option<Told> {
    let groups = largest_first(rows.iter().map(|row| (case(row), *row)));
    let told = groups.iter().map(|(case, own)| {
        let failed = own.iter().filter(|row| row.verdict == Mark::Fail).count();
        let failed = if failed > 0 { format!(", {failed} FAIL") } else { String::new() };
        let whole = if others.contains(case) { String::new() } else { format!(", {whole}") };
        let quantities: BTreeSet<&str> = own.iter().map(|row| row.quantity.as_str()).collect();
        format!("{}: {}{failed}{whole}: {}", case[1], counted(own.len(), "check"), some(quantities))
    });
    let heading = format!("{name}: {} of {}", rows.len(), counted(groups.len(), "case"));
    (!rows.is_empty()).then(|| Told::new(heading, told.collect()))
}

/// Checks that fewer runs are asked for.
fn fewer_runs(pairs: &[Pair]) -> Option<Told> {
    let fewer = pairs.iter().filter(|[before, after]| after.runs < before.runs);
    let row = |[before, after]: &Pair| format!("{}: {} → {} runs", after.quantity, before.runs, after.runs);
    let rows: Vec<String> = fewer.map(row).collect();
    (!rows.is_empty()).then(|| Told::new(format!("Asked of FEWER runs: {}", counted(rows.len(), "check")), rows))
}

/// Renamed checks, those of one change together.
fn renamed(pairs: &[Pair]) -> Option<Told> {
    let changed = pairs.iter().map(|[before, after]| {
        let parts = before.key().into_iter().zip(after.key()).enumerate();
        (parts.filter(|(_, (old, new))| old != new).collect::<Vec<_>>(), ())
    });
    let rows = largest_first(changed).into_iter().map(|(parts, own)| {
        let parts = parts.iter().map(|(part, (old, new))| format!("{} `{old}` → `{new}`", CheckRow::KEY[*part]));
        format!("{}: {}", counted(own.len(), "check"), parts.collect::<Vec<_>>().join(", "))
    });
    let heading = format!("Renamed, with the same numbers: {}", counted(pairs.len(), "check"));
    (!pairs.is_empty()).then(|| Told::new(heading, rows.collect()))
}
