//! Error against seconds of all nine formulations, one panel a scene, kind of cells and quantity.

use crate::error::Error;
use crate::figure::{Axis, Chart, Direction, Drawing, Guide, Series, Style, panels};
use crate::study::drawn::{label, style};
use crate::study::pairing::Pairing;
use crate::study::timings::pareto::Measure;
use crate::study::timings::precision::{Family, LOADS, Point};
use crate::study::timings::record::Record;
use crate::study::timings::targets::COMPARED;

/// The chart.
pub fn detail(record: &Record) -> Result<Drawing, Error> {
    let rows = [Family::Truncated, Family::Cylinder].into_iter().flat_map(|family| [(family, 8), (family, 4)]);
    let charts: Vec<Chart> =
        rows.flat_map(|(family, nodes)| Measure::ALL.map(|measure| panel(record, family, nodes, measure))).collect();
    panels(&format!("Worst error under {LOADS} loads against time, by formulation"), &charts, 2)
}

fn panel(record: &Record, family: Family, nodes: usize, measure: Measure) -> Chart {
    let title = format!("{}, {nodes}-node: {}", family.name(), measure.name());
    let x = Axis::log("time from the scene to the pressures [s]");
    let mut chart = Chart::new(&title, x, Axis::log("worst relative error [%]"));
    for formulation in family.formulations() {
        let points = record.of_meshes(family, nodes, Pairing::of(&formulation));
        chart.series.push(curve(&points, measure, label(&formulation), style(&formulation)));
    }
    chart.guides.push(Guide {
        direction: Direction::Horizontal,
        at: 100.0 * COMPARED,
        label: format!("{} %", 100.0 * COMPARED),
    });
    chart
}

fn curve(points: &[&Point], measure: Measure, label: String, style: Style) -> Series {
    let worst = |point: &Point| 100.0 * measure.errors(point)[1];
    let (sound, failed): (Vec<&&Point>, Vec<&&Point>) = points.iter().partition(|point| worst(point).is_finite());
    Series {
        label,
        points: sound.iter().map(|point| (point.seconds, worst(point))).collect(),
        style,
        hollow: failed.iter().map(|point| point.seconds).collect(),
    }
}
