//! Bands of a field: cells cut along their levels, and the colour bar.

use super::canvas::{Canvas, Point};
use super::cell_grid::{Grid, Vertex};
use super::field::Drawn;
use super::frame::{Frame, distance};
use super::palette::{Colour, ColourMap};
use super::view::View;

/// Levels between the bands, and their colours.
pub(super) struct Bands {
    /// Ends of the bands in ascending order, one more than bands.
    pub levels: Vec<f64>,
    pub step: f64,
    pub map: ColourMap,
}

/// Parts overlap by this much, so that no seam shows [display pixels].
const OVERLAP: f64 = 0.2;

impl Bands {
    /// The largest level in magnitude.
    pub fn largest(&self) -> f64 {
        self.levels.iter().fold(0.0, |largest, level| level.abs().max(largest))
    }

    /// How many bands.
    pub fn count(&self) -> usize {
        self.levels.len() - 1
    }

    /// Colour of a band.
    pub fn colour(&self, band: usize) -> Colour {
        self.map.colour((band as f64 + 0.5) / self.count() as f64)
    }

    /// Band of a value; what is beyond the ends belongs to the first or last.
    fn of(&self, value: f64) -> usize {
        let above = self.levels.iter().skip(1).take_while(|&&level| value >= level).count();
        above.min(self.count() - 1)
    }
}

/// Paints one cell: each part in the colour of its lowest band, then what reaches above each further level.
pub(super) fn paint_cell(canvas: &mut Canvas, drawn: &Drawn<'_>, cell: &[usize], view: &View, bands: &Bands) {
    let corners: Vec<Point> = cell.iter().map(|&node| view.place(drawn.nodes[node])).collect();
    if !touches(&corners, &view.frame) {
        return;
    }
    let grid = Grid::of(drawn, cell, &corners);
    let first = bands.of(grid.vertices[0].value);
    if grid.vertices.iter().all(|vertex| bands.of(vertex.value) == first) {
        return paint_part(canvas, grid.rim(), view, bands);
    }
    for row in 0..grid.parts {
        for column in 0..grid.parts {
            paint_part(canvas, grid.part(row, column), view, bands);
        }
    }
}

fn touches(corners: &[Point], frame: &Frame) -> bool {
    let beyond = |side: &dyn Fn(&Point) -> bool| corners.iter().all(side);
    !(beyond(&|p| p.0 < frame.left)
        || beyond(&|p| p.0 > frame.right)
        || beyond(&|p| p.1 < frame.top)
        || beyond(&|p| p.1 > frame.bottom))
}

/// The part moved outwards on all sides.
fn overlapping(part: &[Vertex]) -> Vec<Vertex> {
    let count = part.len();
    let outward = |a: Point, b: Point| {
        let length = distance(a, b).max(1e-9);
        ((a.1 - b.1) / length, (b.0 - a.0) / length)
    };
    let moved = |n: usize| {
        let (before, here, after) = (part[(n + count - 1) % count].at, part[n].at, part[(n + 1) % count].at);
        let (first, second) = (outward(before, here), outward(here, after));
        let at = (here.0 + OVERLAP * (first.0 + second.0), here.1 + OVERLAP * (first.1 + second.1));
        Vertex { at, ..part[n] }
    };
    (0..count).map(moved).collect()
}

fn paint_part(canvas: &mut Canvas, part: Vec<Vertex>, view: &View, bands: &Bands) {
    let mut rest = within(overlapping(&part), &view.frame);
    let lowest = rest.iter().map(|vertex| vertex.value).fold(f64::INFINITY, f64::min);
    for band in bands.of(lowest)..bands.count() {
        if band > bands.of(lowest) {
            rest = cut(&rest, |vertex| vertex.value - bands.levels[band]);
        }
        if rest.len() < 3 {
            return;
        }
        let outline: Vec<Point> = rest.iter().map(|vertex| vertex.at).collect();
        canvas.area(&outline, bands.colour(band));
    }
}

fn within(part: Vec<Vertex>, frame: &Frame) -> Vec<Vertex> {
    if part.iter().all(|vertex| frame.holds(vertex.at)) {
        return part;
    }
    let part = cut(&part, |vertex| vertex.at.0 - frame.left);
    let part = cut(&part, |vertex| frame.right - vertex.at.0);
    let part = cut(&part, |vertex| vertex.at.1 - frame.top);
    cut(&part, |vertex| frame.bottom - vertex.at.1)
}

/// The part of a polygon where a function is not negative (Sutherland & Hodgman 1974).
fn cut(polygon: &[Vertex], height: impl Fn(&Vertex) -> f64) -> Vec<Vertex> {
    let mut kept = Vec::with_capacity(polygon.len() + 2);
    for (n, &here) in polygon.iter().enumerate() {
        let next = polygon[(n + 1) % polygon.len()];
        let (a, b) = (height(&here), height(&next));
        if a >= 0.0 {
            kept.push(here);
        }
        if (a >= 0.0) != (b >= 0.0) {
            let share = a / (a - b);
            let mix = |from: f64, to: f64| from + share * (to - from);
            let at = (mix(here.at.0, next.at.0), mix(here.at.1, next.at.1));
            kept.push(Vertex { at, value: mix(here.value, next.value) });
        }
    }
    kept
}
