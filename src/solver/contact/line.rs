//! Line contact element: an element edge and its opposite joined by a distributed spring.

use crate::contact::{ContactPoint, Interface, Quadrature};

/// Contact points are the quadrature points of the edge; `b` holds the edge's shape functions,
/// `A = |ds/dξ| w · thickness`, of bodies of revolution 2πr for the thickness.
pub fn points(interface: &Interface, quadrature: Quadrature) -> Vec<ContactPoint> {
    interface.points(quadrature, |edge, at, _| {
        let terms = interface.terms(edge, at).into_iter();
        (terms.map(|(dof, value, _)| (dof, value)).collect(), 1.0)
    })
}
