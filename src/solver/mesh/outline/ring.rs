//! Ring sector: one block between two arcs, fine at the face that carries the contact; rows of cells that grow with the
//! radius where the ends of the contact are known.

use std::f64::consts::{FRAC_PI_2, PI};

use super::layout::{Layout, Rays, can_lean, on_ray};
use crate::mesh::block::{Block, Point, Side, between};
use crate::mesh::spacing;
use crate::scene::{Circle, Face, ROUNDING, Shape};

pub(super) fn blocks(layout: &Layout, shape: &Shape) -> Vec<Block> {
    let Shape::Ring { pole, inner, outer, sweep, both_sides, contact } = *shape else {
        return Vec::new();
    };
    let right = right_blocks(layout, pole, [inner, outer], sweep, contact);
    if !both_sides {
        return right;
    }
    let closed = |block: Block| if sweep < PI { block } else { block.without("end") };
    let right = right.into_iter().map(|block| closed(block.without("start"))).collect();
    Block::with_images(right, pole[0])
}

/// The part to the right of the downward vertical.
fn right_blocks(layout: &Layout, pole: Point, circles: [Circle; 2], sweep: f64, contact: Face) -> Vec<Block> {
    let [inner, outer] = circles;
    let face = Rays { pole, circle: if contact == Face::Top { outer } else { inner } };
    let angles = layout.arc(face, &[sweep.min(FRAC_PI_2), sweep]);
    let (first, depth) = match contact {
        Face::Bottom => (inner.radius * (angles[1] - angles[0]), outer.radius - inner.radius),
        Face::Top => (outer.radius * (angles[1] - angles[0]), outer.radius - inner.radius),
    };
    if layout.same_ends().is_some() && layout.opposite.is_none() {
        return rows(layout, face, circles, &angles, contact);
    }
    let positions = layout.across(first, depth);
    let has_narrow_bore =
        contact == Face::Top && cells_at_bore(circles.map(|circle| circle.radius), layout.grading.coarsest) > 0.0;
    let positions =
        if has_narrow_bore { around_bore(&positions, inner.radius, layout.grading.coarsest) } else { positions };
    let inwards: Vec<f64> = match contact {
        Face::Bottom => positions.iter().rev().map(|d| 1.0 - d / depth).collect(),
        Face::Top => positions.iter().map(|d| d / depth).collect(),
    };
    let faces = circles.map(|circle| Rays { pole, circle });
    let [within, around] = each_alone(layout, faces, contact, sweep).unwrap_or([angles.clone(), angles]);
    let arc = |circle: Circle, angles: &[f64]| layout.along(angles, |angle| on_ray(circle, pole, angle));
    let radial = |angle: f64| {
        let (from, to) = (on_ray(outer, pole, angle), on_ray(inner, pole, angle));
        layout.along(&inwards, |t| between(from, to, t))
    };
    let name = |face, other| if contact == face { "contact" } else { other };
    vec![Block {
        bottom: Side::named(name(Face::Top, "outer"), arc(outer, &around)),
        right: Side::named("end", radial(sweep)),
        top: Side::named(name(Face::Bottom, "inner"), arc(inner, &within)),
        left: Side::named("start", radial(0.0)),
    }]
}

/// Angles on the inner circle and on the outer one, each with the lines of its own contact alone; none where they are
/// not as many, or lean too far.
fn each_alone(layout: &Layout, faces: [Rays; 2], contact: Face, sweep: f64) -> Option<[Vec<f64>; 2]> {
    let [own, other] = layout.each_of_two()?;
    let of_face = if contact == Face::Top { [other, own] } else { [own, other] };
    let [within, around] = [0, 1].map(|k| of_face[k].arc(faces[k], &[sweep.min(FRAC_PI_2), sweep]));
    let [inner, outer] = faces.map(|face| face.circle.radius);
    can_lean([&within, &around], (outer - inner) / inner).then_some([within, around])
}

/// Depth of a ring below the outer face over the radius of its bore from which on that is narrow; length of the cells
/// there over that radius and the coarsest element's part of the body.
const NARROW: f64 = 4.0;

/// Depths below the outer circle, with those among them that cells need near a narrow bore.
///
/// There displacements go as 1/r, which a cell misses across which the radius grows many times, and a coarser one
/// alike: the fit of a ring of ν = 0.49 with a bore of 1/400 of its radius was 2e-5 off on any mesh.
fn around_bore(depths: &[f64], bore: f64, coarsest: f64) -> Vec<f64> {
    let whole = depths[depths.len() - 1];
    let radius = |depth: f64| bore + (whole - depth);
    let mut all = vec![depths[0]];
    for ends in depths.windows(2) {
        let [outside, inside] = [radius(ends[0]), radius(ends[1])];
        let parts = (across([inside, outside], coarsest) - 1e-9).ceil().max(1.0) as i32;
        let within = |k: i32| ends[0] + outside * (1.0 - (inside / outside).powf(f64::from(k) / f64::from(parts)));
        all.extend((1..parts).map(within));
        all.push(ends[1]);
    }
    all
}

/// How many of the cells at a narrow bore lie between two radii.
fn across([inside, outside]: [f64; 2], coarsest: f64) -> f64 {
    (outside / inside).ln() / (NARROW * coarsest).ln_1p()
}

/// How many of them a ring has; none where its bore is not narrow.
pub(crate) fn cells_at_bore([inside, outside]: [f64; 2], coarsest: f64) -> f64 {
    if outside - inside > NARROW * inside { across([inside, outside], coarsest) } else { 0.0 }
}

/// Depth below the face, as difference of logarithms of radii, up to which rows grow as the grading has it.
const NEAR: f64 = 0.42;
/// Growth of the rows beyond, in the same measure: with 2.4 half-widths of pins in plates were 5e-5 off, with 1.8
/// within 4e-6.
const GROWTH: f64 = 1.8;

/// The ring in cells whose nodes lie evenly in the logarithm of the radius: displacements there are sums of its powers,
/// and rows across which the radius is multiplied need no more nodes than those at the contact.
fn rows(layout: &Layout, on: Rays, [inner, outer]: [Circle; 2], angles: &[f64], contact: Face) -> Vec<Block> {
    let whole = (outer.radius / inner.radius).ln();
    let first = angles[1] - angles[0];
    let near = first.max(NEAR).min(whole);
    let below = spacing::growing(0.0, near, first, layout.grading.depth, near);
    let last = below[below.len() - 1] - below[below.len() - 2];
    let depths = spacing::joined(&[below, spacing::growing(near, whole, GROWTH * last, GROWTH, whole)]);
    let heights: Vec<f64> = match contact {
        Face::Bottom => depths.iter().rev().copied().collect(),
        Face::Top => depths.iter().map(|depth| whole - depth).collect(),
    };
    // From the inner circle to the outer one, on both of them to the last bit.
    let point = |angle: f64, height: f64| {
        let part = if height < whole { height.exp_m1() / whole.exp_m1() } else { 1.0 };
        between(on_ray(inner, on.pole, angle), on_ray(outer, on.pole, angle), part)
    };
    let last = (1.0 + ROUNDING) * on.angle(layout.path, layout.stretch);
    let side = |name: &'static str, is_outer: bool, points: Vec<Point>| {
        if is_outer { Side::named(name, points) } else { Side::inner(points) }
    };
    let (face, back) = ("contact", if contact == Face::Bottom { "outer" } else { "inner" });
    let [top, bottom] = if contact == Face::Bottom { [face, back] } else { [back, face] };
    let cell = |height: &[f64], angle: &[f64]| {
        let arc = |height: f64| match angle[1] <= last {
            true => layout.along_contact(on, angle, |angle| point(angle, height)),
            false => layout.along(angle, |angle| point(angle, height)),
        };
        let ray = |angle: f64| layout.along(height, |height| point(angle, height));
        Block {
            bottom: side(bottom, height[0] >= whole, arc(height[0])),
            right: side("end", angle[1] >= angles[angles.len() - 1], ray(angle[1])),
            top: side(top, height[1] <= 0.0, arc(height[1])),
            left: side("start", angle[0] <= 0.0, ray(angle[0])),
        }
    };
    let cell = &cell;
    heights.windows(2).flat_map(|height| angles.windows(2).map(move |angle| cell(height, angle))).collect()
}
