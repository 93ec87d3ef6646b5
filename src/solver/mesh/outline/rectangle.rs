//! Rectangle: one block, fine at the candidate stretch; frames around a contact whose ends are known.

use super::frames;
use super::layout::{Layout, can_lean, last_two};
use crate::mesh::block::{Block, Side};
use crate::mesh::spacing;
use crate::scene::Face;

pub(super) fn blocks(layout: &Layout, x: [f64; 2], y: [f64; 2], contact: Face) -> Vec<Block> {
    if let Some(blocks) = frames::blocks(layout, x, y, contact) {
        return blocks;
    }
    let is_on = |k: usize, ends: [f64; 2]| move |point: &&[f64; 2]| ends.contains(&point[k]);
    let along = columns(layout, x, &layout.points.iter().filter(is_on(1, y)).map(|point| point[0]).collect::<Vec<_>>());
    let finest = match layout.same_ends() {
        Some(ends) => ends.rows(ends.half_width())[1] / layout.elements,
        None => {
            let [before, last] = last_two(&layout.candidates());
            layout.several.iter().map(|one| one.size).fold(last - before, f64::min)
        }
    };
    let heights: Vec<f64> = layout.across(finest, y[1] - y[0]);
    let upwards: Vec<f64> = match contact {
        Face::Bottom => heights.iter().map(|d| y[0] + d).collect(),
        Face::Top => heights.iter().rev().map(|d| y[1] - d).collect(),
    };
    let beside: Vec<f64> = layout.points.iter().filter(is_on(0, x)).map(|point| point[1]).collect();
    let upwards = spacing::through(&upwards, &beside);
    let (bottom, top, opposite) = match contact {
        Face::Bottom => ("contact", "far", y[1]),
        Face::Top => ("far", "contact", y[0]),
    };
    // A point beside a line on an end of the contact that is known has that moved to it on its own side alone.
    let has_ends = layout.same_ends().is_some();
    let far = layout.points.iter().filter(|point| has_ends && point[1] == opposite).map(|point| point[0]);
    let moved = spacing::through(&along, &far.collect::<Vec<_>>());
    let far = if moved.len() == along.len() { moved } else { along.clone() };
    let [along, far] = each_alone(layout, x, y).unwrap_or([along, far]);
    let of = |height: f64| if height == opposite { &far } else { &along };
    vec![Block {
        bottom: Side::named(bottom, layout.along(of(y[0]), |x| [x, y[0]])),
        right: Side::named("right", layout.along(&upwards, |h| [x[1], h])),
        top: Side::named(top, layout.along(of(y[1]), |x| [x, y[1]])),
        left: Side::named("left", layout.along(&upwards, |h| [x[0], h])),
    }]
}

/// Positions on the contact and on the opposite one, each with the lines of its own alone; none where they are not as
/// many, lean too far, or a point that is no corner is held or pressed there.
fn each_alone(layout: &Layout, x: [f64; 2], y: [f64; 2]) -> Option<[Vec<f64>; 2]> {
    let has_points = layout.points.iter().any(|point| y.contains(&point[1]) && !x.contains(&point[0]));
    let [along, far] = layout.each_of_two().filter(|_| !has_points)?.map(|alone| columns(&alone, x, &[]));
    can_lean([&along, &far], y[1] - y[0]).then_some([along, far])
}

/// Positions along the contact: from the left side on, or from the path's origin on to both sides; with the places of
/// points that are held or pressed, beyond the candidates of a contact that is the only one.
fn columns(layout: &Layout, [left, right]: [f64; 2], places: &[f64]) -> Vec<f64> {
    if !layout.several.is_empty() {
        return columns_of_all(layout, [left, right], places);
    }
    let positions = columns_of_one(layout, [left, right]);
    let origin = layout.path.origin()[0];
    let is_fixed = |x: f64| (x - origin).abs() <= layout.stretch * (1.0 + 1e-9);
    let away = |place: f64| move |a: &&f64, b: &&f64| (**a - place).abs().total_cmp(&(**b - place).abs());
    let is_free = |place: &f64| positions.iter().min_by(away(*place)).is_some_and(|nearest| !is_fixed(*nearest));
    let places: Vec<f64> = places.iter().copied().filter(is_free).collect();
    spacing::through(&positions, &places)
}

/// The same of the only contact.
fn columns_of_one(layout: &Layout, [left, right]: [f64; 2]) -> Vec<f64> {
    if !layout.path.has_both_sides() {
        return outwards(layout, right - left).iter().map(|s| left + s).collect();
    }
    let origin = layout.path.origin()[0];
    let mut positions = match layout.same_ends() {
        Some(ends) => {
            let candidates: Vec<f64> = ends.across().iter().map(|s| origin + s).collect();
            let grading = layout.grading;
            let beyond = |from: f64, to: f64, first: f64| {
                let coarsest = grading.coarsest * (right - left);
                spacing::growing(from, to, first * grading.along, grading.along, coarsest)
            };
            let [begin, second] = [candidates[0], candidates[1]];
            let [before, end] = last_two(&candidates);
            let leftwards: Vec<f64> = beyond(begin, left, second - begin).into_iter().rev().collect();
            spacing::joined(&[leftwards, candidates, beyond(end, right, end - before)])
        }
        None => {
            let leftwards = outwards(layout, origin - left).iter().rev().map(|s| origin - s).collect();
            spacing::joined(&[leftwards, outwards(layout, right - origin).iter().map(|s| origin + s).collect()])
        }
    };
    // To the last bit, as supports and other bodies know them.
    if let [from, .., to] = &mut positions[..] {
        (*from, *to) = (left, right);
    }
    positions
}

/// Positions of one side: the candidates, then growing sizes up to the end of the body.
fn outwards(layout: &Layout, end: f64) -> Vec<f64> {
    let candidates = layout.candidates();
    let [before, last] = last_two(&candidates);
    let mut positions = candidates;
    if end > last * (1.0 + 1e-9) {
        let grading = layout.grading;
        let rest = spacing::growing(last, end, (last - before) * grading.along, grading.along, grading.coarsest * end);
        positions = spacing::joined(&[positions, rest]);
    }
    positions
}

/// Positions along the contacts on both sides of the rectangle: every stretch begins, has its s = 0 and ends on one,
/// and so is every place.
fn columns_of_all(layout: &Layout, ends: [f64; 2], places: &[f64]) -> Vec<f64> {
    let straight = layout.several.iter().filter(|one| one.straight);
    let fine = straight.flat_map(|one| one.pieces().map(|[from, to]| [one.origin + from, one.origin + to, one.size]));
    let fine = fine.chain(places.iter().map(|x| [*x, *x, f64::INFINITY]));
    let grading = layout.grading;
    spacing::fine_within(ends, &fine.collect::<Vec<_>>(), grading.along, grading.coarsest * (ends[1] - ends[0]))
}
