//! Pens and lettering: how lines and texts are set.

use plotters::style::text_anchor::HPos;

use super::canvas::Point;
use super::frame::distance;
use super::palette::{Colour, Dash, INK};

/// How a line is drawn.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pen {
    pub colour: Colour,
    pub width: f64,
    pub dash: Dash,
}

impl Pen {
    /// An undashed line.
    pub fn solid(colour: Colour, width: f64) -> Pen {
        Pen { colour, width, dash: Dash::Solid }
    }
}

/// How a text is set: its middle height stands at the given place.
#[derive(Clone, Copy)]
pub(super) struct Lettering {
    pub size: f64,
    pub colour: Colour,
    pub side: HPos,
    pub bold: bool,
    /// Reads from bottom to top.
    pub upright: bool,
}

impl Lettering {
    /// Text beginning at the place.
    pub fn start(size: f64) -> Lettering {
        Lettering { size, colour: INK, side: HPos::Left, bold: false, upright: false }
    }

    /// Text centred on the place.
    pub fn middle(size: f64) -> Lettering {
        Lettering { side: HPos::Center, ..Lettering::start(size) }
    }

    /// Text ending at the place.
    pub fn end(size: f64) -> Lettering {
        Lettering { side: HPos::Right, ..Lettering::start(size) }
    }

    /// The same in bold.
    pub fn bold(self) -> Lettering {
        Lettering { bold: true, ..self }
    }

    /// The same, read from bottom to top.
    pub fn upright(self) -> Lettering {
        Lettering { upright: true, ..self }
    }

    /// The same in another colour.
    pub fn coloured(self, colour: Colour) -> Lettering {
        Lettering { colour, ..self }
    }
}

/// Width of a text as a generous estimate: no fonts are read.
pub(super) fn text_width(text: &str, size: f64) -> f64 {
    let share = |c: char| match c {
        'i' | 'j' | 'l' | '.' | ',' | ':' | ';' | '\'' | '|' | '!' | ' ' => 0.34,
        'f' | 't' | 'r' | '(' | ')' | '[' | ']' | '-' => 0.42,
        '⁰'..='ₜ' | '¹' | '²' | '³' => 0.42,
        'm' | 'w' | 'M' | 'W' => 0.92,
        c if c.is_uppercase() => 0.70,
        _ => 0.62,
    };
    size * text.chars().map(share).sum::<f64>()
}

/// The drawn pieces of a dashed line.
pub(super) fn dashes(points: &[Point], pattern: &[f64]) -> Vec<Vec<Point>> {
    let mut pieces = Vec::new();
    let mut piece: Vec<Point> = points.first().copied().into_iter().collect();
    let (mut phase, mut left) = (0, pattern[0]);
    for pair in points.windows(2) {
        let length = distance(pair[0], pair[1]);
        let mut done = 0.0;
        while length - done > left {
            done += left;
            let share = done / length;
            let turn = (pair[0].0 + share * (pair[1].0 - pair[0].0), pair[0].1 + share * (pair[1].1 - pair[0].1));
            if phase % 2 == 0 {
                piece.push(turn);
                pieces.push(std::mem::take(&mut piece));
            } else {
                piece = vec![turn];
            }
            phase = (phase + 1) % pattern.len();
            left = pattern[phase];
        }
        left -= length - done;
        if phase % 2 == 0 {
            piece.push(pair[1]);
        }
    }
    if piece.len() > 1 {
        pieces.push(piece);
    }
    pieces
}
