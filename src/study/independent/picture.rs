//! Differences of the profiles of independent codes to ours.

use crate::error::Error;
use crate::figure::palette::{self, Dash, Marker, Style};
use crate::figure::{Axis, Chart, Drawing, panels};
use crate::oracle::cross_code::independent::Script;
use crate::study::Found;
use crate::study::drawn::Curve;
use crate::study::independent::benchmark::Scene;
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
        let points = points(compared, &differences);
        Curve { points, failed: Vec::new() }.drawn(other.script.name(), style(other.script))
    }));
    chart
}

/// What profiles are drawn against.
fn abscissa(scene: Scene) -> &'static str {
    match scene {
        Scene::Cylinder | Scene::WiderCylinder | Scene::TruncatedHertz => "place over half-width x / a [–]",
        Scene::PinRod => "θ from the load line [°]",
        Scene::PinPlate => "φ from the load line [°]",
    }
}

/// What pressures are drawn over.
fn unit(scene: Scene) -> &'static str {
    if scene.is_arc() { "F/(R t)" } else { "p₀" }
}

/// Differences in per cent of what the scene is measured by.
fn points(compared: &Compared, differences: &[f64]) -> Vec<[f64; 2]> {
    let [length, pressure] = compared.reference;
    let scale = if compared.scene.is_arc() { 180.0 / std::f64::consts::PI } else { 1.0 / length };
    compared.stations.iter().zip(differences).map(|(s, p)| [scale * s, 100.0 * p / pressure]).collect()
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
