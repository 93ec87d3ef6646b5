//! What stands in a chart beside the curves: shaded ranges and reference lines.

use super::canvas::Canvas;
use super::chart::{Band, Direction, Guide};
use super::frame::Frame;
use super::palette::{Dash, GREY, tint};
use super::pen::{Lettering, Pen, text_width};
use super::plot::Plot;

/// Size of the labels of guides and bands.
pub(super) const GUIDE_SIZE: f64 = 10.5;

const BAND: f64 = 0.13;

impl Plot<'_> {
    /// Shades a range.
    pub fn band(&self, canvas: &mut Canvas, band: &Band) {
        canvas.area(&self.band_frame(band).corners(), tint(GREY, BAND));
    }

    fn band_frame(&self, band: &Band) -> Frame {
        let frame = self.data_frame();
        let across = |value: f64| self.place((value, value));
        let (from, to) = (across(band.from), across(band.to));
        match band.direction {
            Direction::Vertical => Frame { left: from.0.max(frame.left), right: to.0.min(frame.right), ..frame },
            Direction::Horizontal => Frame { top: to.1.max(frame.top), bottom: from.1.min(frame.bottom), ..frame },
        }
    }

    /// Writes the label: beside a horizontal band, at the upper end of a vertical one, upright where it is narrow.
    pub fn band_label(&self, canvas: &mut Canvas, band: &Band) {
        let area = self.band_frame(band);
        let lettering = Lettering::middle(GUIDE_SIZE).coloured(GREY);
        if band.direction == Direction::Horizontal {
            let place = (area.right + 5.0, 0.5 * (area.top + area.bottom));
            let beside = Lettering::start(GUIDE_SIZE).coloured(GREY);
            return canvas.label(place, &band.label, beside);
        }
        let half = 0.5 * text_width(&band.label, GUIDE_SIZE);
        let flat = 2.0 * half < area.width();
        let (across, up) = if flat { (half, 8.0) } else { (8.0, half) };
        let (x, y) = (0.5 * (area.left + area.right), area.top + up + 5.0);
        let backing = Frame { left: x - across, top: y - up, right: x + across, bottom: y + up };
        canvas.area(&backing.corners(), tint(GREY, BAND));
        canvas.label((x, y), &band.label, if flat { lettering } else { lettering.upright() });
    }

    /// Draws the reference lines, their labels outside the frame.
    pub fn guides(&self, canvas: &mut Canvas) {
        let pen = Pen { colour: GREY, width: 1.0, dash: Dash::Dashed };
        for Guide { direction, at, label } in &self.chart().guides {
            let ((x, y), frame) = (self.place((*at, *at)), self.data_frame());
            match direction {
                Direction::Horizontal => {
                    canvas.line(&[(frame.left, y), (frame.right, y)], pen);
                    canvas.label((frame.right + 5.0, y), label, Lettering::start(GUIDE_SIZE).coloured(GREY));
                }
                Direction::Vertical => {
                    canvas.line(&[(x, frame.top), (x, frame.bottom)], pen);
                    let above = frame.top - self.lanes_height() - 9.0;
                    canvas.label((x, above), label, Lettering::middle(GUIDE_SIZE).coloured(GREY));
                }
            }
        }
    }
}
