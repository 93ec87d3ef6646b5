//! Consistent nodal forces of tractions, stress fields, body forces and concentrated forces.

use crate::elasticity::degenerate::degenerate;
use crate::elasticity::dofs::Dofs;
use crate::elasticity::{element, point, quadrature, shape_functions};
use crate::error::Error;
use crate::mesh::{Edge, Mesh};
use crate::scene::{Load, Scene};

/// Gauss points per edge for given stress fields: the Hertz field is integrated to 1e-7 and better on the meshes here.
const EDGE_POINTS: usize = 16;

/// What takes the force on a node, in x and y \[N\].
type Taker<'a> = &'a mut dyn FnMut(usize, [f64; 2]);

/// Load vector of a body \[N\].
pub fn nodal_forces(scene: &Scene, mesh: &Mesh, body: usize, dofs: &Dofs) -> Result<Vec<f64>, Error> {
    let mut force = vec![0.0; dofs.equations];
    for load in &scene.bodies[body].loads {
        if let Load::RigidFace { boundary, component, force: value } = load {
            // The component that the nodes of the face share; a node of it that a support holds has none.
            let nodes = mesh.boundary(scene, body, boundary)?.iter().flatten();
            let shared = nodes.filter_map(|&node| dofs.of_node(node)[component.index()].equation()).next();
            let Some(equation) = shared else { return Err(fixed_face(scene, body, boundary, *value)) };
            force[equation] += value;
        }
        hand_out(scene, mesh, body, load, &mut |node, value| dofs.add_force(node, value, &mut force))?;
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
    for load in &scene.bodies[body].loads {
        let mut take = |node: usize, value: [f64; 2]| {
            (0..2).for_each(|k| forces[node - nodes.start][k] += value[k]);
        };
        hand_out(scene, mesh, body, load, &mut take)?;
    }
    Ok(forces)
}

/// Hands the consistent forces of a load to the nodes; those of a rigid face belong to no single node.
fn hand_out(scene: &Scene, mesh: &Mesh, body: usize, load: &Load, take: Taker) -> Result<(), Error> {
    let rule = quadrature::gauss(EDGE_POINTS);
    match load {
        Load::Traction { boundary, traction } => {
            let constant = |_: [f64; 2], _: [f64; 2], length: f64| traction.map(|t| t * length);
            for edge in mesh.boundary(scene, body, boundary)? {
                integrate_edge(mesh, edge, &rule, scene.thickness, &constant, take);
            }
        }
        Load::TractionField { boundary, field } => {
            let given = |point: [f64; 2], _: [f64; 2], length: f64| (field.0)(point).map(|t| t * length);
            for edge in mesh.boundary(scene, body, boundary)? {
                integrate_edge(mesh, edge, &rule, scene.thickness, &given, take);
            }
        }
        Load::Stress { boundary, field } => {
            let stress = |point: [f64; 2], normal: [f64; 2], _: f64| {
                let [x, y, xy] = (field.0)(point);
                [x * normal[0] + xy * normal[1], xy * normal[0] + y * normal[1]]
            };
            for edge in mesh.boundary(scene, body, boundary)? {
                integrate_edge(mesh, edge, &rule, scene.thickness, &stress, take);
            }
        }
        Load::BodyForce(density) => body_force(scene, mesh, body, *density, take)?,
        Load::Force { at, force } => {
            for (node, value) in point::shapes_at(scene, mesh, body, *at)? {
                take(node, force.map(|f| f * value));
            }
        }
        Load::RigidFace { .. } => {}
    }
    Ok(())
}

/// `f_a = ∫ N_a t ds · thickness`; `traction(point, n ds/dξ, ds/dξ)` returns `t ds/dξ`, with `n ds = (dy, −dx)`.
fn integrate_edge(
    mesh: &Mesh,
    edge: &Edge,
    rule: &[(f64, f64)],
    thickness: f64,
    traction: &dyn Fn([f64; 2], [f64; 2], f64) -> [f64; 2],
    take: Taker,
) {
    for &(xi, weight) in rule {
        let shapes = shape_functions::edge(edge.len(), xi);
        let (mut point, mut slope) = ([0.0; 2], [0.0; 2]);
        for (&node, (value, derivative)) in edge.iter().zip(&shapes) {
            for k in 0..2 {
                point[k] += value * mesh.points[node][k];
                slope[k] += derivative * mesh.points[node][k];
            }
        }
        let t = traction(point, [slope[1], -slope[0]], slope[0].hypot(slope[1]));
        for (&node, (value, _)) in edge.iter().zip(&shapes) {
            take(node, t.map(|t| t * value * weight * thickness));
        }
    }
}

fn body_force(scene: &Scene, mesh: &Mesh, body: usize, density: [f64; 2], take: Taker) -> Result<(), Error> {
    let rule = quadrature::gauss_square((usize::from(mesh.order.number()) + 1).max(3));
    for cell in mesh.bodies[body].cells.clone() {
        let nodes = mesh.cell(cell);
        let points: Vec<[f64; 2]> = nodes.iter().map(|&n| mesh.points[n]).collect();
        for &(at, weight) in &rule {
            let (_, determinant) =
                element::gradients(&points, at).map_err(|jacobian| degenerate(scene, body, cell, jacobian))?;
            let volume = weight * determinant * scene.thickness;
            for (&node, (value, _)) in nodes.iter().zip(shape_functions::cell(points.len(), at)) {
                take(node, density.map(|b| b * value * volume));
            }
        }
    }
    Ok(())
}
