//! The page around a drawing: title above, small print below.

use super::canvas::Canvas;
use super::palette::GREY;
use super::pen::{Lettering, text_width};

/// Margin left and right.
pub(super) const EDGE: f64 = 18.0;
/// Room of the title.
pub(super) const TITLE: f64 = 40.0;
/// Size of the title.
pub(super) const TITLE_SIZE: f64 = 15.0;

const NOTE_SIZE: f64 = 10.5;
const NOTE_ROW: f64 = 15.0;

/// The title in the upper left corner.
pub(super) fn heading(canvas: &mut Canvas, title: &str) {
    canvas.label((EDGE, 0.5 * TITLE), title, Lettering::start(TITLE_SIZE).bold());
}

/// Notes broken into lines of a width.
pub(super) fn wrapped(notes: &[String], width: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for note in notes {
        let mut line = String::new();
        for word in note.split_whitespace() {
            if !line.is_empty() && text_width(&format!("{line} {word}"), NOTE_SIZE) > width {
                lines.push(std::mem::take(&mut line));
            }
            if !line.is_empty() {
                line.push(' ');
            }
            line.push_str(word);
        }
        lines.push(line);
    }
    lines
}

/// Room the lines take below the drawing.
pub(super) fn notes_height(lines: &[String]) -> f64 {
    12.0 + NOTE_ROW * lines.len() as f64
}

/// The lines below the drawing.
pub(super) fn small_print(canvas: &mut Canvas, lines: &[String], top: f64) {
    for (row, line) in lines.iter().enumerate() {
        let place = (EDGE, top + NOTE_ROW * (row as f64 + 0.5));
        canvas.label(place, line, Lettering::start(NOTE_SIZE).coloured(GREY));
    }
}
