//! Node contact element: one spring between a node and what lies opposite.

use crate::contact::interface::ContactNode;
use crate::contact::{ContactPoint, Interface};
use crate::elasticity::quadrature;

/// One contact point per node pair, with the consistent tributary area `A_a = ∫ N_a (n·n_a) ds · thickness`:
/// 1/6, 4/6, 1/6 of a straight 3-node edge, the Lobatto weights of one of any order.
///
/// On an arc the factor `n·n_a` makes a uniform pressure give equal pressures at corner and mid-side nodes; without it
/// they differ by 0.3 Δ², Δ being half the angle of an edge.
pub fn points(interface: &Interface) -> Vec<ContactPoint> {
    let mut shares: Vec<Vec<(usize, f64)>> = vec![Vec::new(); interface.nodes.len()];
    for (index, edge) in interface.edges.iter().enumerate() {
        for (&a, area) in edge.iter().zip(tributary_areas(interface, edge)) {
            shares[a].push((index, area));
        }
    }
    // A node without an area carries nothing.
    let nodes = interface.nodes.iter().zip(shares).filter(|(node, _)| !interface.has_no_area(node));
    let point = |(node, shares): (&ContactNode, Vec<(usize, f64)>)| ContactPoint {
        contact: interface.contact,
        row: node.row().collect(),
        position: node.coordinate,
        weight: shares.iter().map(|(_, area)| area).sum(),
        gap: node.gap,
        relative_stiffness: 1.0,
        shares,
    };
    nodes.map(point).collect()
}

/// `∫ N_k (n·n_k) ds · thickness`, of bodies of revolution `∫ N_k 2πr ds`, over one edge, for each of its nodes
/// \[mm²\].
fn tributary_areas(interface: &Interface, edge: &[usize]) -> Vec<f64> {
    let rule = quadrature::gauss(edge.len().max(3)).into_iter();
    let parts = rule.map(|(xi, weight)| (interface.areas_at(edge, xi), weight));
    parts.fold(vec![0.0; edge.len()], |sums, (areas, weight)| {
        sums.iter().zip(areas).map(|(sum, area)| sum + weight * area).collect()
    })
}
