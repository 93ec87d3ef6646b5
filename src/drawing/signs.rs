//! The signs on points, filled and hollow.

use super::canvas::Canvas;
use super::frame::Point;
use super::palette::{CARD, Marker};
use super::pen::Pen;
use super::theme::Colour;

/// A filled sign with a thin rim of the card, so that it stands off its own line.
pub(super) fn filled(canvas: &mut Canvas, centre: Point, sign: Marker, radius: f64, colour: Colour) {
    match sign {
        Marker::Absent => {}
        Marker::Dot => cloud(canvas, &[(centre, radius)], colour),
        Marker::Circle => canvas.disc(centre, radius + 0.4, colour, Some(Pen::solid(CARD, 0.8))),
        _ => canvas.rimmed(&corners(sign, centre, radius + 0.5), colour, Pen::solid(CARD, 1.0)),
    }
}

/// Small squares, all as one shape.
pub(super) fn cloud(canvas: &mut Canvas, signs: &[(Point, f64)], colour: Colour) {
    const HALF: f64 = 1.4;
    let square = |&((x, y), _): &(Point, f64)| {
        vec![(x - HALF, y - HALF), (x + HALF, y - HALF), (x + HALF, y + HALF), (x - HALF, y + HALF)]
    };
    let squares: Vec<Vec<Point>> = signs.iter().map(square).collect();
    if !squares.is_empty() {
        canvas.tiles(&squares, colour);
    }
}

/// The sign of a run that did not converge; an unmarked curve gets a circle.
pub(super) fn hollow(canvas: &mut Canvas, centre: Point, sign: Marker, colour: Colour) {
    const RADIUS: f64 = 4.0;
    match sign {
        Marker::Absent | Marker::Circle => ring(canvas, centre, RADIUS, colour),
        _ => canvas.rimmed(&corners(sign, centre, RADIUS - 0.2), CARD, Pen::solid(colour, 1.3)),
    }
}

/// A hollow disc.
pub(super) fn ring(canvas: &mut Canvas, centre: Point, radius: f64, colour: Colour) {
    canvas.disc(centre, radius - 0.65, CARD, Some(Pen::solid(colour, 1.3)));
}

/// Corners of a sign of the area of a disc, roughly.
fn corners(sign: Marker, (x, y): Point, radius: f64) -> Vec<Point> {
    let shape: &[Point] = match sign {
        Marker::Square => &[(-0.88, -0.88), (0.88, -0.88), (0.88, 0.88), (-0.88, 0.88)],
        Marker::Triangle => &[(0.0, -1.2), (1.1, 0.75), (-1.1, 0.75)],
        Marker::Wedge => &[(0.0, 1.2), (1.1, -0.75), (-1.1, -0.75)],
        _ => &[(0.0, -1.25), (1.25, 0.0), (0.0, 1.25), (-1.25, 0.0)],
    };
    shape.iter().map(|&(dx, dy)| (x + radius * dx, y + radius * dy)).collect()
}
