//! Element edges: those inside the bodies thin, their outlines stronger.

use std::collections::BTreeMap;

use super::canvas::Canvas;
use super::frame::{Point, between, distance};
use super::palette::INK;
use super::panel::Panel;
use super::pen::Pen;
use super::theme::Colour;

/// Shorter edges inside a body are left out: they would blacken the picture [display pixels].
const SHORTEST: f64 = 4.0;
const INNER: Colour = Colour::same(0x4A5056);

/// Draws the edges inside the bodies and their outlines.
pub(super) fn mesh_lines(canvas: &mut Canvas, panel: &Panel<'_>) {
    let mut edges: BTreeMap<(usize, usize), (Vec<Point>, usize)> = BTreeMap::new();
    for cell in &panel.field.cells {
        for side in 0..4 {
            let (a, b) = (cell[side], cell[(side + 1) % 4]);
            let traced = || traced(panel.nodes[a], panel.nodes[b], cell.get(4 + side).map(|&node| panel.nodes[node]));
            edges.entry((a.min(b), a.max(b))).or_insert_with(|| (traced(), 0)).1 += 1;
        }
    }
    let (outline, inner): (Vec<_>, Vec<_>) = edges.into_values().partition(|(_, cells)| *cells == 1);
    let visible = |line: &[Point]| panel.frame.meets(line);
    let long = |line: &[Point]| distance(line[0], line[line.len() - 1]) >= SHORTEST;
    let lines = |edges: Vec<(Vec<Point>, usize)>, shown: &dyn Fn(&[Point]) -> bool| -> Vec<Vec<Point>> {
        edges.into_iter().map(|(line, _)| line).filter(|line| visible(line) && shown(line)).collect()
    };
    canvas.lines(&lines(inner, &long), Pen::solid(INNER, 0.3));
    canvas.lines(&lines(outline, &|_| true), Pen::solid(INK, 1.1));
}

/// An edge on the canvas: straight, or four pieces of the parabola through its midside node.
fn traced(a: Point, b: Point, middle: Option<Point>) -> Vec<Point> {
    let chord = between(a, b, 0.5);
    let bulge = middle.map_or((0.0, 0.0), |middle| (middle.0 - chord.0, middle.1 - chord.1));
    if bulge.0.hypot(bulge.1) <= 0.15 {
        return vec![a, b];
    }
    let on_parabola = |t: f64| {
        let (straight, rise) = (between(a, b, t), 4.0 * t * (1.0 - t));
        (straight.0 + rise * bulge.0, straight.1 + rise * bulge.1)
    };
    [0.0, 0.25, 0.5, 0.75, 1.0].map(on_parabola).to_vec()
}
