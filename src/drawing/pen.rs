//! Pens and lettering: how lines and texts are set.

use super::palette::{Dash, INK};
use super::theme::Colour;

/// Width of an ordinary curve [display pixels].
pub(super) const LINE_WIDTH: f64 = 1.8;

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

    /// A dashed line.
    pub fn dashed(colour: Colour, width: f64) -> Pen {
        Pen { colour, width, dash: Dash::Dashed }
    }
}

/// How a text is set.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lettering {
    pub size: f64,
    pub colour: Colour,
    /// Which part stands at the place, in the words of SVG.
    pub anchor: &'static str,
    pub bold: bool,
    /// Reads from bottom to top.
    pub upright: bool,
}

impl Lettering {
    /// Text beginning at the place.
    pub fn start(size: f64) -> Lettering {
        Lettering { size, colour: INK, anchor: "start", bold: false, upright: false }
    }

    /// Text centred on the place.
    pub fn middle(size: f64) -> Lettering {
        Lettering { anchor: "middle", ..Lettering::start(size) }
    }

    /// Text ending at the place.
    pub fn end(size: f64) -> Lettering {
        Lettering { anchor: "end", ..Lettering::start(size) }
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
        'f' | 't' | 'r' | '(' | ')' | '[' | ']' | '-' | '⁰'..='ₜ' | '¹' | '²' | '³' => 0.42,
        'm' | 'w' | 'M' | 'W' => 0.92,
        c if c.is_uppercase() => 0.70,
        _ => 0.62,
    };
    size * text.chars().map(share).sum::<f64>()
}

/// Width of the widest text.
pub(super) fn widest<'a>(texts: impl IntoIterator<Item = &'a str>, size: f64) -> f64 {
    texts.into_iter().map(|text| text_width(text, size)).fold(0.0, f64::max)
}

/// Texts broken into lines of a width.
pub(super) fn wrapped(texts: &[String], size: f64, width: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for text in texts {
        let mut words = text.split_whitespace();
        let mut line = words.next().unwrap_or_default().to_string();
        for word in words {
            let longer = format!("{line} {word}");
            if text_width(&longer, size) > width {
                lines.push(line);
                line = word.to_string();
            } else {
                line = longer;
            }
        }
        lines.push(line);
    }
    lines
}
