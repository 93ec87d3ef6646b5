//! Drawing of the pin in the eye of the rod.

use super::canvas::Canvas;
use super::drawing::Drawing;
use super::frame::{Frame, Point};
use super::palette::{GREY, INK, ORANGE, PURPLE, SKY, tint};
use super::pen::{Lettering, Pen};
use super::sketch::{TEXT, arc, arrow, beside, dimension, on_circle, quantity, rollers, text};
use crate::error::Error;

/// Pin in the eye of a connecting rod, half of the rod and a quarter of the pin.
#[derive(Clone, Debug)]
pub struct PinRodScene {
    /// Radius `R` of the pin, in mm.
    pub pin_radius: f64,
    /// Radial clearance `c`, in mm.
    pub clearance: f64,
    /// Outer radius of the eye, in mm.
    pub eye_radius: f64,
    /// Whole width of the shank, in mm.
    pub shank_width: f64,
    /// Height of the shank's end above the centre of the eye, in mm.
    pub shank_end: f64,
    /// Force on the whole rod, in N.
    pub force: f64,
    /// Angle of the last candidate from the load line, in degrees.
    pub candidates: f64,
    /// Small print below.
    pub notes: Vec<String>,
}

/// The symmetry line, and the room for the whole rod on it.
const AXIS: f64 = 106.0;
const TOP: f64 = 102.0;
const HEIGHT: f64 = 470.0;
/// The clearance is drawn at least this wide, as a share of the pin's radius.
const LEAST_CLEARANCE: f64 = 0.10;

/// The drawn places; the pin touches the hole at its lowest point.
struct Shape {
    pin: Point,
    pin_radius: f64,
    eye: Point,
    hole_radius: f64,
    eye_radius: f64,
    shank: f64,
}

impl PinRodScene {
    /// The drawing, drawn.
    pub fn drawing(&self) -> Result<Drawing, Error> {
        let mut canvas = Canvas::new();
        draw_pin_rod(&mut canvas, self);
        let shown = "Not to scale: the clearance is drawn larger.".to_string();
        canvas.drawing("Pin and connecting rod", (452.0, 606.0), &[self.notes.as_slice(), &[shown]].concat())
    }
}

/// Draws both bodies, the pull, supports, candidates and dimensions.
fn draw_pin_rod(canvas: &mut Canvas, scene: &PinRodScene) {
    let shape = Shape::of(scene);
    bodies(canvas, &shape);
    supports(canvas, &shape);
    pull(canvas, scene, &shape);
    candidates(canvas, scene, &shape);
    dimensions(canvas, scene, &shape);
}

impl Shape {
    fn of(scene: &PinRodScene) -> Shape {
        let scale = HEIGHT / (scene.shank_end + scene.eye_radius);
        let pin_radius = scale * scene.pin_radius;
        let clearance = (scale * scene.clearance).max(LEAST_CLEARANCE * pin_radius);
        let eye = (AXIS, TOP + scale * scene.shank_end);
        Shape {
            pin: (AXIS, eye.1 + clearance),
            pin_radius,
            eye,
            hole_radius: pin_radius + clearance,
            eye_radius: scale * scene.eye_radius,
            shank: 0.5 * scale * scene.shank_width,
        }
    }
}

fn bodies(canvas: &mut Canvas, shape: &Shape) {
    let corner = 180.0 - (shape.shank / shape.eye_radius).clamp(-1.0, 1.0).asin().to_degrees();
    let mut rod = arc(shape.eye, shape.eye_radius, 0.0, corner);
    rod.extend([(AXIS + shape.shank, TOP), (AXIS, TOP)]);
    let hole = arc(shape.eye, shape.hole_radius, 180.0, 0.0);
    let mut area = rod.clone();
    area.extend(&hole);
    canvas.area(&area, tint(ORANGE, 0.18));
    let cut = [vec![(AXIS, TOP), hole[0]], vec![(AXIS, shape.eye.1 + shape.hole_radius), rod[0]]];
    canvas.lines(&cut, Pen::solid(INK, 1.2));
    canvas.lines(&[rod, hole], Pen::solid(INK, 1.6));
    let mut pin = arc(shape.pin, shape.pin_radius, 0.0, 90.0);
    pin.push(shape.pin);
    canvas.area(&pin, tint(SKY, 0.35));
    pin.push(pin[0]);
    canvas.line(&pin, Pen::solid(INK, 1.6));
    let name = Lettering::middle(TEXT).bold();
    canvas.label((AXIS + 0.6 * shape.shank, 0.55 * TOP + 0.45 * shape.eye.1), "rod", name);
}

fn supports(canvas: &mut Canvas, shape: &Shape) {
    let (hole_top, hole_bottom) = (shape.eye.1 - shape.hole_radius, shape.eye.1 + shape.hole_radius);
    let runs = [
        (TOP + 6.0, hole_top - 2.0),
        (shape.pin.1 + 4.0, hole_bottom - 4.0),
        (hole_bottom + 4.0, shape.eye.1 + shape.eye_radius - 2.0),
    ];
    for (from, to) in runs {
        let count = ((to - from) / 20.0).round().max(2.0) as usize;
        rollers(canvas, (AXIS, from), (AXIS, to), count);
    }
    rollers(canvas, (AXIS + shape.pin_radius, shape.pin.1), (AXIS + 4.0, shape.pin.1), 3);
    canvas.label((AXIS - 38.0, 0.5 * (TOP + hole_top)), "symmetry", Lettering::middle(TEXT).coloured(GREY).upright());
}

fn pull(canvas: &mut Canvas, scene: &PinRodScene, shape: &Shape) {
    let face = Frame { left: AXIS, top: TOP - 6.0, right: AXIS + shape.shank, bottom: TOP };
    canvas.area(&face.corners(), INK);
    let middle = AXIS + 0.5 * shape.shank;
    arrow(canvas, (middle, TOP - 6.0), (middle, TOP - 46.0), INK);
    canvas.label((middle + 10.0, TOP - 34.0), &quantity("F/2", 0.5 * scene.force, "N"), text());
    canvas.label((face.right + 8.0, TOP - 3.0), "end face stays flat", text().coloured(GREY));
}

fn candidates(canvas: &mut Canvas, scene: &PinRodScene, shape: &Shape) {
    let reach = shape.hole_radius + 7.0;
    canvas.line(&arc(shape.eye, reach, 0.0, scene.candidates), Pen::solid(PURPLE, 3.0));
    let ray = on_circle(shape.eye, shape.eye_radius + 22.0, scene.candidates);
    canvas.line(&[shape.pin, ray], Pen::dashed(GREY, 0.9));
    let bottom = shape.eye.1 + shape.eye_radius;
    canvas.line(&[(AXIS, bottom), (AXIS, bottom + 26.0)], Pen::dashed(GREY, 0.9));
    let turn = arc(shape.eye, shape.eye_radius + 14.0, 0.0, scene.candidates);
    canvas.line(&turn[..turn.len() - 3], Pen::solid(GREY, 1.0));
    arrow(canvas, turn[turn.len() - 5], turn[turn.len() - 1], GREY);
    let at = on_circle(shape.eye, shape.eye_radius + 24.0, 45.0);
    canvas.label(at, &format!("θ: candidates 0…{}°", scene.candidates), text());
}

fn dimensions(canvas: &mut Canvas, scene: &PinRodScene, shape: &Shape) {
    radius(canvas, shape);
    let hole = scene.pin_radius + scene.clearance;
    let sizes = [("pin R", scene.pin_radius), ("clearance c", scene.clearance), ("hole R + c", hole)];
    for (row, (name, value)) in sizes.into_iter().enumerate() {
        let place = (AXIS + shape.eye_radius + 40.0, shape.eye.1 + 22.0 + 19.0 * row as f64);
        canvas.label(place, &quantity(name, value, "mm"), text());
    }
    let outer = on_circle(shape.eye, shape.eye_radius, 110.0);
    canvas.label((outer.0 + 10.0, outer.1 - 10.0), &quantity("outer radius", scene.eye_radius, "mm"), text());
    let y = TOP + 0.30 * (shape.eye.1 - TOP);
    dimension(canvas, (AXIS, y), (AXIS + shape.shank, y));
    canvas.label((AXIS + shape.shank + 9.0, y), &quantity("half width", 0.5 * scene.shank_width, "mm"), text());
    height(canvas, scene, shape);
}

fn radius(canvas: &mut Canvas, shape: &Shape) {
    let rim = on_circle(shape.pin, shape.pin_radius, 52.0);
    arrow(canvas, shape.pin, rim, INK);
    canvas.disc(shape.pin, 2.4, INK);
    canvas.label(beside(shape.pin, rim, 0.62, 10.0), "R", Lettering::middle(TEXT));
    let place = on_circle(shape.pin, 0.66 * shape.pin_radius, 22.0);
    canvas.label(place, "pin", Lettering::middle(TEXT).bold());
}

/// Height of the shank's end above the centre of the eye.
fn height(canvas: &mut Canvas, scene: &PinRodScene, shape: &Shape) {
    let x = AXIS + shape.eye_radius + 164.0;
    let thin = Pen::dashed(GREY, 0.7);
    canvas.line(&[(AXIS + shape.eye_radius + 6.0, shape.eye.1), (x, shape.eye.1)], thin);
    canvas.line(&[(AXIS + shape.shank + 128.0, TOP), (x, TOP)], thin);
    dimension(canvas, (x, shape.eye.1), (x, TOP));
    let label = quantity("height of the end", scene.shank_end, "mm");
    canvas.label((x + 13.0, 0.5 * (TOP + shape.eye.1)), &label, Lettering::middle(TEXT).upright());
}
