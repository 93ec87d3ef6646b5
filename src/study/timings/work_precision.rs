//! Two charts: the worst error of p₀ and a under all loads against seconds and counted work, with what is cheapest for an error.

use crate::error::Error;
use crate::figure::palette::{self, Dash, Marker, Style};
use crate::figure::{Axis, Bars, Chart, Direction, Drawing, Guide, Series, panels};
use crate::markdown::significant;
use crate::solve::Element;
use crate::study::timings::compared::{TRUNCATED, milliseconds, notes, others, ours_fitted, percent, remark, spread};
use crate::study::timings::others::{Peer, PeerPoint};
use crate::study::timings::pareto::{Measure, front, sound, within};
use crate::study::timings::precision::{Family, LOADS, Point};
use crate::study::timings::record::Record;
use crate::study::timings::targets::COMPARED;

/// What a run costs: the axis, the number, and how it is told with its unit.
type Cost = (&'static str, fn(&Point) -> f64, fn(f64) -> String);

const COSTS: [Cost; 2] = [
    ("time from the scene to the pressures [s]", |point| point.seconds, milliseconds),
    ("counted operations [floating-point operations]", Point::operations, operations),
];

/// Truncated Hertz, whose answer is known, beside meshes fitted to the contact and codes on meshes of their own.
pub fn truncated(record: &Record) -> Result<Drawing, Error> {
    let mut charts = charts(record, &TRUNCATED);
    for (chart, measure) in charts.iter_mut().step_by(2).zip(Measure::ALL) {
        ours_fitted(chart, record, measure);
        others(chart, record, measure);
    }
    charts[0].notes.extend(notes(record));
    panels(&format!("What accuracy costs: truncated Hertz, worst error under {LOADS} loads"), &charts, 2)
}

/// The cylinder beside GetFEM and CalculiX.
pub fn cylinder(record: &Record) -> Result<Drawing, Error> {
    let mut charts = charts(record, &[Family::Cylinder]);
    for (k, measure) in Measure::ALL.into_iter().enumerate() {
        peers(&mut charts[2 * k], record, measure);
        for chart in &mut charts[2 * k..2 * k + 2] {
            let (at, label) = (100.0 * record.measured.floor[k], "answer ±".into());
            chart.guides.push(Guide { direction: Direction::Horizontal, at, label });
        }
    }
    charts[0].notes.push(
        "Errors are those against the converged answer of the same scene, known to within the line `answer ±`. GetFEM and CalculiX solve \
         on our meshes under the nominal load alone: no worst of several. What their seconds count:"
            .into(),
    );
    charts[0].notes.extend(counted(record));
    panels(&format!("What accuracy costs: cylinder, worst error under {LOADS} loads"), &charts, 2)
}

/// A row a quantity, a column a cost: ours, and what is cheapest.
fn charts(record: &Record, families: &[Family]) -> Vec<Chart> {
    let points = sound(&record.points, families);
    let chart = |measure: Measure, cost: Cost| ours(&points, measure, cost);
    Measure::ALL.into_iter().flat_map(|measure| COSTS.map(|cost| chart(measure, cost))).collect()
}

fn ours(points: &[&Point], measure: Measure, (axis, cost, told): Cost) -> Chart {
    let [median, worst] = [0, 1].map(|k| move |point: &Point| 100.0 * measure.errors(point)[k]);
    let y = Axis::log("worst relative error [%]");
    let mut chart = Chart::new(measure.name(), Axis::log(axis), y);
    for (element, colour) in Element::ALL.into_iter().zip(palette::CURVES) {
        let own = points.iter().filter(|point| point.formulation.element == element);
        let points = own.map(|point| (cost(point), worst(point))).collect();
        let style = Style::run(colour, Dash::Absent, Marker::Dot);
        chart.series.push(Series {
            label: format!("{} element, any algorithm and mesh", element.name()),
            points,
            style,
            hollow: vec![],
        });
    }
    let front = front(points, cost, &worst);
    let curve = front.iter().map(|point| (cost(point), worst(point))).collect();
    let style = Style::run(palette::INK, Dash::Solid, Marker::Absent);
    chart.series.push(Series {
        label: "Pareto front: none is cheaper and as exact".into(),
        points: curve,
        style,
        hollow: vec![],
    });
    let bar = |point: &&Point| [median(point), worst(point)].map(|error| (cost(point), error));
    chart.bars.push(spread(front.iter().map(bar).collect(), palette::INK));
    chart.guides.push(Guide { direction: Direction::Horizontal, at: 100.0 * COMPARED, label: percent() });
    if let Some(point) = within(&front, 100.0 * COMPARED, &worst) {
        chart.remarks.push(remark((cost(point), worst(point)), told(cost(point)), false, palette::INK));
    }
    chart
}

fn operations(count: f64) -> String {
    format!("{} million", significant(1e-6 * count, 2))
}

/// Codes that ran on our meshes under one load.
fn peers(chart: &mut Chart, record: &Record, measure: Measure) {
    let looks = [(Peer::GetFem, palette::PURPLE, Marker::Triangle), (Peer::CalculiX, palette::ORANGE, Marker::Wedge)];
    for (code, colour, marker) in looks {
        let own: Vec<&PeerPoint> = record.measured.peers.iter().filter(|point| point.code == code).collect();
        let error = |point: &PeerPoint| 100.0 * point.errors[measure as usize];
        let points = own.iter().map(|point| (point.seconds.median, error(point))).collect();
        let style = Style::run(colour, Dash::Absent, marker);
        chart.series.push(Series {
            label: format!("{}, one load, our meshes", code.name()),
            points,
            style,
            hollow: vec![],
        });
        let ends =
            own.iter().map(|point| [point.seconds.least, point.seconds.most].map(|seconds| (seconds, error(point))));
        chart.bars.push(Bars {
            label: "level bar: least to most of repeated runs".into(),
            ends: ends.collect(),
            colour,
        });
    }
}

/// What the seconds of each code on our meshes count, by its own account.
fn counted(record: &Record) -> Vec<String> {
    let mut told: Vec<String> = Vec::new();
    for peer in &record.measured.peers {
        let line = format!("{}: {}.", peer.code.name(), peer.counted);
        if !told.contains(&line) {
            told.push(line);
        }
    }
    told
}
