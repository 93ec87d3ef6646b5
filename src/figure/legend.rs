//! The legend: one entry per style, in columns outside the data.

use super::canvas::{Canvas, Point};
use super::chart::{Chart, Series};
use super::palette::{CARD, Colour, Dash, GREY, Marker, Style};
use super::pen::{Lettering, Pen, text_width};
use super::plot::LINE_WIDTH;

const SIZE: f64 = 11.5;
const ROW: f64 = 18.0;
const SAMPLE: f64 = 44.0;
const GAP: f64 = 8.0;
const MARKER: f64 = 3.8;

/// One line of the legend; without a style it explains the hollow signs, which a series of only such explains itself.
struct Entry {
    label: String,
    style: Option<Style>,
    hollow: bool,
}

/// The entries of one chart or of several.
pub(super) struct Legend {
    entries: Vec<Entry>,
}

impl Legend {
    /// Every labelled series once, in order of appearance.
    pub fn of(charts: &[Chart]) -> Legend {
        let mut entries: Vec<Entry> = Vec::new();
        let all = || charts.iter().flat_map(|chart| &chart.series);
        for series in all() {
            let known = entries.iter().any(|entry| entry.label == series.label);
            if !known && !series.label.is_empty() {
                let hollow = series.points.is_empty() && !series.hollow.is_empty();
                entries.push(Entry { label: series.label.clone(), style: Some(series.style), hollow });
            }
        }
        let explained = entries.iter().any(|entry| entry.hollow);
        if !explained && all().any(|series: &Series| !series.hollow.is_empty()) {
            entries.push(Entry { label: "hollow: not converged".to_string(), style: None, hollow: true });
        }
        Legend { entries }
    }

    /// True when there is nothing to tell apart.
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// Width of one column.
    pub fn column_width(&self) -> f64 {
        let widest = self.entries.iter().map(|entry| text_width(&entry.label, SIZE)).fold(0.0, f64::max);
        SAMPLE + GAP + widest
    }

    /// Columns that fit side by side.
    pub fn columns(&self, width: f64) -> usize {
        let fitting = (width / (self.column_width() + 2.0 * GAP)).floor() as usize;
        fitting.clamp(1, self.entries.len().max(1))
    }

    /// Height with so many columns.
    pub fn height(&self, columns: usize) -> f64 {
        ROW * self.entries.len().div_ceil(columns) as f64
    }

    /// Draws the entries from an upper left corner, column by column.
    pub fn draw(&self, canvas: &mut Canvas, (left, top): Point, columns: usize) {
        let pitch = self.column_width() + 2.0 * GAP;
        let rows = self.entries.len().div_ceil(columns).max(1);
        for (place, entry) in self.entries.iter().enumerate() {
            let x = left + pitch * (place / rows) as f64;
            let y = top + ROW * ((place % rows) as f64 + 0.5);
            sample(canvas, (x, y), entry);
            canvas.label((x + SAMPLE + GAP, y), &entry.label, Lettering::start(SIZE));
        }
    }
}

fn sample(canvas: &mut Canvas, (x, y): Point, entry: &Entry) {
    let centre = (x + 0.5 * SAMPLE, y);
    let Some(style) = entry.style else {
        return hollow_marker(canvas, centre, Marker::Circle, MARKER, GREY);
    };
    if entry.hollow {
        return hollow_marker(canvas, centre, style.marker, MARKER, style.colour);
    }
    if style.dash != Dash::Absent {
        let pen = Pen { colour: style.colour, width: LINE_WIDTH, dash: style.dash };
        canvas.line(&[(x, y), (x + SAMPLE, y)], pen);
    }
    marker(canvas, centre, style.marker, MARKER, style.colour);
}

/// A filled sign with a thin rim of the card, so that it stands off its own line.
pub(super) fn marker(canvas: &mut Canvas, centre: Point, sign: Marker, radius: f64, colour: Colour) {
    match sign {
        Marker::Absent => {}
        Marker::Circle => {
            canvas.disc(centre, radius + 0.8, CARD);
            canvas.disc(centre, radius, colour);
        }
        Marker::Cross => cross(canvas, centre, radius, colour),
        _ => {
            canvas.area(&corners(sign, centre, radius + 1.1), CARD);
            canvas.area(&corners(sign, centre, radius), colour);
        }
    }
}

/// The sign of a run that did not converge; an unmarked curve gets a circle.
pub(super) fn hollow_marker(canvas: &mut Canvas, centre: Point, sign: Marker, radius: f64, colour: Colour) {
    match sign {
        Marker::Absent | Marker::Circle => {
            canvas.disc(centre, radius, colour);
            canvas.disc(centre, radius - 1.3, CARD);
        }
        Marker::Cross => cross(canvas, centre, radius, colour),
        _ => {
            let mut outline = corners(sign, centre, radius);
            canvas.area(&outline, CARD);
            outline.push(outline[0]);
            canvas.line(&outline, Pen::solid(colour, 1.3));
        }
    }
}

fn cross(canvas: &mut Canvas, (x, y): Point, radius: f64, colour: Colour) {
    let arm = 0.85 * radius;
    for slope in [-1.0, 1.0] {
        let ends = [(x - arm, y - slope * arm), (x + arm, y + slope * arm)];
        canvas.line(&ends, Pen::solid(colour, 1.7));
    }
}

/// Corners of a sign of the area of a disc, roughly.
fn corners(sign: Marker, (x, y): Point, radius: f64) -> Vec<Point> {
    let shape: &[Point] = match sign {
        Marker::Square => &[(-0.88, -0.88), (0.88, -0.88), (0.88, 0.88), (-0.88, 0.88)],
        Marker::Triangle => &[(0.0, -1.2), (1.1, 0.75), (-1.1, 0.75)],
        Marker::Wedge => &[(0.0, 1.2), (1.1, -0.75), (-1.1, -0.75)],
        _ => &[(0.0, -1.25), (1.25, 0.0), (0.0, 1.25), (-1.25, 0.0)],
    };
    shape.iter().map(|&(dx, dy)| (x + radius * dx, y + radius * dy)).collect()
}
