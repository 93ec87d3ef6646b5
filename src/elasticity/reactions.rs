//! What the supports exert on a body, from the equilibrium of its nodes.

use std::collections::BTreeMap;

use crate::elasticity::degenerate::degenerate;
use crate::elasticity::element::CellStiffness;
use crate::error::Error;
use crate::mesh::Mesh;
use crate::scene::Scene;

/// Internal force `Σ k_e u_e` of a body at each of its nodes, in x and y \[N\]: what must act on a node to hold the cells
/// around it as deformed as they are.
///
/// `displacement` is that of every node of the mesh \[mm\].
pub fn internal_forces(
    scene: &Scene,
    mesh: &Mesh,
    body: usize,
    displacement: &[[f64; 2]],
) -> Result<Vec<[f64; 2]>, Error> {
    let part = &mesh.bodies[body];
    let material = &scene.bodies[body].material;
    let kernel = CellStiffness::of(mesh.order, material, scene.plane, scene.thickness);
    let mut k = vec![0.0; kernel.entries()];
    let mut forces = vec![[0.0; 2]; part.nodes.len()];
    for cell in part.cells.clone() {
        let nodes = mesh.cell(cell);
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

/// What each support of a body takes of the forces `missing` at the body's nodes: their sum over its nodes in the
/// component that it holds \[N\].
///
/// A component of a node belongs to the last support that prescribes it, as in the numbering.
pub fn of_supports(scene: &Scene, mesh: &Mesh, body: usize, missing: &[[f64; 2]]) -> Result<Vec<f64>, Error> {
    let supports = &scene.bodies[body].supports;
    let mut holder = BTreeMap::new();
    for (index, support) in supports.iter().enumerate() {
        for node in mesh.nodes_at(scene, body, &support.at)? {
            holder.insert((node, support.component.index()), index);
        }
    }
    let mut reactions = vec![0.0; supports.len()];
    for ((node, component), index) in holder {
        reactions[index] += missing[node - mesh.bodies[body].nodes.start][component];
    }
    Ok(reactions)
}
