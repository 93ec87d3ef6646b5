//! What a chart shows: curves over two axes.

use super::palette::Style;

/// How an axis is divided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Equal steps.
    Linear,
    /// Equal ratios.
    Log,
}

/// One axis.
#[derive(Clone, Debug)]
pub struct Axis {
    /// What is measured, with its unit.
    pub label: String,
    /// How it is divided.
    pub scale: Scale,
    /// Its ends; around the values when absent.
    pub range: Option<(f64, f64)>,
}

/// One curve.
#[derive(Clone, Debug)]
pub struct Series {
    /// Text in the legend; the same label stands there once, an empty one not at all.
    pub label: String,
    /// Points in drawing order; a NaN interrupts the line.
    pub points: Vec<(f64, f64)>,
    /// Colour, dash and marker.
    pub style: Style,
    /// Abscissae of runs that did not converge, drawn hollow above the upper frame.
    pub hollow: Vec<f64>,
}

/// Which axis a guide or a band belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// At a value of y.
    Horizontal,
    /// At a value of x.
    Vertical,
}

/// A thin line at one value, labelled outside the frame.
#[derive(Clone, Debug)]
pub struct Guide {
    /// Which axis the value is on.
    pub direction: Direction,
    /// The value.
    pub at: f64,
    /// A few characters.
    pub label: String,
}

/// A shaded range with its label, as for data that are not at hand.
#[derive(Clone, Debug)]
pub struct Band {
    /// Which axis the range is on.
    pub direction: Direction,
    /// Lower end.
    pub from: f64,
    /// Upper end.
    pub to: f64,
    /// What the range means; inside a vertical band, beside a horizontal one.
    pub label: String,
}

/// Curves over two axes.
#[derive(Clone, Debug)]
pub struct Chart {
    /// What is shown, in a few words.
    pub title: String,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// The curves, in drawing order.
    pub series: Vec<Series>,
    /// Reference lines.
    pub guides: Vec<Guide>,
    /// Shaded ranges.
    pub bands: Vec<Band>,
    /// Small print below.
    pub notes: Vec<String>,
}

impl Chart {
    /// A chart without curves.
    pub fn new(title: &str, x: Axis, y: Axis) -> Chart {
        let title = title.to_string();
        Chart { title, x, y, series: vec![], guides: vec![], bands: vec![], notes: vec![] }
    }
}

impl Axis {
    /// An axis with equal steps around its values.
    pub fn linear(label: &str) -> Axis {
        Axis { label: label.to_string(), scale: Scale::Linear, range: None }
    }

    /// An axis with equal ratios around its values.
    pub fn log(label: &str) -> Axis {
        Axis { label: label.to_string(), scale: Scale::Log, range: None }
    }

    /// The axis with given ends.
    pub fn over(self, from: f64, to: f64) -> Axis {
        Axis { range: Some((from, to)), ..self }
    }
}
