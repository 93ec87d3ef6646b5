//! Error against seconds and work, and what finer meshes pay.

use crate::error::Error;
use crate::figure::palette::{self, Dash, Marker, Style};
use crate::figure::{Axis, Chart, Direction, Guide, Series, panels};
use crate::oracle::cross_code::Code;
use crate::study::Found;
use crate::study::drawn::{label, style};
use crate::study::pairing::Pairing;
use crate::study::timings::bar_cost_section;
use crate::study::timings::growth_picture::growth;
use crate::study::timings::others::{OtherPoint, Peer};
use crate::study::timings::precision::{Family, LOADS, Point};
use crate::study::timings::record::Record;
use crate::study::timings::run::{Numbers, recosted, record};
use crate::study::timings::targets::FASTEST;

/// What a run costs.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Cost {
    Seconds,
    Operations,
}

/// Charts with all nine formulations: scene, nodes of a cell, and their file names without the cost.
const NINE: [(Family, usize, &str); 4] = [
    (Family::Truncated, 8, "precision-truncated-8-node"),
    (Family::Truncated, 4, "precision-truncated-4-node"),
    (Family::Cylinder, 8, "precision-cylinder-8-node"),
    (Family::Cylinder, 4, "precision-cylinder-4-node"),
];

/// All charts of the record.
pub fn pictures(findings: &[Found<Numbers>]) -> Result<Vec<(String, String)>, Error> {
    let record = record(findings)?;
    let mut charts = Vec::new();
    for (family, nodes, file) in NINE {
        for (cost, name) in [(Cost::Seconds, "seconds"), (Cost::Operations, "work")] {
            charts.push((format!("{file}-{name}.svg"), precision(&record, family, nodes, cost)?));
        }
    }
    charts.push(("what-pays.svg".into(), what_pays(&record)?));
    charts.push(("growth.svg".into(), growth(&record.measured.growth)?));
    charts.push(("bars-cost.svg".into(), bar_cost_section::chart(recosted(findings)?)?));
    Ok(charts)
}

/// Quantities with their median and worst errors, ours and of other codes.
type Quantity = (&'static str, [fn(&Point) -> f64; 2], [fn(&OtherPoint) -> f64; 2]);

const QUANTITIES: [Quantity; 3] = [
    ("p₀", [|p| p.peak, |p| p.peak_worst], [|p| p.peak, |p| p.peak_worst]),
    ("a", [|p| p.half_width, |p| p.half_width_worst], [|p| p.half_width, |p| p.half_width_worst]),
    ("L2(p)", [|p| p.l2, |p| p.l2_worst], [|p| p.l2, |p| p.l2_worst]),
];

fn precision(record: &Record, family: Family, nodes: usize, cost: Cost) -> Result<String, Error> {
    let axis = if cost == Cost::Seconds { "seconds" } else { "operations" };
    let mut charts = Vec::new();
    for (row, (quantity, ours, theirs)) in QUANTITIES.into_iter().enumerate() {
        for (column, which) in ["median", "worst"].into_iter().enumerate() {
            let title = format!("{quantity}, {which} of {LOADS} loads");
            let mut chart = Chart::new(&title, Axis::log(axis), Axis::log("relative error"));
            for formulation in family.formulations() {
                let points = record.of_meshes(family, nodes, Pairing::of(&formulation));
                chart.series.push(curve(&points, cost, ours[column], label(&formulation), style(&formulation)));
            }
            if family == Family::Truncated && cost == Cost::Seconds {
                chart.series.extend(other_codes(record, theirs[column]));
            }
            if family == Family::Cylinder && nodes == 8 && cost == Cost::Seconds {
                chart.series.extend(peers(record, row));
            }
            if let (Family::Cylinder, Some(&floor)) = (family, record.measured.floor.get(row)) {
                chart.guides.push(Guide { direction: Direction::Horizontal, at: floor, label: "model".into() });
            }
            charts.push(chart);
        }
    }
    panels(&format!("{}, {nodes}-node cells: error against {axis}", family.name()), &charts, 2)
}

fn price(point: &Point, cost: Cost) -> f64 {
    if cost == Cost::Seconds { point.seconds } else { point.operations() }
}

fn curve(points: &[&Point], cost: Cost, error: fn(&Point) -> f64, label: String, style: Style) -> Series {
    let (sound, failed): (Vec<&&Point>, Vec<&&Point>) = points.iter().partition(|point| !error(point).is_nan());
    Series {
        label,
        points: sound.iter().map(|point| (price(point, cost), error(point))).collect(),
        style,
        hollow: failed.iter().map(|point| price(point, cost)).collect(),
    }
}

fn other_codes(record: &Record, error: fn(&OtherPoint) -> f64) -> Vec<Series> {
    let styles = [
        (Code::ScikitFem, Style::run(palette::PURPLE, Dash::DashDot, Marker::Triangle)),
        (Code::Dolfinx, Style::run(palette::ORANGE, Dash::DashDot, Marker::Wedge)),
    ];
    let of = |(code, style): (Code, Style)| {
        let own = record.measured.others.iter().filter(|point| point.code == code);
        let mut points: Vec<(f64, f64)> = own.map(|point| (point.seconds, error(point))).collect();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        Series { label: code.name().into(), points, style, hollow: Vec::new() }
    };
    styles.into_iter().map(of).collect()
}

/// Codes on our own meshes of the cylinder, under its nominal load; they give p₀ and a.
fn peers(record: &Record, quantity: usize) -> Vec<Series> {
    let styles = [
        (Peer::GetFem, Style::run(palette::PURPLE, Dash::DashDot, Marker::Triangle)),
        (Peer::CalculiX, Style::run(palette::ORANGE, Dash::DashDot, Marker::Wedge)),
    ];
    let of = |(code, style): (Peer, Style)| {
        let own = record.measured.peers.iter().filter(|point| point.code == code);
        let points = own.filter_map(|point| Some((point.seconds.median, *point.errors.get(quantity)?))).collect();
        Series { label: code.name().into(), points, style, hollow: Vec::new() }
    };
    styles.into_iter().map(of).filter(|series| !series.points.is_empty()).collect()
}

/// Graded, steep and uniform meshes of 4-node and 8-node cells, and the three elements, by degrees of freedom and by seconds.
fn what_pays(record: &Record) -> Result<String, Error> {
    let families = [
        (Family::Truncated, "graded", Dash::Solid),
        (Family::Steep, "steep", Dash::DashDot),
        (Family::Uniform, "uniform", Dash::Dashed),
    ];
    let cells = [(4, palette::ORANGE, Marker::Square), (8, palette::PURPLE, Marker::Circle)];
    let mut charts = Vec::new();
    let axes = [("degrees of freedom", (|p| p.dofs as f64) as fn(&Point) -> f64), ("seconds", |p| p.seconds)];
    for (axis, cost) in axes {
        let mut chart = Chart::new("Cells and grading, node", Axis::log(axis), Axis::log("larger error of p₀ and a"));
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
        let mut chart = Chart::new("Elements, 8-node graded", Axis::log(axis), Axis::log("larger error of p₀ and a"));
        for formulation in Family::Steep.formulations() {
            let points = record.of_meshes(Family::Truncated, 8, Pairing::of(&formulation));
            chart.series.push(by(&points, cost, label(&formulation), style(&formulation)));
        }
        charts.push(chart);
    }
    panels(&format!("What pays: truncated Hertz, kinematic load, median of {LOADS} loads"), &charts, 2)
}

fn by(points: &[&Point], cost: fn(&Point) -> f64, label: String, style: Style) -> Series {
    let points = points.iter().map(|point| (cost(point), point.error())).collect();
    Series { label, points, style, hollow: Vec::new() }
}
