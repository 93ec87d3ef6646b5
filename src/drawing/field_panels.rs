//! The panels of a field on a page: the whole, the enlarged detail, and the colour bar beside them.

use super::bands::Bands;
use super::canvas::{Canvas, EDGE, TITLE, WIDTH};
use super::drawing::Drawing;
use super::error::Error;
use super::field::{Detail, Field, Window};
use super::frame::{Frame, Point};
use super::mesh_lines::mesh_lines;
use super::numbers::number;
use super::palette::{GREY, INK};
use super::panel::Panel;
use super::pen::{Lettering, Pen, text_width};

/// The panels of a field, placed.
pub(super) struct Panels<'a> {
    field: &'a Field,
    bands: Bands,
    whole: Panel<'a>,
    detail: Option<Panel<'a>>,
}

/// Largest width of a lone panel and of one of two, and the largest height.
const WHOLE: f64 = 640.0;
const HALF: f64 = 366.0;
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
        Drawing::of(self.drawn())
    }

    fn drawn(&self) -> Result<Drawing, Error> {
        let mut canvas = Canvas::new();
        let panels = self.panels(TITLE)?;
        panels.draw(&mut canvas);
        canvas.drawing(&self.title, (WIDTH - EDGE, panels.bottom() + 10.0), &[panels.notes()])
    }

    /// Places the panels in the middle of the width, below a height.
    pub(super) fn panels(&self, top: f64) -> Result<Panels<'_>, Error> {
        self.check()?;
        let (widest, top) = if self.zoom.is_some() { (HALF, top + ABOVE_DETAIL) } else { (WHOLE, top + 4.0) };
        let window = self.extent();
        let beside = self.zoom.map_or(0.0, |zoom| 2.0 * EDGE + zoom.window.fitting(widest).0);
        let used = window.fitting(widest).0 + beside + EDGE + text_width(&self.quantity, QUANTITY).max(BAR);
        let corner = ((0.5 * (WIDTH - used)).max(EDGE), top);
        let whole = Panel::of(self, window, self.magnification, window.frame(corner, widest));
        let detail = self.zoom.map(|Detail { window, magnification, .. }| {
            Panel::of(self, window, magnification, window.frame((whole.frame.right + 2.0 * EDGE, top), widest))
        });
        Ok(Panels { field: self, bands: self.bands()?, whole, detail })
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
        self.detail.as_ref().map_or(bottom, |detail| bottom.max(detail.frame.bottom).max(top + LOWEST))
    }

    /// Paints bands and mesh, marks the detail and draws the colour bar.
    pub fn draw(&self, canvas: &mut Canvas) {
        for panel in [Some(&self.whole), self.detail.as_ref()].into_iter().flatten() {
            canvas.within(panel.frame, |canvas| {
                self.bands.paint(canvas, panel);
                mesh_lines(canvas, panel);
            });
        }
        if let (Some(zoom), Some(Panel { frame, .. })) = (self.field.zoom, &self.detail) {
            let place = |x, y| self.whole.place((x, y));
            let ((left, bottom), (right, top)) =
                (place(zoom.marked.x.0, zoom.marked.y.0), place(zoom.marked.x.1, zoom.marked.y.1));
            canvas.line(&Frame { left, top, right, bottom }.outline(), Pen::solid(INK, 1.4));
            canvas.line(&frame.outline(), Pen::solid(INK, 1.2));
            canvas.label((frame.left, frame.top - 9.0), "detail", Lettering::start(11.0).coloured(GREY));
        }
        self.colour_bar(canvas);
    }

    /// The bands one above the other with their ends, and the quantity over them.
    fn colour_bar(&self, canvas: &mut Canvas) {
        let bands = &self.bands;
        let (left, top) = (self.detail.as_ref().unwrap_or(&self.whole).frame.right + EDGE + 8.0, self.whole.frame.top);
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

    /// The field's notes, the magnification of the displacements and the enlargement of the detail.
    pub fn notes(&self) -> String {
        let field = self.field;
        let mut notes = field.notes.clone();
        if field.displacements.iter().any(|shift| shift.0.hypot(shift.1) > 0.0) && field.magnification > 0.0 {
            let other = |zoom: &Detail| (zoom.magnification - field.magnification).abs() > 0.0;
            notes.push(match field.zoom.filter(other) {
                Some(zoom) => format!("Displacements ×{}, in the detail ×{}.", field.magnification, zoom.magnification),
                None => format!("Displacements ×{}.", field.magnification),
            });
        }
        let enlarged = self.detail.as_ref().map(|detail| detail.scale / self.whole.scale);
        notes.extend(enlarged.map(|factor| format!("Right: the framed detail, ×{factor:.1}.")));
        notes.join(" ")
    }
}
