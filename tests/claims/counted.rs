//! The constants by which bars count on differences between meshes, derived again from the recorded sample.

use std::collections::BTreeMap;
use std::ops::Range;

use contact_vv::accuracy::counted::Row;
use contact_vv::case::Verdict;
use contact_vv::study::promised::counted::{Record, SURVEY};
use contact_vv::study::random::Family;

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
fn derived(recorded: &[Record]) -> Vec<(Row, usize, [f64; 2])> {
    let mut rows: BTreeMap<Row, Vec<&Record>> = BTreeMap::new();
    recorded.iter().for_each(|one| rows.entry(one.row()).or_default().push(one));
    rows.into_iter().map(|(row, own)| (row, own.len(), narrowest(&own))).collect()
}

#[test]
fn constants_of_the_bars_are_the_narrowest_that_hold_on_the_recorded_sample() {
    let sample = SURVEY.surveyed().expect("a record");
    assert_eq!(sample.as_recorded().verdict, Verdict::Pass, "{}", sample.told());
    let derived = derived(&sample.recorded);
    assert_eq!(derived.len(), 28);
    for (row, numbers, constants) in derived {
        assert_eq!(row.constants(), constants, "{row:?}, from {numbers} numbers");
    }
}
