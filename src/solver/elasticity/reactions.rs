//! What the supports exert on a body, from the equilibrium of its nodes.

use std::collections::BTreeMap;

use crate::elasticity::axis;
use crate::elasticity::element::{CellStiffness, degenerate};
use crate::error::Error;
use crate::mesh::Mesh;
use crate::scene::Scene;

/// Internal force `Σ k_e u_e` of a body at each of its nodes, in x and y \[N\]: what must act on a node to hold the cells
/// around it as deformed as they are. It is complete at the nodes of the mesh that are wanted.
///
/// `displacement` is that of every node of the mesh \[mm\].
pub fn internal_forces(
    scene: &Scene,
    mesh: &Mesh,
    body: usize,
    displacement: &[[f64; 2]],
    is_wanted: &dyn Fn(usize) -> bool,
) -> Result<Vec<[f64; 2]>, Error> {
    let part = &mesh.bodies[body];
    let material = &scene.bodies[body].material;
    let kernel = CellStiffness::of(mesh.order, material, scene.plane, scene.thickness);
    let mut k = vec![0.0; kernel.entries()];
    let mut forces = vec![[0.0; 2]; part.nodes.len()];
    for cell in part.cells.clone() {
        let nodes = mesh.cell(cell);
        if !nodes.iter().any(|&node| is_wanted(node)) {
            continue;
        }
        kernel
            .integrate(nodes.iter().map(|&node| mesh.points[node]), &mut k)
            .map_err(|jacobian| degenerate(scene, body, cell, jacobian))?;
        let of_cell: Vec<f64> = nodes.iter().flat_map(|&node| displacement[node]).collect();
        for (row, entries) in k.chunks_exact(of_cell.len()).enumerate() {
            let force: f64 = entries.iter().zip(&of_cell).map(|(k, u)| k * u).sum();
            forces[nodes[row / 2] - part.nodes.start][row % 2] += force;
        }
    }
    Ok(forces)
}

/// Which support of a body holds a component of a node: the last one that prescribes it, as in the numbering. The axis of a
/// body of revolution holds its nodes along the radius by itself.
pub fn holders(scene: &Scene, mesh: &Mesh, body: usize) -> Result<BTreeMap<(usize, usize), usize>, Error> {
    let mut holders = BTreeMap::new();
    let on_axis = axis::holds(scene, mesh, body);
    for (index, support) in scene.bodies[body].supports.iter().enumerate() {
        for node in mesh.nodes_at(scene, body, &support.at)? {
            if support.component != axis::radial(scene) || !on_axis(node) {
                holders.insert((node, support.component.index()), index);
            }
        }
    }
    Ok(holders)
}
