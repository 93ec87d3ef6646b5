//! How bodies touch: each contact element turns the candidate edges into a list of contact points.
//!
//! * [`interface`] — nodes and edges of the candidate stretch.
//! * `dual` — what a node faces where nodes do not face one another.
//! * [`facing`] — projection on to the edges of the other body.
//! * [`node`] — one spring per node pair (paper, Fig. 5).
//! * [`mod@line`] — distributed springs between two element edges (Fig. 3).
//! * [`layer`] — a thin element of fictitious material (Fig. 4).

mod dual;
pub mod facing;
pub mod interface;
pub mod layer;
pub mod line;
pub mod node;

use crate::elasticity::quadrature;

pub use interface::Interface;
pub use layer::Layer;
pub use line::Line;
pub use node::Node;

/// A point at which contact conditions are enforced.
#[derive(Clone, Debug)]
pub struct ContactPoint {
    /// Index of the contact in the scene.
    pub contact: usize,
    /// Sparse row `b` on the retained freedoms: the approach is `w = b·u`.
    pub row: Vec<(usize, f64)>,
    /// Contact coordinate `s` \[mm, or rad on an arc\].
    pub position: f64,
    /// Tributary area `A` of the modelled part \[mm²\].
    pub weight: f64,
    /// Initial normal gap `g` \[mm\]; negative is interference.
    pub gap: f64,
    /// Initial stiffness over the nominal one, `k_i / k_n`.
    pub relative_stiffness: f64,
    /// Parts of the area that belong to each edge of its contact: (edge index, area \[mm²\]).
    pub shares: Vec<(usize, f64)>,
}

impl ContactPoint {
    /// Approach `w = b·u` \[mm\], positive closing.
    pub fn approach(&self, u: &[f64]) -> f64 {
        self.row.iter().map(|&(freedom, value)| value * u[freedom]).sum()
    }

    /// `|b|·|u|`: the size of the displacements whose difference the approach is \[mm\].
    pub fn size_of_approach(&self, u: &[f64]) -> f64 {
        self.row.iter().map(|&(freedom, value)| (value * u[freedom]).abs()).sum()
    }

    /// Adds `factor · b` to a vector on the retained freedoms.
    pub fn add_row(&self, factor: f64, out: &mut [f64]) {
        self.row.iter().for_each(|&(freedom, value)| out[freedom] += factor * value);
    }
}

/// An edge of the first body in the candidate stretch of a contact.
#[derive(Clone, Copy, Debug)]
pub struct ContactEdge {
    /// Index of the contact in the scene.
    pub contact: usize,
    /// Contact coordinates where it begins and ends \[mm, or rad on an arc\].
    pub ends: [f64; 2],
}

/// A contact element: from facing edges to contact points.
pub trait ContactElement {
    /// The contact points of an interface, in the order of the contact coordinate.
    fn points(&self, interface: &Interface) -> Vec<ContactPoint>;
}

/// Where on an edge the contact conditions are enforced.
///
/// As many Gauss points as the edge has nodes are more than its normal displacements can follow: pressures are then not
/// unique and oscillate as springs stiffen. The default takes one point fewer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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
        match (self, nodes) {
            (Self::Gauss, _) => quadrature::gauss(nodes - 1),
            (Self::GaussFull, _) => quadrature::gauss(nodes),
            (Self::Lobatto, 2) => quadrature::lobatto_two(),
            (Self::Lobatto, _) => quadrature::lobatto_three(),
        }
    }
}
