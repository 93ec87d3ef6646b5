//! The canvas: shapes are recorded in display pixels and written as SVG at the end.
//!
//! The SVG backend rounds to whole pixels; everything is therefore written tenfold enlarged, under a header that shows
//! it at its display size.

use plotters::backend::{DrawingBackend, SVGBackend};
use plotters::style::text_anchor::{Pos, VPos};
use plotters::style::{Color, FontDesc, FontFamily, FontStyle, FontTransform, ShapeStyle, TextStyle};

use super::frame::Frame;
use super::palette::{CARD, Colour, PALE};
use super::pen::{Lettering, Pen, dashes};
use crate::error::Error;

/// A place on the canvas, y downwards [display pixels].
pub(super) type Point = (f64, f64);

const ENLARGEMENT: f64 = 10.0;

enum Shape {
    Line(Vec<Point>, Colour, f64),
    Area(Vec<Point>, Colour),
    Disc(Point, f64, Colour),
    Label(Point, String, Lettering),
}

/// Shapes in the order they are painted.
pub(super) struct Canvas {
    width: f64,
    height: f64,
    shapes: Vec<Shape>,
}

impl Canvas {
    /// An empty card.
    pub fn new(width: f64, height: f64) -> Canvas {
        let mut canvas = Canvas { width, height, shapes: Vec::new() };
        let card = Frame { left: 0.0, top: 0.0, right: width, bottom: height };
        canvas.area(&card.corners(), CARD);
        canvas.line(&card.outline(), Pen::solid(PALE, 1.6));
        canvas
    }

    /// A line through the points, dashed as the pen says.
    pub fn line(&mut self, points: &[Point], pen: Pen) {
        let pattern = pen.dash.pattern();
        if pattern.is_empty() {
            self.shapes.push(Shape::Line(points.to_vec(), pen.colour, pen.width));
            return;
        }
        for piece in dashes(points, pattern) {
            self.shapes.push(Shape::Line(piece, pen.colour, pen.width));
        }
    }

    /// A filled polygon.
    pub fn area(&mut self, points: &[Point], fill: Colour) {
        self.shapes.push(Shape::Area(points.to_vec(), fill));
    }

    /// A filled disc.
    pub fn disc(&mut self, centre: Point, radius: f64, fill: Colour) {
        self.shapes.push(Shape::Disc(centre, radius, fill));
    }

    /// A line of text.
    pub fn label(&mut self, at: Point, text: &str, lettering: Lettering) {
        self.shapes.push(Shape::Label(at, text.to_string(), lettering));
    }

    /// The SVG text, the same bytes for the same shapes.
    pub fn svg(&self, figure: &str) -> Result<String, Error> {
        let mut text = String::new();
        let size = (whole(self.width) as u32, whole(self.height) as u32);
        let mut backend = SVGBackend::with_string(&mut text, size);
        for shape in &self.shapes {
            paint(&mut backend, shape).map_err(|reason| drawing(figure, reason, FINITE))?;
        }
        backend.present().map_err(|cause| drawing(figure, cause.to_string(), FINITE))?;
        drop(backend);
        Ok(self.at_display_size(&text))
    }

    fn at_display_size(&self, text: &str) -> String {
        let body = text.split_once('>').map_or(text, |(_, body)| body);
        let header = format!(
            "<svg width=\"{}\" height=\"{}\" viewBox=\"0 0 {} {}\" stroke-linejoin=\"round\" xmlns=\"http://www.w3.org/2000/svg\">",
            self.width.round(),
            self.height.round(),
            whole(self.width),
            whole(self.height)
        );
        header + &body.replace(" opacity=\"1\"", "").replace(" \"/>", "\"/>")
    }
}

/// What to do where a shape cannot be drawn.
const FINITE: &str = "leave values that are not finite out of the input";

/// Error of a figure that cannot be drawn.
pub(super) fn drawing(figure: &str, reason: impl Into<String>, remedy: &str) -> Error {
    Error::at(format!("figure `{figure}`").as_str(), reason, remedy)
}

fn whole(length: f64) -> i32 {
    (length * ENLARGEMENT).round() as i32
}

fn paint(backend: &mut SVGBackend<'_>, shape: &Shape) -> Result<(), String> {
    match shape {
        Shape::Line(points, colour, width) => {
            let style = ShapeStyle { color: colour.to_rgba(), filled: false, stroke_width: whole(*width) as u32 };
            backend.draw_path(enlarged(points)?, &style)
        }
        Shape::Area(points, fill) => backend.fill_polygon(enlarged(points)?, &fill.filled()),
        Shape::Disc(centre, radius, fill) => {
            backend.draw_circle(enlarged(&[*centre])?[0], whole(*radius) as u32, &fill.filled(), true)
        }
        Shape::Label(at, text, lettering) => backend.draw_text(text, &text_style(lettering), enlarged(&[*at])?[0]),
    }
    .map_err(|cause| cause.to_string())
}

fn enlarged(points: &[Point]) -> Result<Vec<(i32, i32)>, String> {
    let place = |&(x, y): &Point| (x.is_finite() && y.is_finite()).then(|| (whole(x), whole(y)));
    let places: Option<Vec<_>> = points.iter().map(place).collect();
    places.ok_or_else(|| "a coordinate is not finite".to_string())
}

fn text_style(lettering: &Lettering) -> TextStyle<'_> {
    let style = if lettering.bold { FontStyle::Bold } else { FontStyle::Normal };
    // The backend divides by 1.24 to turn line height into font size.
    let font = FontDesc::new(FontFamily::SansSerif, lettering.size * ENLARGEMENT * 1.24, style);
    let turn = if lettering.upright { FontTransform::Rotate270 } else { FontTransform::None };
    TextStyle::from(font.transform(turn)).color(&lettering.colour).pos(Pos::new(lettering.side, VPos::Center))
}
