//! Profiles of all codes, and their differences to the closed form on a scale where they can be seen.

use crate::error::Error;
use crate::figure::palette::{self, Dash, Marker, Style};
use crate::figure::{Axis, Chart, Drawing, Ribbon, panels};
use crate::oracle::cross_code::{Code, Method};
use crate::study::Found;
use crate::study::cross_code::Numbers;
use crate::study::cross_code::benchmark::Scene;
use crate::study::cross_code::physical::{Compared, Finder};
use crate::study::drawn::Curve;

/// Scenes that are drawn.
const SCENES: [Scene; 4] = [Scene::TruncatedHertz, Scene::Cylinder, Scene::PinPlate, Scene::PinRod];

/// The band of all codes, and the difference of each to the closed form, or to ours where there is none.
pub fn pictures(findings: &[Found<Numbers>]) -> Result<Vec<(String, Drawing)>, Error> {
    let all = || findings.iter().filter_map(|found| found.numbers.physical());
    let drawn: Vec<&Compared> = SCENES.iter().filter_map(|&scene| all().find(|one| one.scene == scene)).collect();
    let pressures: Vec<Chart> = drawn.iter().map(|compared| pressure(compared)).collect();
    let differences: Vec<Chart> = drawn.iter().map(|compared| difference(compared)).collect();
    let closed: Vec<&str> =
        drawn.iter().filter_map(|one| one.closed_form.as_ref()).map(|exact| exact.name.as_str()).collect();
    let against = format!("Difference of each code to the closed form ({}), or to ours", closed.join(", "));
    Ok(vec![
        (
            "pressure-cross-code.svg".into(),
            panels("The same physical problem: ours and the assembly twin", &pressures, 2)?,
        ),
        ("difference-cross-code.svg".into(), panels(&against, &differences, 2)?),
    ])
}

/// The band of all codes over the closed form, or over ours where there is none.
fn pressure(compared: &Compared) -> Chart {
    let mut chart = chart(compared, &format!("pressure p over {} [–]", unit(compared.scene)));
    let all: Vec<Vec<[f64; 2]>> = compared.all().map(|found| drawn(compared, &found.profile, 1.0)).collect();
    let at = |k: usize| {
        let pressures = all.iter().map(|profile| profile[k][1]);
        let [least, most] = pressures.fold([f64::NAN; 2], |[least, most], p| [p.min(least), p.max(most)]);
        [all[0][k][0], least, most]
    };
    let shared = all.iter().map(Vec::len).min().unwrap_or(0);
    let label = "all codes: least to most".into();
    chart.ribbons.push(Ribbon { label, points: (0..shared).map(at).collect(), colour: palette::GREY });
    let (name, profile) = reference(compared);
    let points = drawn(compared, profile, 1.0);
    chart.series.push(Curve { points, failed: Vec::new() }.drawn(name, Style::reference()));
    chart
}

/// What profiles are held against: the closed form, or ours where there is none.
fn reference(compared: &Compared) -> (&'static str, &[f64]) {
    match &compared.closed_form {
        Some(exact) => ("closed form", &exact.profile),
        None => ("ours, where there is no closed form", &compared.ours.profile),
    }
}

fn difference(compared: &Compared) -> Chart {
    let (_, reference) = reference(compared);
    let mut chart = chart(compared, &format!("difference [% of {}]", unit(compared.scene)));
    chart.series.extend(compared.all().map(|found| {
        let differences: Vec<f64> = found.profile.iter().zip(reference).map(|(p, q)| p - q).collect();
        let points = drawn(compared, &differences, 100.0);
        Curve { points, failed: Vec::new() }.drawn(found.by.to_string(), style(found.by))
    }));
    chart
}

fn drawn(compared: &Compared, profile: &[f64], factor: f64) -> Vec<[f64; 2]> {
    points(compared.scene, compared.reference, &compared.stations, profile, factor)
}

fn chart(compared: &Compared, y: &str) -> Chart {
    Chart::new(compared.scene.name(), Axis::linear(abscissa(compared.scene)), Axis::linear(y))
}

/// What profiles are drawn against.
pub fn abscissa(scene: Scene) -> &'static str {
    match scene {
        Scene::Cylinder | Scene::WiderCylinder | Scene::TruncatedHertz => "place over half-width x / a [–]",
        Scene::PinRod => "θ from the load line [°]",
        Scene::PinPlate => "φ from the load line [°]",
    }
}

/// What pressures are drawn over.
pub fn unit(scene: Scene) -> &'static str {
    if scene.is_arc() { "F/(R t)" } else { "p₀" }
}

/// A profile over what its scene is measured by, times a factor.
pub fn points(
    scene: Scene,
    [length, pressure]: [f64; 2],
    stations: &[f64],
    profile: &[f64],
    factor: f64,
) -> Vec<[f64; 2]> {
    let scale = if scene.is_arc() { 180.0 / std::f64::consts::PI } else { 1.0 / length };
    stations.iter().zip(profile).map(|(s, p)| [scale * s, factor * p / pressure]).collect()
}

fn style(by: Finder) -> Style {
    match by {
        Finder::Ours | Finder::Independent(_) => Style::run(palette::NODE, Dash::Solid, Marker::Absent),
        Finder::Theirs(Code::ScikitFem, Method::Penalty) => Style::run(palette::LINE, Dash::Dashed, Marker::Circle),
        Finder::Theirs(Code::Dolfinx, _) => Style::run(palette::LAYER, Dash::Dotted, Marker::Square),
        Finder::Theirs(_, Method::ActiveSet) => Style::run(palette::PURPLE, Dash::DashDot, Marker::Diamond),
    }
}
