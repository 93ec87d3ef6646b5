//! Panels of a field: where they stand, and the marked detail.

use super::canvas::{Canvas, Point};
use super::field::Window;
use super::frame::Frame;
use super::palette::{GREY, INK};
use super::pen::{Lettering, Pen};

/// Where one panel stands, and the scale of its drawing.
#[derive(Clone, Copy)]
pub(super) struct View {
    pub frame: Frame,
    pub window: Window,
    /// Display pixels per length.
    pub scale: f64,
}

impl View {
    /// The largest view of a window in the room below a corner.
    pub fn fitting(window: Window, (left, top): Point, (width, height): Point) -> View {
        let (across, up) = (window.x.1 - window.x.0, window.y.1 - window.y.0);
        let scale = (width / across).min(height / up);
        let frame = Frame { left, top, right: left + scale * across, bottom: top + scale * up };
        View { frame, window, scale }
    }

    /// Place of a point of the drawn shape on the canvas.
    pub fn place(&self, (x, y): Point) -> Point {
        let frame = &self.frame;
        (frame.left + self.scale * (x - self.window.x.0), frame.bottom - self.scale * (y - self.window.y.0))
    }
}

/// Frames the detail in the whole and beside it.
pub(super) fn mark_detail(canvas: &mut Canvas, whole: &View, detail: &View, marked: Window) {
    let (left, bottom) = whole.place((marked.x.0, marked.y.0));
    let (right, top) = whole.place((marked.x.1, marked.y.1));
    let marked = Frame { left, top, right, bottom };
    canvas.line(&marked.outline(), Pen::solid(INK, 1.4));
    canvas.line(&detail.frame.outline(), Pen::solid(INK, 1.2));
    canvas.label((detail.frame.left, detail.frame.top - 9.0), "detail", Lettering::start(11.0).coloured(GREY));
}
