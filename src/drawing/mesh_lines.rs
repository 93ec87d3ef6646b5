//! Element edges: those inside the bodies thin, their outlines stronger.

use std::collections::BTreeMap;

use super::canvas::Canvas;
use super::field::Panel;
use super::frame::{Point, between, distance};
use super::palette::{GREY, INK};
use super::pen::Pen;
use super::theme::Colour;

/// Shorter edges inside a body are left out: they would blacken the picture [display pixels].
const SHORTEST: f64 = 4.0;
const INNER: Colour = Colour::same(0x4A5056);

/// Draws the edges inside the bodies and their outlines.
pub(super) fn mesh_lines(canvas: &mut Canvas, panel: &Panel<'_>) {
    let [outline, inner] = edges(panel);
    let long = |line: &Vec<Point>| distance(line[0], line[line.len() - 1]) >= SHORTEST;
    canvas.lines(&inner.into_iter().filter(long).collect::<Vec<_>>(), Pen::solid(INNER, 0.3));
    canvas.lines(&outline, Pen::solid(INK, 1.1));
}

/// Draws the outlines alone, dashed.
pub(super) fn undeformed(canvas: &mut Canvas, panel: &Panel<'_>) {
    canvas.lines(&edges(panel)[0], Pen::dashed(GREY, 0.8));
}

/// Edges on the outlines, and those inside, of which anything is seen.
fn edges(panel: &Panel<'_>) -> [Vec<Vec<Point>>; 2] {
    let mut edges: BTreeMap<(usize, usize), (Vec<Point>, usize)> = BTreeMap::new();
    for cell in &panel.field.cells {
        for side in 0..4 {
            let (a, b) = (cell[side], cell[(side + 1) % 4]);
            let traced = || traced(panel, cell, side);
            edges.entry((a.min(b), a.max(b))).or_insert_with(|| (traced(), 0)).1 += 1;
        }
    }
    edges.retain(|_, (line, _)| panel.frame.meets(line));
    let (outline, inner): (Vec<_>, Vec<_>) = edges.into_values().partition(|(_, cells)| *cells == 1);
    [outline, inner].map(|edges| edges.into_iter().map(|(line, _)| line).collect())
}

/// A side of a cell on the canvas: straight, or in four pieces.
fn traced(panel: &Panel<'_>, cell: &[usize], side: usize) -> Vec<Point> {
    const CORNERS: [Point; 4] = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    let [from, to] = [CORNERS[side], CORNERS[(side + 1) % 4]];
    let place = |t: f64| {
        let (xi, eta) = between(from, to, t);
        let shares = (panel.field.shapes)(cell.len(), [xi, eta]);
        let nodes = cell.iter().map(|&node| panel.nodes[node]).zip(shares);
        nodes.fold((0.0, 0.0), |sum, (node, share)| (sum.0 + share * node.0, sum.1 + share * node.1))
    };
    let [a, b] = [side, (side + 1) % 4].map(|corner| panel.nodes[cell[corner]]);
    if distance(place(0.5), between(a, b, 0.5)) <= 0.15 {
        vec![a, b]
    } else {
        [0.0, 0.25, 0.5, 0.75, 1.0].map(place).to_vec()
    }
}
