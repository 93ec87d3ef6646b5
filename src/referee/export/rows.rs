//! What a deck and the plain numbers of a problem share: approaches of contact nodes as displacements of nodes along x
//! and y, nodal forces, and nodes on an axis of revolution.

use crate::contact::interface::ContactNode;
use crate::elasticity::{axis, loads};
use crate::error::Error;
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

/// Nodal forces of all bodies: node from 0 on, axis, force.
pub(super) fn forces(discretisation: &Discretisation) -> Result<Vec<(usize, usize, f64)>, Error> {
    let Discretisation { scene, mesh, .. } = discretisation;
    let mut all = Vec::new();
    for (body, part) in mesh.bodies.iter().enumerate() {
        let forces = loads::at_nodes(scene, mesh, body)?.into_iter().zip(part.nodes.clone());
        all.extend(forces.flat_map(|(force, node)| [0, 1].map(|axis| (node, axis, force[axis]))));
    }
    all.retain(|(.., value)| value.abs() > 0.0);
    Ok(all)
}

/// Nodes of a body on the axis of revolution that no support holds along its radius.
pub(super) fn on_axis(
    discretisation: &Discretisation,
    body: usize,
    is_held: impl Fn(&(usize, usize)) -> bool,
) -> Vec<usize> {
    let Discretisation { scene, mesh, .. } = discretisation;
    let on_axis = axis::holds(scene, mesh, body);
    mesh.bodies[body].nodes.clone().filter(|&node| on_axis(node) && !is_held(&(node, 0))).collect()
}
