//! The curve along which contact runs, and the contact coordinate on it; circles, and the rays that meet them.

use crate::error::Coordinate;
use crate::scene::material::PlaneHypothesis;

/// The curve along which the contact coordinate `s` runs.
#[derive(Clone, Copy, Debug)]
pub enum Path {
    /// A horizontal line; the normal is vertical and areas are horizontal projections.
    Straight {
        /// Where s = 0 lies \[mm\].
        origin: [f64; 2],
        /// Contact on both sides of the origin, `s = x − x₀`; else from it on, `s = |x − x₀|` \[mm\].
        both_sides: bool,
    },
    /// `s = θ` \[rad\] from the downward vertical about a centre; normals are radial and areas those of the circle.
    Arc(Circle),
}

/// Difference of two radii, over one of them, up to which they are one.
const SAME: f64 = 1e-9;

impl Path {
    /// y = 0 from x = 0 on.
    pub const HORIZONTAL: Self = Self::Straight { origin: [0.0, 0.0], both_sides: false };

    /// Whether `s` runs from negative to positive.
    pub fn has_both_sides(&self) -> bool {
        matches!(self, Self::Straight { both_sides: true, .. })
    }

    /// Whether it is a line.
    pub fn is_straight(&self) -> bool {
        matches!(self, Self::Straight { .. })
    }

    /// Where s = 0 lies, or the arc's centre \[mm\].
    pub fn origin(&self) -> [f64; 2] {
        match self {
            Self::Straight { origin, .. } => *origin,
            Self::Arc(circle) => circle.centre,
        }
    }

    /// The same path with its origin, or its centre, elsewhere \[mm\].
    pub(super) fn moved_to(self, origin: [f64; 2]) -> Self {
        match self {
            Self::Straight { both_sides, .. } => Self::Straight { origin, both_sides },
            Self::Arc(circle) => Self::Arc(Circle { centre: origin, ..circle }),
        }
    }

    /// Length of path per unit of the contact coordinate: 1 on a plane, the radius on an arc [mm/rad].
    pub fn metric(&self) -> f64 {
        match self {
            Self::Straight { .. } => 1.0,
            Self::Arc(circle) => circle.radius,
        }
    }

    /// Contact coordinate of a point: `|x − x₀|`, `x − x₀`, or the angle from the downward vertical.
    pub fn coordinate(&self, point: [f64; 2]) -> f64 {
        match self {
            Self::Straight { origin, both_sides: false } => (point[0] - origin[0]).abs(),
            Self::Straight { origin, both_sides: true } => point[0] - origin[0],
            Self::Arc(circle) => {
                let d = [point[0] - circle.centre[0], point[1] - circle.centre[1]];
                d[0].abs().atan2(-d[1])
            }
        }
    }

    /// Its point at a contact coordinate, on the right of the origin where `s` runs to both sides of it \[mm\].
    pub fn point(&self, s: f64) -> [f64; 2] {
        match self {
            Self::Straight { origin: [x, y], .. } => [x + s, *y],
            Self::Arc(Circle { centre: [x, y], radius }) => [x + radius * s.sin(), y - radius * s.cos()],
        }
    }

    /// Whether it begins on the axis of bodies of revolution, so that the contact is a circle, and no ring.
    pub fn is_around_axis(&self, plane: PlaneHypothesis) -> bool {
        plane.radial().is_some_and(|radial| self.point(0.0)[radial].abs() <= 0.0)
    }

    /// Contact coordinate of the axis x = 0 or y = 0, by the line of the radii at both ends of a stretch; none where
    /// they are the same.
    pub fn axis(&self, radial: usize, [from, to]: [f64; 2]) -> Option<f64> {
        let [first, last] = [from, to].map(|s| self.point(s)[radial]);
        let grows = last - first;
        (grows.abs() > SAME * last.abs()).then(|| from - first * ((to - from) / grows))
    }

    /// A contact coordinate as messages give it.
    pub fn reported(&self, s: f64) -> Coordinate {
        match self {
            Self::Straight { .. } => Coordinate::Length(s),
            Self::Arc(_) => Coordinate::Angle(s),
        }
    }

    /// Unit vector along the gap at a point, pointing down or away from the arc's centre.
    pub fn direction(&self, point: [f64; 2]) -> [f64; 2] {
        match self {
            Self::Straight { .. } => [0.0, -1.0],
            Self::Arc(circle) => {
                let d = [point[0] - circle.centre[0], point[1] - circle.centre[1]];
                let length = d[0].hypot(d[1]);
                if d[0].abs() <= 1e-12 * length {
                    return [0.0, d[1].signum()];
                }
                if d[1].abs() <= 1e-12 * length {
                    return [d[0].signum(), 0.0];
                }
                [d[0] / length, d[1] / length]
            }
        }
    }

    /// How far a point lies along [`Path::direction`]: `y₀ − y`, or its distance from the arc's centre \[mm\].
    pub fn depth(&self, point: [f64; 2]) -> f64 {
        match self {
            Self::Straight { origin, .. } => origin[1] - point[1],
            Self::Arc(circle) => (point[0] - circle.centre[0]).hypot(point[1] - circle.centre[1]),
        }
    }

    /// The depth of the path itself: 0, or the radius \[mm\].
    pub fn own_depth(&self) -> f64 {
        match self {
            Self::Straight { .. } => 0.0,
            Self::Arc(circle) => circle.radius,
        }
    }

    /// Cosine between the normals at two contact coordinates: 1 on a plane, `cos(s − s')` on an arc.
    pub fn alignment(&self, s: f64, other: f64) -> f64 {
        match self {
            Self::Straight { .. } => 1.0,
            Self::Arc(_) => (s - other).cos(),
        }
    }

    /// Part of a pressure at `s` that acts along the load line: 1 on a plane, `cos θ` on an arc.
    pub fn share(&self, s: f64) -> f64 {
        match self {
            Self::Straight { .. } => 1.0,
            Self::Arc(_) => s.cos(),
        }
    }
}

/// A circle.
#[derive(Clone, Copy, Debug)]
pub struct Circle {
    /// Centre \[mm\].
    pub centre: [f64; 2],
    /// Radius \[mm\].
    pub radius: f64,
}

impl Circle {
    /// Distance from `pole` to the circle along the ray at angle `θ` from the downward vertical \[mm\].
    ///
    /// With `e = pole − centre` and the ray's direction `d`: `r = −e·d + √(ρ² − |e|² + (e·d)²)`; the pole lies inside.
    pub fn along_ray(&self, pole: [f64; 2], angle: f64) -> f64 {
        let (s, c) = angle.sin_cos();
        let e = [pole[0] - self.centre[0], pole[1] - self.centre[1]];
        let forward = e[0] * s - e[1] * c;
        let offset = e[0] * e[0] + e[1] * e[1];
        (self.radius * self.radius - offset + forward * forward).sqrt() - forward
    }
}
