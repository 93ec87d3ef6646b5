//! How formulations are drawn everywhere: colour = element, dash = algorithm; and what a page's picture is called.

use crate::algorithm::Acceleration;
use crate::drawing::palette::{self, Dash, Marker, Style};
use crate::drawing::{self, Drawing};
use crate::error::Error;
use crate::solve::{Formulation, Iteration};

/// The SVG of a figure.
pub fn svg(figure: &Drawing) -> Result<String, Error> {
    figure.svg().map_err(|drawing::Error { figure, reason, remedy }| {
        Error::at(format!("figure `{figure}`").as_str(), reason, remedy)
    })
}

/// Files of figures by their names.
pub fn written(figures: &[(String, Drawing)]) -> Result<Vec<(String, String)>, Error> {
    figures.iter().map(|(name, figure)| Ok((name.clone(), svg(figure)?))).collect()
}

/// Colour = element, dash = algorithm.
pub fn style(formulation: &Formulation) -> Style {
    let colour = palette::CURVES[formulation.element as usize % palette::CURVES.len()];
    let (dash, marker) = match formulation.algorithm {
        Iteration::Varying => (Dash::Solid, Marker::Circle),
        Iteration::Constant => (Dash::Dashed, Marker::Square),
        Iteration::Kinematic => (Dash::Dotted, Marker::Diamond),
    };
    Style::run(colour, dash, marker)
}

/// Label of a formulation in legends, with its acceleration.
pub fn label(formulation: &Formulation) -> String {
    let Formulation { element, algorithm, acceleration, .. } = formulation;
    let added = if *acceleration == Acceleration::None { String::new() } else { format!(" + {}", acceleration.name()) };
    format!("{} · {}{added}", element.name(), algorithm.name())
}

/// A picture of the page, with its caption below.
pub fn picture(file: &str, caption: &str) -> String {
    format!("<img alt=\"{}\" src=\"snapshots/charts/{file}\">\n\n*{caption}.*\n\n", attribute(caption))
}

/// A text inside the quotes of an attribute.
fn attribute(text: &str) -> String {
    text.replace('&', "&amp;").replace('"', "&quot;").replace('<', "&lt;")
}
