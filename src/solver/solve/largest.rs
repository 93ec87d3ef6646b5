//! Where inside cells the largest of a stress is looked for: at the places of a grid, at the edges of a region that cut
//! it, and closer and closer around the largest of those.

use crate::elasticity::shape_functions;

/// Part of the largest stress at a node that a cell must have at one of its own for places between them to be looked
/// at.
pub(super) const NEAR: f64 = 0.8;
/// Parts of a cell's side at whose ends stresses are looked at, and halvings of them around the largest.
const PARTS: usize = 8;
const HALVINGS: usize = 8;
/// Halvings between a place inside a region and one outside, after which the one inside lies on its edge.
const BISECTIONS: usize = 20;

/// Natural coordinates of the places of a cell that are looked at, with the shape functions there.
pub(super) fn grid(nodes: usize) -> Vec<([f64; 2], Vec<f64>)> {
    let natural = |k: usize| 2.0 * k as f64 / PARTS as f64 - 1.0;
    let all = (0..=PARTS).flat_map(|i| (0..=PARTS).map(move |j| [natural(i), natural(j)]));
    all.map(|at| (at, shapes(nodes, at))).collect()
}

/// The largest of what is found around a place of a cell by its shape functions, by smaller and smaller steps; none
/// where nothing is found at the place itself.
pub(super) fn largest_around<T>(
    nodes: usize,
    mut at: [f64; 2],
    found: impl Fn(&[f64]) -> Option<T>,
    stress: impl Fn(&T) -> f64,
) -> Option<T> {
    let mut best = found(&shapes(nodes, at))?;
    let mut step = 2.0 / PARTS as f64;
    for _ in 0..HALVINGS {
        step *= 0.5;
        for (dx, dy) in [(-1.0, 0.0), (1.0, 0.0), (0.0, -1.0), (0.0, 1.0)] {
            let next = [at[0] + dx * step, at[1] + dy * step].map(|x: f64| x.clamp(-1.0, 1.0));
            if let Some(found) = found(&shapes(nodes, next)).filter(|found| stress(found) > stress(&best)) {
                (at, best) = (next, found);
            }
        }
    }
    Some(best)
}

/// The same on the edge of a region, along which a step may lead that no step along a cell's sides stays inside of.
pub(super) fn largest_along_edge<T>(
    nodes: usize,
    mut at: [f64; 2],
    found: impl Fn(&[f64]) -> Option<T>,
    stress: impl Fn(&T) -> f64,
) -> Option<T> {
    let mut best = found(&shapes(nodes, at))?;
    let mut step = 2.0 / PARTS as f64;
    for _ in 0..HALVINGS {
        step *= 0.5;
        let by = [-step, 0.0, step];
        let moved = |dx: f64, dy: f64| [at[0] + dx, at[1] + dy].map(|x: f64| x.clamp(-1.0, 1.0));
        let places: Vec<[f64; 2]> = by.iter().flat_map(|&dx| by.map(|dy| moved(dx, dy))).collect();
        let inside = places.iter().map(|&at| found(&shapes(nodes, at))).collect::<Vec<_>>();
        let on_edge = edges(nodes, &places, &|k| inside[k].is_some(), &found);
        let all = places.into_iter().zip(inside).filter_map(|(at, one)| Some((at, one?)));
        for (next, one) in all.chain(on_edge) {
            if stress(&one) > stress(&best) {
                (at, best) = (next, one);
            }
        }
    }
    Some(best)
}

/// Where the edge of a region cuts the lines between neighbours of a square of places of a cell, and what is found
/// there, just inside.
pub(super) fn edges<T>(
    nodes: usize,
    places: &[[f64; 2]],
    is_inside: &dyn Fn(usize) -> bool,
    found: &impl Fn(&[f64]) -> Option<T>,
) -> Vec<([f64; 2], T)> {
    let side = places.len().isqrt();
    let along = (0..places.len()).filter(|k| (k + 1) % side > 0).map(|k| [k, k + 1]);
    let across = (0..places.len() - side).map(|k| [k, k + side]);
    let cut = along.chain(across).filter(|pair| is_inside(pair[0]) != is_inside(pair[1]));
    let edge = |[k, l]: [usize; 2]| {
        let (mut inside, mut outside) = if is_inside(k) { (places[k], places[l]) } else { (places[l], places[k]) };
        let mut best = None;
        for _ in 0..BISECTIONS {
            let middle = [0, 1].map(|i| 0.5 * (inside[i] + outside[i]));
            match found(&shapes(nodes, middle)) {
                Some(one) => (inside, best) = (middle, Some(one)),
                None => outside = middle,
            }
        }
        Some((inside, best?))
    };
    cut.filter_map(edge).collect()
}

fn shapes(nodes: usize, at: [f64; 2]) -> Vec<f64> {
    shape_functions::cell(nodes, at).into_iter().map(|(value, _)| value).collect()
}
