//! All charts of the record; what finer meshes pay.

use crate::error::Error;
use crate::figure::palette::{self, Dash, Marker, Style};
use crate::figure::{Axis, Chart, Drawing, Series, panels};
use crate::study::Found;
use crate::study::drawn::{label, style};
use crate::study::pairing::Pairing;
use crate::study::timings::growth_picture::growth;
use crate::study::timings::precision::{Family, LOADS, Point};
use crate::study::timings::precision_detail::detail;
use crate::study::timings::record::Record;
use crate::study::timings::run::{Numbers, record};
use crate::study::timings::targets::FASTEST;
use crate::study::timings::work_precision::{cylinder, truncated};

/// All charts of the record.
pub fn pictures(findings: &[Found<Numbers>]) -> Result<Vec<(String, Drawing)>, Error> {
    let record = record(findings)?;
    let mut charts = vec![
        ("work-precision.svg".into(), truncated(&record)?),
        ("work-precision-cylinder.svg".into(), cylinder(&record)?),
        ("work-precision-detail.svg".into(), detail(&record)?),
    ];
    charts.push(("what-pays.svg".into(), what_pays(&record)?));
    charts.push(("growth.svg".into(), growth(&record.measured.growth)?));
    Ok(charts)
}

/// Graded, steep and uniform meshes of 4-node and 8-node cells, and the three elements, by degrees of freedom and by seconds.
fn what_pays(record: &Record) -> Result<Drawing, Error> {
    let families = [
        (Family::Truncated, "graded", Dash::Solid),
        (Family::Steep, "steep", Dash::DashDot),
        (Family::Uniform, "uniform", Dash::Dashed),
    ];
    let cells = [(4, palette::ORANGE, Marker::Square), (8, palette::PURPLE, Marker::Circle)];
    let mut charts = Vec::new();
    let axes = [("degrees of freedom [–]", (|p| p.dofs as f64) as fn(&Point) -> f64), ("time [s]", |p| p.seconds)];
    for (axis, cost) in axes {
        let mut chart =
            Chart::new("Cells and grading, node", Axis::log(axis), Axis::log("larger error of p₀ and a [%]"));
        for (nodes, colour, marker) in cells {
            for (family, grading, dash) in families {
                let points = record.of_meshes(family, nodes, FASTEST);
                let style = Style::run(colour, dash, marker);
                chart.series.push(by(&points, cost, format!("{nodes}-node, {grading}"), style));
            }
        }
        charts.push(chart);
    }
    for (axis, cost) in axes {
        let mut chart =
            Chart::new("Elements, 8-node graded", Axis::log(axis), Axis::log("larger error of p₀ and a [%]"));
        for formulation in Family::Steep.formulations() {
            let points = record.of_meshes(Family::Truncated, 8, Pairing::of(&formulation));
            chart.series.push(by(&points, cost, label(&formulation), style(&formulation)));
        }
        charts.push(chart);
    }
    panels(&format!("What pays: truncated Hertz, kinematic load, median of {LOADS} loads"), &charts, 2)
}

fn by(points: &[&Point], cost: fn(&Point) -> f64, label: String, style: Style) -> Series {
    let points = points.iter().map(|point| (cost(point), 100.0 * point.error())).collect();
    Series { label, points, style, hollow: Vec::new() }
}
