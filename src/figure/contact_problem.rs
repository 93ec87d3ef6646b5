//! Drawing of two bodies in contact, and of contact elements between the external nodes of their potential contact areas.

use super::canvas::{Canvas, EDGE, WIDTH};
use super::drawing::Drawing;
use super::frame::{Point, between};
use super::palette::{GREY, INK, LAYER, NODE, SKY, tint};
use super::pen::{Lettering, Pen};
use super::sketch::{TEXT, arc, arrow, beside, fixed_line, node, on_circle, spring};
use crate::error::Error;

const HEIGHT: f64 = 362.0;
/// Body A is a disc cut off where it touches, body B a block.
const CENTRE: Point = (180.0, 142.0);
const RADIUS: f64 = 84.0;
const SURFACE: f64 = 210.0;
const BLOCK: [Point; 2] = [(66.0, SURFACE), (294.0, 300.0)];
/// Half the opening angle of the contact surface, seen from the disc's centre \[°\].
const HALF_ANGLE: f64 = 36.0;
/// Facing surfaces of the meshes, and how far the upper one rises towards its end.
const FACES: [f64; 2] = [174.0, 206.0];
const RISE: f64 = 26.0;
/// Columns of both meshes, from the line of symmetry on, their width, and how many of their nodes may touch.
const COLUMNS: usize = 7;
const COLUMN: f64 = 44.0;
const EXTERNAL: usize = 6;
const LEFT: f64 = 442.0;

/// The contact problem and its contact elements as SVG.
pub fn contact_problem() -> Result<Drawing, Error> {
    let mut canvas = Canvas::new();
    bodies(&mut canvas);
    meshes(&mut canvas);
    canvas.drawing("Two bodies in contact, and contact elements between them", (WIDTH - EDGE, HEIGHT), &[])
}

fn bodies(canvas: &mut Canvas) {
    let [(left, top), (right, bottom)] = BLOCK;
    let disc = arc(CENTRE, RADIUS, HALF_ANGLE, 360.0 - HALF_ANGLE);
    let block = [(left, top), (right, top), (right, bottom), (left, bottom), (left, top)];
    canvas.area(&disc, tint(SKY, 0.25));
    canvas.area(&block, tint(GREY, 0.16));
    canvas.line(&disc, Pen::solid(INK, 1.5));
    canvas.line(&block, Pen::solid(INK, 1.5));
    let touching = [disc[disc.len() - 1], disc[0]];
    canvas.line(&touching, Pen::solid(LAYER, 4.0));
    canvas.label(
        (touching[1].0 + 18.0, SURFACE - 11.0),
        "A_c contact surface",
        Lettering::start(TEXT).coloured(LAYER).bold(),
    );
    canvas.label((CENTRE.0 - 44.0, CENTRE.1 - 34.0), "A", Lettering::middle(17.0).bold().coloured(GREY));
    canvas.label((left + 22.0, bottom - 22.0), "B", Lettering::middle(17.0).bold().coloured(GREY));
    supports(canvas, (left, right, bottom));
    for angle in [-165.0, -147.0, -129.0_f64] {
        arrow(canvas, on_circle(CENTRE, RADIUS + 34.0, angle), on_circle(CENTRE, RADIUS + 3.0, angle), INK);
    }
    canvas.label((CENTRE.0 - 116.0, CENTRE.1 - 98.0), "f on A_t", Lettering::start(TEXT));
    arrow(canvas, (right + 36.0, SURFACE + 45.0), (right + 3.0, SURFACE + 45.0), INK);
    canvas.label((right + 8.0, SURFACE + 62.0), "f on A_t", Lettering::start(TEXT));
    for (x, y) in [(CENTRE.0 + 12.0, CENTRE.1 - 16.0), (CENTRE.0 + 12.0, SURFACE + 32.0)] {
        arrow(canvas, (x, y), (x, y + 30.0), GREY);
        canvas.label((x + 8.0, y + 14.0), "b", Lettering::start(TEXT).coloured(GREY));
    }
    canvas.label(
        (EDGE + 8.0, 350.0),
        "bodies A and B, tractions f, body forces b, supports A_u",
        Lettering::start(TEXT),
    );
}

/// Hatched lines where displacements are given.
fn supports(canvas: &mut Canvas, (left, right, bottom): (f64, f64, f64)) {
    let upper = [112.0, 122.0, 132.0, 142.0, 152.0].map(|angle| on_circle(CENTRE, RADIUS, angle));
    upper.windows(2).for_each(|piece| fixed_line(canvas, piece[0], piece[1]));
    canvas.label((upper[0].0 + 12.0, upper[0].1 - 10.0), "A_u", Lettering::start(TEXT));
    fixed_line(canvas, (left + 40.0, bottom), (right - 40.0, bottom));
    canvas.label((right - 32.0, bottom + 10.0), "A_u", Lettering::start(TEXT));
}

fn meshes(canvas: &mut Canvas) {
    let [upper, lower] = [face(0), face(1)];
    let far = [62.0, 300.0];
    for (face, far, fill) in [(&upper, far[0], tint(SKY, 0.25)), (&lower, far[1], tint(GREY, 0.16))] {
        let back: Vec<Point> = face.iter().map(|&(x, _)| (x, far)).collect();
        canvas.area(&face.iter().chain(back.iter().rev()).copied().collect::<Vec<_>>(), fill);
        let rows = [0.0, 0.36, 1.0].map(|share| row(face, &back, share));
        let columns = face.iter().zip(&back).map(|(a, b)| vec![*a, *b]);
        canvas.lines(&rows.iter().cloned().chain(columns).collect::<Vec<_>>(), Pen::solid(GREY, 0.9));
        canvas.line(face, Pen::solid(INK, 1.6));
        rows[1].iter().for_each(|&at| canvas.disc(at, 2.4, GREY));
    }
    for (&a, &b) in upper.iter().zip(&lower).take(EXTERNAL) {
        spring(canvas, a, b, 4.6, NODE);
        node(canvas, a);
        node(canvas, b);
    }
    let (from, to) = (lower[0], lower[EXTERNAL - 1]);
    canvas.line(&[from, to], Pen::solid(LAYER, 3.2));
    lower.iter().take(EXTERNAL).for_each(|&at| node(canvas, at));
    canvas.label(
        beside(from, to, 0.5, -16.0),
        "potential contact area",
        Lettering::middle(TEXT).coloured(LAYER).bold(),
    );
    canvas.label((upper[0].0 + 12.0, 50.0), "A", Lettering::middle(15.0).bold().coloured(GREY));
    canvas.label((lower[0].0 + 12.0, 314.0), "B", Lettering::middle(15.0).bold().coloured(GREY));
    let end = upper[COLUMNS];
    canvas.label((end.0 + 10.0, 120.0), "internal nodes (•)", Lettering::start(TEXT).coloured(GREY));
    canvas.label((end.0 + 10.0, 178.0), "external nodes (○)", Lettering::start(TEXT));
    canvas.label((end.0 + 10.0, 196.0), "contact elements", Lettering::start(TEXT).coloured(NODE));
    canvas.label(
        (LEFT, 350.0),
        "contact elements between external nodes; internal ones are condensed",
        Lettering::start(TEXT),
    );
}

/// Nodes of a surface: the upper one, 0, rises away from the first contact, the lower one is flat.
fn face(side: usize) -> Vec<Point> {
    let rise = if side == 0 { RISE } else { 0.0 };
    let at = |k: usize| (LEFT + COLUMN * k as f64, FACES[side] - rise * (k as f64 / COLUMNS as f64).powi(2));
    (0..=COLUMNS).map(at).collect()
}

fn row(face: &[Point], back: &[Point], share: f64) -> Vec<Point> {
    face.iter().zip(back).map(|(&a, &b)| between(a, b, share)).collect()
}
