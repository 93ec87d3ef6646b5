//! A cell divided in small parts by its shape functions.

use super::canvas::Point;
use super::field::Drawn;
use super::frame::distance;

/// A point of a polygon with the scalar there.
#[derive(Clone, Copy)]
pub(super) struct Vertex {
    pub at: Point,
    pub value: f64,
}

/// Parts longer than this are cut in smaller ones, so that straight cuts follow the field [display pixels].
const PART: f64 = 16.0;
const FINEST: usize = 8;
/// A cell divided in equal parts of its natural coordinates, vertices row by row.
pub(super) struct Grid {
    pub parts: usize,
    pub vertices: Vec<Vertex>,
}

impl Grid {
    /// The grid of a cell whose nodes stand at these places on the canvas.
    pub fn of(drawn: &Drawn<'_>, cell: &[usize], corners: &[Point]) -> Grid {
        let parts = divisions(corners);
        let natural = |n: usize| 2.0 * n as f64 / parts as f64 - 1.0;
        let places = (0..=parts).flat_map(|row| (0..=parts).map(move |column| (natural(column), natural(row))));
        let vertices = places.map(|place| vertex(drawn, cell, corners, place)).collect();
        Grid { parts, vertices }
    }

    fn at(&self, row: usize, column: usize) -> Vertex {
        self.vertices[row * (self.parts + 1) + column]
    }

    /// One part, counter-clockwise.
    pub fn part(&self, row: usize, column: usize) -> Vec<Vertex> {
        vec![self.at(row, column), self.at(row, column + 1), self.at(row + 1, column + 1), self.at(row + 1, column)]
    }

    /// The whole rim, counter-clockwise.
    pub fn rim(&self) -> Vec<Vertex> {
        let n = self.parts;
        let along = |side: usize, k: usize| match side {
            0 => self.at(0, k),
            1 => self.at(k, n),
            2 => self.at(n, n - k),
            _ => self.at(n - k, 0),
        };
        (0..4).flat_map(|side| (0..n).map(move |k| along(side, k))).collect()
    }
}

fn divisions(corners: &[Point]) -> usize {
    let side = |n: usize| distance(corners[n], corners[(n + 1) % 4]);
    let longest = (0..4).map(side).fold(0.0, f64::max);
    ((longest / PART).ceil() as usize).clamp(1, FINEST)
}

fn vertex(drawn: &Drawn<'_>, cell: &[usize], corners: &[Point], place: (f64, f64)) -> Vertex {
    let shape = shape_functions(cell.len(), place);
    let sum = |of: &dyn Fn(usize) -> f64| (0..cell.len()).map(|n| shape[n] * of(n)).sum::<f64>();
    Vertex { at: (sum(&|n| corners[n].0), sum(&|n| corners[n].1)), value: sum(&|n| drawn.field.values[cell[n]]) }
}

/// Shape functions of the bilinear or the serendipity quadrilateral.
fn shape_functions(nodes: usize, (xi, eta): (f64, f64)) -> [f64; 8] {
    let signs = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    let mut shape = [0.0; 8];
    for (n, (a, b)) in signs.into_iter().enumerate() {
        shape[n] = 0.25 * (1.0 + a * xi) * (1.0 + b * eta);
        if nodes == 8 {
            shape[n] *= a * xi + b * eta - 1.0;
        }
    }
    if nodes == 8 {
        shape[4] = 0.5 * (1.0 - xi * xi) * (1.0 - eta);
        shape[5] = 0.5 * (1.0 + xi) * (1.0 - eta * eta);
        shape[6] = 0.5 * (1.0 - xi * xi) * (1.0 + eta);
        shape[7] = 0.5 * (1.0 - xi) * (1.0 - eta * eta);
    }
    shape
}
