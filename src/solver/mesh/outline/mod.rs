//! From outlines to structured blocks: one file per shape.
//!
//! * `frames` — rectangles around a contact whose ends are known.
//! * `known_ends` — positions along a contact whose ends are known.
//! * `layout` — what the outlines need to know of the scene.

mod blocks;
mod disc;
pub(crate) mod eye;
mod frames;
mod known_ends;
mod layout;
mod rectangle;
mod ring;

use crate::mesh::block::Block;
use crate::scene::{Face, Shape};

pub(crate) use layout::{Layout, widest};
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
                blocks.iter().map(|block| block.turned_over(centre[1])).collect()
            }
            Shape::Ring { .. } => ring::blocks(self, shape),
            Shape::Eye { .. } => eye::blocks(self, shape),
            Shape::Blocks(shapes) => blocks::blocks(self, shapes),
            Shape::Given(_) => Vec::new(),
        }
    }
}
