//! Bands of a field: cells cut along the levels between them.

use super::canvas::Canvas;
use super::cell_grid::{Grid, Vertex};
use super::colour_map::ColourMap;
use super::error::Error;
use super::field::{Field, Shapes};
use super::frame::{Point, between};
use super::numbers::round_values;
use super::panel::Panel;
use super::theme::Colour;

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
            let vertex = |&node: &usize| Vertex { at: panel.nodes[node], value: panel.field.values[node] };
            let cell: Vec<Vertex> = cell.iter().map(vertex).collect();
            if panel.frame.meets(&places(&cell)) {
                self.divide(&cell, panel.field.shapes, &mut areas);
            }
        }
        for (band, areas) in areas.iter().enumerate().filter(|(_, areas)| !areas.is_empty()) {
            canvas.tiles(areas, self.colour(band));
        }
    }

    fn divide(&self, cell: &[Vertex], shapes: Shapes, areas: &mut [Vec<Vec<Point>>]) {
        let grid = Grid::of(cell, shapes);
        let first = self.of(grid.vertices[0].value);
        if grid.vertices.iter().all(|vertex| self.of(vertex.value) == first) {
            return areas[first].push(places(&grid.rim()));
        }
        grid.parts().for_each(|part| self.cut(part, areas));
    }

    /// The part in its lowest band, then what of it reaches above each further level.
    fn cut(&self, mut part: Vec<Vertex>, areas: &mut [Vec<Vec<Point>>]) {
        let lowest = self.of(part.iter().map(|vertex| vertex.value).fold(f64::INFINITY, f64::min));
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

fn places(polygon: &[Vertex]) -> Vec<Point> {
    polygon.iter().map(|vertex| vertex.at).collect()
}

/// The part of a polygon not below a level (Sutherland & Hodgman 1974).
fn above(polygon: &[Vertex], level: f64) -> Vec<Vertex> {
    let mut kept = Vec::with_capacity(polygon.len() + 2);
    for (n, &here) in polygon.iter().enumerate() {
        let next = polygon[(n + 1) % polygon.len()];
        if here.value >= level {
            kept.push(here);
        }
        if (here.value >= level) != (next.value >= level) {
            let share = (level - here.value) / (next.value - here.value);
            kept.push(Vertex { at: between(here.at, next.at, share), value: level });
        }
    }
    kept
}
