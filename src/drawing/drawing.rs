//! A finished figure, and its SVG for light and dark pages.
//!
//! plotters was tried and refused: it places whole pixels, so that curves kink unless the drawing is enlarged and its
//! text edited afterwards, and its chart builder cuts labels it has no font to measure and keeps no room above a frame.
//! The crate `svg` writes the elements with fractions of pixels, and leaves dashes and clipping to the viewer.

use svg::Document;
use svg::node::element::{Circle, ClipPath, Description, Group, Path, Rectangle, Text, Title};
use svg::node::{Node, Text as Words};

use super::error::Error;
use super::frame::{Frame, Point};
use super::outline::{outlines, tenths};
use super::palette::{self, CARD, Dash, INK, PALE};
use super::pen::{Lettering, Pen};
use super::theme::{Colour, Theme};

pub(super) const TITLE_SIZE: f64 = 15.0;
pub(super) const NOTE_SIZE: f64 = 10.5;
pub(super) const NOTE_ROW: f64 = 15.0;
/// Size of a text that says nothing else.
const TEXT_SIZE: f64 = 11.0;
/// Lines on the rim of a clipped part keep their half width, and areas overlap by as much, so that no seam shows.
const SLACK: f64 = 0.5;

/// What is painted, in display pixels.
#[derive(Clone, Debug)]
pub(super) enum Shape {
    /// Lines of one pen.
    Lines { lines: Vec<Vec<Point>>, pen: Pen },
    /// Filled polygons; tiles overlap a little.
    Areas { polygons: Vec<Vec<Point>>, fill: Colour, tiled: bool },
    /// A filled disc.
    Disc { centre: Point, radius: f64, fill: Colour },
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
    /// Drawn by hand: an SVG file in the colours of light pages.
    Schematic(String),
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
    pub fn svg(&self, theme: Theme) -> Result<String, Error> {
        match self {
            Self::Painted(painted) => Ok(painted.svg(theme)),
            Self::Schematic(light) => Ok(palette::on(light, theme)),
            Self::Broken(error) => Err(error.clone()),
        }
    }

    /// Files of a figure of a name, for light and for dark pages.
    pub fn files(&self, name: &str) -> Result<[(String, String); 2], Error> {
        let [light, dark] = Theme::ALL.map(|theme| self.svg(theme).map(|svg| (theme.file(name), svg)));
        Ok([light?, dark?])
    }
}

impl Painted {
    fn svg(&self, theme: Theme) -> String {
        let (right, bottom) = self.size;
        let card = rectangle(Frame { left: 0.0, top: 0.0, right, bottom }).set("fill", CARD.on(theme).to_string());
        let card = card.set("stroke", PALE.on(theme).to_string()).set("stroke-width", 1.6);
        let document = Document::new().set("width", right).set("height", bottom).set("role", "img");
        let document = document.set("viewBox", (0, 0, right, bottom)).set("font-family", "sans-serif");
        let document = document.set("font-size", TEXT_SIZE).set("stroke-linejoin", "round");
        let document = document.add(Title::new(self.title.as_str()));
        let document = document.add(Description::new().add(Words::new(self.about.as_str()))).add(card);
        let mut writer = Writer { theme, clips: 0 };
        document.add(writer.group(&self.shapes).set("fill", INK.on(theme).to_string())).to_string()
    }
}

/// Whether a text is a drawing of this program.
pub fn is_drawing(text: &str) -> bool {
    text.starts_with("<svg font-family=\"sans-serif\" font-size=") && text.trim_end().ends_with("</svg>")
}

/// Writes shapes for a page.
struct Writer {
    theme: Theme,
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
            Shape::Areas { polygons, fill, tiled } => group.append(self.areas(polygons, *fill, *tiled)),
            Shape::Disc { centre, radius, fill } => {
                let (x, y) = (tenths(centre.0), tenths(centre.1));
                group.append(
                    Circle::new().set("cx", x).set("cy", y).set("r", tenths(*radius)).set("fill", self.colour(*fill)),
                );
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

    fn colour(&self, colour: Colour) -> String {
        colour.on(self.theme).to_string()
    }

    fn lines(&self, lines: &[Vec<Point>], pen: Pen) -> Path {
        let path = Path::new().set("d", outlines(lines, "")).set("fill", "none");
        let path = path.set("stroke", self.colour(pen.colour)).set("stroke-width", tenths(pen.width));
        match pen.dash {
            Dash::Solid | Dash::Absent => path,
            dash => path.set("stroke-dasharray", dash.pattern()),
        }
    }

    fn areas(&self, polygons: &[Vec<Point>], fill: Colour, tiled: bool) -> Path {
        let path = Path::new().set("d", outlines(polygons, "Z")).set("fill", self.colour(fill));
        if tiled { path.set("stroke", self.colour(fill)).set("stroke-width", SLACK) } else { path }
    }

    fn label(&self, (x, y): Point, words: &str, lettering: Lettering) -> Text {
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
