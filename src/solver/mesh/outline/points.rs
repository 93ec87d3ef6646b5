//! Points of outlines, met to the last bit on symmetry lines.

use crate::mesh::block::Point;

/// Point at the fraction `t` between two points.
pub(super) fn between(a: Point, b: Point, t: f64) -> Point {
    [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t]
}

/// Point at radius `r` and angle `θ` from the downward vertical about a centre.
pub(super) fn polar(centre: Point, radius: f64, angle: f64) -> Point {
    [centre[0] + radius * exact_sin(angle), centre[1] - radius * exact_sin(std::f64::consts::FRAC_PI_2 - angle)]
}

/// `sin` that is exactly zero at multiples of π, so that symmetry lines are met to the last bit.
pub(super) fn exact_sin(angle: f64) -> f64 {
    let sin = angle.sin();
    if sin.abs() < 1e-15 { 0.0 } else { sin }
}
