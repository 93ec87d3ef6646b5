//! What schematic drawings are made of: springs, arrows, rollers, hatching, dimensions.

use super::canvas::Canvas;
use super::frame::{Point, distance};
use super::palette::{GREY, INK};
use super::pen::{Lettering, Pen};
use super::signs::ring;
use super::theme::Colour;

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
    let turn = |n: usize| {
        let side = if n.is_multiple_of(2) { half_width } else { -half_width };
        beside(a, b, 0.18 + 0.64 * (n as f64 + 0.5) / TURNS as f64, side)
    };
    let mut line = vec![a, beside(a, b, 0.18, 0.0)];
    line.extend((0..TURNS).map(turn).chain([beside(a, b, 0.82, 0.0), b]));
    canvas.line(&line, Pen::solid(colour, 1.5));
}

/// An arrow with a filled head at its end.
pub(super) fn arrow(canvas: &mut Canvas, a: Point, b: Point, colour: Colour) {
    const HEAD: f64 = 8.0;
    let neck = 1.0 - HEAD / distance(a, b).max(HEAD);
    canvas.line(&[a, beside(a, b, neck, 0.0)], Pen::solid(colour, 1.4));
    canvas.area(&[b, beside(a, b, neck, 3.1), beside(a, b, neck, -3.1)], colour);
}

/// A thin line between two short bars.
pub(super) fn dimension(canvas: &mut Canvas, a: Point, b: Point) {
    let bar = |along: f64| vec![beside(a, b, along, -4.0), beside(a, b, along, 4.0)];
    canvas.lines(&[vec![a, b], bar(0.0), bar(1.0)], Pen::solid(GREY, 0.9));
}

/// A fixed line: a stroke with slanted hatching on its right-hand side on the page.
pub(super) fn fixed_line(canvas: &mut Canvas, a: Point, b: Point) {
    const PITCH: f64 = 8.0;
    let length = distance(a, b);
    let count = (length / PITCH).round().max(1.0);
    let slanted = |along: f64| vec![beside(a, b, along, 0.0), beside(a, b, along - 0.8 / count, -8.0)];
    let hatching: Vec<_> = (0..count as usize).map(|n| slanted((n as f64 + 0.9) / count)).collect();
    canvas.lines(&hatching, Pen::solid(GREY, 0.8));
    canvas.line(&[a, b], Pen::solid(INK, 1.6));
}

/// Rollers on the right-hand side of a line on the page, running on a hatched one.
pub(super) fn rollers(canvas: &mut Canvas, a: Point, b: Point, count: usize) {
    const RADIUS: f64 = 4.2;
    for n in 0..count {
        ring(canvas, beside(a, b, (n as f64 + 0.5) / count as f64, -RADIUS - 1.0), RADIUS, INK);
    }
    let off = -2.0 * RADIUS - 1.6;
    fixed_line(canvas, beside(a, b, 0.0, off), beside(a, b, 1.0, off));
}

/// A point of a circle; the angle in degrees from the downward direction, positive to the right.
pub(super) fn on_circle(centre: Point, radius: f64, angle: f64) -> Point {
    let angle = angle.to_radians();
    (centre.0 + radius * angle.sin(), centre.1 + radius * angle.cos())
}

/// Points of an arc between two such angles.
pub(super) fn arc(centre: Point, radius: f64, from: f64, to: f64) -> Vec<Point> {
    const PIECES: usize = 48;
    (0..=PIECES).map(|n| on_circle(centre, radius, from + (to - from) * n as f64 / PIECES as f64)).collect()
}

/// A node of the mesh.
pub(super) fn node(canvas: &mut Canvas, at: Point) {
    ring(canvas, at, 4.2, INK);
}

/// A named number with its unit, `R = 50 mm`.
pub(super) fn quantity(name: &str, value: f64, unit: &str) -> String {
    let rounded = (value * 1e6).round() / 1e6;
    format!("{name} = {rounded} {unit}").replace('-', "−")
}

/// Text beside a drawing.
pub(super) fn text() -> Lettering {
    Lettering::start(TEXT)
}
