//! The record of checks: which check of one record is which of another, by its key; and what a change of a verdict, a
//! limit, a number or a bar means, the most important first.

use std::collections::BTreeSet;
use std::path::Path;

use super::told::{Change, Told};
use crate::case::Relation;
use crate::markdown::{self, significant};
use crate::oracle::ReferenceKind;
use crate::report::record::{CheckRow, Mark, ROUND_OFF};
use crate::study::grouped::{joined, largest_first};

/// Folders of what is recorded.
const RECORDS: [&str; 2] = ["snapshots", "oracles/frozen"];
/// Digits that the record has.
const DIGITS: usize = 4;
/// Relative difference that rounding leaves between a tolerance and a bar of four digits each.
const ROUNDING: f64 = 1e-3;

/// A check before and after.
type Pair<'a> = [&'a CheckRow; 2];

/// The checks of two records, matched.
#[derive(Clone, Debug, Default)]
pub struct Pairs<'a> {
    /// In both.
    pub both: Vec<Pair<'a>>,
    /// Before only.
    pub gone: Vec<&'a CheckRow>,
    /// After only.
    pub came: Vec<&'a CheckRow>,
}

impl<'a> Pairs<'a> {
    /// Matches two records by the keys of their checks.
    pub fn of(before: &'a [CheckRow], after: &'a [CheckRow]) -> Self {
        let keyed = |rows: &'a [CheckRow]| rows.iter().map(|row| (row.key(), row));
        let mut pairs = Self::default();
        for one in joined([before, after].map(keyed)).into_values() {
            match one {
                [Some(old), Some(new)] => pairs.both.push([old, new]),
                [old, new] => {
                    pairs.gone.extend(old);
                    pairs.came.extend(new);
                }
            }
        }
        pairs
    }
}

/// Whether two numbers of a record differ; what is no number is like what is no number.
fn differ([before, after]: [f64; 2]) -> bool {
    before.to_bits() != after.to_bits() && !(before.is_nan() && after.is_nan())
}

/// What got worse against a truth, by error over tolerance; limits; other verdicts; what went, came or is asked of
/// fewer runs; numbers and error bars. [`stale`] records are apart.
pub fn told(pairs: &Pairs) -> Vec<Told> {
    let moved = |what, is_one: fn(&Pair) -> bool, change: fn(&Pair) -> Change| {
        section(what, pairs.both.iter().filter(|pair| is_one(pair)).map(|pair| (pair[1], change(pair))))
    };
    let of_one_record = |what, rows: &[&CheckRow], side: usize| {
        let others = [&pairs.gone, &pairs.came][side].iter().copied().chain(pairs.both.iter().map(|pair| pair[side]));
        let cases: BTreeSet<[&str; 2]> = others.map(case).collect();
        section(what, rows.iter().map(|row| (*row, alone(row, &cases))))
    };
    let came = pairs.came.iter().filter(|row| !is_stale(row)).copied();
    let (failing, passing): (Vec<&CheckRow>, Vec<&CheckRow>) = came.partition(|row| is_failing(row));
    let told = [
        moved(
            "Verdicts that got WORSE against closed forms, other codes and measurements",
            |pair| is_worse(pair) && is_of_truth(pair[1]),
            verdict,
        ),
        of_one_record("New checks that FAIL", &failing, 0),
        moved("Tolerances LOOSENED", is_loosened_by_hand, limits),
        moved("Verdicts that got WORSE", |pair| is_worse(pair) && !is_of_truth(pair[1]) && !is_stale(pair[1]), verdict),
        moved("Tolerances wider as the error bars that they follow", is_loosened_as_bar, limits),
        moved("Tolerances tightened", |pair| differ(pair.map(limit)) && !is_loosened(pair), limits),
        moved("Verdicts that got better", |[before, after]| after.verdict < before.verdict, verdict),
        of_one_record("Checks that are GONE", &pairs.gone, 1),
        of_one_record("New checks", &passing, 0),
        moved("Checks asked of FEWER runs", is_asked_less, |pair| {
            number(pair, |row| row.runs as f64, |row| format!("{} runs", row.runs))
        }),
        moved(
            "Checks held against ANOTHER kind of truth",
            |[before, after]| before.kind != after.kind,
            |[before, after]| change(after, 0.0, format!("{} → {}", before.kind, after.kind)),
        ),
        moved(
            "Numbers that moved",
            |pair| is_changed(pair) && pair[0].verdict == pair[1].verdict && !is_stale(pair[1]),
            share,
        ),
        moved(
            "Error bars that moved",
            |pair| differ(pair.map(bar)),
            |pair| {
                number(pair, bar, |row| if bar(row).is_finite() { markdown::error(bar(row)) } else { "none".into() })
            },
        ),
    ];
    told.into_iter().flatten().collect()
}

/// Checks that changed in one way, counted by the kind of what they are held against.
fn section<'a>(what: &str, changes: impl Iterator<Item = (&'a CheckRow, Change)>) -> Option<Told> {
    let (rows, changes): (Vec<&CheckRow>, Vec<Change>) = changes.unzip();
    let kinds = largest_first(rows.iter().map(|row| (row.kind, ())));
    let kinds: Vec<String> = kinds.iter().map(|(kind, all)| format!("{} {kind}", all.len())).collect();
    let told = Told::counted(what, "check", changes)?;
    Some(Told { heading: format!("{} ({})", told.heading, kinds.join(", ")), ..told })
}

/// Records that the present code no longer gives: one line.
pub fn stale(pairs: &Pairs) -> Option<Told> {
    let changed = pairs.both.iter().filter(|pair| is_worse(pair) || is_changed(pair)).map(|pair| pair[1]);
    let stale = changed.chain(pairs.came.iter().copied()).filter(|row| is_stale(row));
    let records: BTreeSet<String> = stale.map(|row| format!("`{}`", row.against)).collect();
    let heading = |all: Vec<String>| format!("STALE records: {} ({})", all.len(), all.join(", "));
    (!records.is_empty()).then(|| Told { heading: heading(Vec::from_iter(records)), ..Told::default() })
}

/// Whether a verdict got worse, or what came fails, but for [`stale`] records.
pub fn worse(pairs: &Pairs) -> bool {
    let came = pairs.came.iter().copied().filter(|row| is_failing(row));
    pairs.both.iter().filter(|pair| is_worse(pair)).map(|pair| pair[1]).chain(came).any(|row| !is_stale(row))
}

/// Whether something is accepted now that was not, or is no longer asked: a limit that no bar explains, a check that is
/// gone, or held against this code alone, fewer runs.
pub fn is_laxer(pairs: &Pairs) -> bool {
    let is_own = |pair: &Pair| is_of_truth(pair[0]) && !is_of_truth(pair[1]);
    let is_laxer = |pair: &Pair| is_loosened_by_hand(pair) || is_asked_less(pair) || is_own(pair);
    !pairs.gone.is_empty() || pairs.both.iter().any(is_laxer)
}

/// What a check says, and of which case and run.
fn change(row: &CheckRow, size: f64, how: String) -> Change {
    let of = format!("{} against {}", row.quantity, row.against);
    Change { of, case: row.case.clone(), at: at(row), size: size.abs(), factor: None, how }
}

/// Case, trial and place of a check; of several runs those of the worst.
fn at(row: &CheckRow) -> String {
    if !row.worst.is_empty() {
        return row.worst.clone();
    }
    let place = if row.place.is_empty() { String::new() } else { format!(", {}", row.place) };
    format!("{} × {}{place}", row.case, row.trial)
}

/// A number of a check before and after.
fn number(pair: &Pair, of: fn(&CheckRow) -> f64, shown: fn(&CheckRow) -> String) -> Change {
    let one = change(pair[1], 0.0, String::new());
    Change { case: one.case, ..Change::number(one.of, one.at, pair.map(of), pair.map(shown)) }
}

/// By error over tolerance.
fn verdict(pair: &Pair) -> Change {
    let why = if pair[1].why.is_empty() { String::new() } else { format!(" ({})", pair[1].why) };
    let marks = pair.map(|row| row.verdict.told()[1]).join(" → ");
    change(pair[1], pair[1].share, format!("{marks}{why}; {}", errors(pair)))
}

/// The error, or the value that has a bound, before and after, beside what is accepted.
fn errors(pair: &Pair) -> String {
    let is_bound = matches!(pair[1].relation, Relation::AtLeast | Relation::AtMost);
    let shown = |row: &CheckRow| if is_bound { significant(row.value, DIGITS) } else { markdown::error(row.error) };
    let [old, new] = pair.map(shown);
    let moved = if old == new { new } else { format!("{old} → {new}") };
    format!("{} {moved}, {}", if is_bound { "value" } else { "error" }, wanted(pair[1]))
}

/// What is accepted.
fn wanted(row: &CheckRow) -> String {
    match row.relation {
        Relation::AtLeast => format!("wanted ≥ {}", markdown::bound(limit(row))),
        Relation::AtMost => format!("wanted ≤ {}", markdown::bound(limit(row))),
        Relation::Near | Relation::NearAbsolutely | Relation::Error => {
            format!("tolerance {}", markdown::tolerance(row.tolerance))
        }
    }
}

/// The largest error, or the last value, that is accepted.
fn limit(row: &CheckRow) -> f64 {
    match row.relation {
        Relation::AtLeast => row.reference - row.tolerance,
        Relation::AtMost => row.reference + row.tolerance,
        Relation::Near | Relation::NearAbsolutely | Relation::Error => row.tolerance,
    }
}

fn limits(pair: &Pair) -> Change {
    number(pair, limit, wanted)
}

/// Whether the check now accepts more, or something else: what cannot be compared counts as loosened.
fn is_loosened(pair: &Pair) -> bool {
    let [old, new] = pair.map(limit);
    // NaN is looser.
    let is_kept = if pair[1].relation == Relation::AtLeast { new >= old } else { new <= old };
    pair[0].relation != pair[1].relation || differ([old, new]) && !is_kept
}

/// Whether tolerance and error bar of a check became wider by one factor: the tolerance is a multiple of the bar.
fn is_loosened_as_bar(pair: &Pair) -> bool {
    let [before, after] = pair.map(|row| row.bar.unwrap_or(f64::NAN));
    let expected = before / pair[0].tolerance * pair[1].tolerance;
    let follows = (after - expected).abs() <= ROUNDING * expected.abs() + ROUND_OFF;
    is_loosened(pair) && pair[0].relation == pair[1].relation && follows
}

fn is_loosened_by_hand(pair: &Pair) -> bool {
    is_loosened(pair) && !is_loosened_as_bar(pair)
}

/// Whether its numbers are others, or its error is another part of the same limit.
fn is_changed(pair: &Pair) -> bool {
    let numbers: [fn(&CheckRow) -> f64; 3] = [|row| row.value, |row| row.reference, |row| row.error];
    let is_another_share = differ(pair.map(|row| row.share)) && !differ(pair.map(limit));
    is_another_share || numbers.into_iter().any(|number| differ(pair.map(number)))
}

fn is_asked_less([before, after]: &Pair) -> bool {
    after.runs < before.runs
}

/// A check that is in one record only: told as such, or together with all of its case where the other record has no
/// such case.
fn alone(row: &CheckRow, others: &BTreeSet<[&str; 2]>) -> Change {
    let (size, how) = if is_failing(row) { (row.share, errors(&[row, row])) } else { (0.0, String::new()) };
    let one = change(row, size, how);
    if others.contains(&case(row)) { one } else { told_by(format!("the whole case {}", row.case), one) }
}

/// A change that is told in one row with others than those of the same quantity.
fn told_by(of: String, one: Change) -> Change {
    Change { at: format!("{}, {}", one.at, one.of), of, ..one }
}

fn case(row: &CheckRow) -> [&str; 2] {
    [&row.study, &row.case]
}

/// By how much more or less of its limit a check uses.
fn share(pair: &Pair) -> Change {
    let one = number(pair, |row| row.share, |row| format!("{} %", significant(100.0 * row.share, 2)));
    let size = (pair[1].share - pair[0].share).abs();
    let of_limit = if size.is_finite() { format!("{} of the limit; ", one.how) } else { String::new() };
    let [old, new] = pair.map(|row| row.reference);
    let held = if differ([old, new]) {
        format!("; reference {}", [old, new].map(markdown::bound).join(" → "))
    } else {
        String::new()
    };
    Change { size, how: of_limit + &errors(pair) + &held, ..one }
}

/// What the value may be off; what has no bar may be off by anything.
fn bar(row: &CheckRow) -> f64 {
    row.bar.or(row.uncertainty).unwrap_or(f64::INFINITY)
}

fn is_failing(row: &CheckRow) -> bool {
    row.verdict == Mark::Fail
}

fn is_worse([before, after]: &Pair) -> bool {
    after.verdict > before.verdict
}

/// Whether a check is held against something that is not this code.
fn is_of_truth(row: &CheckRow) -> bool {
    row.kind != ReferenceKind::SelfConsistency
}

/// Whether the present code does not give a record of its own.
fn is_stale(row: &CheckRow) -> bool {
    row.verdict != Mark::Pass
        && !is_of_truth(row)
        && RECORDS.iter().any(|folder| Path::new(&row.against).starts_with(folder))
}
