//! Half a rod eye with a shank: a ring up to the shank, a ring below the shank, and the shank itself.

use std::f64::consts::PI;

use super::layout::{Layout, last_two, on_ray};
use crate::mesh::block::{Block, Point, Side, between, polar};
use crate::mesh::spacing;
use crate::scene::Shape;

/// Size of the elements at the re-entrant corner of eye and shank over that of the contact elements.
///
/// Coarse there, they cost 0.14 % of the second-moment angle of the contact, however fine the contact itself.
const CORNER: f64 = 0.5;

pub(super) fn blocks(layout: &Layout, shape: &Shape) -> Vec<Block> {
    let Shape::Eye { pole, hole, outer_radius, shank_half_width, shank_end } = *shape else {
        return Vec::new();
    };
    let corner = corner_angle(outer_radius, shank_half_width);
    let surface = layout.candidates();
    let [before, last] = last_two(&surface);
    let grading = layout.grading;
    let fine = CORNER * hole.radius * (surface[1] - surface[0]);
    let (along, coarsest) = (grading.along, layout.widest);
    let next = ((last - before) * along).min(coarsest);
    let towards = spacing::growing_from_both(last, corner, [next, fine / outer_radius], along, coarsest);
    let angles = spacing::joined(&[surface, towards]);
    let rest = spacing::growing(corner, PI, fine / outer_radius, along, coarsest);
    let depth = outer_radius - hole.radius;
    let first = hole.radius * (angles[1] - angles[0]) * grading.first;
    let positions = spacing::growing_from_both(0.0, depth, [first, fine], grading.depth, grading.coarsest * depth);
    let inwards: Vec<f64> = positions.iter().rev().map(|d| 1.0 - d / depth).collect();

    let outer = |angle: f64| polar(hole.centre, outer_radius, angle);
    let arc = |list: &[f64]| layout.along(list, |angle| on_ray(hole, pole, angle));
    let spoke = |angle: f64| {
        let (from, to) = (outer(angle), on_ray(hole, pole, angle));
        layout.along(&inwards, |t| between(from, to, t))
    };
    let below = Block {
        bottom: Side::named("outer", layout.along(&angles, outer)),
        right: Side::inner(spoke(corner)),
        top: Side::named("contact", arc(&angles)),
        left: Side::named("axis", spoke(0.0)),
    };
    let neck = Block {
        bottom: Side::inner(layout.along(&rest, outer)),
        right: Side::named("axis", spoke(PI)),
        top: Side::named("contact", arc(&rest)),
        left: Side::inner(spoke(corner)),
    };
    vec![below, neck, shank(layout, &rest, outer, [shank_half_width, hole.centre[1] + shank_end])]
}

/// The re-entrant corner of eye and shank; none of other shapes.
pub(crate) fn corner(shape: &Shape) -> Option<Point> {
    let Shape::Eye { hole, outer_radius, shank_half_width, .. } = *shape else { return None };
    Some(polar(hole.centre, outer_radius, corner_angle(outer_radius, shank_half_width)))
}

/// Angle of that corner, from the downward vertical on.
fn corner_angle(outer_radius: f64, shank_half_width: f64) -> f64 {
    PI - (shank_half_width / outer_radius).asin()
}

/// From the eye's outer arc (run backwards, so that the block stays counter-clockwise) up to the flat end.
fn shank(layout: &Layout, rest: &[f64], outer: impl Fn(f64) -> Point, [half_width, end]: [f64; 2]) -> Block {
    let backwards: Vec<f64> = rest.iter().rev().copied().collect();
    let [side, axis] = [outer(rest[0]), outer(PI)];
    let [first, second] = [outer(rest[0]), outer(rest[1])];
    let fine = (first[0] - second[0]).hypot(first[1] - second[1]);
    let heights = spacing::growing(0.0, end - side[1], fine, layout.grading.depth, 2.5 * half_width / 4.0);
    let total = end - side[1];
    let across = spacing::uniform(0.0, half_width, rest.len() - 1);
    Block {
        bottom: Side::inner(layout.along(&backwards, &outer)),
        right: Side::named("shank", layout.along(&heights, |h| between(side, [half_width, end], h / total))),
        top: Side::named("end", layout.along(&across, |x| [x, end])),
        left: Side::named("axis", layout.along(&heights, |h| between(axis, [0.0, end], h / total))),
    }
}
