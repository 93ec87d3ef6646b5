//! What the page shows of the independent scripts.

use std::fmt::Write;

use crate::drawing::palette::{self, Dash, Marker, Style};
use crate::drawing::{Axis, Chart, Drawing, panels};
use crate::error::Error;
use crate::markdown::{self, Column};
use crate::oracle::cross_code::independent::{Folder, Independent, Script};
use crate::study::Found;
use crate::study::drawn::{Curve, picture};
use crate::study::independent::benchmark::Scene;
use crate::study::independent::found::{Measured, Number};
use crate::study::independent::judge::against;
use crate::study::independent::run::{Compared, Other};
use crate::uncertainty::{COVERAGE, Comparison};

/// The scripts, and their numbers beside ours.
pub fn section(findings: &[Found<Compared>]) -> Result<String, Error> {
    let frozen = Independent::read()?;
    let mut text = String::new();
    for folder in Folder::ALL {
        let hash: String = frozen.scripts.get(&folder).map_or("", String::as_str).chars().take(12).collect();
        let version = frozen.apart.get(&folder).or_else(|| frozen.versions.get(folder.name()));
        let live = if folder.is_set_up() { "asked again by the tests" } else { "asked when the answers were frozen" };
        let _ = writeln!(text, "* {} {}: script {hash}…, {live}.", folder.name(), version.map_or("", String::as_str));
    }
    let _ = write!(
        text,
        "\nEach script has its own mesh, its own contact terms in the language of its code, its own iteration and its own measures; none imports \
         from another. They share the numbers of the scene and the names of what is asked. ± is the standard uncertainty from three meshes; \
         |E| shall be at most {COVERAGE} u_val, of both meshes and of the script's penalty (what springs of its stiffness change on our mesh).\n\n{}\n",
        numbers(findings)
    );
    text += &picture("difference-independent.svg", "Difference of the profiles of independent codes to ours");
    Ok(text)
}

/// A number of a scene by a script.
type Line<'a> = (&'a Compared, Number, &'a Other);

/// All numbers, a row a script.
fn numbers(findings: &[Found<Compared>]) -> String {
    let rows: Vec<Line> = findings
        .iter()
        .flat_map(|found| Number::ALL.map(|number| (found.numbers, number)))
        .flat_map(|(compared, number)| compared.others.iter().map(move |other| (compared, number, other)))
        .collect();
    markdown::columns(&columns(), &rows)
}

fn columns<'a>() -> [Column<Line<'a>>; 10] {
    [
        ("case", |(compared, ..)| compared.scene.name().into()),
        ("quantity", |(compared, number, _)| match number {
            Number::Peak => "peak [MPa]".into(),
            Number::Width => number.unit(compared.scene).into(),
        }),
        ("ours ± u", |(compared, number, _)| quoted(number.of(compared.scene, &compared.ours))),
        ("code", |(.., other)| format!("{} ({} dofs)", other.script, other.found.dofs)),
        ("found ± u", |line| quoted(theirs(line))),
        ("E = ours − theirs", |line| {
            format!("{} %", markdown::signed(100.0 * difference(line).error / theirs(line).value.abs(), 2))
        }),
        ("u_val", |line| percent(difference(line).uncertainty / theirs(line).value.abs())),
        ("|E| / u_val", |line| format!("{:.2}", difference(line).ratio())),
        ("", |line| if difference(line).ratio() <= COVERAGE { "✓" } else { "✗" }.into()),
        ("to the closed form", |line| {
            let (compared, number, _) = line;
            compared.closed_form.map_or("–".into(), |exact| {
                let exact = number.per_unit(compared.scene) * exact[*number as usize];
                format!("{} %", markdown::signed(100.0 * (theirs(line).value / exact - 1.0), 2))
            })
        }),
    ]
}

fn theirs((compared, number, other): &Line) -> Measured {
    number.of(compared.scene, &other.found)
}

fn difference((compared, number, other): &Line) -> Comparison {
    against(compared, other, *number)
}

fn percent(share: f64) -> String {
    format!("{} %", markdown::significant(100.0 * share, 2))
}

fn quoted(of: Measured) -> String {
    format!("{:.5} ± {}", of.value, percent(of.uncertainty / of.value.abs()))
}

/// One panel a scene.
pub fn pictures(findings: &[Found<Compared>]) -> Result<Vec<(String, Drawing)>, Error> {
    let charts: Vec<Chart> = findings.iter().map(|found| profiles(found.numbers)).collect();
    Ok(vec![(
        "difference-independent.svg".into(),
        panels("Independent codes: difference of the pressure to ours", &charts, 3),
    )])
}

/// Differences of the profiles to ours.
fn profiles(compared: &Compared) -> Chart {
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
