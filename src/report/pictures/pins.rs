//! Hoop stress and displacement along the pin (Fig. 15), and the dimensionless family.

use super::{curve, of_picture, with};
use crate::error::Error;
use crate::figure::palette::{self, Dash, Marker, Style};
use crate::figure::{Axis, Band, Chart, Direction, panels};
use crate::study::pictures;
use crate::study::unsorted::Finding;

/// Hoop stress and normal displacement along the arcs of pin and rod.
pub fn along(findings: &[Finding]) -> Result<String, Error> {
    let name = pictures::field("pin-rod");
    let own: Vec<Finding> = findings.iter().filter(|finding| finding.case == name).cloned().collect();
    let chart = |picture: &str, axis: &str| {
        let angle = Axis::linear("θ from the load line [°]").over(0.0, 90.0);
        let curves = of_picture(&own, picture).enumerate().map(|(k, series)| {
            let colour = [palette::NODE, palette::PURPLE][k % 2];
            curve(series, series.label.clone(), Style::run(colour, [Dash::Solid, Dash::Dashed][k % 2], Marker::Absent))
        });
        let mut chart = with(Chart::new(picture, angle, Axis::linear(axis)), curves.collect());
        let label = "Gaertner 1977: not at hand".into();
        chart.bands.push(Band { direction: Direction::Vertical, from: 76.0, to: 89.0, label });
        chart
    };
    let charts = [chart("hoop stress", "σ_θθ [MPa]"), chart("normal displacement", "u_n, outward [mm]")];
    panels("Pin and rod along their contact arcs, node element with kinematic load", &charts, 2)
}

/// Pressure and angle against dimensionless clearance.
pub fn family(findings: &[Finding]) -> Result<String, Error> {
    let colours = [palette::LINE, palette::NODE, palette::LAYER];
    let chart = |picture: &str, axis: &str| {
        let curves = of_picture(findings, picture).enumerate().map(|(k, series)| {
            let (dash, marker) = if k < 3 { (Dash::Solid, Marker::Circle) } else { (Dash::Dashed, Marker::Square) };
            curve(series, series.label.clone(), Style::run(colours[k % 3], dash, marker))
        });
        with(Chart::new(picture, Axis::linear("E t c / F"), Axis::linear(axis)), curves.collect())
    };
    let charts = [chart("family: pressure", "R t p_max / F"), chart("family: angle", "2 √(∫pθ²/∫p) [°]")];
    panels("Pin–rod: the dimensionless family", &charts, 2)
}
