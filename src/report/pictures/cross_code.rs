//! Profiles of all codes, and their differences to the closed form on a scale where they can be seen.

use super::{curve, of_picture, with};
use crate::error::Error;
use crate::figure::palette::{self, Dash, Marker, Style};
use crate::figure::{Axis, Chart, panels};
use crate::study::cross_code::shown::PROFILES;
use crate::study::unsorted::Finding;

/// Scene, axis of the contact coordinate, unit of pressure, and the closed form's name.
type Panel = (&'static str, &'static str, &'static str);

const HERTZ: [Panel; 2] = [("truncated Hertz", "x / a", "p₀"), ("cylinder, a/R = 0.05", "x / a", "p₀")];
const PINS: [Panel; 2] =
    [("pin in plate", "φ from the load line [°]", "F/(R t)"), ("pin-rod", "θ from the load line [°]", "F/(R t)")];

/// Pressure of every code in four scenes.
pub fn pressure(findings: &[Finding]) -> Result<String, Error> {
    let scenes = HERTZ.into_iter().chain(PINS);
    let charts: Vec<Chart> =
        scenes.map(|(scene, x, unit)| chart(findings, PROFILES[0], scene, x, &format!("p over {unit}"))).collect();
    panels("The same physical problem in three codes", &charts, 2)
}

/// Difference of every code to the closed form.
pub fn difference(findings: &[Finding]) -> Result<String, Error> {
    let scenes = HERTZ.into_iter().chain([PINS[0]]);
    let charts: Vec<Chart> = scenes
        .map(|(scene, x, unit)| chart(findings, PROFILES[1], scene, x, &format!("difference [% of {unit}]")))
        .collect();
    panels("Difference of each code to the closed form (Hertz, Hertz, Persson)", &charts, 3)
}

fn chart(findings: &[Finding], picture: &str, scene: &str, x: &str, y: &str) -> Chart {
    let name = format!("{picture}{scene}");
    let curves = of_picture(findings, &name).map(|series| {
        let style = match series.label.as_str() {
            "ours" => Style::run(palette::NODE, Dash::Solid, Marker::Absent),
            "scikit-fem" => Style::run(palette::LINE, Dash::Dashed, Marker::Circle),
            "dolfinx" => Style::run(palette::LAYER, Dash::Dotted, Marker::Square),
            label if label.starts_with("scikit-fem") => Style::run(palette::PURPLE, Dash::DashDot, Marker::Diamond),
            _ => Style::reference(),
        };
        let label = if style.dash == Dash::Long { "closed form".into() } else { series.label.clone() };
        curve(series, label, style)
    });
    with(Chart::new(scene, Axis::linear(x), Axis::linear(y)), curves.collect())
}
