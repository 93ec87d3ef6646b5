//! Rectangles on the canvas, and what of a line lies in them.

use super::canvas::Point;

/// A rectangle on the canvas, y downwards [display pixels].
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    pub left: f64,
    pub top: f64,
    pub right: f64,
    pub bottom: f64,
}

/// A line this close to the rectangle's edge lies inside, whatever round-off says \[display pixels\].
const SLACK: f64 = 1e-6;

impl Frame {
    /// Width [display pixels].
    pub fn width(&self) -> f64 {
        self.right - self.left
    }

    /// Height [display pixels].
    pub fn height(&self) -> f64 {
        self.bottom - self.top
    }

    /// The four corners, counter-clockwise from the lower left.
    pub fn corners(&self) -> [Point; 4] {
        [(self.left, self.bottom), (self.right, self.bottom), (self.right, self.top), (self.left, self.top)]
    }

    /// The outline as a closed line.
    pub fn outline(&self) -> [Point; 5] {
        let [a, b, c, d] = self.corners();
        [a, b, c, d, a]
    }

    /// True within half a pixel of the rectangle.
    pub fn holds(&self, (x, y): Point) -> bool {
        x >= self.left - 0.5 && x <= self.right + 0.5 && y >= self.top - 0.5 && y <= self.bottom + 0.5
    }

    /// The pieces of a polyline inside the rectangle.
    pub fn clip(&self, line: &[Point]) -> Vec<Vec<Point>> {
        let mut pieces: Vec<Vec<Point>> = Vec::new();
        let mut open = false;
        for pair in line.windows(2) {
            let Some((start, end)) = self.clip_segment(pair[0], pair[1]) else {
                open = false;
                continue;
            };
            match pieces.last_mut() {
                Some(piece) if open => piece.push(end),
                _ => pieces.push(vec![start, end]),
            }
            open = distance(end, pair[1]) < 1e-9;
        }
        pieces
    }

    /// The part of a segment inside the rectangle (Liang & Barsky 1984).
    fn clip_segment(&self, a: Point, b: Point) -> Option<(Point, Point)> {
        let (dx, dy) = (b.0 - a.0, b.1 - a.1);
        let rooms = [a.0 - self.left, self.right - a.0, a.1 - self.top, self.bottom - a.1].map(|room| room + SLACK);
        let sides = [-dx, dx, -dy, dy].into_iter().zip(rooms);
        let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
        for (rate, room) in sides {
            if rate.abs() < SLACK {
                if room < 0.0 {
                    return None;
                }
            } else if rate < 0.0 {
                enter = enter.max(room / rate);
            } else {
                leave = leave.min(room / rate);
            }
        }
        let at = |share: f64| (a.0 + share * dx, a.1 + share * dy);
        // A segment that ends inside keeps its end to the last bit.
        let end = if leave < 1.0 { at(leave) } else { b };
        (enter <= leave).then(|| (at(enter), end))
    }
}

/// Distance of two points.
pub(super) fn distance(a: Point, b: Point) -> f64 {
    (a.0 - b.0).hypot(a.1 - b.1)
}
