//! What holds and what loads the bodies of a field: supports, loads, and rigid sides.

use super::canvas::Canvas;
use super::field::{Mark, Panel};
use super::frame::{Point, distance};
use super::palette::{CARD, INK, LAYER};
use super::pen::Pen;

/// Marks of a kind stand at least so far apart, and a support or the shaft of an arrow is so long [display pixels].
const APART: f64 = 22.0;
const SUPPORT: f64 = 8.0;
const ARROW: f64 = 18.0;
/// Length of the strokes of a rigid side, and their distance [display pixels].
const STROKE: f64 = 6.0;

/// Draws the marks of a panel, those of a kind thinned out.
pub(super) fn marks(canvas: &mut Canvas, panel: &Panel<'_>) {
    let (mut fixed, mut pushed): (Vec<Point>, Vec<Point>) = (Vec::new(), Vec::new());
    let free = |taken: &mut Vec<Point>, at: Point| {
        let free = taken.iter().all(|other| distance(*other, at) >= APART);
        taken.extend(free.then_some(at));
        free
    };
    // What the frame cuts off is not drawn.
    let seen = panel.frame.widened(0.5);
    for mark in &panel.field.marks {
        let (node, along, is_fixed) = match mark {
            Mark::Rigid(points) => {
                rigid(canvas, panel, points);
                continue;
            }
            Mark::Fixed(node, along) => (*node, *along, true),
            Mark::Pushed(node, along) => (*node, *along, false),
        };
        let (at, across) = (panel.nodes[node], (along.1, 0.0 - along.0));
        let taken = if is_fixed { &mut fixed } else { &mut pushed };
        let middle = if is_fixed { place(at, along, 0.5 * SUPPORT) } else { at };
        if !free(taken, middle) || !seen.holds(at) {
            continue;
        }
        if is_fixed {
            let foot = place(at, along, SUPPORT);
            let corners = [at, place(foot, across, 0.6 * SUPPORT), place(foot, across, -0.6 * SUPPORT)];
            canvas.rimmed(&corners, CARD, Pen::solid(INK, 1.0));
        } else {
            let head = place(at, along, -0.35 * ARROW);
            canvas.line(&[place(at, along, 0.0 - ARROW), head], Pen::solid(LAYER, 1.6));
            canvas.area(&[at, place(head, across, 0.2 * ARROW), place(head, across, -0.2 * ARROW)], LAYER);
        }
    }
}

/// A place so many display pixels away in a direction, y upwards.
fn place((x, y): Point, (across, up): (f64, f64), away: f64) -> Point {
    (x + across * away, y - up * away)
}

/// A line with strokes into what is rigid.
fn rigid(canvas: &mut Canvas, panel: &Panel<'_>, points: &[[(f64, f64); 2]]) {
    let surface: Vec<(Point, Point)> = points.iter().map(|[at, into]| (panel.place(*at), *into)).collect();
    let line: Vec<Point> = surface.iter().map(|(at, _)| *at).collect();
    let mut strokes = Vec::new();
    for pair in surface.windows(2) {
        let (from, to) = (pair[0].0, pair[1].0);
        let pieces = (distance(from, to) / STROKE).ceil().clamp(1.0, 100.0) as usize;
        let along = |k: usize| (k as f64 + 0.5) / pieces as f64;
        let each = (0..pieces).map(|k| (from.0 + along(k) * (to.0 - from.0), from.1 + along(k) * (to.1 - from.1)));
        strokes.extend(each.filter(|at| panel.frame.holds(*at)).map(|at| (at, pair[0].1)));
    }
    let mut last: Option<Point> = None;
    strokes.retain(|(at, _)| {
        let apart = last.is_none_or(|last| distance(last, *at) >= STROKE);
        if apart {
            last = Some(*at);
        }
        apart
    });
    let stroke = |(at, (across, up)): &(Point, Point)| {
        let end = place(*at, (across + 0.7 * up, up - 0.7 * across), STROKE);
        vec![*at, end]
    };
    canvas.lines(&strokes.iter().map(stroke).collect::<Vec<_>>(), Pen::solid(INK, 0.8));
    canvas.line(&line, Pen::solid(INK, 1.6));
}
