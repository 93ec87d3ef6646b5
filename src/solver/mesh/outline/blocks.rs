//! Blocks given one by one.

use super::layout::Layout;
use crate::mesh::block::{Block, Side, between, on_side};
use crate::mesh::spacing;
use crate::scene::BlockShape;

pub(super) fn blocks(layout: &Layout, shapes: &[BlockShape]) -> Vec<Block> {
    shapes.iter().map(|shape| block(layout, shape)).collect()
}

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
