//! The panels of a field on a page: the whole, the enlarged details, and the colour bar beside them.

use super::axis::number;
use super::bands::Bands;
use super::canvas::{Canvas, EDGE, TITLE, WIDTH};
use super::drawing::{Drawing, Error};
use super::field::{Detail, Field, Mark, Panel, Window};
use super::frame::{Frame, Point};
use super::marks::marks;
use super::mesh_lines::{mesh_lines, undeformed};
use super::palette::{GREY, INK};
use super::pen::{Lettering, Pen, text_width};

/// The panels of a field, placed.
pub(super) struct Panels<'a> {
    field: &'a Field,
    bands: Bands,
    whole: Panel<'a>,
    details: Vec<Panel<'a>>,
}

/// Largest width of a lone panel, of several together, and the largest height.
const WHOLE: f64 = 640.0;
const TOGETHER: f64 = 768.0;
const TALLEST: f64 = 440.0;
/// Room of the word above a detail.
const ABOVE_DETAIL: f64 = 16.0;
/// Lowest end of a colour bar beside two panels, below their top.
const LOWEST: f64 = 240.0;
/// Room of the colour bar with its numbers, and the size of the quantity over it.
const BAR: f64 = 96.0;
const QUANTITY: f64 = 11.5;

impl Field {
    /// The field, drawn.
    pub fn drawing(&self) -> Drawing {
        let mut canvas = Canvas::new();
        let panels = self.panels(TITLE)?;
        panels.draw(&mut canvas);
        canvas.drawing(&self.title, (WIDTH - EDGE, panels.bottom() + 10.0), &[panels.notes()])
    }

    /// Places the panels in the middle of the width, below a height.
    pub(super) fn panels(&self, top: f64) -> Result<Panels<'_>, Error> {
        self.check()?;
        let panels = self.details.len() as f64 + 1.0;
        let (widest, top) = match self.details.is_empty() {
            true => (WHOLE, top + 4.0),
            false => ((TOGETHER + 2.0 * EDGE) / panels - 2.0 * EDGE, top + ABOVE_DETAIL),
        };
        let window = self.extent();
        let beside: f64 = self.details.iter().map(|one| 2.0 * EDGE + one.window.fitting(widest).0).sum();
        let used = window.fitting(widest).0 + beside + EDGE + text_width(&self.quantity, QUANTITY).max(BAR);
        let corner = ((0.5 * (WIDTH - used)).max(EDGE), top);
        let whole = Panel::of(self, window, self.magnification, window.frame(corner, widest));
        let mut right = whole.frame.right;
        let beside = |Detail { window, magnification, .. }: &Detail| {
            let frame = window.frame((right + 2.0 * EDGE, top), widest);
            right = frame.right;
            Panel::of(self, *window, *magnification, frame)
        };
        let details = self.details.iter().map(beside).collect();
        Ok(Panels { field: self, bands: self.bands()?, whole, details })
    }
}

impl Window {
    /// Its largest size in a panel.
    fn fitting(&self, widest: f64) -> (f64, f64) {
        let (across, up) = (self.x.1 - self.x.0, self.y.1 - self.y.0);
        let scale = (widest / across).min(TALLEST / up);
        (scale * across, scale * up)
    }

    fn frame(&self, (left, top): Point, widest: f64) -> Frame {
        let (width, height) = self.fitting(widest);
        Frame { left, top, right: left + width, bottom: top + height }
    }
}

impl Panels<'_> {
    /// Lower end.
    pub fn bottom(&self) -> f64 {
        let Frame { top, bottom, .. } = self.whole.frame;
        let least = if self.details.is_empty() { bottom } else { top + LOWEST };
        self.details.iter().map(|detail| detail.frame.bottom).fold(bottom.max(least), f64::max)
    }

    /// Paints bands, mesh and marks, shows and names the details, and draws the colour bar.
    pub fn draw(&self, canvas: &mut Canvas) {
        for panel in std::iter::once(&self.whole).chain(&self.details) {
            canvas.within(panel.frame, |canvas| {
                self.bands.paint(canvas, panel);
                mesh_lines(canvas, panel);
                marks(canvas, panel);
            });
        }
        if self.is_displaced() {
            canvas.within(self.whole.frame, |canvas| undeformed(canvas, &self.whole.undeformed()));
        }
        for (n, (zoom, Panel { frame, .. })) in self.field.details.iter().zip(&self.details).enumerate() {
            let place = |x, y| self.whole.place((x, y));
            let ((left, bottom), (right, top)) =
                (place(zoom.marked.x.0, zoom.marked.y.0), place(zoom.marked.x.1, zoom.marked.y.1));
            canvas.line(&Frame { left, top, right, bottom }.outline(), Pen::solid(INK, 1.4));
            canvas.line(&frame.outline(), Pen::solid(INK, 1.2));
            canvas.label((frame.left, frame.top - 9.0), &self.name(n), Lettering::start(11.0).coloured(GREY));
        }
        self.colour_bar(canvas);
    }

    fn is_displaced(&self) -> bool {
        let field = self.field;
        field.magnification > 0.0 && field.displacements.iter().any(|shift| shift.0.hypot(shift.1) > 0.0)
    }

    /// What stands above a detail: its name, and how much it is enlarged.
    fn name(&self, n: usize) -> String {
        let name = &self.field.details[n].name;
        format!("{} ×{:.1}", if name.is_empty() { "framed" } else { name }, self.details[n].scale / self.whole.scale)
    }

    /// The bands one above the other with their ends, and the quantity over them.
    fn colour_bar(&self, canvas: &mut Canvas) {
        let bands = &self.bands;
        let (left, top) = (self.details.last().unwrap_or(&self.whole).frame.right + EDGE + 8.0, self.whole.frame.top);
        let whole = Frame { left, top: top + 24.0, right: left + 14.0, bottom: self.bottom() };
        let height = whole.height().min(26.0 * bands.count() as f64);
        let level = |n: usize| whole.top + height * (1.0 - n as f64 / bands.count() as f64);
        for band in 0..bands.count() {
            let step = Frame { top: level(band + 1), bottom: level(band), ..whole };
            canvas.tiles(&[step.corners().to_vec()], bands.colour(band));
        }
        canvas.line(&Frame { bottom: level(0), ..whole }.outline(), Pen::solid(GREY, 0.8));
        let (right, largest) = (whole.right, bands.levels.iter().fold(0.0, |largest, level| level.abs().max(largest)));
        for (n, &value) in bands.levels.iter().enumerate() {
            canvas.line(&[(right, level(n)), (right + 3.5, level(n))], Pen::solid(GREY, 0.8));
            let text = number(value, bands.step, largest);
            canvas.label((right + 7.0, level(n)), &text, Lettering::start(10.5));
        }
        canvas.label((left, whole.top - 15.0), &self.field.quantity, Lettering::start(QUANTITY));
    }

    /// The field's notes, the magnification of the displacements, and what marks stand for.
    pub fn notes(&self) -> String {
        let field = self.field;
        let mut notes = field.notes.clone();
        if self.is_displaced() {
            let other = |zoom: &&Detail| (zoom.magnification - field.magnification).abs() > 0.0;
            notes.push(match field.details.iter().find(other) {
                Some(zoom) => format!("Displacements ×{}, in details ×{}.", field.magnification, zoom.magnification),
                None => format!("Displacements ×{}.", field.magnification),
            });
        }
        let any = |kind: fn(&Mark) -> bool| field.marks.iter().any(kind);
        let meant = [
            ("triangles: fixed", any(|mark| matches!(mark, Mark::Fixed(..)))),
            ("arrows: loads and prescribed displacements", any(|mark| matches!(mark, Mark::Pushed(..)))),
            ("hatched: rigid, as far as contact is looked for", any(|mark| matches!(mark, Mark::Rigid(_)))),
            ("dashed: undeformed", self.is_displaced()),
        ];
        let meant: Vec<&str> = meant.into_iter().filter(|(_, shown)| *shown).map(|(text, _)| text).collect();
        if let Some((first, rest)) = meant.split_first() {
            let (initial, tail) = first.split_at(1);
            let first = format!("{}{tail}", initial.to_uppercase());
            notes.push([&[first.as_str()], rest].concat().join("; ") + ".");
        }
        notes.join(" ")
    }
}
