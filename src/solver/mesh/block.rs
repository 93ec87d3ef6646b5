//! A structured block: four sides given point by point, the inside by transfinite interpolation; points of outlines,
//! met to the last bit on symmetry lines.

use std::f64::consts::FRAC_PI_2;

use crate::mesh::{Order, spacing};
use crate::scene::{BoundaryName, Curve};

/// Point of the plane \[mm\].
pub type Point = [f64; 2];

/// Point at the fraction `t` between two points.
pub(crate) fn between(a: Point, b: Point, t: f64) -> Point {
    [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t]
}

/// Point at radius `r` and angle `θ` from the downward vertical about a centre.
pub(crate) fn polar(centre: Point, radius: f64, angle: f64) -> Point {
    [centre[0] + radius * exact_sin(angle), centre[1] - radius * exact_sin(FRAC_PI_2 - angle)]
}

/// `sin` that is exactly zero at multiples of π, so that symmetry lines are met to the last bit.
pub(crate) fn exact_sin(angle: f64) -> f64 {
    let sin = angle.sin();
    if sin.abs() < 1e-15 { 0.0 } else { sin }
}

/// One side of a block: its lattice points, and the boundary it belongs to.
#[derive(Clone, Debug)]
pub struct Side {
    /// Lattice points: those of one cell after the other, common ends once.
    pub points: Vec<Point>,
    /// Names of the boundary, or of the line inside the body; none for sides nothing refers to.
    pub names: Vec<BoundaryName>,
    /// Whether the side lies inside the body.
    pub inside: bool,
}

/// Four sides; `bottom` and `top` run along ξ, `left` and `right` along η, counter-clockwise seen as a whole.
#[derive(Clone, Debug)]
pub struct Block {
    /// η = 0.
    pub bottom: Side,
    /// ξ = 1.
    pub right: Side,
    /// η = 1.
    pub top: Side,
    /// ξ = 0.
    pub left: Side,
}

impl Side {
    /// A side on a named boundary.
    pub fn named(boundary: impl Into<BoundaryName>, points: Vec<Point>) -> Self {
        Self { points, names: vec![boundary.into()], inside: false }
    }

    /// A side inside the body.
    pub fn inner(points: Vec<Point>) -> Self {
        Self { points, names: vec![], inside: true }
    }

    /// A named line inside the body, which may carry a load.
    pub fn line(name: impl Into<BoundaryName>, points: Vec<Point>) -> Self {
        Self { points, names: vec![name.into()], inside: true }
    }

    /// Whether it lies on a boundary, or on a line inside.
    pub fn is_on(&self, name: &str) -> bool {
        self.names.iter().any(|own| own == name)
    }

    /// The side with every point moved to its image.
    fn imaged(&self, image: impl Fn(&Point) -> Point) -> Self {
        Self { points: self.points.iter().map(image).collect(), ..self.clone() }
    }

    /// The side from its end to its begin.
    pub(super) fn backwards(mut self) -> Self {
        self.points.reverse();
        self
    }
}

impl Block {
    /// Its sides, counter-clockwise from the bottom.
    pub fn sides(&self) -> [&Side; 4] {
        [&self.bottom, &self.right, &self.top, &self.left]
    }

    /// Its corners, counter-clockwise from the lower left one.
    pub fn corners(&self) -> [Point; 4] {
        let last = |side: &Side| side.points[side.points.len() - 1];
        [self.bottom.points[0], last(&self.bottom), last(&self.top), self.top.points[0]]
    }

    /// The block with every side made into another one.
    fn map(self, made: impl Fn(Side) -> Side) -> Self {
        let [bottom, right, top, left] = [self.bottom, self.right, self.top, self.left].map(made);
        Self { bottom, right, top, left }
    }

    /// The block seen in a mirror on the horizontal at a height.
    pub fn turned_over(self, height: f64) -> Self {
        self.map(|side| side.imaged(|p| [p[0], 2.0 * height - p[1]])).upside_down()
    }

    /// A block that was drawn as seen in a mirror on the horizontal, bottom and top in each other's place, so that it
    /// is counter-clockwise.
    pub fn upside_down(self) -> Self {
        Self { bottom: self.top, right: self.right.backwards(), top: self.bottom, left: self.left.backwards() }
    }

    /// The block seen in a mirror on the vertical at an abscissa; left and right change places, so that it stays
    /// counter-clockwise.
    pub fn seen_in_mirror(&self, abscissa: f64) -> Self {
        self.clone().map(|side| side.imaged(|p| [2.0 * abscissa - p[0], p[1]])).the_other_way()
    }

    /// A block that was drawn as seen in a mirror on the vertical, right and left in each other's place, so that it is
    /// counter-clockwise.
    pub fn the_other_way(self) -> Self {
        Self { bottom: self.bottom.backwards(), right: self.left, top: self.top.backwards(), left: self.right }
    }

    /// Blocks on the right of a vertical, and their images in it.
    pub fn with_images(right: Vec<Self>, abscissa: f64) -> Vec<Self> {
        let left: Vec<Self> = right.iter().map(|block| block.seen_in_mirror(abscissa)).collect();
        right.into_iter().chain(left).collect()
    }

    /// The block with the sides of a boundary inside the body.
    pub fn without(self, boundary: &str) -> Self {
        self.instead_of(boundary, Side::inner)
    }

    /// The block with the sides of a boundary, or of a line inside, made again from their points.
    pub fn instead_of(self, boundary: &str, made: impl Fn(Vec<Point>) -> Side) -> Self {
        self.map(|side| if side.is_on(boundary) { made(side.points) } else { side })
    }

    /// Lattice size along ξ and η.
    pub fn size(&self) -> [usize; 2] {
        [self.bottom.points.len(), self.left.points.len()]
    }

    /// All lattice points, row by row from the bottom, by transfinite interpolation:
    /// `P = (1−η)b + ηt + (1−ξ)l + ξr − [(1−ξ)(1−η)P₀₀ + ξ(1−η)P₁₀ + ξηP₁₁ + (1−ξ)ηP₀₁]`.
    ///
    /// (ξ, η) is where the straight lines between equal positions of opposite sides meet.
    pub fn lattice(&self, order: Order) -> Vec<Vec<Point>> {
        let [bottom, right, top, left] = self.sides().map(|side| fractions(&side.points, order));
        let [columns, rows] = self.size();
        (0..rows)
            .map(|j| {
                (0..columns)
                    .map(|i| {
                        let at = crossing([bottom[i], top[i]], [left[j], right[j]]);
                        self.point(i, j, at)
                    })
                    .collect()
            })
            .collect()
    }

    fn point(&self, i: usize, j: usize, [xi, eta]: [f64; 2]) -> Point {
        let [columns, rows] = self.size();
        match (i, j) {
            (_, 0) => return self.bottom.points[i],
            (0, _) => return self.left.points[j],
            (_, j) if j + 1 == rows => return self.top.points[i],
            (i, _) if i + 1 == columns => return self.right.points[j],
            _ => {}
        }
        let (b, t) = (self.bottom.points[i], self.top.points[i]);
        let (l, r) = (self.left.points[j], self.right.points[j]);
        let (p00, p10) = (self.bottom.points[0], self.bottom.points[columns - 1]);
        let (p01, p11) = (self.top.points[0], self.top.points[columns - 1]);
        std::array::from_fn(|k| {
            let sides = (1.0 - eta) * b[k] + eta * t[k] + (1.0 - xi) * l[k] + xi * r[k];
            let corners =
                (1.0 - xi) * ((1.0 - eta) * p00[k] + eta * p01[k]) + xi * ((1.0 - eta) * p10[k] + eta * p11[k]);
            sides - corners
        })
    }
}

/// Where the line between ξ = `x[0]` (η = 0) and `x[1]` (η = 1) meets that between η = `y[0]` (ξ = 0) and `y[1]`.
fn crossing(x: [f64; 2], y: [f64; 2]) -> [f64; 2] {
    let (dx, dy) = (x[1] - x[0], y[1] - y[0]);
    let xi = (x[0] + dx * y[0]) / (1.0 - dx * dy);
    [xi, y[0] + dy * xi]
}

/// Normalised chord length of the lattice points of a side.
///
/// Of tensor cells that of their corners, with the cell's own positions between: inside a cell the map is then as
/// smooth as its sides.
fn fractions(points: &[Point], order: Order) -> Vec<f64> {
    if !order.is_tensor() {
        return chords(points);
    }
    let corners: Vec<Point> = points.iter().copied().step_by(order.intervals()).collect();
    spacing::lattice(&chords(&corners), 0, order)
}

/// Length of the chords up to each point, over that of all.
fn chords(points: &[Point]) -> Vec<f64> {
    let mut covered = vec![0.0];
    let mut length = 0.0;
    for pair in points.windows(2) {
        length += (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1]);
        covered.push(length);
    }
    covered.iter().map(|c| c / length).collect()
}

/// Point at the fraction `t` of a side of a cell: of an arc about a centre, of the parabola through its middle, of a
/// line.
pub(super) fn on_side([a, b]: [Point; 2], middle: Option<Point>, centre: Option<Point>, t: f64) -> Point {
    match (centre, middle) {
        _ if t <= 0.0 => a,
        _ if t >= 1.0 => b,
        (Some(centre), None) => Curve::Arc { centre, ends: [a, b] }.point(t),
        (Some(centre), Some(m)) if t <= 0.5 => Curve::Arc { centre, ends: [a, m] }.point(2.0 * t),
        (Some(centre), Some(m)) => Curve::Arc { centre, ends: [m, b] }.point(2.0 * t - 1.0),
        (None, None) => Curve::Line([a, b]).point(t),
        (None, Some(m)) => {
            let [first, second, last] = [(1.0 - t) * (1.0 - 2.0 * t), 4.0 * t * (1.0 - t), t * (2.0 * t - 1.0)];
            [0, 1].map(|k| first * a[k] + second * m[k] + last * b[k])
        }
    }
}
