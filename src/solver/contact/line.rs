//! Line contact element: an element edge and its opposite joined by a distributed spring.

use crate::contact::{ContactElement, ContactPoint, Interface, Quadrature};

/// Contact points are the quadrature points of the edge; `b` holds the edge's shape functions, `A = |ds/dξ| w · thickness`, of bodies of
/// revolution 2πr for the thickness.
#[derive(Clone, Copy, Debug)]
pub struct Line {
    /// Quadrature on the edge.
    pub quadrature: Quadrature,
}

impl ContactElement for Line {
    fn points(&self, interface: &Interface) -> Vec<ContactPoint> {
        let mut points = Vec::new();
        for (index, edge) in interface.edges.iter().enumerate() {
            for (xi, weight) in interface.ruled(edge, self.quadrature) {
                let (shapes, position, length) = interface.at(edge, xi);
                let area = interface.area(weight, length);
                points.push(ContactPoint {
                    contact: interface.contact,
                    row: interface.terms(edge, &shapes, position).iter().map(|t| (t.dof, t.value)).collect(),
                    position,
                    weight: area,
                    gap: interface.gap(edge, &shapes, position),
                    relative_stiffness: 1.0,
                    shares: vec![(index, area)],
                });
            }
        }
        points.sort_by(|a, b| a.position.total_cmp(&b.position));
        points
    }
}
