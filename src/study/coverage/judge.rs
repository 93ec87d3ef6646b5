//! What the record must hold: a fixed part solved again is what was recorded, and errors lie within their bars.

use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::study::coverage::group::{CELLS, Group};
use crate::study::coverage::run::{Kind, Numbers, Record};
use crate::study::coverage::sites::{FAMILIES, JUDGED};

/// Share of errors that lie within their bars.
pub const SHARE: f64 = 0.95;
/// Bars beyond which no error lies.
pub const BEYOND: f64 = 3.0;
/// Bars over errors in the median: a bar that is never needed says nothing. 4.2 since they contain what the growth leaves in bodies that bend,
/// what the force leaves, tops between points, and places between them.
pub const MEDIAN: f64 = 5.0;
/// A recomputed error or bar may differ by this share: the record holds four digits.
const DIGITS: f64 = 2e-3;
/// Errors and bars below may differ: they are round-off.
const ROUND_OFF: f64 = 1e-7;

/// The checks.
pub fn judge(Numbers { recorded, fresh }: &Numbers) -> Result<Vec<Judged>, Error> {
    Ok(vec![as_recorded(recorded, fresh), within(recorded), told(recorded), beyond(recorded), narrow(recorded)])
}

/// Whether fresh errors and bars are the recorded ones, number by number of each scene.
pub fn as_recorded(recorded: &[Record], fresh: &[Record]) -> Judged {
    let site = |record: &Record| (record.family, record.number);
    let moved = |scene: &[Record]| {
        let kept: Vec<&Record> = recorded.iter().filter(|kept| site(kept) == site(&scene[0])).collect();
        let apart = scene.iter().zip(&kept).filter(|(fresh, kept)| !is_as_recorded(kept, fresh)).count();
        apart + scene.len().abs_diff(kept.len())
    };
    let moved: usize = fresh.chunk_by(|a, b| site(a) == site(b)).map(moved).sum();
    let quantity = Quantity::at("recomputed error or bar that is not the recorded one", format!("of {}", fresh.len()));
    let record = Reference::own("snapshots/coverage.csv", 0.0);
    Check::at_most(quantity, record, "errors and bars; `coverage` renews the record").judge(if fresh.is_empty() {
        f64::NAN
    } else {
        moved as f64
    })
}

/// Whether a fresh number is the recorded one.
pub fn is_as_recorded(kept: &Record, fresh: &Record) -> bool {
    let key = |record: &Record| (record.family, record.number, record.cell, record.element, record.kind);
    let alike =
        |a: f64, b: f64| (a.is_nan() && b.is_nan()) || (a - b).abs() <= DIGITS * a.abs().max(b.abs()) + ROUND_OFF;
    key(kept) == key(fresh) && alike(kept.error, fresh.error) && alike(kept.bar, fresh.bar)
}

/// The share of errors within their bars, an unknown one being outside, of each number of each family on each kind of cells, where it is
/// smallest.
pub fn within(recorded: &[Record]) -> Judged {
    let groups = JUDGED.into_iter().flat_map(|family| Kind::ALL.map(|kind| (family, kind)));
    let groups = groups.flat_map(|(family, kind)| CELLS.map(|cell| (family, kind, cell)));
    let shares = groups.filter_map(|(family, kind, cell)| {
        let group = Group::of(recorded, |one| one.family == family && one.kind == kind && one.cell == cell);
        let at = || format!("{}, {}, {cell}-node cells", kind.title(), family.title());
        (!group.records.is_empty()).then(|| (at(), group.within(1.0)))
    });
    let quantity = "share of the true errors within their bars, where it is smallest";
    let bound = Reference::analytic("closed forms", SHARE);
    smallest(shares, quantity, bound, "of each number of each family on each kind of cells")
}

/// The share of errors within the bars that are told, of each number of every family, where it is smallest; none told is no share.
pub fn told(recorded: &[Record]) -> Judged {
    let groups = FAMILIES.into_iter().flat_map(|family| Kind::ALL.map(|kind| (family, kind)));
    let shares = groups.filter_map(|(family, kind)| {
        let is_own = |one: &Record| one.family == family && one.kind == kind;
        let told = Group::of(recorded, |one| is_own(one) && !one.bar.is_nan());
        let at = || format!("{}, {}", kind.title(), family.title());
        recorded.iter().any(is_own).then(|| (at(), told.within(1.0)))
    });
    let quantity = "share of the true errors within the bars that are told, where it is smallest";
    let bound = Reference::analytic("closed forms and boundary methods", SHARE);
    smallest(shares, quantity, bound, "of each number of every family")
}

/// The smallest of some shares, which shall not be below a bound; one that is no number is the smallest.
fn smallest(
    shares: impl Iterator<Item = (String, f64)>,
    quantity: &'static str,
    bound: Reference,
    because: &'static str,
) -> Judged {
    let least = shares.reduce(|a, b| if b.1 < a.1 || b.1.is_nan() { b } else { a });
    let (at, share) = least.unwrap_or((String::new(), f64::NAN));
    Check::at_least(Quantity::at(quantity, at), bound, because).judge(share)
}

/// Errors far outside the bars that are known.
pub fn beyond(recorded: &[Record]) -> Judged {
    let known = Group::of(recorded, |one| JUDGED.contains(&one.family) && !one.bar.is_nan());
    let quantity = Quantity::at(
        format!("share of the true errors beyond {BEYOND} bars"),
        format!("of {} bars known", known.records.len()),
    );
    let because = "a number so far outside would mislead whoever trusts its bar";
    Check::at_most(quantity, Reference::analytic("closed forms", 0.0), because).judge(1.0 - known.within(BEYOND))
}

/// Bars are no wider than they need be.
pub fn narrow(recorded: &[Record]) -> Judged {
    let median = Group::of(recorded, |one| JUDGED.contains(&one.family)).median();
    let quantity =
        Quantity::at("median of bar over true error", format!("all numbers above round-off, of {}", recorded.len()));
    Check::at_most(quantity, Reference::analytic("closed forms", MEDIAN), "a bar that is never needed says nothing")
        .judge(median)
}
