//! Joins the blocks of a body: lattice points that coincide become one node.

use std::collections::HashMap;

use super::block::Block;
use super::{BodyMesh, Edge, Mesh, Order};

/// Points closer than this fraction of the body's size are one node; or than a part of the shortest distance along a
/// side, where layers of cells are so small.
const SAME: f64 = 1e-9;
const APART: f64 = 0.01;
/// The same up to which rounding explains a distance.
const ROUNDING: f64 = 1e-12;

impl Mesh {
    /// Adds a body made of blocks.
    pub(super) fn append(&mut self, blocks: &[Block]) {
        let first_node = self.points.len();
        let first_cell = self.cells();
        let mut register = Register::new(blocks);
        let mut body = BodyMesh {
            nodes: 0..0,
            cells: 0..0,
            boundaries: Default::default(),
            lines: Default::default(),
            candidates: Vec::new(),
        };
        let (intervals, places) = (self.order.intervals(), self.order.places());
        // Nodes of a side of a cell between its ends; lattice points of 4-node cells that are no nodes are left out.
        let between = |side: &[(usize, usize)]| match self.order {
            Order::Linear => Vec::new(),
            _ => side[1..intervals].to_vec(),
        };
        for block in blocks {
            let lattice = block.lattice(self.order);
            let [columns, rows] = block.size();
            let mut known = vec![None; columns * rows];
            // Inside a block no point coincides with another.
            let mut node = |i: usize, j: usize| {
                let inside = i > 0 && j > 0 && i + 1 < columns && j + 1 < rows;
                *known[j * columns + i].get_or_insert_with(|| match inside {
                    true => {
                        self.points.push(lattice[j][i]);
                        self.points.len() - 1
                    }
                    false => register.node(lattice[j][i], &mut self.points),
                })
            };
            for j in (0..rows - 1).step_by(intervals) {
                for i in (0..columns - 1).step_by(intervals) {
                    self.connectivity.extend(places.iter().map(|[di, dj]| node(i + di, j + dj)));
                }
            }
            let sides = [
                (&block.bottom, (0..columns).map(|i| (i, 0)).collect::<Vec<_>>()),
                (&block.right, (0..rows).map(|j| (columns - 1, j)).collect()),
                (&block.top, (0..columns).rev().map(|i| (i, rows - 1)).collect()),
                (&block.left, (0..rows).rev().map(|j| (0, j)).collect()),
            ];
            for (side, positions) in sides {
                let named = if side.inside { &mut body.lines } else { &mut body.boundaries };
                for side_of_cell in
                    positions.windows(intervals + 1).step_by(intervals).filter(|_| !side.names.is_empty())
                {
                    let [ends, inner] = [[side_of_cell[0], side_of_cell[intervals]].to_vec(), between(side_of_cell)];
                    let edge: Edge = ends.into_iter().chain(inner).map(|(i, j)| node(i, j)).collect();
                    for name in &side.names {
                        named.entry(name.clone()).or_default().push(edge.clone());
                    }
                }
            }
        }
        body.nodes = first_node..self.points.len();
        body.cells = first_cell..self.cells();
        self.bodies.push(body);
    }
}

/// Nodes found so far, by position on a grid far finer than any element.
struct Register {
    cell: f64,
    known: HashMap<[i64; 2], usize>,
}

impl Register {
    fn new(blocks: &[Block]) -> Self {
        let size = blocks
            .iter()
            .flat_map(|b| b.bottom.points.iter().chain(&b.top.points))
            .fold(0.0_f64, |size, p| size.max(p[0].abs()).max(p[1].abs()));
        let sides = blocks.iter().flat_map(Block::sides);
        let apart = |two: &[[f64; 2]]| (two[1][0] - two[0][0]).hypot(two[1][1] - two[0][1]);
        let all = sides.flat_map(|side| side.points.windows(2).map(apart));
        let shortest = all.filter(|length| *length > ROUNDING * size).fold(f64::INFINITY, f64::min);
        Self { cell: (SAME * size).min(APART * shortest), known: HashMap::new() }
    }

    /// The node at a point, new or known; a neighbour on the grid counts, so that rounding cannot split a node.
    fn node(&mut self, point: [f64; 2], points: &mut Vec<[f64; 2]>) -> usize {
        let key = point.map(|x| (x / self.cell).round() as i64);
        for dx in -1..=1 {
            for dy in -1..=1 {
                if let Some(&node) = self.known.get(&[key[0] + dx, key[1] + dy]) {
                    return node;
                }
            }
        }
        points.push(point);
        self.known.insert(key, points.len() - 1);
        points.len() - 1
    }
}
