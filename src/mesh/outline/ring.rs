//! Ring sector: one block between two arcs, fine at the face that carries the contact.

use std::f64::consts::FRAC_PI_2;

use super::layout::Layout;
use super::points::{between, exact_sin};
use crate::mesh::block::{Block, Point, Side};
use crate::scene::{Circle, Face};

pub(super) fn blocks(layout: &Layout, pole: Point, circles: [Circle; 2], sweep: f64, contact: Face) -> Vec<Block> {
    let [inner, outer] = circles;
    let angles = layout.arc(inner.radius, &[FRAC_PI_2, sweep]);
    let (first, depth) = match contact {
        Face::Bottom => (inner.radius * (angles[1] - angles[0]), outer.radius - inner.radius),
        Face::Top => (outer.radius * (angles[1] - angles[0]), outer.radius - inner.radius),
    };
    let positions = layout.across(first, depth);
    let inwards: Vec<f64> = match contact {
        Face::Bottom => positions.iter().rev().map(|d| 1.0 - d / depth).collect(),
        Face::Top => positions.iter().map(|d| d / depth).collect(),
    };
    let arc = |circle: Circle| layout.along(&angles, |angle| on_ray(circle, pole, angle));
    let radial = |angle: f64| {
        let (from, to) = (on_ray(outer, pole, angle), on_ray(inner, pole, angle));
        layout.along(&inwards, |t| between(from, to, t))
    };
    let name = |face, other| if contact == face { "contact" } else { other };
    vec![Block {
        bottom: Side::named(name(Face::Top, "outer"), arc(outer)),
        right: Side::named("end", radial(sweep)),
        top: Side::named(name(Face::Bottom, "inner"), arc(inner)),
        left: Side::named("start", radial(0.0)),
    }]
}

/// Where the ray at angle `θ` from the pole meets a circle.
pub(super) fn on_ray(circle: Circle, pole: Point, angle: f64) -> Point {
    let r = circle.along_ray(pole, angle);
    [pole[0] + r * exact_sin(angle), pole[1] - r * exact_sin(FRAC_PI_2 - angle)]
}
