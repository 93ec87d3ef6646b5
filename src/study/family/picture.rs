//! Pressure and angle against the dimensionless clearance.

use crate::error::Error;
use crate::figure::palette::{self, Dash, Marker, Style};
use crate::figure::{Axis, Chart, Drawing, panels};
use crate::study::Found;
use crate::study::drawn::Curve;
use crate::study::family::run::{Curves, Ended, Line, Numbers, Placed};
use crate::study::family::section::named;

/// Ends of the axis of clearances; what has none stands on its left end.
const LEAST: f64 = 0.25;
const MOST: f64 = 60.0;

/// The chart.
pub fn pictures(findings: &[Found<Numbers>]) -> Result<Vec<(String, Drawing)>, Error> {
    let all: Vec<&Curves> = findings.iter().filter_map(|found| curves(found.numbers)).collect();
    let chart = |title: &str, axis: &str, of: fn(Placed) -> f64| {
        let mut chart = Chart::new(title, Axis::log("clearance E t c / F [–]").over(LEAST, MOST), Axis::linear(axis));
        for curves in &all {
            chart.series.extend(named(curves).zip(styles()).map(|((name, line), style)| {
                let points = curves.clearances.iter().zip(&line.ended);
                let points = points.map(|(clearance, ended)| [*clearance, of(ended.placed())]).collect();
                Curve { points, failed: failed(curves, line) }.drawn(name, style)
            }));
        }
        if chart
            .series
            .iter()
            .flat_map(|series| &series.points)
            .any(|(clearance, value)| *clearance <= 0.0 && value.is_finite())
        {
            chart.notes.push("The points on the left rim have no clearance.".into());
        }
        chart
    };
    let charts = [
        chart("family: pressure", "peak pressure R t p_max / F [–]", |placed| placed.pressure),
        chart("family: angle", "angle 2 √(∫pθ²/∫p) [°]", |placed| placed.angle.to_degrees()),
    ];
    Ok(vec![("family-pin-rod.svg".into(), panels("Pin–rod: the dimensionless family", &charts, 2)?)])
}

fn curves(numbers: &Numbers) -> Option<&Curves> {
    match numbers {
        Numbers::Curves(curves) => Some(curves),
        Numbers::Sensitivities(_) => None,
    }
}

/// Clearances of iterations that did not converge; a contact beyond the quarter is refused, and no point of the family.
fn failed(curves: &Curves, line: &Line) -> Vec<f64> {
    let all = curves.clearances.iter().zip(&line.ended);
    all.filter(|(_, ended)| matches!(ended, Ended::NotConverged)).map(|(clearance, _)| *clearance).collect()
}

/// Eyes solid, shanks dashed.
fn styles() -> impl Iterator<Item = Style> {
    [(Dash::Solid, Marker::Circle), (Dash::Dashed, Marker::Square)].into_iter().flat_map(|(dash, marker)| {
        [palette::LINE, palette::NODE, palette::LAYER].map(|colour| Style::run(colour, dash, marker))
    })
}
