//! A cell divided in small parts by its shape functions.

use super::field::Shapes;
use super::frame::{Point, distance};

/// A point of a polygon with the scalar there.
#[derive(Clone, Copy)]
pub(super) struct Vertex {
    pub at: Point,
    pub value: f64,
}

/// Parts longer than this are cut in smaller ones, so that straight cuts follow the field [display pixels].
const PART: f64 = 20.0;
const FINEST: usize = 8;

/// A cell divided in equal parts of its natural coordinates, vertices row by row.
pub(super) struct Grid {
    parts: usize,
    pub vertices: Vec<Vertex>,
}

impl Grid {
    /// The grid of a cell on the canvas.
    pub fn of(cell: &[Vertex], shapes: Shapes) -> Grid {
        let side = |n: usize| distance(cell[n].at, cell[(n + 1) % 4].at);
        let longest = (0..4).map(side).fold(0.0, f64::max);
        let parts = ((longest / PART).ceil() as usize).clamp(1, FINEST);
        let natural = |n: usize| 2.0 * n as f64 / parts as f64 - 1.0;
        let places = (0..=parts).flat_map(|row| (0..=parts).map(move |column| [natural(column), natural(row)]));
        Grid { parts, vertices: places.map(|place| interpolated(cell, shapes, place)).collect() }
    }

    fn at(&self, row: usize, column: usize) -> Vertex {
        self.vertices[row * (self.parts + 1) + column]
    }

    /// The parts, each counter-clockwise.
    pub fn parts(&self) -> impl Iterator<Item = Vec<Vertex>> {
        let corners = |row, column| [(row, column), (row, column + 1), (row + 1, column + 1), (row + 1, column)];
        let places = (0..self.parts).flat_map(|row| (0..self.parts).map(move |column| (row, column)));
        places.map(move |(row, column)| corners(row, column).map(|(row, column)| self.at(row, column)).to_vec())
    }

    /// The whole rim, counter-clockwise.
    pub fn rim(&self) -> Vec<Vertex> {
        let n = self.parts;
        let along = |k: usize| [(0, k), (k, n), (n, n - k), (n - k, 0)];
        let places = (0..4).flat_map(|side| (0..n).map(move |k| along(k)[side]));
        places.map(|(row, column)| self.at(row, column)).collect()
    }
}

fn interpolated(cell: &[Vertex], shapes: Shapes, place: [f64; 2]) -> Vertex {
    let shape = shapes(cell.len(), place);
    let sum = |of: fn(&Vertex) -> f64| cell.iter().zip(&shape).map(|(node, share)| share * of(node)).sum::<f64>();
    Vertex { at: (sum(|node| node.at.0), sum(|node| node.at.1)), value: sum(|node| node.value) }
}
