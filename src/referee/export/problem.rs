//! A case as plain numbers, for scripts of other codes: mesh, materials, supports, nodal forces, and contact nodes with
//! their rows of the approach. The scripts themselves are those of `oracles/peers`.

use serde::Serialize;

use crate::contact::Interface;
use crate::error::Error;
use crate::mesh::{Edge, candidates};
use crate::referee::answer::Point;
use crate::referee::export::deck::kind;
use crate::referee::export::rows::{approach, forces, on_axis, retained};
use crate::referee::profile::tributary;
use crate::scene::{Load, Place, Scene};
use crate::solve::Discretisation;

/// Scripts that solve an exported plane case by another code, and what they share: name, text, what it is.
pub const SCRIPTS: [(&str, &str, &str); 10] = [
    ("exported.py", include_str!("../../../oracles/peers/exported.py"), "what the scripts below share"),
    ("run_getfem.py", include_str!("../../../oracles/peers/run_getfem.py"), "solves it by GetFEM"),
    ("run_ngsolve.py", include_str!("../../../oracles/peers/run_ngsolve.py"), "solves it by NGSolve"),
    ("run_sfepy.py", include_str!("../../../oracles/peers/run_sfepy.py"), "solves it by SfePy"),
    ("run_kratos.py", include_str!("../../../oracles/peers/run_kratos.py"), "solves it by Kratos"),
    ("run_akantu.py", include_str!("../../../oracles/peers/run_akantu.py"), "solves it by Akantu"),
    ("run_felupe.py", include_str!("../../../oracles/peers/run_felupe.py"), "solves it by FElupe"),
    ("run_dolfinx.py", include_str!("../../../oracles/peers/run_dolfinx.py"), "solves it by dolfinx"),
    ("run_scikit_fem.py", include_str!("../../../oracles/peers/run_scikit_fem.py"), "solves it by scikit-fem"),
    ("run_calculix.py", include_str!("../../../oracles/peers/run_calculix.py"), "solves it by CalculiX"),
];

/// The same of bodies of revolution: none of the others knows a hoop strain.
const OF_REVOLUTION: [(&str, &str, &str); 3] = [
    SCRIPTS[0],
    (SCRIPTS[2].0, SCRIPTS[2].1, "what that one takes of NGSolve; alone it solves plane scenes"),
    (
        "run_revolution.py",
        include_str!("../../../oracles/peers/run_revolution.py"),
        "solves it by scikit-fem, dolfinx, FElupe, NGSolve or CalculiX; for GetFEM, SfePy, Kratos and Akantu bodies of \
        revolution have no script",
    ),
];

/// The scripts that can solve a scene.
pub fn scripts(scene: &Scene) -> &'static [(&'static str, &'static str, &'static str)] {
    if scene.is_of_revolution() { &OF_REVOLUTION } else { &SCRIPTS }
}

/// The problem; units mm, N, MPa, rad, nodes from 0 on, components 0 and 1.
#[derive(Debug, Serialize)]
struct Problem {
    /// Name of the case.
    case: String,
    /// `strain`, `stress` or `axisymmetric`: of these the thickness is 1, forces and areas are of the whole
    /// circumference, and nodes on the axis are held along it.
    plane: &'static str,
    thickness: f64,
    /// Order of the cells.
    order: u8,
    points: Vec<[f64; 2]>,
    /// Corners counter-clockwise, then the middles of 01, 12, 23, 30.
    cells: Vec<Vec<usize>>,
    /// Body of each cell.
    body: Vec<usize>,
    young: Vec<f64>,
    poisson: Vec<f64>,
    /// Node, component, displacement.
    held: Vec<(usize, usize, f64)>,
    /// Node, component, force.
    forces: Vec<(usize, usize, f64)>,
    /// Sides that stay flat.
    tied: Vec<Tied>,
    contacts: Vec<Contact>,
}

/// A side that stays flat: its nodes move as one along a component, under a force.
#[derive(Debug, Serialize)]
struct Tied {
    nodes: Vec<usize>,
    component: usize,
    force: f64,
}

/// A contact.
#[derive(Debug, Serialize)]
struct Contact {
    name: String,
    /// Whether positions are angles.
    arc: bool,
    /// Where the path begins, and the outward normal of the first body there.
    origin: [f64; 2],
    normal: [f64; 2],
    /// Bodies; no second one is a rigid body.
    first: usize,
    second: Option<usize>,
    /// Edges of the first body that may touch: ends, then the middle; and those of the second.
    edges: Vec<Vec<usize>>,
    opposite_edges: Vec<Vec<usize>>,
    nodes: Vec<Node>,
}

/// A contact node of the first body.
#[derive(Debug, Serialize)]
struct Node {
    node: usize,
    position: f64,
    /// Outward normal of the first body.
    normal: [f64; 2],
    area: f64,
    /// Initial gap; none where there is no other side, and where the node has no area, as that of an edge of order 2 on
    /// the axis.
    gap: Option<f64>,
    /// Its approach: node, component, factor.
    row: Vec<(usize, usize, f64)>,
}

/// The text of the file.
pub fn text(name: &str, discretisation: &Discretisation) -> Result<String, Error> {
    let Discretisation { scene, mesh, .. } = discretisation;
    kind(discretisation)?;
    let mut problem = Problem {
        case: name.into(),
        plane: scene.plane.name(),
        thickness: scene.thickness,
        order: mesh.order.number(),
        points: mesh.points.clone(),
        cells: (0..mesh.cells()).map(|cell| mesh.cell(cell).to_vec()).collect(),
        body: mesh.bodies.iter().enumerate().flat_map(|(b, part)| part.cells.clone().map(move |_| b)).collect(),
        young: scene.bodies.iter().map(|body| body.material.young).collect(),
        poisson: scene.bodies.iter().map(|body| body.material.poisson).collect(),
        held: vec![],
        forces: forces(discretisation)?,
        tied: vec![],
        contacts: discretisation
            .interfaces
            .iter()
            .map(|interface| contact(discretisation, interface))
            .collect::<Result<_, _>>()?,
    };
    (0..scene.bodies.len()).try_for_each(|body| held(discretisation, body, &mut problem))?;
    Ok(serde_json::to_string(&problem).expect("numbers, strings and lists can be written as JSON") + "\n")
}

/// Supports of a body, and its sides that stay flat.
fn held(discretisation: &Discretisation, body: usize, problem: &mut Problem) -> Result<(), Error> {
    let Discretisation { scene, mesh, .. } = discretisation;
    for support in &scene.bodies[body].supports {
        let nodes = mesh.nodes_at(scene, body, &support.at)?;
        problem.held.extend(nodes.into_iter().map(|node| (node, support.component.index(), support.value)));
    }
    let is_held = |at: &(usize, usize)| problem.held.iter().any(|(node, axis, _)| (*node, *axis) == *at);
    let axis = on_axis(discretisation, body, is_held);
    problem.held.extend(axis.into_iter().map(|node| (node, 0, 0.0)));
    for load in &scene.bodies[body].loads {
        let Load::RigidFace { boundary, component, force } = load else { continue };
        let nodes = mesh.nodes_at(scene, body, &Place::Boundary(boundary.clone()))?;
        problem.tied.push(Tied { nodes, component: component.index(), force: *force });
    }
    Ok(())
}

fn contact(discretisation: &Discretisation, interface: &Interface) -> Result<Contact, Error> {
    let Discretisation { scene, mesh, .. } = discretisation;
    let pair = &interface.pair;
    let edges = |body: usize| {
        let edges = candidates::candidate_edges(mesh, scene, pair, body)?;
        Ok::<_, Error>(edges.iter().map(|edge: &Edge| edge.to_vec()).collect())
    };
    let places = interface.nodes.iter();
    let places: Vec<Point> =
        places.map(|node| Point { position: node.coordinate, value: 0.0, area: None, gap: None }).collect();
    let areas = tributary(scene, pair, &places, mesh.order);
    let nodes = interface.nodes.iter().zip(areas).map(|(node, area)| Node {
        node: retained(discretisation, node.dof).0,
        position: node.coordinate,
        normal: node.normal,
        area,
        gap: Some(node.gap).filter(|gap| gap.is_finite() && area > 0.0),
        row: approach(discretisation, node).into_iter().map(|(node, axis, factor)| (node - 1, axis, factor)).collect(),
    });
    let middle = interface.nodes.iter().min_by(|a, b| a.coordinate.abs().total_cmp(&b.coordinate.abs()));
    Ok(Contact {
        name: pair.name.clone(),
        arc: !pair.path.is_straight(),
        origin: pair.path.origin(),
        normal: pair.normal(middle.map_or(pair.path.origin(), |node| node.point)),
        first: pair.first,
        second: pair.second,
        edges: edges(pair.first)?,
        opposite_edges: pair.second.map_or(Ok(vec![]), edges)?,
        nodes: nodes.collect(),
    })
}
