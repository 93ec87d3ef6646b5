//! How far bars count on differences between meshes: random scenes of closed form, none of those that judge the bars, and the constants that
//! they give.

use std::collections::BTreeMap;
use std::ops::Range;

use serde::{Deserialize, Serialize};

use super::bars::{self, ROUND_OFF};
use crate::accuracy::counted::{Kind, Row};
use crate::error::Error;
use crate::study::random::family::JUDGED;
use crate::study::random::{Family, Site};
use crate::study::records::{Millionths, Survey, are_like};

/// The survey.
pub const SURVEY: Survey<Site, Record> = Survey {
    name: "counted",
    head: || COLUMNS.map(String::from).into(),
    sites: || Ok(JUDGED.iter().flat_map(|&family| (1..=EACH).map(move |number| Site { family, number })).collect()),
    key: Site::key,
    of: |record| Site { family: record.family, number: record.number }.key(),
    run: record,
    alike: |kept, fresh| {
        let numbers = |one: &Record| [one.error, one.apart, one.hidden, one.rest].map(Some);
        kept.row() == fresh.row() && are_like(&numbers(kept), &numbers(fresh), ROUND_OFF)
    },
    again: |site| site.number % AGAIN == 1,
};

/// Scenes of a family: five of each cells, element, and way to end.
const EACH: usize = 90;
/// Of so many scenes one is solved again whenever the record is judged.
const AGAIN: usize = EACH;

const COLUMNS: [&str; 8] = ["family", "number", "kind", "ends_at_candidates", "error", "apart", "hidden", "rest"];

/// A number of a scene, over the size of such a number.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Record {
    family: Family,
    number: usize,
    kind: Kind,
    ends_at_candidates: bool,
    /// True error.
    error: Millionths,
    /// Worst difference to a coarser mesh over `r^q − 1`.
    apart: Millionths,
    /// Element over contact, `(h/a)^s`.
    hidden: Millionths,
    /// What the bar holds besides.
    rest: Millionths,
}

impl Record {
    /// What it is counted on as.
    fn row(&self) -> Row {
        Row::of(self.kind, bars::element(self.number), bars::order(self.number), self.ends_at_candidates)
    }
}

/// The numbers of a scene that a bar holds an estimate of, but for those whose error is round-off.
fn record(site: &Site) -> Result<Vec<Record>, Error> {
    let each = bars::barred(site)?.into_iter().filter_map(|(one, error, size)| {
        let told = one.told?;
        let rest = told.rest + one.bar.iteration + one.bar.penalty;
        let over = |value: f64| Millionths(value / size);
        let is_told = told.bar().is_finite() && rest.is_finite() && error.is_finite() && error > ROUND_OFF * size;
        is_told.then(|| Record {
            family: site.family,
            number: site.number,
            kind: told.row.kind,
            ends_at_candidates: told.row.ends_at_candidates,
            error: over(error),
            apart: over(told.apart),
            hidden: over(told.hidden),
            rest: over(rest),
        })
    });
    Ok(each.collect())
}

/// Mantissas of the constants: those of the series E24 (IEC 60063).
const MANTISSAS: [f64; 24] = [
    1.0, 1.1, 1.2, 1.3, 1.5, 1.6, 1.8, 2.0, 2.2, 2.4, 2.7, 3.0, 3.3, 3.6, 3.9, 4.3, 4.7, 5.1, 5.6, 6.2, 6.8, 7.5, 8.2,
    9.1,
];
/// Decades of F and of C: no bar is below the error that the differences tell.
const DECADES: [Range<i32>; 2] = [0..1, -3..1];
/// Share of the numbers of each family that may be beyond their bars, and bars beyond which none is.
const BEYOND: (f64, f64) = (0.01, 2.0);

/// The constants F or C that are tried, from the smallest on.
fn tried(decades: Range<i32>) -> impl Iterator<Item = f64> {
    let decade = |k: i32| MANTISSAS.map(|mantissa| format!("{mantissa}e{k}").parse().unwrap_or(f64::NAN));
    decades.flat_map(decade)
}

/// The bar of a number by some constants.
fn bar(one: &Record, [factor, hidden]: [f64; 2]) -> f64 {
    factor * one.apart.0 + hidden * one.hidden.0 + one.rest.0
}

/// Whether bars by some constants hold in each family.
fn hold(sample: &[&Record], constants: [f64; 2]) -> bool {
    let (share, most) = BEYOND;
    let mut families: BTreeMap<Family, [usize; 2]> = BTreeMap::new();
    for one in sample {
        let bar = bar(one, constants);
        // A bar that is no number holds nothing.
        let is_within = |bars: f64| one.error.0 <= bars * bar;
        if !is_within(most) {
            return false;
        }
        let [all, beyond] = families.entry(one.family).or_default();
        *all += 1;
        *beyond += usize::from(!is_within(1.0));
    }
    families.values().all(|[all, beyond]| *beyond as f64 <= share * *all as f64)
}

/// F and C of the narrowest bars that hold, by the mean of their logarithms: for each F the least C; NaN where none hold.
fn narrowest(sample: &[&Record]) -> [f64; 2] {
    let width = |constants: [f64; 2]| sample.iter().map(|one| bar(one, constants).ln()).sum::<f64>();
    let [factors, hidden] = DECADES;
    let hidden: Vec<f64> = std::iter::once(0.0).chain(tried(hidden)).collect();
    let holding = tried(factors).filter_map(|factor| {
        let least = hidden.partition_point(|hidden| !hold(sample, [factor, *hidden]));
        Some([factor, *hidden.get(least)?])
    });
    let narrower = |a: [f64; 2], b: [f64; 2]| if width(b) < width(a) { b } else { a };
    holding.reduce(narrower).unwrap_or([f64::NAN; 2])
}

/// The constants of every row, derived from a record, with the numbers that they are from.
pub fn derived(recorded: &[Record]) -> Vec<(Row, usize, [f64; 2])> {
    let mut rows: BTreeMap<Row, Vec<&Record>> = BTreeMap::new();
    recorded.iter().for_each(|one| rows.entry(one.row()).or_default().push(one));
    rows.into_iter().map(|(row, own)| (row, own.len(), narrowest(&own))).collect()
}
