//! What stands in a chart beside the curves: shaded ranges, reference lines and triangles of orders.

use super::canvas::Canvas;
use super::chart::{Band, Direction, Guide, Slope};
use super::frame::Frame;
use super::palette::{GREY, tint};
use super::pen::{Lettering, Pen, text_width};
use super::plot::{GUIDE_SIZE, Plot};

const BAND: f64 = 0.13;

impl Plot<'_> {
    /// Shades a range.
    pub fn band(&self, canvas: &mut Canvas, band: &Band) {
        canvas.area(&self.band_frame(band).corners(), tint(GREY, BAND));
    }

    fn band_frame(&self, band: &Band) -> Frame {
        let frame = self.frame;
        let (from, to) = (self.place((band.from, band.from)), self.place((band.to, band.to)));
        match band.direction {
            Direction::Vertical => Frame { left: from.0.max(frame.left), right: to.0.min(frame.right), ..frame },
            Direction::Horizontal => Frame { top: to.1.max(frame.top), bottom: from.1.min(frame.bottom), ..frame },
        }
    }

    /// Writes the label: beside a horizontal band, at the upper end of a vertical one, upright where it is narrow.
    pub fn band_label(&self, canvas: &mut Canvas, band: &Band) {
        let area = self.band_frame(band);
        let (x, y) = area.middle();
        if band.direction == Direction::Horizontal {
            return canvas.label((area.right + 5.0, y), &band.label, Lettering::start(GUIDE_SIZE).coloured(GREY));
        }
        let lettering = Lettering::middle(GUIDE_SIZE).coloured(GREY);
        let half = 0.5 * text_width(&band.label, GUIDE_SIZE);
        let flat = 2.0 * half < area.width();
        let (across, up) = if flat { (half, 8.0) } else { (8.0, half) };
        let y = area.top + up + 5.0;
        let backing = Frame { left: x - across, top: y - up, right: x + across, bottom: y + up };
        canvas.area(&backing.corners(), tint(GREY, BAND));
        canvas.label((x, y), &band.label, if flat { lettering } else { lettering.upright() });
    }

    /// Draws a triangle of an order, which stands beside its vertical leg.
    pub fn slope(&self, canvas: &mut Canvas, slope: &Slope) {
        let [start, end, corner] = slope.corners().map(|corner| self.place(corner));
        canvas.area(&[start, end, corner], tint(GREY, BAND));
        canvas.line(&[start, end, corner, start], Pen::solid(GREY, 1.0));
        let (upright, side, lettering) = match slope.above {
            true => (start, -5.0, Lettering::end(GUIDE_SIZE)),
            false => (end, 5.0, Lettering::start(GUIDE_SIZE)),
        };
        let beside = (corner.0 + side, 0.5 * (corner.1 + upright.1));
        canvas.label(beside, &format!("order {}", slope.order), lettering.coloured(GREY));
    }

    /// Draws a reference line, its label outside the frame.
    pub fn guide(&self, canvas: &mut Canvas, Guide { direction, at, label }: &Guide) {
        let ((x, y), frame) = (self.place((*at, *at)), self.frame);
        let (ends, place, lettering) = match direction {
            Direction::Horizontal => {
                ([(frame.left, y), (frame.right, y)], (frame.right + 5.0, y), Lettering::start(GUIDE_SIZE))
            }
            Direction::Vertical => {
                ([(x, frame.top), (x, frame.bottom)], (x, self.above() - 9.0), Lettering::middle(GUIDE_SIZE))
            }
        };
        canvas.line(&ends, Pen::dashed(GREY, 1.0));
        canvas.label(place, label, lettering.coloured(GREY));
    }
}
