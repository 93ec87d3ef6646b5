//! How fine a mesh is.

use crate::mesh::Order;

/// How fine a mesh is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Resolution {
    /// Elements per half-width, or per 10 mm of arc on pins.
    pub elements: usize,
    /// Times every element of that mesh is halved both ways.
    pub refinement: u32,
    /// Element order.
    pub order: Order,
}
