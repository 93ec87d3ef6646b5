//! The worst error of p₀ and a under all loads against seconds and counted work, with what is cheapest for an error.

use crate::drawing::palette::{self, Dash, Marker, Style};
use crate::drawing::{self, Axis, Bars, Chart, Colour, Direction, Drawing, Guide, Remark, panels};
use crate::markdown::significant;
use crate::solve::Element;
use crate::study::timings::others::cells;
use crate::study::timings::pareto::{Measure, cheapest, front, sound};
use crate::study::timings::precision::{LOADS, Point};
use crate::study::timings::record::Record;
use crate::study::timings::section::{beside, conclusion, milliseconds, percent};
use crate::study::timings::series::Series;
use crate::study::timings::targets::COMPARED;

/// What a run costs: the axis, the number, and how it is told with its unit.
type Cost = (&'static str, fn(&Point) -> f64, fn(f64) -> String);

const SECONDS: Cost = ("time from the scene to the pressures [s]", |point| point.seconds, milliseconds);
const OPERATIONS: Cost = (
    "counted operations [floating-point operations]",
    |point| point.operations,
    |count| format!("{} million", significant(1e-6 * count, 2)),
);

/// Truncated Hertz, whose answer is known, beside meshes fitted to the contact and codes on meshes of their own.
pub fn chart(record: &Record) -> Drawing {
    let mut charts = charts(record);
    for (chart, measure) in charts.iter_mut().step_by(2).zip(Measure::ALL) {
        let style = Style::run(palette::INK, Dash::Dashed, Marker::Square);
        let label = "node element, high order, fitted to the contact it finds".into();
        curve(chart, label, style, record.of(Series::Fitted).collect(), SECONDS, measure);
        others(chart, record, measure);
    }
    charts[0].notes.extend(std::iter::once(conclusion(record)).chain(beside(record)));
    panels(&format!("What accuracy costs: truncated Hertz, worst error under {LOADS} loads"), &charts, 2)
}

/// A row a quantity, a column a cost: ours, and what is cheapest.
fn charts(record: &Record) -> Vec<Chart> {
    let points = sound(&record.points);
    let both = |measure: Measure| [SECONDS, OPERATIONS].map(|cost| ours(&points, measure, cost));
    Measure::ALL.into_iter().flat_map(both).collect()
}

fn ours(points: &[&Point], measure: Measure, cost: Cost) -> Chart {
    let (axis, value, _) = cost;
    let worst = |point: &Point| measure.errors(point)[1];
    let mut chart = Chart::new(measure.name(), Axis::log(axis), Axis::log("worst relative error [%]"));
    for (element, colour) in Element::ALL.into_iter().zip(palette::CURVES) {
        let own = points.iter().filter(|point| point.formulation.is_some_and(|own| own.element == element));
        chart.series.push(drawing::Series {
            label: format!("{} element, any algorithm and mesh", element.name()),
            points: own.map(|point| (value(point), 100.0 * worst(point))).collect(),
            style: Style::run(colour, Dash::Absent, Marker::Dot),
            hollow: vec![],
        });
    }
    let label = "Pareto front: none is cheaper and as exact".into();
    let style = Style::run(palette::INK, Dash::Solid, Marker::Absent);
    curve(&mut chart, label, style, front(points, value, &worst), cost, measure);
    chart.guides.push(Guide { direction: Direction::Horizontal, at: 100.0 * COMPARED, label: percent() });
    remark(&mut chart, points.iter().copied(), cost, measure, false, palette::INK);
    chart
}

/// A curve through the worst errors of some points, with bars from their medians; nothing where there is no point.
fn curve(
    chart: &mut Chart,
    label: String,
    style: Style,
    mut points: Vec<&Point>,
    (_, cost, _): Cost,
    measure: Measure,
) {
    if points.is_empty() {
        return;
    }
    points.sort_by(|a, b| cost(a).total_cmp(&cost(b)));
    let ends: Vec<_> =
        points.iter().map(|point| measure.errors(point).map(|error| (cost(point), 100.0 * error))).collect();
    let worst = ends.iter().map(|[_, worst]| *worst).collect();
    chart.series.push(drawing::Series { label, points: worst, style, hollow: vec![] });
    let label = format!("upright bar: median to worst of {LOADS} loads");
    chart.bars.push(Bars { label, ends, colour: style.colour });
}

/// What the cheapest of some points within the compared error costs.
fn remark<'a>(
    chart: &mut Chart,
    points: impl IntoIterator<Item = &'a Point>,
    (_, cost, told): Cost,
    measure: Measure,
    right: bool,
    colour: Colour,
) {
    let worst = |point: &Point| measure.errors(point)[1];
    if let Some(point) = cheapest(points, cost, worst, COMPARED) {
        let label = format!("cheapest within {}", percent());
        let (at, text) = ((cost(point), 100.0 * worst(point)), told(cost(point)));
        chart.remarks.push(Remark { at, text, right, label, colour });
    }
}

/// Codes that ran under all loads, on meshes of their own.
fn others(chart: &mut Chart, record: &Record, measure: Measure) {
    let looks = [
        (Series::ScikitFem, palette::PURPLE, Marker::Triangle),
        (Series::Dolfinx, palette::ORANGE, Marker::Wedge),
        (Series::Ngsolve, palette::SKY, Marker::Diamond),
    ];
    for (code, colour, marker) in looks {
        let (label, style) = (format!("{}, {}", code.name(), cells(code)), Style::run(colour, Dash::DashDot, marker));
        curve(chart, label, style, record.of(code).collect(), SECONDS, measure);
        remark(chart, record.of(code), SECONDS, measure, code != Series::ScikitFem, colour);
    }
}
