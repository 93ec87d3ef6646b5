//! The canvas: shapes in display pixels, in the order in which they are painted.

use std::mem;

use super::drawing::{Drawing, NOTE_ROW, NOTE_SIZE, Painted, SLACK, Shape, TITLE_SIZE};
use super::error::Error;
use super::frame::{Frame, Point};
use super::joined::joined;
use super::palette::GREY;
use super::pen::{Lettering, Pen, text_width, wrapped};
use super::theme::Colour;

/// Margin left and right.
pub(super) const EDGE: f64 = 18.0;
/// Room of the title.
pub(super) const TITLE: f64 = 40.0;
/// Width of a figure with panels.
pub(super) const WIDTH: f64 = 900.0;

/// Shapes in the order they are painted.
pub(super) struct Canvas {
    shapes: Vec<Shape>,
    /// False once a coordinate was not a number.
    sound: bool,
}

impl Canvas {
    /// An empty canvas.
    pub fn new() -> Canvas {
        Canvas { shapes: Vec::new(), sound: true }
    }

    /// A line through the points.
    pub fn line(&mut self, points: &[Point], pen: Pen) {
        self.lines(&[points.to_vec()], pen);
    }

    /// Several lines of one pen.
    pub fn lines(&mut self, lines: &[Vec<Point>], pen: Pen) {
        self.check(lines.iter().flatten());
        if !lines.is_empty() {
            self.shapes.push(Shape::Lines { lines: lines.to_vec(), pen });
        }
    }

    /// A filled polygon.
    pub fn area(&mut self, points: &[Point], fill: Colour) {
        self.areas(&[points.to_vec()], fill, None);
    }

    /// A filled polygon with a line on its rim.
    pub fn rimmed(&mut self, points: &[Point], fill: Colour, rim: Pen) {
        self.areas(&[points.to_vec()], fill, Some(rim));
    }

    /// Filled polygons that tile a surface, joined where they meet.
    pub fn tiles(&mut self, polygons: &[Vec<Point>], fill: Colour) {
        self.check(polygons.iter().flatten());
        let joined = joined(polygons);
        if !joined.is_empty() {
            self.areas(&joined, fill, Some(Pen::solid(fill, SLACK)));
        }
    }

    fn areas(&mut self, polygons: &[Vec<Point>], fill: Colour, rim: Option<Pen>) {
        self.check(polygons.iter().flatten());
        self.shapes.push(Shape::Areas { polygons: polygons.to_vec(), fill, rim });
    }

    /// A filled disc, with the line on its rim.
    pub fn disc(&mut self, centre: Point, radius: f64, fill: Colour, rim: Option<Pen>) {
        self.check(&[centre]);
        self.shapes.push(Shape::Disc { centre, radius, fill, rim });
    }

    /// A line of text, its middle height at the place.
    pub fn label(&mut self, at: Point, text: &str, lettering: Lettering) {
        self.check(&[at]);
        self.shapes.push(Shape::Label { at, text: text.to_string(), lettering });
    }

    /// Draws what shows only inside a frame.
    pub fn within(&mut self, frame: Frame, draw: impl FnOnce(&mut Canvas)) {
        let around = mem::take(&mut self.shapes);
        draw(self);
        let inside = mem::replace(&mut self.shapes, around);
        self.shapes.push(Shape::Within { frame, shapes: inside });
    }

    /// The finished figure with title and notes; its shapes end at the corner.
    pub fn drawing(mut self, title: &str, (right, bottom): Point, notes: &[String]) -> Result<Drawing, Error> {
        let width = (right + EDGE).max(text_width(title, TITLE_SIZE) + 2.0 * EDGE).round();
        let lines = wrapped(notes, NOTE_SIZE, width - 2.0 * EDGE);
        let height = (bottom + 12.0 + NOTE_ROW * lines.len() as f64).round();
        self.label((EDGE, 0.5 * TITLE), title, Lettering::start(TITLE_SIZE).bold());
        for (row, line) in lines.iter().enumerate() {
            let place = (EDGE, bottom + NOTE_ROW * (row as f64 + 0.5));
            self.label(place, line, Lettering::start(NOTE_SIZE).coloured(GREY));
        }
        if !self.sound {
            return Err(Error::of(title, "a coordinate is not finite", FINITE));
        }
        let (title, about) = (title.to_string(), notes.join(" "));
        Ok(Drawing::Painted(Painted { title, about, size: (width, height), shapes: self.shapes }))
    }

    fn check<'a>(&mut self, points: impl IntoIterator<Item = &'a Point>) {
        self.sound &= points.into_iter().all(|(x, y)| x.is_finite() && y.is_finite());
    }
}

/// What to do where a shape cannot be drawn.
const FINITE: &str = "leave values that are not finite out of the input";
