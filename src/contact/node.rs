//! Node contact element: one spring between two facing nodes.

use crate::contact::{ContactElement, ContactPoint, Interface};
use crate::elasticity::quadrature;

/// One contact point per node pair, with the consistent tributary area `A_a = ∫ N_a (n·n_a) ds · thickness`:
/// 1/6, 4/6, 1/6 of a straight 3-node edge.
///
/// On an arc the factor `n·n_a` makes a uniform pressure give equal pressures at corner and mid-side nodes; without it
/// they differ by 0.3 Δ², Δ being half the angle of an edge.
#[derive(Clone, Copy, Debug)]
pub struct Node;

impl ContactElement for Node {
    fn points(&self, interface: &Interface) -> Vec<ContactPoint> {
        let mut areas = vec![0.0; interface.stations.len()];
        for edge in &interface.edges {
            for (xi, weight) in quadrature::gauss(3) {
                let (shapes, position, length) = interface.at(edge, xi);
                for (&a, value) in edge.iter().zip(shapes) {
                    let alignment = interface.pair.path.alignment(position, interface.stations[a].coordinate);
                    areas[a] += value * alignment * weight * length * interface.thickness;
                }
            }
        }
        let stations = interface.stations.iter().zip(areas);
        stations
            .map(|(station, weight)| ContactPoint {
                row: station.freedoms.iter().map(|&f| (f, 1.0)).collect(),
                position: station.coordinate,
                weight,
                gap: station.gap,
                relative_stiffness: 1.0,
            })
            .collect()
    }
}
