//! What stands in a chart beside the curves: reference lines and triangles of orders.

use super::canvas::Canvas;
use super::chart::{Direction, Guide, Slope};
use super::palette::{GREY, tint};
use super::pen::{Lettering, Pen};
use super::plot::{GUIDE_SIZE, Plot};

/// How much of grey the area of a triangle has.
const TRIANGLE: f64 = 0.13;

impl Plot<'_> {
    /// Draws a triangle of an order, which stands beside its vertical leg.
    pub fn slope(&self, canvas: &mut Canvas, slope: &Slope) {
        let [start, end, corner] = slope.corners().map(|corner| self.place(corner));
        canvas.area(&[start, end, corner], tint(GREY, TRIANGLE));
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
                ([(x, frame.top), (x, frame.bottom)], (x, self.above() - 10.5), Lettering::middle(GUIDE_SIZE))
            }
        };
        canvas.line(&ends, Pen::dashed(GREY, 1.0));
        canvas.label(place, label, lettering.coloured(GREY));
    }
}
