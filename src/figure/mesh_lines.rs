//! Element edges, joined to long lines so that the file stays small.

use std::collections::BTreeMap;

use super::canvas::{Canvas, Point};
use super::field::Drawn;
use super::frame::distance;
use super::palette::{Colour, INK};
use super::pen::Pen;
use super::view::View;

/// Shorter edges inside a body are left out: they would blacken the picture [display pixels].
const SHORTEST: f64 = 4.0;
const INNER: Colour = plotters::style::RGBColor(0x4A, 0x50, 0x56);

/// One element edge: its ends, its midside node if any, and how many cells share it.
struct Edge {
    ends: (usize, usize),
    middle: Option<usize>,
    cells: usize,
}

/// Draws the edges inside the bodies thin and their outlines stronger.
pub(super) fn mesh_lines(canvas: &mut Canvas, drawn: &Drawn<'_>, view: &View) {
    let place = |node: usize| view.place(drawn.nodes[node]);
    let (outline, inner): (Vec<Edge>, Vec<Edge>) = edges(drawn).into_iter().partition(|edge| edge.cells == 1);
    let long = |edge: &Edge| distance(place(edge.ends.0), place(edge.ends.1)) >= SHORTEST;
    let visible: Vec<Edge> = inner.into_iter().filter(long).collect();
    for (set, pen) in [(visible, Pen::solid(INNER, 0.3)), (outline, Pen::solid(INK, 1.1))] {
        for chain in chains(&set, &place) {
            let line = traced(&set, &chain, &place);
            view.frame.clip(&line).iter().for_each(|piece| canvas.line(piece, pen));
        }
    }
}

fn edges(drawn: &Drawn<'_>) -> Vec<Edge> {
    let mut found: BTreeMap<(usize, usize), Edge> = BTreeMap::new();
    for cell in &drawn.field.cells {
        for side in 0..4 {
            let (a, b) = (cell[side], cell[(side + 1) % 4]);
            let edge = Edge { ends: (a, b), middle: cell.get(4 + side).copied(), cells: 0 };
            found.entry((a.min(b), a.max(b))).or_insert(edge).cells += 1;
        }
    }
    found.into_values().collect()
}

/// Edges in walking order: each chain goes on with the edge that turns least.
fn chains(edges: &[Edge], place: &dyn Fn(usize) -> Point) -> Vec<Vec<(usize, bool)>> {
    let mut at_node: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for (n, edge) in edges.iter().enumerate() {
        at_node.entry(edge.ends.0).or_default().push(n);
        at_node.entry(edge.ends.1).or_default().push(n);
    }
    let mut free = vec![true; edges.len()];
    let mut chains = Vec::new();
    for first in 0..edges.len() {
        if !free[first] {
            continue;
        }
        free[first] = false;
        let mut chain = vec![(first, true)];
        extend(&mut chain, edges, &at_node, &mut free, place);
        chain = chain.into_iter().rev().map(|(n, forward)| (n, !forward)).collect();
        extend(&mut chain, edges, &at_node, &mut free, place);
        chains.push(chain);
    }
    chains
}

fn extend(
    chain: &mut Vec<(usize, bool)>,
    edges: &[Edge],
    at_node: &BTreeMap<usize, Vec<usize>>,
    free: &mut [bool],
    place: &dyn Fn(usize) -> Point,
) {
    while let Some(&(last, forward)) = chain.last() {
        let (from, end) = directed(&edges[last], forward);
        let heading = direction(place(from), place(end));
        let straightness = |&n: &usize| {
            let (start, far) = directed(&edges[n], edges[n].ends.0 == end);
            let next = direction(place(start), place(far));
            heading.0 * next.0 + heading.1 * next.1
        };
        let candidates = at_node.get(&end).into_iter().flatten().filter(|&&n| free[n]);
        let Some(&next) = candidates.max_by(|a, b| straightness(a).total_cmp(&straightness(b))) else {
            return;
        };
        if straightness(&next) < 0.5 {
            return;
        }
        free[next] = false;
        chain.push((next, edges[next].ends.0 == end));
    }
}

fn directed(edge: &Edge, forward: bool) -> (usize, usize) {
    if forward { edge.ends } else { (edge.ends.1, edge.ends.0) }
}

fn direction(a: Point, b: Point) -> Point {
    let length = distance(a, b).max(1e-12);
    ((b.0 - a.0) / length, (b.1 - a.1) / length)
}

/// The chain on the canvas: straight where an edge is straight, else four pieces of its parabola.
fn traced(edges: &[Edge], chain: &[(usize, bool)], place: &dyn Fn(usize) -> Point) -> Vec<Point> {
    let mut line: Vec<Point> = Vec::new();
    for &(n, forward) in chain {
        let (start, end) = directed(&edges[n], forward);
        let (a, b) = (place(start), place(end));
        if line.is_empty() {
            line.push(a);
        }
        if let Some(middle) = edges[n].middle.map(place) {
            let bulge = (middle.0 - 0.5 * (a.0 + b.0), middle.1 - 0.5 * (a.1 + b.1));
            if bulge.0.hypot(bulge.1) > 0.15 {
                line.extend([0.25, 0.5, 0.75].map(|t| on_parabola(a, b, bulge, t)));
            }
        }
        line.push(b);
    }
    line
}

fn on_parabola(a: Point, b: Point, bulge: Point, t: f64) -> Point {
    let rise = 4.0 * t * (1.0 - t);
    (a.0 + t * (b.0 - a.0) + rise * bulge.0, a.1 + t * (b.1 - a.1) + rise * bulge.1)
}
