//! Our discretisation as plain numbers, for another code.

use crate::error::Error;
use crate::mesh::candidates;
use crate::oracle::cross_code::DiscreteProblem;
use crate::scene::{Load, Path, Profile, Scene};
use crate::solve::Discretisation;

/// Stiffness of the springs.
pub const KAPPA: [f64; 2] = [1e2, 1e4];

/// Our discretisation as plain numbers, and displacements, node by node, to multiply the stiffness with.
pub fn problem(discretisation: &Discretisation, vectors: Vec<Vec<f64>>) -> Result<DiscreteProblem, Error> {
    let (scene, mesh) = (&discretisation.scene, &discretisation.mesh);
    let contact = scene.contact();
    let side = |body: usize| candidates::candidate_edges(mesh, scene, contact, body);
    let (profile, radius, clearance) = profile(scene)?;
    let mut problem = DiscreteProblem {
        name: format!("{}, {}-node", scene.name, mesh.order.nodes_per_cell()),
        plane: scene.plane.name(),
        thickness: scene.thickness,
        points: mesh.points.clone(),
        cells: (0..mesh.cells()).map(|cell| mesh.cell(cell).to_vec()).collect(),
        body: mesh.bodies.iter().enumerate().flat_map(|(b, part)| part.cells.clone().map(move |_| b)).collect(),
        young: scene.bodies.iter().map(|body| body.material.young).collect(),
        poisson: scene.bodies.iter().map(|body| body.material.poisson).collect(),
        contact_first: side(contact.first)?,
        contact_second: contact.second.map_or(Ok(Vec::new()), side)?,
        profile,
        radius,
        clearance,
        arc: matches!(contact.path, Path::Arc(_)),
        length: scene.reference.length,
        kappa: KAPPA.into(),
        vectors,
        ..Default::default()
    };
    for index in 0..scene.bodies.len() {
        supports_and_loads(discretisation, index, &mut problem)?;
    }
    Ok(problem)
}

/// Name, radius and clearance of the gap.
fn profile(scene: &Scene) -> Result<(&'static str, f64, f64), Error> {
    match scene.contact().profile {
        _ if scene.contact().clearance > 0.0 => Err(not_handed_over(&scene.name, "a clearance beside a profile")),
        Profile::Circle { radius } => Ok(("circle", radius, 0.0)),
        Profile::Parabola { radius } => Ok(("parabola", radius, 0.0)),
        Profile::Hole { radius, clearance } => Ok(("hole", radius, clearance)),
        Profile::Uniform(_) | Profile::Punch { .. } => Err(not_handed_over(&scene.name, "a uniform gap")),
        Profile::Drawn
        | Profile::Bodies(_)
        | Profile::Table(_)
        | Profile::Smooth(_)
        | Profile::Even { .. }
        | Profile::Powers { .. }
        | Profile::Wedge { .. }
        | Profile::Circles { .. }
        | Profile::Pin { .. }
        | Profile::Cosine { .. } => Err(not_handed_over(&scene.name, "this rigid profile")),
    }
}

/// Adds the fixed components and the loads of a body.
fn supports_and_loads(
    discretisation: &Discretisation,
    index: usize,
    problem: &mut DiscreteProblem,
) -> Result<(), Error> {
    let (scene, mesh) = (&discretisation.scene, &discretisation.mesh);
    for support in &scene.bodies[index].supports {
        let nodes = mesh.nodes_at(scene, index, &support.at)?;
        problem.held.extend(nodes.into_iter().map(|node| [node, support.component.index()]));
    }
    for load in &scene.bodies[index].loads {
        match load {
            Load::Traction { boundary, traction } => {
                problem.load_edges.extend_from_slice(mesh.boundary(scene, index, boundary)?);
                problem.traction = *traction;
            }
            Load::Stress { boundary, .. } => {
                problem.load_edges.extend_from_slice(mesh.boundary(scene, index, boundary)?);
                problem.hertz_load = true;
            }
            Load::RigidFace { boundary, force, .. } => {
                problem.tied = mesh.boundary(scene, index, boundary)?.iter().flatten().copied().collect();
                problem.tied.sort_unstable();
                problem.tied.dedup();
                problem.tied_force = *force;
            }
            Load::OnSide { .. } | Load::BodyForce(_) | Load::Force { .. } | Load::TractionField { .. } => {
                return Err(not_handed_over(&scene.name, "such a load"));
            }
        }
    }
    Ok(())
}

/// The refusal of what another code is not taught to take.
pub fn not_handed_over(scene: &str, what: &str) -> Error {
    let remedy = "choose another scene, or teach oracles/python/discrete.py to take it";
    Error::at(scene, format!("{what} is not handed over to other codes"), remedy)
}
