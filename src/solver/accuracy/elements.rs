//! What bars depend on of a mesh: how wide its elements are, whether a body is one element deep, and where corners are
//! that loads and held sides make.

use std::collections::{BTreeMap, BTreeSet};

use crate::mesh::candidates::candidate_edges;
use crate::scene::{ContactPair, Place};
use crate::solve::Discretisation;

/// Length of the edge at a cusp of the pressure, towards which cells shrink, over that that is counted on: of rⁿ, n
/// from 1.15 to 1.98, peaks are off by a half of their bars.
const SHRUNK: f64 = 4.0;

/// A cell made elsewhere at the surface below a contact: between which places, and how deep, in its coordinate.
pub(super) type Beneath = ([f64; 2], f64);

/// The end of a side that carries a load: body, place, and length of the outermost edge.
pub(super) type Corner = (usize, [f64; 2], f64);

/// Whether a body has no more cells than edges on one of the sides that touch.
pub(super) fn is_shallow(Discretisation { scene, mesh, .. }: &Discretisation) -> bool {
    let is_row = |pair: &ContactPair, body: usize| {
        let edges = mesh.boundary(scene, body, pair.side(body)).map_or(0, <[_]>::len);
        mesh.bodies[body].cells.len() <= edges
    };
    scene.contacts.iter().any(|pair| pair.bodies().any(|body| is_row(pair, body)))
}

/// Along which components a body is held where it loses regularity: on a side that is held in both directions up to
/// where a free one begins, or at a point on the end of a side that carries a load.
pub(super) fn held_at_corner(discretisation: &Discretisation, corners: &[Corner]) -> [bool; 2] {
    let Discretisation { scene, mesh, .. } = discretisation;
    let has_corner = |body: usize| {
        let mut at_nodes: BTreeMap<usize, [bool; 2]> = BTreeMap::new();
        for (name, edges) in &mesh.bodies[body].boundaries {
            let kind = match scene.bodies[body].held(name) {
                [false, false] => 0,
                [true, true] => 1,
                _ => continue,
            };
            edges.iter().flat_map(|edge| &edge[..2]).for_each(|node| at_nodes.entry(*node).or_default()[kind] = true);
        }
        at_nodes.into_values().any(|[free, fixed]| free && fixed)
    };
    let at_point = |body: usize, k: usize| {
        let own = scene.bodies[body].supports.iter().filter(|support| support.component.index() == k);
        let mut points = own.filter_map(|support| if let Place::Point(at) = support.at { Some(at) } else { None });
        points.any(|at| is_near(corners, body, at))
    };
    [0, 1].map(|k| (0..scene.bodies.len()).any(|body| has_corner(body) || at_point(body, k)))
}

/// Whether a point of a body lies within an edge of one of some corners.
pub(super) fn is_near(corners: &[Corner], body: usize, [x, y]: [f64; 2]) -> bool {
    corners.iter().any(|(of, at, length)| *of == body && (x - at[0]).hypot(y - at[1]) <= *length)
}

/// Mean candidate element of each contact, in its coordinate.
pub(super) fn sizes(discretisation: &Discretisation) -> Vec<f64> {
    let each = discretisation.interfaces.iter().map(|interface| {
        let nodes = &interface.nodes;
        let [begin, end] = [nodes.first(), nodes.last()].map(|node| node.map_or(f64::NAN, |node| node.coordinate));
        // As wide as the 8-node elements that have as many nodes.
        let wide = discretisation.resolution.order.intervals() as f64 / 2.0;
        (end - begin) / (interface.edges.len() as f64 * wide)
    });
    each.collect()
}

/// About the distance from s = 0 of each contact to the next node, by the candidate edge there, the widest of those
/// that end with it; a part of that edge where cells shrink towards it.
pub(super) fn spacings_at_vertex(discretisation: &Discretisation) -> Vec<f64> {
    let order = discretisation.resolution.order;
    let of_8_nodes = order.intervals() as f64 / 2.0;
    let from_zero = |[a, b]: &[f64; 2]| if a * b <= 0.0 { 0.0 } else { a.abs().min(b.abs()) };
    let each = discretisation.interfaces.iter().zip(&discretisation.scene.contacts).map(|(interface, pair)| {
        let ends = |edge: &Vec<usize>| [0, 1].map(|end| interface.nodes[edge[end]].coordinate);
        let nearest = interface.edges.iter().map(ends).min_by(|a, b| from_zero(a).total_cmp(&from_zero(b)));
        let part = if pair.power_at_cusp().is_some() { SHRUNK } else { of_8_nodes * f64::from(order.number()) };
        nearest.map_or(f64::NAN, |[a, b]| (b - a).abs() / part)
    });
    each.collect()
}

/// Two mean spacings of the candidates of the second body of each contact, an 8-node cell or two of 4 nodes; 0 where
/// that is rigid.
pub(super) fn of_second(discretisation: &Discretisation) -> Vec<f64> {
    let of = |(contact, pair): (usize, &ContactPair)| {
        let body = &discretisation.mesh.bodies[pair.second?];
        let own = &body.candidates[body.candidates_of(contact)];
        Some(2.0 * (own.last()?.coordinate - own.first()?.coordinate) / (own.len() as f64 - 1.0))
    };
    discretisation.scene.contacts.iter().enumerate().map(|one| of(one).unwrap_or(0.0)).collect()
}

/// Ends of the sides that carry a load.
pub(super) fn loaded_corners(discretisation: &Discretisation) -> Vec<Corner> {
    let (scene, mesh) = (&discretisation.scene, &discretisation.mesh);
    let mut corners = Vec::new();
    for side in scene.loaded_sides() {
        let Place::Boundary(name) = &side.at else { continue };
        let edges = mesh.boundary(scene, side.body, name).map_or(&[][..], |edges| edges);
        let is_end = |node: usize| edges.iter().filter(|edge| edge[..2].contains(&node)).count() == 1;
        for edge in edges {
            let [a, b] = [edge[0], edge[1]].map(|node| mesh.points[node]);
            let length = (a[0] - b[0]).hypot(a[1] - b[1]);
            let ends = edge[..2].iter().filter(|node| is_end(**node));
            corners.extend(ends.map(|&node| (side.body, mesh.points[node], length)));
        }
    }
    corners
}

/// Cells made elsewhere at the surface of a body below a contact; none of a body that is meshed here, whose cells are
/// about as deep as wide there.
pub(super) fn beneath(
    Discretisation { scene, mesh, .. }: &Discretisation,
    pair: &ContactPair,
    body: usize,
) -> Vec<Beneath> {
    if !scene.bodies[body].shape.has_given_mesh() {
        return Vec::new();
    }
    let sorted = |[a, b]: [usize; 2]| [a.min(b), a.max(b)];
    let edges = candidate_edges(mesh, scene, pair, body).unwrap_or_default();
    let edges: BTreeSet<[usize; 2]> = edges.iter().map(|edge| sorted([edge[0], edge[1]])).collect();
    let length = |a: usize, b: usize| {
        let [[x, y], [to_x, to_y]] = [mesh.points[a], mesh.points[b]];
        (to_x - x).hypot(to_y - y) / pair.path.metric()
    };
    let cell = |nodes: &[usize]| {
        let [a, b, c, d] = [0, 1, 2, 3]
            .map(|k| [0, 1, 2, 3].map(|n| nodes[(k + n) % 4]))
            .into_iter()
            .find(|[a, b, ..]| edges.contains(&sorted([*a, *b])))?;
        let [from, to] = [a, b].map(|node| pair.path.coordinate(mesh.points[node]));
        Some(([from.min(to), from.max(to)], 0.5 * (length(a, d) + length(b, c))))
    };
    mesh.bodies[body].cells.clone().filter_map(|index| cell(mesh.cell(index))).collect()
}
