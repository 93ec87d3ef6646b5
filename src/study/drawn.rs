//! How formulations are drawn everywhere: colour = element, dash = algorithm; and what a page's picture is called.

use crate::figure::Series;
use crate::figure::palette::{self, Dash, Marker, Style};
use crate::solve::{Formulation, Iteration};

/// Points of a curve, and the abscissae of runs that did not converge.
#[derive(Clone, Debug, Default, serde::Serialize)]
pub struct Curve {
    /// Points.
    pub points: Vec<[f64; 2]>,
    /// Abscissae without a converged run.
    pub failed: Vec<f64>,
}

impl Curve {
    /// The curve in a chart.
    pub fn drawn(&self, label: impl Into<String>, style: Style) -> Series {
        let points = self.points.iter().map(|&[x, y]| (x, y)).collect();
        Series { label: label.into(), points, style, hollow: self.failed.clone() }
    }
}

/// Colours of the contact elements, in their order; those of further ones are there.
const ELEMENTS: [palette::Colour; 6] =
    [palette::LINE, palette::LAYER, palette::NODE, palette::PURPLE, palette::SKY, palette::ORANGE];

/// Colour = element, dash = algorithm.
pub fn style(formulation: &Formulation) -> Style {
    let colour = ELEMENTS[formulation.element as usize % ELEMENTS.len()];
    let (dash, marker) = match formulation.algorithm {
        Iteration::Varying => (Dash::Solid, Marker::Circle),
        Iteration::Constant => (Dash::Dashed, Marker::Square),
        Iteration::Kinematic => (Dash::Dotted, Marker::Diamond),
    };
    Style::run(colour, dash, marker)
}

/// Label of a formulation in legends.
pub fn label(formulation: &Formulation) -> String {
    format!("{} · {}", formulation.element.name(), formulation.algorithm.name())
}

/// A picture of the page with its caption.
pub fn picture(file: &str, caption: &str) -> String {
    format!("![{caption}](snapshots/charts/{file})\n*{caption}.*\n\n")
}
