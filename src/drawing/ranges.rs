//! Ranges in a chart: areas between curves, bars on points, and points marked with words.

use super::canvas::Canvas;
use super::chart::{Bars, Remark, Ribbon};
use super::frame::Point;
use super::palette::tint;
use super::pen::{Lettering, Pen};
use super::plot::{GUIDE_SIZE, Plot};

/// How much of its colour an area has.
pub(super) const RIBBON: f64 = 0.3;
/// Width of a bar and of its ends.
pub(super) const BAR: f64 = 1.1;
const CAP: f64 = 2.6;
const RING: f64 = 6.5;

impl Plot<'_> {
    /// Fills the area between two curves.
    pub fn ribbon(&self, canvas: &mut Canvas, Ribbon { points, colour, .. }: &Ribbon) {
        let side = |k: usize| points.iter().map(move |point| self.place((point[0], point[k])));
        let outline: Vec<Point> =
            side(1).chain(side(2).rev()).filter(|at| at.0.is_finite() && at.1.is_finite()).collect();
        canvas.within(self.frame, |canvas| canvas.area(&outline, tint(*colour, RIBBON)));
    }

    /// Draws bars with short strokes across their ends; of one that leaves the frame, what lies inside.
    pub fn bars(&self, canvas: &mut Canvas, Bars { ends, colour, .. }: &Bars) {
        let strokes = ends.iter().map(|ends| ends.map(|end| self.place(end)));
        let strokes = strokes.filter(|ends| ends.iter().all(|(x, y)| x.is_finite() && y.is_finite()));
        let pieces: Vec<Vec<Point>> = strokes.flat_map(bar).flat_map(|stroke| self.frame.clip(&stroke)).collect();
        canvas.lines(&pieces, Pen::solid(*colour, BAR));
    }

    /// Draws a ring and the words beside it.
    pub fn remark(&self, canvas: &mut Canvas, Remark { at, text, right, colour, .. }: &Remark) {
        let (x, y) = self.place(*at);
        if self.frame.holds((x, y)) {
            ring(canvas, (x, y), Pen::solid(*colour, 1.6));
            let (side, lettering) =
                if *right { (1.0, Lettering::start(GUIDE_SIZE)) } else { (-1.0, Lettering::end(GUIDE_SIZE)) };
            canvas.label((x + side * (RING + 2.0), y + RING + 2.0), text, lettering.coloured(*colour).bold());
        }
    }
}

/// A bar and its ends.
pub(super) fn bar([a, b]: [Point; 2]) -> [Vec<Point>; 3] {
    let upright = (b.0 - a.0).abs() < (b.1 - a.1).abs();
    let (dx, dy) = if upright { (CAP, 0.0) } else { (0.0, CAP) };
    let cap = |(x, y): Point| vec![(x - dx, y - dy), (x + dx, y + dy)];
    [vec![a, b], cap(a), cap(b)]
}

/// A ring without a filling.
pub(super) fn ring(canvas: &mut Canvas, (x, y): Point, pen: Pen) {
    const PIECES: usize = 24;
    let place = |n: usize| {
        let angle = std::f64::consts::TAU * n as f64 / PIECES as f64;
        (x + RING * angle.cos(), y + RING * angle.sin())
    };
    canvas.line(&(0..=PIECES).map(place).collect::<Vec<_>>(), pen);
}
