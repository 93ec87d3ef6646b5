//! What the supports exert on a body, from the equilibrium of its nodes.

use std::collections::BTreeMap;

use crate::elasticity::axis;
use crate::elasticity::element::{CellStiffness, degenerate};
use crate::error::Error;
use crate::mesh::Mesh;
use crate::scene::{Place, Scene};

/// Internal force `Σ k_e u_e` of a body at each of its nodes, in x and y \[N\]: what must act on a node to hold the
/// cells around it as deformed as they are. It is complete at the nodes of the mesh that are wanted.
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

/// Which support of a body holds a component of a node: of several that do, the one whose side faces most along the
/// component there, since a side on a line of symmetry has no shear, and any side before a point; of those that face
/// alike the last one, as in the numbering. The axis of a body of revolution holds its nodes along the radius by
/// itself.
pub fn holders(scene: &Scene, mesh: &Mesh, body: usize) -> Result<BTreeMap<(usize, usize), usize>, Error> {
    let mut holders: BTreeMap<(usize, usize), (usize, f64)> = BTreeMap::new();
    let on_axis = axis::holds(scene, mesh, body);
    for (index, support) in scene.bodies[body].supports.iter().enumerate() {
        let component = support.component.index();
        let edges = match &support.at {
            Place::Boundary(name) => mesh.boundary(scene, body, name)?,
            Place::Point(_) => &[],
        };
        for node in mesh.nodes_at(scene, body, &support.at)? {
            if support.component == axis::radial(scene) && on_axis(node) {
                continue;
            }
            let own = edges.iter().filter(|edge| edge.contains(&node));
            // A point faces nothing, and takes what no side does.
            let faces = own.map(|edge| facing(mesh, edge, component)).fold(-1.0, f64::max);
            let is_less = |(_, other): &(usize, f64)| *other <= faces + ALIKE;
            if holders.get(&(node, component)).is_none_or(is_less) {
                holders.insert((node, component), (index, faces));
            }
        }
    }
    Ok(holders.into_iter().map(|(held, (support, _))| (held, support)).collect())
}

/// Difference of two directions' components that rounding explains.
const ALIKE: f64 = 1e-6;

/// Component of an edge's normal, without its sign.
fn facing(mesh: &Mesh, edge: &[usize], component: usize) -> f64 {
    let [from, to] = [edge[0], edge[1]].map(|node| mesh.points[node]);
    let along = [0, 1].map(|k| to[k] - from[k]);
    (along[1 - component] / along[0].hypot(along[1])).abs()
}
