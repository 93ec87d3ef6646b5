//! A finished figure, and its SVG: one file for light and for dark pages.
//!
//! Attributes hold the colours of light pages, a style sheet exchanges them where dark ones are preferred.
//!
//! plotters was tried and refused: it places whole pixels, so that curves kink unless the drawing is enlarged and its
//! text edited afterwards, and its chart builder cuts labels it has no font to measure and keeps no room above a frame.
//! The crate `svg` writes the elements with fractions of pixels, and leaves dashes and clipping to the viewer.

use std::collections::BTreeSet;
use svg::Document;

use svg::node::element::{Circle, ClipPath, Description, Group, Path, Rectangle, Style, Text, Title};
use svg::node::{Node, Text as Words};

use super::error::Error;
use super::frame::{Frame, Point};
use super::outline::{outlines, tenths};
use super::palette::{CARD, Dash, INK, PALE};
use super::pen::{Lettering, Pen};
use super::theme::{Colour, Theme, exchanged};

pub(super) const TITLE_SIZE: f64 = 15.0;
pub(super) const NOTE_SIZE: f64 = 10.5;
pub(super) const NOTE_ROW: f64 = 15.0;
/// Size of a text that says nothing else.
const TEXT_SIZE: f64 = 11.0;
/// Lines on the rim of a clipped part keep their half width, and areas overlap by as much, so that no seam shows.
pub(super) const SLACK: f64 = 0.5;

/// What is painted, in display pixels.
#[derive(Clone, Debug)]
pub(super) enum Shape {
    /// Lines of one pen.
    Lines { lines: Vec<Vec<Point>>, pen: Pen },
    /// Filled polygons, with the line on their rims.
    Areas { polygons: Vec<Vec<Point>>, fill: Colour, rim: Option<Pen> },
    /// A filled disc, with the line on its rim.
    Disc { centre: Point, radius: f64, fill: Colour, rim: Option<Pen> },
    /// A line of text, its middle height at the place.
    Label { at: Point, text: String, lettering: Lettering },
    /// What shows only inside a frame.
    Within { frame: Frame, shapes: Vec<Shape> },
}

/// A finished figure.
#[derive(Clone, Debug)]
pub enum Drawing {
    /// Of shapes.
    Painted(Painted),
    /// Drawn by hand: an SVG file, and its colours.
    Schematic(String, BTreeSet<Colour>),
    /// One that cannot be drawn, which is told where it is written.
    Broken(Error),
}

/// A figure of shapes.
#[derive(Clone, Debug)]
pub struct Painted {
    pub(super) title: String,
    /// What is read to those who do not see it.
    pub(super) about: String,
    pub(super) size: Point,
    pub(super) shapes: Vec<Shape>,
}

impl Drawing {
    /// What became of a figure.
    pub(super) fn of(drawn: Result<Self, Error>) -> Self {
        drawn.unwrap_or_else(Self::Broken)
    }

    /// The SVG text, the same bytes for the same shapes.
    pub fn svg(&self) -> Result<String, Error> {
        match self {
            Self::Painted(painted) => painted.svg(),
            Self::Schematic(svg, colours) => {
                let (head, shapes) = svg.split_once('>').unwrap_or_default();
                Ok(format!("{head}>\n{}{shapes}", Style::new(exchanged("drawn by hand", colours)?)))
            }
            Self::Broken(error) => Err(error.clone()),
        }
    }
}

impl Painted {
    fn svg(&self) -> Result<String, Error> {
        let (right, bottom) = self.size;
        let mut writer = Writer { colours: BTreeSet::new(), clips: 0 };
        let card = rectangle(Frame { left: 0.0, top: 0.0, right, bottom }).set("fill", writer.colour(CARD));
        let card = card.set("stroke", writer.colour(PALE)).set("stroke-width", 1.6);
        let shapes = writer.group(&self.shapes).set("fill", writer.colour(INK));
        let document = Document::new().set("width", right).set("height", bottom).set("role", "img");
        let document = document.set("viewBox", (0, 0, right, bottom)).set("font-family", "sans-serif");
        let document = document.set("font-size", TEXT_SIZE).set("stroke-linejoin", "round");
        let document = document.add(Title::new(self.title.as_str()));
        let document = document.add(Description::new().add(Words::new(self.about.as_str())));
        let document = document.add(Style::new(exchanged(&self.title, &writer.colours)?));
        Ok(document.add(card).add(shapes).to_string())
    }
}

/// Whether a text is a drawing of this program.
pub fn is_drawing(text: &str) -> bool {
    text.starts_with("<svg font-family=\"sans-serif\" font-size=") && text.trim_end().ends_with("</svg>")
}

/// Writes shapes.
struct Writer {
    /// Colours so far.
    colours: BTreeSet<Colour>,
    /// How many frames have clipped so far: each has a name of its own.
    clips: usize,
}

impl Writer {
    fn group(&mut self, shapes: &[Shape]) -> Group {
        let mut group = Group::new();
        shapes.iter().for_each(|shape| self.append(&mut group, shape));
        group
    }

    fn append(&mut self, group: &mut Group, shape: &Shape) {
        match shape {
            Shape::Lines { lines, pen } => group.append(self.lines(lines, *pen)),
            Shape::Areas { polygons, fill, rim } => {
                let path = Path::new().set("d", outlines(polygons, "Z")).set("fill", self.colour(*fill));
                group.append(rim.iter().fold(path, |path, pen| self.stroked(path, pen)));
            }
            Shape::Disc { centre, radius, fill, rim } => {
                let (x, y) = (tenths(centre.0), tenths(centre.1));
                let disc = Circle::new().set("cx", x).set("cy", y).set("r", tenths(*radius));
                let disc = disc.set("fill", self.colour(*fill));
                group.append(rim.iter().fold(disc, |disc, pen| {
                    disc.set("stroke", self.colour(pen.colour)).set("stroke-width", tenths(pen.width))
                }));
            }
            Shape::Label { at, text, lettering } => group.append(self.label(*at, text, *lettering)),
            Shape::Within { frame, shapes } => {
                self.clips += 1;
                let name = format!("frame-{}", self.clips);
                let window = rectangle(frame.widened(SLACK));
                group.append(ClipPath::new().set("id", name.as_str()).add(window));
                group.append(self.group(shapes).set("clip-path", format!("url(#{name})")));
            }
        }
    }

    fn colour(&mut self, colour: Colour) -> String {
        self.colours.insert(colour);
        colour.on(Theme::Light).to_string()
    }

    fn lines(&mut self, lines: &[Vec<Point>], pen: Pen) -> Path {
        let path = Path::new().set("d", outlines(lines, "")).set("fill", "none");
        let path = self.stroked(path, &pen);
        match pen.dash {
            Dash::Solid | Dash::Absent => path,
            dash => path.set("stroke-dasharray", dash.pattern()),
        }
    }

    fn stroked(&mut self, path: Path, pen: &Pen) -> Path {
        path.set("stroke", self.colour(pen.colour)).set("stroke-width", tenths(pen.width))
    }

    fn label(&mut self, (x, y): Point, words: &str, lettering: Lettering) -> Text {
        let text = Text::new(words).set("x", tenths(x)).set("y", tenths(y)).set("dy", ".32em");
        let turn = format!("rotate(-90 {} {})", tenths(x), tenths(y));
        let text = if lettering.upright { text.set("transform", turn) } else { text };
        let text = if lettering.anchor == "start" { text } else { text.set("text-anchor", lettering.anchor) };
        let usual = (lettering.size - TEXT_SIZE).abs() < 1e-9;
        let text = if usual { text } else { text.set("font-size", tenths(lettering.size)) };
        let text = if lettering.bold { text.set("font-weight", "bold") } else { text };
        if lettering.colour == INK { text } else { text.set("fill", self.colour(lettering.colour)) }
    }
}

fn rectangle(frame: Frame) -> Rectangle {
    let place = Rectangle::new().set("x", tenths(frame.left)).set("y", tenths(frame.top));
    place.set("width", tenths(frame.width())).set("height", tenths(frame.height()))
}
