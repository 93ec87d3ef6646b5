//! The approach of a contact node as displacements of nodes along x and y.

use crate::contact::interface::ContactNode;
use crate::solve::Discretisation;

/// Factor of a displacement below which it takes no part.
const NONE: f64 = 1e-12;

/// The approach of a contact node as terms of displacements: node from 1 on, axis, factor.
pub(super) fn approach(discretisation: &Discretisation, contact: &ContactNode) -> Vec<(usize, usize, f64)> {
    let mut terms: Vec<(usize, usize, f64)> = Vec::new();
    for (dof, value) in contact.row() {
        let (node, normal) = retained(discretisation, dof);
        for axis in [0, 1].into_iter().filter(|&axis| (value * normal[axis]).abs() > NONE) {
            match terms.iter_mut().find(|(known, other, _)| (*known, *other) == (node + 1, axis)) {
                Some((_, _, sum)) => *sum += value * normal[axis],
                None => terms.push((node + 1, axis, value * normal[axis])),
            }
        }
    }
    terms
}

/// Node and outward normal of a retained dof.
pub(super) fn retained(discretisation: &Discretisation, dof: usize) -> (usize, [f64; 2]) {
    let offsets = &discretisation.condensed.offsets;
    let body = offsets.iter().rposition(|&first| first <= dof).unwrap_or(0);
    let candidate = &discretisation.mesh.bodies[body].candidates[dof - offsets[body]];
    (candidate.node, candidate.normal)
}
