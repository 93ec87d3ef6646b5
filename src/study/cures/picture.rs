//! The chart: iterations against initial stiffness, plain and accelerated.

use crate::algorithm::Acceleration;
use crate::error::Error;
use crate::figure::palette::{self, Dash, Marker, Style};
use crate::figure::{Axis, Chart, Drawing, panels};
use crate::study::Found;
use crate::study::cures::record::{DRAWN, Runs, stiffnesses};
use crate::study::cures::run::{Numbers, Reach};
use crate::study::drawn::Curve;

/// File name of the chart.
pub(super) const FILE: &str = "cures.svg";
/// Its title.
pub(super) const TITLE: &str = "Iterations of constant stiffness, plain and accelerated";

/// One panel per element.
pub fn pictures(findings: &[Found<Numbers>]) -> Result<Vec<(String, Drawing)>, Error> {
    let charts: Vec<Chart> = reaches(findings).map(|reach| panel(&reach.recorded)).collect();
    Ok(vec![(FILE.into(), panels(TITLE, &charts, 3)?)])
}

/// The trials of reach, in the order of the elements.
pub(super) fn reaches<'a>(findings: &'a [Found<'a, Numbers>]) -> impl Iterator<Item = &'a Reach> {
    findings.iter().filter_map(|found| match found.numbers {
        Numbers::Reach(reach) => Some(reach),
        Numbers::Rules(_) | Numbers::Nested(_) => None,
    })
}

/// What an acceleration is called in charts and tables.
pub(super) fn called(acceleration: Acceleration) -> &'static str {
    match acceleration {
        Acceleration::None => "plain",
        Acceleration::CrossedSecant => "crossed secant",
        Acceleration::Anderson => "Anderson",
        Acceleration::Newton => "Newton",
    }
}

fn panel(recorded: &[Runs]) -> Chart {
    let element = recorded.first().map_or("", |runs| runs.element.name());
    let mut chart = Chart::new(
        element,
        Axis::log("initial stiffness κ₀ [–]").over(1e-3, 1e3),
        Axis::log("iterations [–]").over(5.0, 200.0),
    );
    chart.series = recorded.iter().map(|runs| curve(runs).drawn(called(runs.acceleration), style(runs))).collect();
    chart
}

fn style(runs: &Runs) -> Style {
    match runs.acceleration {
        Acceleration::None => Style::run(palette::INK, Dash::Dashed, Marker::Square),
        Acceleration::CrossedSecant => Style::run(palette::ORANGE, Dash::DashDot, Marker::Triangle),
        Acceleration::Anderson | Acceleration::Newton => Style::run(palette::SKY, Dash::Solid, Marker::Circle),
    }
}

/// Iterations to the default tolerance against initial stiffness on the drawn plane.
fn curve(runs: &Runs) -> Curve {
    let mut curve = Curve::default();
    for (stiffness, iterations) in stiffnesses().into_iter().zip(&runs.iterations[0][DRAWN]) {
        match iterations {
            Some(iterations) => curve.points.push([stiffness, *iterations as f64]),
            None => curve.failed.push(stiffness),
        }
    }
    curve
}
