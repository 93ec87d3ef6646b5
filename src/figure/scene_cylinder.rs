//! Drawing of the cylinder quarter on the rigid plane.

use super::canvas::Canvas;
use super::drawing::Drawing;
use super::frame::Point;
use super::palette::{GREY, INK, SKY, tint};
use super::pen::{Lettering, Pen};
use super::sketch::{TEXT, arc, arrow, dimension, fixed_line, on_circle, quantity, rollers, text};
use crate::error::Error;

/// Elastic cylinder on a rigid plane, the lower quarter of it.
#[derive(Clone, Debug)]
pub struct CylinderScene {
    /// Radius `R`, in mm.
    pub radius: f64,
    /// Half-width `a` of the contact, in mm.
    pub half_width: f64,
    /// Length `L` of the candidates from the symmetry line, in mm.
    pub candidates: f64,
    /// Uniform load `q` on the horizontal cut, in MPa.
    pub load: f64,
    /// Small print below.
    pub notes: Vec<String>,
}

const CENTRE: Point = (112.0, 106.0);
const RADIUS: f64 = 232.0;
/// The contact is drawn at least this wide, as a share of the radius.
const LEAST_SHARE: f64 = 0.17;

impl CylinderScene {
    /// The drawing, drawn.
    pub fn drawing(&self) -> Result<Drawing, Error> {
        let mut canvas = Canvas::new();
        draw_cylinder(&mut canvas, self);
        let shown = "Not to scale: a and L are drawn larger.".to_string();
        canvas.drawing("Cylinder on a rigid plane", (452.0, 414.0), &[self.notes.as_slice(), &[shown]].concat())
    }
}

/// Draws the quarter, its load, supports and dimensions.
fn draw_cylinder(canvas: &mut Canvas, scene: &CylinderScene) {
    let bottom = (CENTRE.0, CENTRE.1 + RADIUS);
    let mut body = arc(CENTRE, RADIUS, 0.0, 90.0);
    body.push(CENTRE);
    canvas.area(&body, tint(SKY, 0.22));
    fixed_line(canvas, (bottom.0 - 50.0, bottom.1), (CENTRE.0 + RADIUS + 24.0, bottom.1));
    canvas.label((CENTRE.0 + RADIUS + 24.0, bottom.1 - 12.0), "rigid plane", Lettering::end(TEXT).coloured(GREY));
    body.push(body[0]);
    canvas.line(&body, Pen::solid(INK, 1.6));
    rollers(canvas, (CENTRE.0, CENTRE.1 + 16.0), (bottom.0, bottom.1 - 12.0), 8);
    let upright = Lettering::middle(TEXT).coloured(GREY).upright();
    canvas.label((CENTRE.0 - 38.0, CENTRE.1 + 0.5 * RADIUS), "symmetry", upright);
    load(canvas, scene);
    radius(canvas, scene);
    widths(canvas, scene, bottom);
}

fn load(canvas: &mut Canvas, scene: &CylinderScene) {
    const ARROWS: usize = 9;
    let top = CENTRE.1 - 38.0;
    for n in 0..ARROWS {
        let x = CENTRE.0 + 3.0 + (RADIUS - 6.0) * n as f64 / (ARROWS - 1) as f64;
        arrow(canvas, (x, top), (x, CENTRE.1 - 2.0), INK);
    }
    canvas.line(&[(CENTRE.0, top), (CENTRE.0 + RADIUS, top)], Pen::solid(INK, 1.4));
    let label = quantity("q", scene.load, "MPa");
    canvas.label((CENTRE.0 + RADIUS + 12.0, top + 10.0), &label, text());
}

fn radius(canvas: &mut Canvas, scene: &CylinderScene) {
    let rim = on_circle(CENTRE, RADIUS, 52.0);
    arrow(canvas, CENTRE, rim, GREY);
    canvas.disc(CENTRE, 2.6, INK);
    let (x, y) = (0.45 * CENTRE.0 + 0.55 * rim.0, 0.45 * CENTRE.1 + 0.55 * rim.1);
    canvas.label((x + 12.0, y - 8.0), &quantity("R", scene.radius, "mm"), text());
}

fn widths(canvas: &mut Canvas, scene: &CylinderScene, bottom: Point) {
    let share = (scene.half_width / scene.radius).max(LEAST_SHARE);
    let factor = share / (scene.half_width / scene.radius);
    let rows = [("L", "candidates", scene.candidates, 24.0), ("a", "contact", scene.half_width, 48.0)];
    for (name, meaning, length, depth) in rows {
        let end = bottom.0 + (factor * length / scene.radius * RADIUS).min(RADIUS);
        let y = bottom.1 + depth;
        canvas.line(&[(end, bottom.1 + 2.0), (end, y)], Pen::dashed(GREY, 0.8));
        dimension(canvas, (bottom.0, y), (end, y));
        let label = format!("{} ({meaning})", quantity(name, length, "mm"));
        canvas.label((end + 9.0, y + 1.0), &label, text());
    }
    canvas.line(&[(bottom.0, bottom.1 + 2.0), (bottom.0, bottom.1 + 50.0)], Pen::dashed(GREY, 0.8));
}
