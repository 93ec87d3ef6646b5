//! Bands of a field: cells cut along the levels between them.

use super::axis::round_values;
use super::canvas::Canvas;
use super::drawing::Error;
use super::field::{Field, Panel, Shapes};
use super::frame::{Point, between, distance};
use super::palette::ColourMap;
use super::theme::Colour;

/// A point of a polygon, and the scalar there.
type Vertex = (Point, f64);

/// Parts of a cell longer than this are cut in smaller ones, so that straight cuts follow the field [display pixels].
const PART: f64 = 20.0;
const FINEST: usize = 8;

/// Levels between the bands, and their colours.
pub(super) struct Bands {
    /// Ends of the bands in ascending order, one more than bands.
    pub levels: Vec<f64>,
    pub step: f64,
    pub map: ColourMap,
}

impl Field {
    /// Bands of a round step over the range, symmetric about zero where the colours are.
    pub(super) fn bands(&self) -> Result<Bands, Error> {
        let (mut low, mut high) = self.range.or_else(|| self.ends(|node| self.values[node])).unwrap_or_default();
        if !(low.is_finite() && high.is_finite() && low <= high) {
            return Err(Error::of(&self.title, format!("values from {low} to {high}"), "leave infinite ones out"));
        }
        if self.map == ColourMap::Diverging {
            high = high.abs().max(low.abs());
            low = -high;
        }
        if high - low < 1e-9 * high.abs().max(1e-300) {
            let room = (1e-3 * high.abs()).max(1e-9);
            (low, high) = (low - room, high + room);
        }
        let (step, _) = round_values(low, high, 10);
        let (first, last) = ((low / step + 1e-9).floor(), (high / step - 1e-9).ceil());
        let levels = (0..=(last - first) as usize).map(|n| (first + n as f64) * step).collect();
        Ok(Bands { levels, step, map: self.map })
    }
}

impl Bands {
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

    /// Paints the cells band by band, the lowest first.
    pub fn paint(&self, canvas: &mut Canvas, panel: &Panel<'_>) {
        let mut areas: Vec<Vec<Vec<Point>>> = vec![Vec::new(); self.count()];
        for cell in &panel.field.cells {
            let vertex = |&node: &usize| (panel.nodes[node], panel.field.values[node]);
            let cell: Vec<Vertex> = cell.iter().map(vertex).collect();
            if panel.frame.meets(&places(&cell)) {
                self.divide(&cell, panel.field.shapes, &mut areas);
            }
        }
        for (band, areas) in areas.iter().enumerate().filter(|(_, areas)| !areas.is_empty()) {
            canvas.tiles(areas, self.colour(band));
        }
    }

    /// Takes a cell, divided in equal parts of its natural coordinates; whole where it lies in one band.
    fn divide(&self, cell: &[Vertex], shapes: Shapes, areas: &mut [Vec<Vec<Point>>]) {
        let side = |n: usize| distance(cell[n].0, cell[(n + 1) % 4].0);
        let longest = (0..4).map(side).fold(0.0, f64::max);
        let parts = ((longest / PART).ceil() as usize).clamp(1, FINEST);
        let natural = |n: usize| 2.0 * n as f64 / parts as f64 - 1.0;
        let across = |row: usize| (0..=parts).map(move |column| [natural(column), natural(row)]);
        let row = |row: usize| across(row).map(|place| interpolated(cell, shapes, place)).collect();
        let grid: Vec<Vec<Vertex>> = (0..=parts).map(row).collect();
        let first = self.of(grid[0][0].1);
        if grid.iter().flatten().all(|vertex| self.of(vertex.1) == first) {
            let along = |k: usize| [(0, k), (k, parts), (parts, parts - k), (parts - k, 0)];
            let rim = (0..4).flat_map(|side| (0..parts).map(move |k| along(k)[side]));
            return areas[first].push(rim.map(|(row, column)| grid[row][column].0).collect());
        }
        for two in grid.windows(2) {
            for k in 0..parts {
                self.cut(vec![two[0][k], two[0][k + 1], two[1][k + 1], two[1][k]], areas);
            }
        }
    }

    /// The part in its lowest band, then what of it reaches above each further level.
    fn cut(&self, mut part: Vec<Vertex>, areas: &mut [Vec<Vec<Point>>]) {
        let lowest = self.of(part.iter().map(|vertex| vertex.1).fold(f64::INFINITY, f64::min));
        for (band, areas) in areas.iter_mut().enumerate().skip(lowest) {
            if band > lowest {
                part = above(&part, self.levels[band]);
            }
            if part.len() < 3 {
                return;
            }
            areas.push(places(&part));
        }
    }
}

fn interpolated(cell: &[Vertex], shapes: Shapes, place: [f64; 2]) -> Vertex {
    let shape = shapes(cell.len(), place);
    let sum = |of: fn(&Vertex) -> f64| cell.iter().zip(&shape).map(|(node, share)| share * of(node)).sum::<f64>();
    ((sum(|node| node.0.0), sum(|node| node.0.1)), sum(|node| node.1))
}

fn places(polygon: &[Vertex]) -> Vec<Point> {
    polygon.iter().map(|vertex| vertex.0).collect()
}

/// The part of a polygon not below a level (Sutherland & Hodgman 1974).
fn above(polygon: &[Vertex], level: f64) -> Vec<Vertex> {
    let mut kept = Vec::with_capacity(polygon.len() + 2);
    for (n, &here) in polygon.iter().enumerate() {
        let next = polygon[(n + 1) % polygon.len()];
        if here.1 >= level {
            kept.push(here);
        }
        if (here.1 >= level) != (next.1 >= level) {
            let share = (level - here.1) / (next.1 - here.1);
            kept.push((between(here.0, next.0, share), level));
        }
    }
    kept
}
