//! From outlines to structured blocks: one file per shape, but for blocks that are given one by one.
//!
//! * `frames` — rectangles around a contact whose ends are known.
//! * `known_ends` — positions along a contact whose ends are known.
//! * `layout` — what the outlines need to know of the scene.
//! * `points` — where a body is held or pressed at points.

mod disc;
pub(crate) mod eye;
mod frames;
mod known_ends;
mod layout;
mod points;
mod rectangle;
mod ring;

use crate::mesh::block::{Block, Side, between, on_side};
use crate::mesh::spacing;
use crate::scene::{BlockShape, Face, Shape};

pub(crate) use layout::{Layout, widest};
pub(super) use points::pressed;
pub(crate) use ring::cells_at_bore;

impl Layout<'_> {
    /// Blocks of a shape.
    pub fn blocks(&self, shape: &Shape) -> Vec<Block> {
        match shape {
            Shape::Rectangle { x, y, contact } => rectangle::blocks(self, *x, *y, *contact),
            Shape::Disc { centre, radius, sector, contact: Face::Bottom } => {
                disc::blocks(self, *centre, *radius, *sector)
            }
            Shape::Disc { centre, radius, sector, contact: Face::Top } => {
                let blocks = disc::blocks(self, *centre, *radius, *sector);
                blocks.into_iter().map(|block| block.turned_over(centre[1])).collect()
            }
            Shape::Ring { .. } => ring::blocks(self, shape),
            Shape::Eye { .. } => eye::blocks(self, shape),
            Shape::Blocks(shapes) => shapes.iter().map(|shape| block(self, shape)).collect(),
            Shape::Given(_) => Vec::new(),
        }
    }
}

/// A block that is given.
fn block(layout: &Layout, shape: &BlockShape) -> Block {
    let [columns, rows] = [0, 1].map(|k| {
        let n = shape.elements[k];
        spacing::stretched(0.0, 1.0, n, shape.growth[k].powi(n as i32 - 1))
    });
    // Corner at which a side begins and ends: bottom and top run to the right, left and right upwards.
    let side = |k: usize, [from, to]: [usize; 2], positions: &[f64]| {
        let ends = [shape.corners[from], shape.corners[to]];
        let at = |t: f64| match shape.arcs[k] {
            None => between(ends[0], ends[1], t),
            Some(centre) => on_side(ends, None, Some(centre), t),
        };
        let points = layout.along(positions, at);
        match &shape.names[k] {
            Some(name) => Side::named(name.clone(), points),
            None => Side::inner(points),
        }
    };
    Block {
        bottom: side(0, [0, 1], &columns),
        right: side(1, [1, 2], &rows),
        top: side(2, [3, 2], &columns),
        left: side(3, [0, 3], &rows),
    }
}
