//! How bodies touch: each contact element turns the candidate edges into a list of contact points.
//!
//! * [`interface`] — nodes and edges of the candidate stretch.
//! * `dual` — what a node faces where nodes do not face one another.
//! * [`facing`] — projection on to the edges of the other body.
//! * [`node`] — one spring per node pair (paper, Fig. 5).
//! * [`mod@line`] — distributed springs between two element edges (Fig. 3).
//! * [`layer`] — a thin element of fictitious material (Fig. 4).
//! * [`mod@quadrature`] — where on an edge they are enforced.

mod dual;
pub mod facing;
pub mod interface;
pub mod layer;
pub mod line;
pub mod node;
pub mod quadrature;

use crate::named::named_enum;

pub use interface::Interface;
pub use layer::Layer;
pub use line::Line;
pub use node::Node;
pub use quadrature::Quadrature;

named_enum! {
    /// Contact element, in the paper's order.
    pub enum Element {
        /// Two facing edges joined by a distributed spring.
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
