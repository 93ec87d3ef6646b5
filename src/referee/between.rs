//! Pressures between the points at which they were handed in: straight lines, or roots of parabolas.

use crate::mesh::Order;
use crate::referee::answer::{Handed, Point};

/// Parts into which what lies between two points is cut: the end of a root leaves `0.2/PARTS^1.5` of what lies in its
/// part.
const PARTS: usize = 16;
/// Parts between all points together from which on fewer between two of them will do: the part at the end is a small
/// one of the contact.
const ALL: usize = 64_000;

/// Square that a parabola has at the first point that does not press, over that of the last that does, up to which it
/// ends there.
const ENDS: f64 = 0.25;

/// Straight lines with their middles, so that Simpson's rule takes their second moments exactly.
pub fn by_lines(handed: &Handed) -> Handed {
    let middle = |pair: &[Point]| Point {
        position: 0.5 * (pair[0].position + pair[1].position),
        value: 0.5 * (pair[0].value + pair[1].value),
        area: None,
        // Where one of them has no other side, the gap is that of the other.
        gap: pair[0].gap.zip(pair[1].gap).map(|(a, b)| if a.max(b).is_finite() { 0.5 * (a + b) } else { a.min(b) }),
    };
    let mut points: Vec<Point> = handed.points.windows(2).flat_map(|pair| [pair[0], middle(pair)]).collect();
    points.extend(handed.points.last());
    Handed { points, order: Order::Quadratic, ..handed.clone() }
}

/// Roots of the parabolas through the squares of the three points around, which draw `p ∝ √(a² − s²)` exactly up to its
/// end between two points; a straight line where three do not press, or the parabola has no end where the points do.
pub fn by_roots(points: &[Point]) -> Vec<Point> {
    let parts = (ALL / points.len()).clamp(1, PARTS);
    let presses = |k: &usize| points.get(*k).is_some_and(|point| point.value > 0.0);
    let square = |k: usize| (points[k].position, points[k].value.powi(2));
    let between = |k: usize| {
        // The three that press, of which two lie around; towards an end the last three.
        let three = [
            [k.wrapping_sub(1), k, k + 1],
            [k, k + 1, k + 2],
            [k.wrapping_sub(2), k.wrapping_sub(1), k],
            [k + 1, k + 2, k + 3],
        ];
        let parabola = three.iter().find(|three| three.iter().all(presses)).map(|three| three.map(square));
        let [a, b] = [points[k], points[k + 1]];
        let squared = move |s: f64| parabola.map(|three| through(three, s));
        let lowest = ENDS * a.value.max(b.value).powi(2);
        let ends = |point: &Point| point.value > 0.0 || squared(point.position).is_none_or(|square| square <= lowest);
        let is_root = ends(&a) && ends(&b) && (a.value > 0.0 || b.value > 0.0);
        (0..parts).map(move |part| {
            let share = part as f64 / parts as f64;
            let position = a.position + share * (b.position - a.position);
            let line = a.value + share * (b.value - a.value);
            let root = squared(position).filter(|_| is_root && part > 0).map(|square| square.max(0.0).sqrt());
            Point { position, value: root.unwrap_or(line), area: None, gap: None }
        })
    };
    let last = points.last().map(|last| Point { area: None, gap: None, ..*last });
    (0..points.len() - 1).flat_map(between).chain(last).collect()
}

/// Difference from a straight line, over the largest pressure, that digits explain.
pub const STRAIGHT: f64 = 1e-5;

/// Places between which pressures lie on straight lines: the ends of edges, of which samples along a line tell many
/// points each.
pub fn lines(points: &[Point]) -> Vec<f64> {
    let near = STRAIGHT * points.iter().map(|point| point.value.abs()).fold(0.0, f64::max);
    let mut ends = vec![points[0].position];
    let all = [f64::NEG_INFINITY, f64::INFINITY];
    let (mut from, mut slopes) = (0, all);
    for (k, point) in points.iter().enumerate().skip(1) {
        let slope = |from: &Point, off: f64| (point.value + off - from.value) / (point.position - from.position);
        let own = slope(&points[from], 0.0);
        if !(slopes[0] <= own && own <= slopes[1]) {
            (from, slopes) = (k - 1, all);
            ends.push(points[from].position);
        }
        let [low, high] = [0.0 - near, near].map(|off| slope(&points[from], off));
        slopes = [slopes[0].max(low), slopes[1].min(high)];
    }
    ends.extend(points.last().map(|point| point.position));
    ends
}

/// The parabola through three places, at another.
fn through(three: [(f64, f64); 3], at: f64) -> f64 {
    let term = |k: usize| {
        let others = (0..3).filter(|other| *other != k);
        others.fold(three[k].1, |product, other| product * (at - three[other].0) / (three[k].0 - three[other].0))
    };
    (0..3).map(term).sum()
}
