//! Sides as they are drawn, and the gap between two of them.

use crate::scene::path::Path;

/// A piece of a side along which the contact coordinate only rises or only falls.
#[derive(Clone, Debug)]
pub enum Curve {
    /// Straight, between two points \[mm\].
    Line([[f64; 2]; 2]),
    /// Circular, less than half a turn; its ends may differ in their distance from the centre by rounding.
    Arc {
        /// Centre \[mm\].
        centre: [f64; 2],
        /// Where it begins and ends \[mm\].
        ends: [[f64; 2]; 2],
    },
    /// Edge of a mesh: first node, last node and, on 3-node edges, the middle one \[mm\].
    Edge(Vec<[f64; 2]>),
}

/// The gap between two sides, or between one and the path, taken from the curves themselves and not from a mesh of
/// them.
#[derive(Clone, Debug)]
pub struct DrawnGap {
    /// Side of the first body and, unless the other side is rigid, of the second.
    pub sides: Vec<Vec<Curve>>,
    /// The curve along which the contact coordinate runs.
    pub path: Path,
    /// Whether the first body is the upper, or inner, one.
    pub above: bool,
}

impl DrawnGap {
    /// Distance of the sides along the path's direction at the contact coordinate `s` \[mm\], negative where they
    /// overlap; infinite where a side has ended.
    pub fn gap(&self, s: f64) -> f64 {
        let s = if self.path.has_both_sides() { s } else { s.abs() };
        let depth = |side: usize| match self.sides.get(side) {
            Some(curves) => curves.iter().find_map(|curve| curve.depth(&self.path, s)),
            None => Some(self.path.own_depth()),
        };
        match (depth(0), depth(1)) {
            (Some(first), Some(second)) if self.above => second - first,
            (Some(first), Some(second)) => first - second,
            _ => f64::INFINITY,
        }
    }

    /// Contact coordinates at which a piece of a side begins or ends \[mm, or rad on an arc\].
    pub fn corners(&self) -> Vec<f64> {
        let curves = self.sides.iter().flatten();
        curves.flat_map(|curve| [0.0, 1.0].map(|t| curve.at(&self.path, t)[0])).collect()
    }

    /// Contact coordinates at which the slope leaps upwards, and by how much \[mm, or rad on an arc; 1, or mm/rad\].
    ///
    /// Of second differences, from which what the curvature beside a corner adds is taken off by those over half the
    /// distance.
    pub fn tips(&self) -> Vec<[f64; 2]> {
        let mut corners = self.corners();
        corners.sort_by(f64::total_cmp);
        let farthest = corners.iter().fold(0.0, |farthest: f64, s| farthest.max(s.abs()));
        corners.dedup_by(|a, b| *a - *b <= SAME * farthest);
        let tip = |k: usize| {
            let s = corners[k];
            let beside = [k.checked_sub(1), Some(k + 1)].into_iter().flatten().filter_map(|k| corners.get(k));
            let near = NEAR * beside.map(|other| (other - s).abs()).fold(farthest, f64::min);
            let over = |near: f64| (self.gap(s + near) - 2.0 * self.gap(s) + self.gap(s - near)) / near;
            let leap = 2.0 * over(0.5 * near) - over(near);
            (leap > ROUND_OFF * self.path.metric() * farthest / near).then_some([s, leap])
        };
        (0..corners.len()).filter_map(tip).collect()
    }

    /// The same with every point, and the path, taken to another place.
    pub fn moved(&self, path: Path, place: impl Fn([f64; 2]) -> [f64; 2]) -> Self {
        let side = |curves: &Vec<Curve>| curves.iter().map(|curve| curve.moved(&place)).collect();
        Self { sides: self.sides.iter().map(side).collect(), path, above: self.above }
    }
}

/// Slack at the ends of a curve, over its farthest contact coordinate, that rounding explains.
const SAME: f64 = 1e-9;
/// Distance over which the slope is taken on either side of a corner, over that to the next one.
const NEAR: f64 = 1e-4;
/// What rounding leaves of a gap, over the farthest place.
const ROUND_OFF: f64 = 1e-13;
/// Halvings after which a parameter has all its digits.
const HALVINGS: usize = 60;

impl Curve {
    /// Depth at a contact coordinate \[mm\]; none where the curve does not reach.
    pub fn depth(&self, path: &Path, s: f64) -> Option<f64> {
        let [begin, end] = [0.0, 1.0].map(|t| self.at(path, t)[0]);
        let slack = SAME * begin.abs().max(end.abs());
        if s < begin.min(end) - slack || s > begin.max(end) + slack {
            return None;
        }
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            let before = (self.at(path, middle)[0] < s) == (begin < end);
            *if before { &mut low } else { &mut high } = middle;
        }
        Some(self.at(path, 0.5 * (low + high))[1])
    }

    /// Contact coordinate and depth, as `t` runs from 0 to 1; on an edge they are those of its nodes, interpolated by
    /// its shape functions, so that nodes on an arc make an arc.
    fn at(&self, path: &Path, t: f64) -> [f64; 2] {
        let of = |point: [f64; 2]| [path.coordinate(point), path.depth(point)];
        let Self::Edge(nodes) = self else { return of(self.point(t)) };
        let xi = 2.0 * t - 1.0;
        let shapes = match nodes.len() {
            3 => vec![0.5 * xi * (xi - 1.0), 0.5 * xi * (xi + 1.0), 1.0 - xi * xi],
            _ => vec![1.0 - t, t],
        };
        let each = shapes.iter().zip(nodes).map(|(shape, node)| of(*node).map(|x| shape * x));
        each.fold([0.0; 2], |sum, term| [sum[0] + term[0], sum[1] + term[1]])
    }

    /// The point at `0 ≤ t ≤ 1` \[mm\]; on an edge, of its chord.
    pub fn point(&self, t: f64) -> [f64; 2] {
        match self {
            Self::Line([from, to]) => between(*from, *to, t),
            Self::Edge(nodes) => between(nodes[0], nodes[1], t),
            Self::Arc { centre, ends } => {
                let [a, b] = ends.map(|end| [end[0] - centre[0], end[1] - centre[1]]);
                let sweep = (a[0] * b[1] - a[1] * b[0]).atan2(a[0] * b[0] + a[1] * b[1]);
                let (sin, cos) = (t * sweep).sin_cos();
                // From the distance of one end to that of the other, so that neighbouring arcs meet.
                let grown = 1.0 + t * (b[0].hypot(b[1]) / a[0].hypot(a[1]) - 1.0);
                [centre[0] + grown * (a[0] * cos - a[1] * sin), centre[1] + grown * (a[0] * sin + a[1] * cos)]
            }
        }
    }

    fn moved(&self, place: &impl Fn([f64; 2]) -> [f64; 2]) -> Self {
        match self {
            Self::Line(ends) => Self::Line(ends.map(place)),
            Self::Arc { centre, ends } => Self::Arc { centre: place(*centre), ends: ends.map(place) },
            Self::Edge(nodes) => Self::Edge(nodes.iter().copied().map(place).collect()),
        }
    }
}

fn between(from: [f64; 2], to: [f64; 2], t: f64) -> [f64; 2] {
    [0, 1].map(|k| from[k] + (to[k] - from[k]) * t)
}
