//! Refuses a body that could move as a rigid one although its supports and contact nodes are fixed.

use nalgebra::{Matrix3, SymmetricEigen, Vector3};

use crate::elasticity::dofs::Dofs;
use crate::error::Error;
use crate::mesh::Mesh;
use crate::scene::contact_pair::CONTACT;
use crate::scene::{Load, Scene};

/// Below this fraction of the largest eigenvalue a rigid motion counts as free.
pub(super) const FREE: f64 = 1e-10;
/// Rigid motions of a body.
pub const MOTIONS: [&str; 3] = ["slide along x", "slide along y", "rotate"];
/// What stops each of them.
pub const STOPPED_BY: [&str; 3] = [
    "a support along x",
    "a support along y",
    "a support that stops the rotation, as a whole side or a second node does",
];

/// The interior stiffness is positive definite ⇔ no rigid motion `(a, b, ω)` leaves every fixed component at rest.
///
/// Fixed are prescribed components, the normals of contact candidates, and the rotation of rigid faces. A body of revolution
/// can slide along its axis only.
pub fn refuse_free(scene: &Scene, mesh: &Mesh, body: usize, dofs: &Dofs) -> Result<(), Error> {
    let nodes = mesh.bodies[body].nodes.clone();
    let count = nodes.len() as f64;
    let centre: [f64; 2] = std::array::from_fn(|k| nodes.clone().map(|n| mesh.points[n][k]).sum::<f64>() / count);
    let arm = |n: usize| [mesh.points[n][0] - centre[0], mesh.points[n][1] - centre[1]];
    let size = nodes.clone().map(|n| arm(n)[0].hypot(arm(n)[1])).fold(0.0, f64::max);
    let held = |n: usize, axis: [f64; 2]| {
        let [x, y] = arm(n).map(|r| r / size);
        Vector3::new(axis[0], axis[1], axis[1] * x - axis[0] * y)
    };
    let mut gram = Matrix3::zeros();
    let mut hold = |row: Vector3<f64>| gram += row * row.transpose();
    for node in nodes {
        for (dof, axis) in dofs.of_node(node).into_iter().zip(dofs.frame(node)) {
            if dof.equation().is_none_or(|equation| dofs.retained.contains(&equation)) {
                hold(held(node, axis));
            }
        }
    }
    for load in &scene.bodies[body].loads {
        if let Load::RigidFace { boundary, component, .. } = load {
            let mut axis = [0.0; 2];
            axis[component.index()] = 1.0;
            let edge = &mesh.boundary(scene, body, boundary)?[0];
            hold(held(edge[0], axis) - held(edge[1], axis));
        }
    }
    if let Some(radial) = scene.plane.radial() {
        [Vector3::ith(radial, 1.0), Vector3::z()].into_iter().for_each(&mut hold);
    }
    let eigen = SymmetricEigen::new(gram);
    let weakest = eigen.eigenvalues.imin();
    if eigen.eigenvalues[weakest] > FREE * eigen.eigenvalues.max() {
        return Ok(());
    }
    let motion = eigen.eigenvectors.column(weakest).map(f64::abs).imax();
    let message =
        format!("it is free to {}: no support holds it that way, and its contacts do not act there", MOTIONS[motion]);
    let own = scene.bodies[body].shape.boundaries().into_iter().filter(|name| name != CONTACT);
    let names: Vec<String> = own.map(|name| format!("`{name}`")).collect();
    let places = if names.is_empty() { String::new() } else { format!(" on a boundary ({}) or", names.join(", ")) };
    let remedy = format!("add {},{places} at a node `[x, y]`", STOPPED_BY[motion]);
    Err(Error::at(scene.place_of_body(body), message, remedy))
}
