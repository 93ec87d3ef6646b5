//! The canvas: shapes in display pixels, written as SVG between a title and small print.
//!
//! plotters was tried and refused: it places whole pixels, so that curves kink unless the drawing is enlarged and its
//! text edited afterwards, and its chart builder cuts labels it has no font to measure and keeps no room above a frame.
//! The crate `svg` writes the elements with fractions of pixels, and leaves dashes and clipping to the viewer.

use std::mem;

use svg::Document;
use svg::node::element::{Circle, ClipPath, Description, Group, Path, Rectangle, Text, Title};
use svg::node::{Node, Text as Words};

use super::frame::{Frame, Point};
use super::palette::{CARD, Colour, GREY, PALE};
use super::pen::{Lettering, Pen, text_width, wrapped};
use crate::error::Error;

/// Margin left and right.
pub(super) const EDGE: f64 = 18.0;
/// Room of the title.
pub(super) const TITLE: f64 = 40.0;
/// Width of a figure with panels.
pub(super) const WIDTH: f64 = 900.0;

const TITLE_SIZE: f64 = 15.0;
const NOTE_SIZE: f64 = 10.5;
const NOTE_ROW: f64 = 15.0;
/// Lines on the rim of a clipped part keep their half width, and areas overlap by as much, so that no seam shows.
const SLACK: f64 = 0.5;

/// Shapes in the order they are painted.
pub(super) struct Canvas {
    shapes: Group,
    clips: usize,
    /// False once a coordinate was not a number.
    sound: bool,
}

impl Canvas {
    /// An empty canvas.
    pub fn new() -> Canvas {
        Canvas { shapes: Group::new(), clips: 0, sound: true }
    }

    /// A line through the points.
    pub fn line(&mut self, points: &[Point], pen: Pen) {
        self.lines(&[points.to_vec()], pen);
    }

    /// Several lines of one pen.
    pub fn lines(&mut self, lines: &[Vec<Point>], pen: Pen) {
        if lines.is_empty() {
            return;
        }
        let path = Path::new().set("d", self.outlines(lines, "")).set("fill", "none");
        let path = path.set("stroke", pen.colour.to_string()).set("stroke-width", pen.width);
        self.shapes.append(path.set("stroke-dasharray", pen.dash.pattern()));
    }

    /// A filled polygon.
    pub fn area(&mut self, points: &[Point], fill: Colour) {
        let path = Path::new().set("d", self.outlines(&[points.to_vec()], "Z"));
        self.shapes.append(path.set("fill", fill.to_string()));
    }

    /// Filled polygons that tile a surface.
    pub fn tiles(&mut self, polygons: &[Vec<Point>], fill: Colour) {
        let path = Path::new().set("d", self.outlines(polygons, "Z")).set("fill", fill.to_string());
        self.shapes.append(path.set("stroke", fill.to_string()).set("stroke-width", SLACK));
    }

    /// A filled disc.
    pub fn disc(&mut self, centre: Point, radius: f64, fill: Colour) {
        let (x, y) = self.place(centre);
        self.shapes.append(Circle::new().set("cx", x).set("cy", y).set("r", radius).set("fill", fill.to_string()));
    }

    /// A line of text, its middle height at the place.
    pub fn label(&mut self, at: Point, text: &str, lettering: Lettering) {
        let (x, y) = self.place(at);
        let turn = if lettering.upright { " rotate(-90)" } else { "" };
        let text = Text::new(text).set("transform", format!("translate({x} {y}){turn}"));
        let text = text.set("dy", "0.32em").set("text-anchor", lettering.anchor).set("font-size", lettering.size);
        let text = if lettering.bold { text.set("font-weight", "bold") } else { text };
        self.shapes.append(text.set("fill", lettering.colour.to_string()));
    }

    /// Draws what shows only inside a frame.
    pub fn within(&mut self, frame: Frame, draw: impl FnOnce(&mut Canvas)) {
        self.clips += 1;
        let name = format!("frame-{}", self.clips);
        let around = mem::replace(&mut self.shapes, Group::new());
        draw(self);
        let inside = mem::replace(&mut self.shapes, around).set("clip-path", format!("url(#{name})"));
        let window = frame.widened(SLACK);
        self.shapes.append(ClipPath::new().set("id", name).add(rectangle(window)));
        self.shapes.append(inside);
    }

    /// The SVG text with title and notes, the same bytes for the same shapes; they end at the corner.
    pub fn svg(mut self, title: &str, (right, bottom): Point, notes: &[String]) -> Result<String, Error> {
        let width = (right + EDGE).max(text_width(title, TITLE_SIZE) + 2.0 * EDGE).round();
        let lines = wrapped(notes, NOTE_SIZE, width - 2.0 * EDGE);
        let height = (bottom + 12.0 + NOTE_ROW * lines.len() as f64).round();
        self.label((EDGE, 0.5 * TITLE), title, Lettering::start(TITLE_SIZE).bold());
        for (row, line) in lines.iter().enumerate() {
            let place = (EDGE, bottom + NOTE_ROW * (row as f64 + 0.5));
            self.label(place, line, Lettering::start(NOTE_SIZE).coloured(GREY));
        }
        if !self.sound {
            return Err(drawing(title, "a coordinate is not finite", FINITE));
        }
        let card = rectangle(Frame { left: 0.0, top: 0.0, right: width, bottom: height });
        let document = Document::new().set("width", width).set("height", height).set("role", "img");
        let document = document.set("viewBox", (0, 0, width, height)).set("font-family", "sans-serif");
        let document = document.set("stroke-linejoin", "round").add(Title::new(title));
        let document = document.add(Description::new().add(Words::new(notes.join(" "))));
        let card = card.set("fill", CARD.to_string()).set("stroke", PALE.to_string()).set("stroke-width", 1.6);
        Ok(document.add(card).add(self.shapes).to_string())
    }

    fn outlines(&mut self, lines: &[Vec<Point>], end: &str) -> String {
        let mut outline = |line: &Vec<Point>| {
            let points = line.iter().map(|&point| self.place(point));
            let points: Vec<String> = points.map(|(x, y)| format!("{x} {y}")).collect();
            format!("M{}{end}", points.join("L"))
        };
        lines.iter().map(&mut outline).collect()
    }

    /// The place to a tenth of a pixel: finer digits differ between machines.
    fn place(&mut self, (x, y): Point) -> Point {
        self.sound &= x.is_finite() && y.is_finite();
        // Adding zero turns −0 into 0.
        ((10.0 * x).round() / 10.0 + 0.0, (10.0 * y).round() / 10.0 + 0.0)
    }
}

/// What to do where a shape cannot be drawn.
const FINITE: &str = "leave values that are not finite out of the input";

/// Error of a figure that cannot be drawn.
pub(super) fn drawing(figure: &str, reason: impl Into<String>, remedy: &str) -> Error {
    Error::at(format!("figure `{figure}`").as_str(), reason, remedy)
}

fn rectangle(frame: Frame) -> Rectangle {
    let place = Rectangle::new().set("x", frame.left).set("y", frame.top);
    place.set("width", frame.width()).set("height", frame.height())
}
