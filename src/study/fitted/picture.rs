//! Error over degrees of freedom: fitted cells of high order, what an accuracy chooses, and 8-node cells.

use crate::error::Error;
use crate::figure::palette::{self, Dash, Marker, Style};
use crate::figure::{Axis, Chart, Drawing, Series};
use crate::study::Found;
use crate::study::drawn::Curve;
use crate::study::fitted::run::{Mesh, Numbers};

/// File of the chart.
pub const FILE: &str = "fitted.svg";

/// The chart.
pub fn pictures(findings: &[Found<Numbers>]) -> Result<Vec<(String, Drawing)>, Error> {
    let mut chart = Chart::new(
        "Truncated Hertz: what accuracy costs",
        Axis::log("degrees of freedom [–]"),
        Axis::log("larger relative error of p₀ and a [–]"),
    );
    let fitted = Style::run(palette::PURPLE, Dash::Solid, Marker::Circle);
    let chosen = Style::run(palette::ORANGE, Dash::DashDot, Marker::Diamond);
    let plain = Style::run(palette::NODE, Dash::Dashed, Marker::Square);
    for Found { numbers, .. } in findings {
        chart.series.push(curve("order 4 to 8, fitted to the contact", &numbers.fitted, fitted));
        chart.series.push(curve("chosen by --accuracy", &numbers.chosen, chosen));
        chart.series.push(curve("8-node cells, as fine on all candidates", &numbers.plain, plain));
    }
    Ok(vec![(FILE.into(), chart.drawing()?)])
}

fn curve(label: &str, meshes: &[Mesh], style: Style) -> Series {
    let points = meshes.iter().map(|mesh| [mesh.dofs as f64, mesh.error()]).collect();
    Curve { points, failed: Vec::new() }.drawn(label, style)
}
