//! What schematic drawings are made of: springs, arrows, rollers, hatching, dimensions.

use super::canvas::{Canvas, Point};
use super::frame::distance;
use super::palette::{CARD, Colour, GREY, INK};
use super::pen::{Lettering, Pen};

/// Text of the schematic drawings.
pub(super) const TEXT: f64 = 12.0;

/// A point at shares along and across a segment; across is to its left on the page, in pixels.
pub(super) fn beside(a: Point, b: Point, along: f64, across: f64) -> Point {
    let length = distance(a, b).max(1e-9);
    let (dx, dy) = ((b.0 - a.0) / length, (b.1 - a.1) / length);
    (a.0 + along * length * dx + across * dy, a.1 + along * length * dy - across * dx)
}

/// A zigzag spring with straight ends.
pub(super) fn spring(canvas: &mut Canvas, a: Point, b: Point, half_width: f64, colour: Colour) {
    const TURNS: usize = 8;
    let mut line = vec![a, beside(a, b, 0.18, 0.0)];
    for turn in 0..TURNS {
        let along = 0.18 + 0.64 * (turn as f64 + 0.5) / TURNS as f64;
        let side = if turn % 2 == 0 { half_width } else { -half_width };
        line.push(beside(a, b, along, side));
    }
    line.extend([beside(a, b, 0.82, 0.0), b]);
    canvas.line(&line, Pen::solid(colour, 1.5));
}

/// An arrow with a filled head at its end.
pub(super) fn arrow(canvas: &mut Canvas, a: Point, b: Point, colour: Colour) {
    const HEAD: f64 = 8.0;
    let neck = 1.0 - HEAD / distance(a, b).max(HEAD);
    canvas.line(&[a, beside(a, b, neck, 0.0)], Pen::solid(colour, 1.4));
    canvas.area(&[b, beside(a, b, neck, 3.1), beside(a, b, neck, -3.1)], colour);
}

/// A thin line between two short bars, its label beside the middle.
pub(super) fn dimension(canvas: &mut Canvas, a: Point, b: Point, label: &str, offset: f64) {
    let pen = Pen::solid(GREY, 0.9);
    canvas.line(&[a, b], pen);
    for along in [0.0, 1.0] {
        canvas.line(&[beside(a, b, along, -4.0), beside(a, b, along, 4.0)], pen);
    }
    canvas.label(beside(a, b, 0.5, offset), label, Lettering::middle(TEXT));
}

/// A fixed line: a stroke with slanted hatching on its right-hand side on the page.
pub(super) fn fixed_line(canvas: &mut Canvas, a: Point, b: Point) {
    const PITCH: f64 = 8.0;
    let length = distance(a, b);
    let count = (length / PITCH).round().max(1.0);
    for n in 0..count as usize {
        let along = (n as f64 + 0.9) / count;
        let ends = [beside(a, b, along, 0.0), beside(a, b, along - 0.8 / count, -8.0)];
        canvas.line(&ends, Pen::solid(GREY, 0.8));
    }
    canvas.line(&[a, b], Pen::solid(INK, 1.6));
}

/// Rollers on the right-hand side of a line on the page, running on a hatched one.
pub(super) fn rollers(canvas: &mut Canvas, a: Point, b: Point, count: usize) {
    const RADIUS: f64 = 4.2;
    for n in 0..count {
        let along = (n as f64 + 0.5) / count as f64;
        let centre = beside(a, b, along, -RADIUS - 1.0);
        canvas.disc(centre, RADIUS, INK);
        canvas.disc(centre, RADIUS - 1.1, CARD);
    }
    let off = -2.0 * RADIUS - 1.6;
    fixed_line(canvas, beside(a, b, 0.0, off), beside(a, b, 1.0, off));
}

/// Points of an arc; angles in degrees from the downward direction, positive to the right.
pub(super) fn arc(centre: Point, radius: f64, from: f64, to: f64) -> Vec<Point> {
    const PIECES: usize = 48;
    let at = |n: usize| {
        let angle = (from + (to - from) * n as f64 / PIECES as f64).to_radians();
        (centre.0 + radius * angle.sin(), centre.1 + radius * angle.cos())
    };
    (0..=PIECES).map(at).collect()
}

/// A node of the mesh.
pub(super) fn node(canvas: &mut Canvas, at: Point) {
    canvas.disc(at, 4.2, INK);
    canvas.disc(at, 2.7, CARD);
}
