//! Rectangle: one block, fine at the candidate stretch.

use super::{Layout, Span, last_two};
use crate::mesh::block::{Block, Side};
use crate::mesh::spacing;
use crate::scene::Face;

pub(super) fn blocks(layout: &Layout, x: [f64; 2], y: [f64; 2], contact: Face) -> Vec<Block> {
    let along = columns(layout, x);
    let [before, last] = last_two(&layout.candidates());
    let heights: Vec<f64> = layout.across(last - before, y[1] - y[0]);
    let upwards: Vec<f64> = match contact {
        Face::Bottom => heights.iter().map(|d| y[0] + d).collect(),
        Face::Top => heights.iter().rev().map(|d| y[1] - d).collect(),
    };
    let (bottom, top) = match contact {
        Face::Bottom => ("contact", "far"),
        Face::Top => ("far", "contact"),
    };
    vec![Block {
        bottom: Side::named(bottom, layout.along(&along, |x| [x, y[0]])),
        right: Side::named("right", layout.along(&upwards, |h| [x[1], h])),
        top: Side::named(top, layout.along(&along, |x| [x, y[1]])),
        left: Side::named("left", layout.along(&upwards, |h| [x[0], h])),
    }]
}

/// Stations along the contacts: candidates about every origin, growing sizes between them and to the ends of the body.
fn columns(layout: &Layout, [left, right]: [f64; 2]) -> Vec<f64> {
    let mut spans = layout.spans.clone();
    spans.sort_by(|a, b| a.origin.total_cmp(&b.origin));
    let mut stations = Vec::new();
    for span in &spans {
        let candidates = candidates(layout, span);
        let before = match stations.is_empty() {
            true if span.both_sides => mirrored(span, beyond(layout, span, span.origin - left)),
            true => vec![],
            false => between(layout, &stations, &candidates),
        };
        stations = spacing::joined(&[stations, before, candidates]);
    }
    if let Some(last) = spans.last() {
        let after = beyond(layout, last, right - last.origin).iter().map(|s| last.origin + s).collect();
        stations = spacing::joined(&[stations, after]);
    }
    // To the last bit, as supports and other bodies know them.
    if let [from, .., to] = &mut stations[..] {
        (*from, *to) = (left, right);
    }
    stations
}

/// Candidates of a span, ascending.
fn candidates(layout: &Layout, span: &Span) -> Vec<f64> {
    let outwards = layout.candidates_of(span.stretch);
    let right = outwards.iter().map(|s| span.origin + s).collect();
    if span.both_sides { spacing::joined(&[mirrored(span, outwards), right]) } else { right }
}

/// Stations to the left of an origin from their distances, ascending.
fn mirrored(span: &Span, distances: Vec<f64>) -> Vec<f64> {
    distances.iter().rev().map(|s| span.origin - s).collect()
}

/// Distances from the origin of a span beyond its candidates up to the end of the body; sizes grow.
fn beyond(layout: &Layout, span: &Span, end: f64) -> Vec<f64> {
    let [before, last] = last_two(&layout.candidates_of(span.stretch));
    if end <= last * (1.0 + 1e-9) {
        return vec![last];
    }
    let grading = layout.grading;
    spacing::growing(last, end, (last - before) * grading.along, grading.along, grading.coarsest * end)
}

/// Stations between the candidates of two contacts; sizes grow from both.
fn between(layout: &Layout, left: &[f64], right: &[f64]) -> Vec<f64> {
    let ([before, from], [to, after]) = (last_two(left), [right[0], right[1]]);
    let along = layout.grading.along;
    let first = [(from - before) * along, (after - to) * along];
    spacing::growing_from_both(from, to, first, along, layout.grading.coarsest * (to - from))
}
