//! Differences of the profiles of independent codes to ours.

use crate::error::Error;
use crate::figure::palette::{self, Dash, Marker, Style};
use crate::figure::{Axis, Chart, Drawing, panels};
use crate::oracle::cross_code::independent::Script;
use crate::study::Found;
use crate::study::cross_code::picture::{abscissa, points, unit};
use crate::study::drawn::Curve;
use crate::study::independent::run::Compared;

/// One panel a scene.
pub fn pictures(findings: &[Found<Compared>]) -> Result<Vec<(String, Drawing)>, Error> {
    let charts: Vec<Chart> = findings.iter().map(|found| difference(found.numbers)).collect();
    Ok(vec![(
        "difference-independent.svg".into(),
        panels("Independent codes: difference of the pressure to ours", &charts, 3)?,
    )])
}

fn difference(compared: &Compared) -> Chart {
    let axis = Axis::linear(&format!("difference [% of {}]", unit(compared.scene)));
    let mut chart = Chart::new(compared.scene.name(), Axis::linear(abscissa(compared.scene)), axis);
    chart.series.extend(compared.others.iter().map(|other| {
        let differences: Vec<f64> =
            other.found.profile.iter().zip(&compared.ours.profile).map(|(p, q)| p - q).collect();
        let points = points(compared.scene, compared.reference, &compared.stations, &differences, 100.0);
        Curve { points, failed: Vec::new() }.drawn(other.script.name(), style(other.script))
    }));
    chart
}

fn style(script: Script) -> Style {
    match script {
        Script::Ufl => Style::run(palette::LAYER, Dash::Dotted, Marker::Square),
        Script::Facets => Style::run(palette::LINE, Dash::Dashed, Marker::Circle),
        Script::Nitsche => Style::run(palette::PURPLE, Dash::DashDot, Marker::Diamond),
        Script::HalfPlane => Style::run(palette::NODE, Dash::Solid, Marker::Triangle),
        Script::Augmented => Style::run(palette::ORANGE, Dash::Solid, Marker::Wedge),
        Script::Gaps => Style::run(palette::LAYER, Dash::Dashed, Marker::Triangle),
    }
}
