//! What stands in a chart beside the curves: reference lines, triangles of orders, areas, bars, and points marked with
//! words.

use super::canvas::Canvas;
use super::chart::{Bars, Direction, Guide, Remark, Slope};
use super::curves::{Curve, sampled};
use super::frame::{Frame, Point, between};
use super::palette::{GREY, tint};
use super::pen::{Lettering, Pen, text_width};
use super::plot::{GUIDE_SIZE, Plot};

/// Width of a bar and of its ends.
pub(super) const BAR: f64 = 1.1;
/// How much of grey the area of a triangle has.
const TRIANGLE: f64 = 0.13;
const CAP: f64 = 2.6;
const RING: f64 = 6.5;

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

    /// Draws bars with short strokes across their ends; of one that leaves the frame, what lies inside.
    pub fn bars(&self, canvas: &mut Canvas, Bars { ends, colour, .. }: &Bars) {
        let strokes = ends.iter().map(|ends| ends.map(|end| self.place(end)));
        let strokes = strokes.filter(|ends| ends.iter().all(|(x, y)| x.is_finite() && y.is_finite()));
        let pieces: Vec<Vec<Point>> = strokes.flat_map(bar).flat_map(|stroke| self.frame.clip(&stroke)).collect();
        canvas.lines(&pieces, Pen::solid(*colour, BAR));
    }

    /// Draws rings, and the words beside points.
    pub fn remarks(&self, canvas: &mut Canvas, curves: &[Curve]) {
        let shown: Vec<(&Remark, Point)> = self.chart.remarks.iter().map(|one| (one, self.place(one.at))).collect();
        let shown = || shown.iter().filter(|(_, at)| self.frame.holds(*at));
        for (Remark { colour, .. }, at) in shown().filter(|(remark, _)| remark.ring.is_some()) {
            ring(canvas, *at, Pen::solid(*colour, 1.6));
        }
        let mut taken: Vec<Frame> = shown().map(|(_, at)| Frame::around(*at, RING)).collect();
        taken.extend(curves.iter().flat_map(|curve| &curve.signs).map(|(at, radius)| Frame::around(*at, radius + 1.0)));
        let mut lines: Vec<Point> = curves.iter().flat_map(|curve| sampled(curve, 0.5 * GUIDE_SIZE)).collect();
        let bars = self.chart.bars.iter().flat_map(|bars| &bars.ends).map(|ends| ends.map(|end| self.place(end)));
        lines.extend(bars.flat_map(|[a, b]| (0..=32).map(move |k| between(a, b, f64::from(k) / 32.0))));
        for (Remark { text, colour, .. }, at) in shown() {
            let words = free_place(*at, BOLD * text_width(text, GUIDE_SIZE), self.frame, &taken, &lines);
            let lettering = Lettering::middle(GUIDE_SIZE).coloured(*colour).bold();
            canvas.label(words.middle(), text, lettering);
            taken.push(words);
        }
    }
}

/// Width of bold letters over that of plain ones.
const BOLD: f64 = 1.15;

/// Of places around a point one where words of a width cover nothing that is taken and stay in the frame, on the fewest
/// points of lines, the nearest of these.
fn free_place((x, y): Point, width: f64, within: Frame, taken: &[Frame], lines: &[Point]) -> Frame {
    const AROUND: [Point; 8] =
        [(1.0, 0.0), (1.0, -1.0), (1.0, 1.0), (0.0, -1.0), (0.0, 1.0), (-1.0, 0.0), (-1.0, -1.0), (-1.0, 1.0)];
    let (half, tall) = (0.5 * width, 0.6 * GUIDE_SIZE);
    let at = |(distance, (across, down)): (usize, Point)| {
        let away = RING + 2.0 + 6.0 * distance as f64;
        let (x, y) = (x + across * (half + away), y + down * (tall + away));
        Frame { left: x - half, right: x + half, top: y - tall, bottom: y + tall }
    };
    let wrong = |words: &Frame| {
        let outside = [(words.left, words.top), (words.right, words.bottom)].iter().any(|at| !within.holds(*at));
        let covered = taken.iter().filter(|other| other.overlaps(words)).count() + usize::from(outside);
        (covered, lines.iter().filter(|at| words.holds(**at)).count())
    };
    let places = (0..8).flat_map(|distance| AROUND.map(|to| (distance, to))).map(at);
    places.min_by_key(wrong).unwrap_or(at((0, AROUND[0])))
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
