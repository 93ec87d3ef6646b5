//! The choice of the contact element.

use crate::contact::{ContactElement, Layer, Line, Node, Quadrature};
use crate::named::named_enum;

named_enum! {
    /// Contact element, in the paper's order.
    pub enum Element {
        /// An edge and its opposite joined by a distributed spring.
        Line = "line",
        /// A thin element of fictitious material.
        Layer = "layer",
        /// One spring per node pair.
        Node = "node",
    }
}

impl Element {
    /// The element with its quadrature and its thickness over the length of an edge, as far as it has them.
    pub fn with(self, quadrature: Quadrature, thickness: f64) -> Box<dyn ContactElement> {
        match self {
            Self::Line => Box::new(Line { quadrature }),
            Self::Layer => Box::new(Layer { quadrature, thickness }),
            Self::Node => Box::new(Node),
        }
    }
}
