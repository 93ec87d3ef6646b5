//! What a chart shows: curves over two axes.

use super::palette::Style;
use super::theme::Colour;

/// How an axis is divided.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Scale {
    /// Equal steps.
    #[default]
    Linear,
    /// Equal ratios.
    Log,
}

/// One axis.
#[derive(Clone, Debug, Default)]
pub struct Axis {
    /// What is measured, with its unit.
    pub label: String,
    /// How it is divided.
    pub scale: Scale,
    /// Its ends; around the values when absent.
    pub range: Option<(f64, f64)>,
    /// Names of the whole values from 1 on, in place of numbers; none where numbers are meant.
    pub names: Vec<String>,
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

impl Series {
    /// A curve of runs that all converged.
    pub fn new(
        label: impl Into<String>,
        points: impl IntoIterator<Item = impl Into<(f64, f64)>>,
        style: Style,
    ) -> Self {
        Self { label: label.into(), points: points.into_iter().map(Into::into).collect(), style, hollow: Vec::new() }
    }
}

/// Which axis a guide belongs to.
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

/// Bars from one value to another, as of repeated runs.
#[derive(Clone, Debug)]
pub struct Bars {
    /// Text in the legend; the same label stands there once.
    pub label: String,
    /// Both ends of each.
    pub ends: Vec<[(f64, f64); 2]>,
    /// Colour of the curve they belong to.
    pub colour: Colour,
}

/// A few words beside a point, as the name of a curve at its end: where they cover no sign and no other words.
#[derive(Clone, Debug)]
pub struct Remark {
    /// The point.
    pub at: (f64, f64),
    /// The words beside it.
    pub text: String,
    /// What a ring around the point means, in the legend, where the same label stands once; without it there is no
    /// ring.
    pub ring: Option<String>,
    /// Colour of the curve it belongs to.
    pub colour: Colour,
}

/// A triangle on two logarithmic axes whose hypotenuse has the slope of an order of accuracy.
#[derive(Clone, Copy, Debug)]
pub struct Slope {
    /// Ends of its horizontal leg, the smaller first.
    pub ends: [f64; 2],
    /// Ordinate of its hypotenuse at the smaller one.
    pub value: f64,
    /// The order.
    pub order: f64,
    /// Whether it stands above its hypotenuse, for a place above a curve.
    pub above: bool,
}

impl Slope {
    /// The ends of the hypotenuse, then the right angle.
    pub fn corners(&self) -> [(f64, f64); 3] {
        let [from, to] = self.ends;
        let top = self.value * (to / from).powf(self.order);
        [(from, self.value), (to, top), if self.above { (from, top) } else { (to, self.value) }]
    }
}

/// Curves over two axes.
#[derive(Clone, Debug, Default)]
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
    /// Triangles of orders.
    pub slopes: Vec<Slope>,
    /// Bars on points.
    pub bars: Vec<Bars>,
    /// Points marked with words.
    pub remarks: Vec<Remark>,
    /// Small print below.
    pub notes: Vec<String>,
}

impl Chart {
    /// A chart without curves.
    pub fn new(title: &str, x: Axis, y: Axis) -> Chart {
        Chart { title: title.to_string(), x, y, ..Chart::default() }
    }
}

impl Axis {
    /// An axis with equal steps around its values.
    pub fn linear(label: &str) -> Axis {
        Axis { label: label.to_string(), ..Axis::default() }
    }

    /// An axis with equal ratios around its values.
    pub fn log(label: &str) -> Axis {
        Axis { scale: Scale::Log, ..Axis::linear(label) }
    }

    /// An axis of named rows, the first the lowest.
    pub fn rows(names: Vec<String>) -> Axis {
        Axis { range: Some((0.4, names.len() as f64 + 0.6)), names, ..Axis::linear("") }
    }

    /// The axis with given ends.
    pub fn over(self, from: f64, to: f64) -> Axis {
        Axis { range: Some((from, to)), ..self }
    }
}
