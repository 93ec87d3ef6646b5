//! True error against the bar claimed.

use crate::error::Error;
use crate::figure::palette::{self, Dash, Marker, Style};
use crate::figure::{Axis, Chart, Drawing, Series, panels};
use crate::study::Found;
use crate::study::coverage::group::Group;
use crate::study::coverage::run::{Kind, Numbers, Record};

/// Numbers that have a panel: errors of the others are mostly round-off.
const SHOWN: [Kind; 3] = [Kind::Peak, Kind::SecondMomentWidth, Kind::Edge];
/// Ends of both axes.
const RANGE: [f64; 2] = [1e-5, 1.0];
/// Ranges of bars in a decade.
const PER_DECADE: f64 = 4.0;
/// Fewest errors of which quantiles are drawn.
const FEWEST: usize = 20;

/// The chart.
pub fn pictures(findings: &[Found<Numbers>]) -> Result<Vec<(String, Drawing)>, Error> {
    let recorded: Vec<Record> = findings.iter().flat_map(|found| found.numbers.recorded.clone()).collect();
    let chart = panels("True error against the bar claimed", &SHOWN.map(|kind| panel(&recorded, kind)), 3)?;
    Ok(vec![("coverage.svg".into(), chart)])
}

fn panel(recorded: &[Record], kind: Kind) -> Chart {
    let axis = |label: &str| Axis::log(label).over(RANGE[0], RANGE[1]);
    let mut chart = Chart::new(kind.title(), axis("bar, relative [–]"), axis("true error, relative [–]"));
    let group = Group::of(recorded, |record| record.kind == kind);
    let quantiles = [
        ("largest", 1.0, palette::LINE, Dash::Solid, Marker::Diamond),
        ("95 of 100", 0.95, palette::NODE, Dash::Solid, Marker::Circle),
        ("median", 0.5, palette::LAYER, Dash::Dashed, Marker::Square),
    ];
    for (label, share, colour, dash, marker) in quantiles {
        let (points, style) = (curve(&group, share), Style::run(colour, dash, marker));
        chart.series.push(Series { label: label.into(), points, style, hollow: Vec::new() });
    }
    let diagonal = RANGE.map(|end| (end, end)).into();
    chart.series.push(Series {
        label: "error = bar".into(),
        points: diagonal,
        style: Style::reference(),
        hollow: Vec::new(),
    });
    chart
}

/// In each range of bars the error that a share of the errors is not above.
fn curve(group: &Group, share: f64) -> Vec<(f64, f64)> {
    let [low, high] = RANGE.map(|end| (PER_DECADE * end.log10()).round() as i32);
    let edge = |k: i32| 10f64.powf(f64::from(k) / PER_DECADE);
    let point = |k: i32| {
        let own = group.above_round_off().filter(|record| edge(k) <= record.bar && record.bar < edge(k + 1));
        let mut errors: Vec<f64> = own.map(|record| record.error).collect();
        errors.sort_by(f64::total_cmp);
        let rank = (share * errors.len() as f64).ceil() as usize;
        let error = errors.get(rank.max(1) - 1).copied().filter(|_| errors.len() >= FEWEST);
        error.filter(|error| *error >= RANGE[0]).map(|error| (edge(k) * edge(1).sqrt(), error))
    };
    (low..high).filter_map(point).collect()
}
