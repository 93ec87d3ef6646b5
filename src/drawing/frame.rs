//! Rectangles on the canvas, and what of a line lies in them.

/// A place on the canvas, y downwards [display pixels].
pub(super) type Point = (f64, f64);

/// A rectangle on the canvas, y downwards [display pixels].
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    pub left: f64,
    pub top: f64,
    pub right: f64,
    pub bottom: f64,
}

/// A line this close to the rectangle's edge lies inside \[display pixels\].
const ROUND_OFF: f64 = 1e-6;

impl Frame {
    /// The square around a point.
    pub fn around((x, y): Point, half: f64) -> Frame {
        Frame { left: x - half, top: y - half, right: x + half, bottom: y + half }
    }

    /// Whether two rectangles have more than a rim in common.
    pub fn overlaps(&self, other: &Frame) -> bool {
        self.left < other.right && other.left < self.right && self.top < other.bottom && other.top < self.bottom
    }

    /// Width [display pixels].
    pub fn width(&self) -> f64 {
        self.right - self.left
    }

    /// Height [display pixels].
    pub fn height(&self) -> f64 {
        self.bottom - self.top
    }

    /// The middle.
    pub fn middle(&self) -> Point {
        (0.5 * (self.left + self.right), 0.5 * (self.top + self.bottom))
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

    /// The rectangle moved outwards on all sides.
    pub fn widened(&self, by: f64) -> Frame {
        Frame { left: self.left - by, top: self.top - by, right: self.right + by, bottom: self.bottom + by }
    }

    /// True inside and on the rim.
    pub fn holds(&self, (x, y): Point) -> bool {
        x >= self.left && x <= self.right && y >= self.top && y <= self.bottom
    }

    /// False when the points lie all beyond one side.
    pub fn meets(&self, points: &[Point]) -> bool {
        let any = |near: &dyn Fn(&Point) -> bool| points.iter().any(near);
        any(&|p| p.0 >= self.left)
            && any(&|p| p.0 <= self.right)
            && any(&|p| p.1 >= self.top)
            && any(&|p| p.1 <= self.bottom)
    }

    /// The pieces of a polyline inside the rectangle: viewers cannot be left with places far beyond it.
    pub fn clip(&self, line: &[Point]) -> Vec<Vec<Point>> {
        let mut pieces: Vec<Vec<Point>> = Vec::new();
        for (start, end) in line.windows(2).filter_map(|pair| self.clip_segment(pair[0], pair[1])) {
            match pieces.last_mut() {
                Some(piece) if piece.last().is_some_and(|&last| distance(last, start) < 1e-9) => piece.push(end),
                _ => pieces.push(vec![start, end]),
            }
        }
        pieces
    }

    /// The part of a segment inside the rectangle (Liang & Barsky 1984).
    fn clip_segment(&self, a: Point, b: Point) -> Option<(Point, Point)> {
        let rises = [a.0 - b.0, b.0 - a.0, a.1 - b.1, b.1 - a.1];
        let rooms = [a.0 - self.left, self.right - a.0, a.1 - self.top, self.bottom - a.1];
        let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
        for (rise, room) in rises.into_iter().zip(rooms.map(|room| room + ROUND_OFF)) {
            match rise {
                _ if rise.abs() < ROUND_OFF && room < 0.0 => return None,
                _ if rise <= -ROUND_OFF => enter = enter.max(room / rise),
                _ if rise >= ROUND_OFF => leave = leave.min(room / rise),
                _ => {}
            }
        }
        // A segment that ends inside keeps its end to the last bit.
        let end = if leave < 1.0 { between(a, b, leave) } else { b };
        (enter <= leave).then(|| (between(a, b, enter), end))
    }
}

/// Distance of two points.
pub(super) fn distance(a: Point, b: Point) -> f64 {
    (a.0 - b.0).hypot(a.1 - b.1)
}

/// The point at a share of the way from one to the other.
pub(super) fn between(a: Point, b: Point, share: f64) -> Point {
    (a.0 + share * (b.0 - a.0), a.1 + share * (b.1 - a.1))
}
