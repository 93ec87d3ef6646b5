//! Consistent nodal forces of tractions, stress fields, body forces and concentrated forces.

use crate::elasticity::dofs::Dofs;
use crate::elasticity::side_loads::{LoadedSide, Taker};
use crate::elasticity::{element, point, quadrature, shape_functions};
use crate::error::Error;
use crate::mesh::Mesh;
use crate::scene::{Load, Scene};

/// Load vector of a body, from the forces applied at its nodes and those on rigid faces \[N\].
pub fn vector(scene: &Scene, mesh: &Mesh, body: usize, dofs: &Dofs, applied: &[[f64; 2]]) -> Result<Vec<f64>, Error> {
    let mut force = vec![0.0; dofs.equations];
    for (node, &value) in mesh.bodies[body].nodes.clone().zip(applied) {
        dofs.add_force(node, value, &mut force);
    }
    for load in &scene.bodies[body].loads {
        if let Load::RigidFace { boundary, component, force: value } = load {
            // The component that the nodes of the face share; a node of it that a support holds has none.
            let nodes = mesh.boundary(scene, body, boundary)?.iter().flatten();
            let shared = nodes.filter_map(|&node| dofs.of_node(node)[component.index()].equation()).next();
            let Some(equation) = shared else { return Err(fixed_face(scene, body, boundary, *value)) };
            force[equation] += value;
        }
    }
    Ok(force)
}

fn fixed_face(scene: &Scene, body: usize, boundary: &str, force: f64) -> Error {
    let expected = format!("every node of `{boundary}` is fixed in that direction");
    let remedy = "leave out the supports or the force";
    Error::value(scene.place_of_body(body), "force on a rigid face", force, expected, remedy)
}

/// Applied forces at each node of a body, in x and y, fixed components included \[N\].
///
/// The force on a rigid face is not among them: it acts on what its nodes have in common, which no support holds.
pub fn at_nodes(scene: &Scene, mesh: &Mesh, body: usize) -> Result<Vec<[f64; 2]>, Error> {
    let nodes = mesh.bodies[body].nodes.clone();
    let mut forces = vec![[0.0; 2]; nodes.len()];
    for index in 0..scene.bodies[body].loads.len() {
        let mut take = |node: usize, value: [f64; 2]| {
            (0..2).for_each(|k| forces[node - nodes.start][k] += value[k]);
        };
        hand_out(scene, mesh, body, index, &mut take)?;
    }
    Ok(forces)
}

/// Hands the consistent forces of a load, one of its body by its index, to the nodes; those of a rigid face belong to no
/// single node.
fn hand_out(scene: &Scene, mesh: &Mesh, body: usize, index: usize, take: Taker) -> Result<(), Error> {
    match &scene.bodies[body].loads[index] {
        Load::OnSide { boundary, part, action } => {
            LoadedSide::of(scene, mesh, (body, index), boundary, part.as_ref())?.hand_out(action, take);
            Ok(())
        }
        Load::BodyForce(density) => body_force(scene, mesh, body, *density, take),
        Load::Force { at, force } => {
            for (node, value) in point::shapes_at(scene, mesh, body, *at)? {
                take(node, force.map(|f| f * value));
            }
            Ok(())
        }
        Load::RigidFace { .. } => Ok(()),
    }
}

fn body_force(scene: &Scene, mesh: &Mesh, body: usize, density: [f64; 2], take: Taker) -> Result<(), Error> {
    let rule = quadrature::gauss_square((usize::from(mesh.order.number()) + 1).max(3));
    for cell in mesh.bodies[body].cells.clone() {
        let nodes = mesh.cell(cell);
        let points: Vec<[f64; 2]> = nodes.iter().map(|&n| mesh.points[n]).collect();
        for &(at, weight) in &rule {
            let (_, determinant) =
                element::gradients(&points, at).map_err(|jacobian| element::degenerate(scene, body, cell, jacobian))?;
            let shapes = shape_functions::cell(points.len(), at);
            let of = |k: usize| shapes.iter().zip(&points).map(|((value, _), point)| value * point[k]).sum();
            let volume = weight * determinant * scene.depth([of(0), of(1)]);
            for (&node, (value, _)) in nodes.iter().zip(shapes) {
                take(node, density.map(|b| b * value * volume));
            }
        }
    }
    Ok(())
}
