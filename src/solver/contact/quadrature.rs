//! Where on an edge the contact conditions are enforced.

use crate::elasticity::quadrature;

/// Where on an edge the contact conditions are enforced.
///
/// As many Gauss points as the edge has nodes are more than its normal displacements can follow: pressures are then not
/// unique and oscillate as springs stiffen. The default takes one point fewer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
pub enum Quadrature {
    /// Gauss, one point fewer than the edge has nodes: 1 on 2-node, 2 on 3-node edges; the default.
    Gauss,
    /// Gauss, as many points as nodes: 2 on 2-node, 3 on 3-node edges.
    GaussFull,
    /// Lobatto: the nodes themselves.
    Lobatto,
}

impl Quadrature {
    /// Points and weights for an edge of `nodes` nodes.
    pub fn rule(self, nodes: usize) -> Vec<(f64, f64)> {
        match self {
            Self::Gauss => quadrature::gauss(nodes - 1),
            Self::GaussFull => quadrature::gauss(nodes),
            Self::Lobatto => quadrature::lobatto(nodes),
        }
    }
}
