//! Drawing of the three contact elements side by side.

use super::canvas::{Canvas, EDGE, WIDTH};
use super::drawing::Drawing;
use super::frame::{Frame, Point, between};
use super::palette::{Dash, GREY, INK, LAYER, LINE, NODE, tint};
use super::pen::{Lettering, Pen};
use super::signs::cross;
use super::sketch::{TEXT, arrow, beside, dimension, node, spring};
use super::theme::Colour;
use crate::error::Error;

const HEIGHT: f64 = 368.0;
const PANEL: f64 = 292.0;
/// Upper face of the contact zone of every panel, and half the drawn gap.
const MIDDLE: f64 = 195.0;
const HALF_GAP: f64 = 42.0;
const INSET: f64 = 34.0;

/// Place of the Gauss points of the two-point rule on 0…1.
const GAUSS: [f64; 2] = [0.211_324_865, 0.788_675_135];

/// The two opposite edges of a panel, left to right.
struct Faces {
    upper: [Point; 2],
    lower: [Point; 2],
}

/// The line, layer and node elements as SVG.
pub fn contact_elements() -> Result<Drawing, Error> {
    let mut canvas = Canvas::new();
    line_element(&mut canvas, EDGE);
    layer_element(&mut canvas, EDGE + PANEL);
    node_element(&mut canvas, EDGE + 2.0 * PANEL);
    canvas.drawing("The three contact elements", (WIDTH - EDGE, HEIGHT), &[])
}

fn line_element(canvas: &mut Canvas, left: f64) {
    let faces = faces(left, 0.0);
    bodies(canvas, left, &faces);
    // So spaced that the Gauss points fall between springs.
    let pitch = (GAUSS[1] - GAUSS[0]) / 6.0;
    for n in 0..10 {
        let along = 0.5 + pitch * (f64::from(n) - 4.5);
        let (a, b) = across(&faces, along);
        spring(canvas, a, b, 3.6, tint(LINE, 0.8));
    }
    for along in GAUSS {
        let (a, b) = across(&faces, along);
        canvas.line(&[a, b], Pen::dashed(LINE, 1.6));
        [a, b].into_iter().for_each(|end| cross(canvas, end, 5.0, Pen::solid(LINE, 2.2)));
    }
    corner_nodes(canvas, &faces);
    axes(canvas, (left + PANEL - 36.0, MIDDLE + 12.0));
    let text = [
        "distributed spring kₙ between two edges,",
        "force summed at the Gauss points (×)",
        "wᵢ = Σ Nₐ(ξᵢ) (uₐᴬ + uₐᴮ),  kᵢ = kₙ",
    ];
    caption(canvas, left, "line", LINE, &text);
}

fn layer_element(canvas: &mut Canvas, left: f64) {
    let faces = faces(left, 15.0);
    let [upper, lower] = [faces.upper, faces.lower];
    canvas.area(&[lower[0], lower[1], upper[1], upper[0]], tint(LAYER, 0.22));
    bodies(canvas, left, &faces);
    canvas.lines(&[0, 1].map(|side| vec![lower[side], upper[side]]), Pen::solid(LAYER, 1.4));
    let (start, end) = (between(upper[0], lower[0], 0.5), between(upper[1], lower[1], 0.5));
    canvas.line(&[start, end], Pen { colour: LAYER, width: 1.4, dash: Dash::DashDot });
    for along in GAUSS {
        cross(canvas, between(start, end, along), 5.0, Pen::solid(LAYER, 2.2));
    }
    canvas.label((end.0 + 6.0, end.1), "η = 0", Lettering::start(TEXT));
    let (a, b) = across(&faces, 0.37);
    [a, b].into_iter().for_each(|end| arrow(canvas, between(a, b, 0.5), end, INK));
    canvas.label((a.0 + 8.0, MIDDLE + 18.0), "t(ξ) = t₀ + g(ξ)", Lettering::start(TEXT));
    canvas.label((a.0 + 8.0, MIDDLE - 18.0), "Eₙ, G = 0", Lettering::start(TEXT).coloured(LAYER).bold());
    corner_nodes(canvas, &faces);
    let text = ["thin element of a fictitious material,", "stiff where the gap is narrow", "kᵢ = Eₙ / t(ξᵢ)"];
    caption(canvas, left, "layer", LAYER, &text);
}

fn node_element(canvas: &mut Canvas, left: f64) {
    let faces = faces(left, 0.0);
    bodies(canvas, left, &faces);
    for along in [0.0, 0.5, 1.0] {
        let (a, b) = across(&faces, along);
        spring(canvas, a, b, 6.0, NODE);
        node(canvas, a);
        node(canvas, b);
        canvas.label((a.0 + 11.0, MIDDLE), "kₙAᵢ", Lettering::start(TEXT).coloured(NODE));
    }
    let below = |along: f64| beside(faces.lower[0], faces.lower[1], along, -26.0);
    dimension(canvas, below(0.17), below(0.83));
    canvas.label(beside(below(0.17), below(0.83), 0.5, -13.0), "Aᵢ", Lettering::middle(TEXT));
    let ends = [0.17, 0.83].map(below).map(|(x, y)| vec![(x, y - 24.0), (x, y + 4.0)]);
    canvas.lines(&ends, Pen { colour: GREY, width: 0.9, dash: Dash::Dotted });
    let text =
        ["one normal spring per node pair,", "weighted with its tributary length Aᵢ", "wᵢ = uᵢᴬ + uᵢᴮ,  kᵢ = kₙ"];
    caption(canvas, left, "node", NODE, &text);
}

/// Opposite edges; a taper opens the gap to the right.
fn faces(left: f64, taper: f64) -> Faces {
    let (from, to) = (left + INSET, left + PANEL - 68.0);
    Faces {
        upper: [(from, MIDDLE - HALF_GAP + taper), (to, MIDDLE - HALF_GAP - taper)],
        lower: [(from, MIDDLE + HALF_GAP - taper), (to, MIDDLE + HALF_GAP + taper)],
    }
}

fn across(faces: &Faces, along: f64) -> (Point, Point) {
    (between(faces.upper[0], faces.upper[1], along), between(faces.lower[0], faces.lower[1], along))
}

/// The two bodies as pale strips that run on beyond the element.
fn bodies(canvas: &mut Canvas, left: f64, faces: &Faces) {
    let (from, to) = (left + INSET - 22.0, left + PANEL - 46.0);
    let fill = tint(GREY, 0.16);
    for (edge, far, name) in [(faces.upper, MIDDLE - 106.0, "A"), (faces.lower, MIDDLE + 106.0, "B")] {
        let slope = (edge[1].1 - edge[0].1) / (edge[1].0 - edge[0].0);
        let at = |x: f64| (x, edge[0].1 + slope * (x - edge[0].0));
        let (a, b) = (at(from), at(to));
        canvas.area(&[a, b, (to, far), (from, far)], fill);
        canvas.line(&[a, b], Pen::solid(INK, 1.5));
        let inwards = if name == "A" { far + 14.0 } else { far - 14.0 };
        canvas.label((from + 12.0, inwards), name, Lettering::middle(13.0).bold().coloured(GREY));
    }
}

fn corner_nodes(canvas: &mut Canvas, faces: &Faces) {
    faces.upper.into_iter().chain(faces.lower).for_each(|at| node(canvas, at));
}

fn axes(canvas: &mut Canvas, origin: Point) {
    let (t, n) = ((origin.0 + 26.0, origin.1), (origin.0, origin.1 - 30.0));
    arrow(canvas, origin, t, INK);
    arrow(canvas, origin, n, INK);
    canvas.label((t.0 - 4.0, t.1 + 11.0), "t", Lettering::middle(TEXT));
    canvas.label((n.0 + 9.0, n.1 + 4.0), "n", Lettering::middle(TEXT));
}

fn caption(canvas: &mut Canvas, left: f64, name: &str, colour: Colour, lines: &[&str]) {
    let frame = Frame { left: left + 12.0, top: 56.0, right: left + 42.0, bottom: 59.0 };
    canvas.area(&frame.corners(), colour);
    canvas.label((left + 50.0, 57.0), name, Lettering::start(14.0).bold());
    for (row, line) in lines.iter().enumerate() {
        canvas.label((left + 12.0, 322.0 + 17.0 * row as f64), line, Lettering::start(TEXT));
    }
}
