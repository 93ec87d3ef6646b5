//! How much of their tolerances the checks use, by what they are held against.

use crate::drawing::palette::{self, Dash, Marker, Style};
use crate::drawing::theme::Colour;
use crate::drawing::{Axis, Chart, Direction, Drawing, Guide, Series};
use crate::oracle::ReferenceKind;
use crate::report::record;
use crate::study::Finding;

/// The chart's file, and what it shows.
pub const CHART: [&str; 2] = [
    "nearness.svg",
    "Of the checks held against each kind of reference, the part whose error uses at most so much of its tolerance",
];

/// Shares that are drawn: of what lies below the first the curve tells how many there are.
const RANGE: [f64; 2] = [1e-4, 10.0];
/// Steps of a curve in a decade.
const PER_DECADE: i32 = 8;
/// A kind, and how its curve is drawn.
const CURVES: [(ReferenceKind, Colour, Dash, Marker); 4] = [
    (ReferenceKind::SelfConsistency, palette::LINE, Dash::Solid, Marker::Circle),
    (ReferenceKind::CrossCode, palette::LAYER, Dash::Dashed, Marker::Square),
    (ReferenceKind::Analytic, palette::NODE, Dash::Dotted, Marker::Diamond),
    (ReferenceKind::Measured, palette::PURPLE, Dash::DashDot, Marker::Circle),
];

/// A curve for each kind that has checks; a check without an error counts as beyond every share.
pub fn chart(findings: &[Finding]) -> Drawing {
    let rows = record::rows(findings);
    let [least, most] = RANGE;
    let share = Axis::log("share of the tolerance that is used [–]").over(least, most);
    let mut chart = Chart::new(
        "How near checks are to their limits",
        share,
        Axis::linear("part of the checks [%]").over(0.0, 100.0),
    );
    chart.notes.push("A check that could not be run is beyond every share.".into());
    chart.guides.push(Guide { direction: Direction::Vertical, at: 1.0, label: "limit".into() });
    for (kind, colour, dash, marker) in CURVES {
        let shares: Vec<f64> = rows.iter().filter(|row| row.kind == kind.to_string()).map(|row| row.share).collect();
        if !shares.is_empty() {
            let label = format!("{kind}, {} checks", shares.len());
            let style = Style::run(colour, dash, marker);
            chart.series.push(Series::new(label, cumulated(&shares), style));
        }
    }
    chart.drawing()
}

/// The part of the shares, in per cent, that are at most so large.
pub fn cumulated(shares: &[f64]) -> Vec<(f64, f64)> {
    let [from, to] = RANGE.map(|end| (f64::from(PER_DECADE) * end.log10()).round() as i32);
    let part = |k: i32| {
        let at = 10f64.powf(f64::from(k) / f64::from(PER_DECADE));
        (at, 100.0 * shares.iter().filter(|share| **share <= at).count() as f64 / shares.len() as f64)
    };
    (from..=to).map(part).collect()
}
