//! The canvas: shapes in display pixels, in the order in which they are painted, and the SVG they become: one file for
//! light and for dark pages.
//!
//! Attributes hold the colours of light pages, a style sheet exchanges them where dark ones are preferred.
//!
//! plotters was tried and refused: it places whole pixels, so that curves kink unless the drawing is enlarged and its
//! text edited afterwards, and its chart builder cuts labels it has no font to measure and keeps no room above a frame.
//! The crate `svg` writes the elements with fractions of pixels, and leaves dashes and clipping to the viewer.

use std::collections::BTreeSet;
use std::mem;

use svg::Document;
use svg::node::element::{Circle, ClipPath, Description, Group, Path, Rectangle, Style, Text, Title};
use svg::node::{Node, Text as Words};

use super::drawing::{Drawing, Error};
use super::frame::{Frame, Point};
use super::outline::{joined, outlines, tenths};
use super::palette::{CARD, Dash, GREY, INK, PALE};
use super::pen::{Lettering, Pen, text_width, wrapped};
use super::theme::{Colour, Theme, exchanged};

/// Margin left and right.
pub(super) const EDGE: f64 = 18.0;
/// Room of the title.
pub(super) const TITLE: f64 = 40.0;
/// Width of a figure with panels.
pub(super) const WIDTH: f64 = 900.0;
const TITLE_SIZE: f64 = 15.0;
const NOTE_SIZE: f64 = 10.5;
const NOTE_ROW: f64 = 15.0;
/// Size of a text that says nothing else.
const TEXT_SIZE: f64 = 11.0;
/// Lines on the rim of a clipped part keep their half width, and areas overlap by as much, so that no seam shows.
const SLACK: f64 = 0.5;

/// Shapes in the order they are painted.
pub(super) struct Canvas {
    shapes: Group,
    colours: BTreeSet<Colour>,
    /// How many frames have clipped so far: each has a name of its own.
    clips: usize,
    /// False once a coordinate was not a number.
    sound: bool,
}

impl Canvas {
    /// An empty canvas.
    pub fn new() -> Canvas {
        Canvas { shapes: Group::new(), colours: BTreeSet::new(), clips: 0, sound: true }
    }

    /// A line through the points.
    pub fn line(&mut self, points: &[Point], pen: Pen) {
        self.lines(&[points.to_vec()], pen);
    }

    /// Several lines of one pen.
    pub fn lines(&mut self, lines: &[Vec<Point>], pen: Pen) {
        if self.has_place_for(lines.iter().flatten()) && !lines.is_empty() {
            let path = Path::new().set("d", outlines(lines, "")).set("fill", "none");
            let path = self.stroked(path, pen);
            self.shapes.append(match pen.dash {
                Dash::Solid | Dash::Absent => path,
                dash => path.set("stroke-dasharray", dash.pattern()),
            });
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
        let joined = if self.has_place_for(polygons.iter().flatten()) { joined(polygons) } else { vec![] };
        if !joined.is_empty() {
            self.areas(&joined, fill, Some(Pen::solid(fill, SLACK)));
        }
    }

    fn areas(&mut self, polygons: &[Vec<Point>], fill: Colour, rim: Option<Pen>) {
        if self.has_place_for(polygons.iter().flatten()) {
            let path = Path::new().set("d", outlines(polygons, "Z")).set("fill", self.coloured(fill));
            let path = rim.into_iter().fold(path, |path, pen| self.stroked(path, pen));
            self.shapes.append(path);
        }
    }

    /// A filled disc, with the line on its rim.
    pub fn disc(&mut self, (x, y): Point, radius: f64, fill: Colour, rim: Option<Pen>) {
        if self.has_place_for(&[(x, y)]) {
            let disc = Circle::new().set("cx", tenths(x)).set("cy", tenths(y)).set("r", tenths(radius));
            let disc = disc.set("fill", self.coloured(fill));
            let disc = rim.into_iter().fold(disc, |disc, pen| {
                disc.set("stroke", self.coloured(pen.colour)).set("stroke-width", tenths(pen.width))
            });
            self.shapes.append(disc);
        }
    }

    /// A line of text, its middle height at the place.
    pub fn label(&mut self, (x, y): Point, words: &str, lettering: Lettering) {
        if !self.has_place_for(&[(x, y)]) {
            return;
        }
        let text = Text::new(words).set("x", tenths(x)).set("y", tenths(y)).set("dy", ".32em");
        let turn = format!("rotate(-90 {} {})", tenths(x), tenths(y));
        let text = if lettering.upright { text.set("transform", turn) } else { text };
        let text = if lettering.anchor == "start" { text } else { text.set("text-anchor", lettering.anchor) };
        let usual = (lettering.size - TEXT_SIZE).abs() < 1e-9;
        let text = if usual { text } else { text.set("font-size", tenths(lettering.size)) };
        let text = if lettering.bold { text.set("font-weight", "bold") } else { text };
        let usual = lettering.colour == INK;
        let text = if usual { text } else { text.set("fill", self.coloured(lettering.colour)) };
        self.shapes.append(text);
    }

    /// Draws what shows only inside a frame.
    pub fn within(&mut self, frame: Frame, draw: impl FnOnce(&mut Canvas)) {
        self.clips += 1;
        let name = format!("frame-{}", self.clips);
        let around = mem::replace(&mut self.shapes, Group::new());
        draw(self);
        let inside = mem::replace(&mut self.shapes, around);
        self.shapes.append(ClipPath::new().set("id", name.as_str()).add(rectangle(frame.widened(SLACK))));
        self.shapes.append(inside.set("clip-path", format!("url(#{name})")));
    }

    /// The finished figure with title and notes, which are read to those who do not see it; its shapes end at the
    /// corner.
    pub fn drawing(mut self, title: &str, (right, bottom): Point, notes: &[String]) -> Drawing {
        let width = (right + EDGE).max(text_width(title, TITLE_SIZE) + 2.0 * EDGE).round();
        let lines = wrapped(notes, NOTE_SIZE, width - 2.0 * EDGE);
        let height = (bottom + 12.0 + NOTE_ROW * lines.len() as f64).round();
        self.label((EDGE, 0.5 * TITLE), title, Lettering::start(TITLE_SIZE).bold());
        for (row, line) in lines.iter().enumerate() {
            let place = (EDGE, bottom + NOTE_ROW * (row as f64 + 0.5));
            self.label(place, line, Lettering::start(NOTE_SIZE).coloured(GREY));
        }
        if !self.sound {
            let remedy = "leave values that are not finite out of the input";
            return Err(Error::of(title, "a coordinate is not finite", remedy));
        }
        let card = rectangle(Frame { left: 0.0, top: 0.0, right: width, bottom: height });
        let card = card.set("fill", self.coloured(CARD)).set("stroke", self.coloured(PALE)).set("stroke-width", 1.6);
        let ink = self.coloured(INK);
        let document = Document::new().set("width", width).set("height", height).set("role", "img");
        let document = document.set("viewBox", (0, 0, width, height)).set("font-family", "sans-serif");
        let document = document.set("font-size", TEXT_SIZE).set("stroke-linejoin", "round");
        let document = document.add(Title::new(title)).add(Description::new().add(Words::new(notes.join(" "))));
        let document = document.add(Style::new(exchanged(title, &self.colours)?));
        Ok(document.add(card).add(self.shapes.set("fill", ink)).to_string())
    }

    fn coloured(&mut self, colour: Colour) -> String {
        self.colours.insert(colour);
        colour.on(Theme::Light).to_string()
    }

    fn stroked(&mut self, path: Path, pen: Pen) -> Path {
        path.set("stroke", self.coloured(pen.colour)).set("stroke-width", tenths(pen.width))
    }

    /// Whether all places are numbers; that one is not is remembered.
    fn has_place_for<'a>(&mut self, points: impl IntoIterator<Item = &'a Point>) -> bool {
        self.sound &= points.into_iter().all(|(x, y)| x.is_finite() && y.is_finite());
        self.sound
    }
}

fn rectangle(frame: Frame) -> Rectangle {
    let place = Rectangle::new().set("x", tenths(frame.left)).set("y", tenths(frame.top));
    place.set("width", tenths(frame.width())).set("height", tenths(frame.height()))
}
