//! The choice of the contact element.

use crate::contact::{ContactPoint, Interface, Quadrature, layer, line, node};
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
    /// The contact points of an interface, in the order of the contact coordinate, with a quadrature and a thickness
    /// over the length of an edge, as far as the element has them.
    pub fn points(self, interface: &Interface, quadrature: Quadrature, thickness: f64) -> Vec<ContactPoint> {
        match self {
            Self::Line => line::points(interface, quadrature),
            Self::Layer => layer::points(interface, quadrature, thickness),
            Self::Node => node::points(interface),
        }
    }
}
