//! Which edges of a mesh made elsewhere lie on the contact side of the first body.

use std::collections::{HashMap, HashSet};

use crate::scene::{ContactPair, Path, Profile, Scene, Shape};

/// Distance from the side, over the length of an edge, that its chord explains.
const NEAR: f64 = 0.02;
/// Cosine between outward normals from which on they are of one side.
const ALONG: f64 = 0.5;
/// Rounding of the stretch.
const SAME: f64 = 1e-6;

/// A cell by its nodes: three or four corners, then the mid-sides, if it has them.
#[derive(Clone, Debug)]
pub struct Cell {
    /// Its nodes.
    pub nodes: Vec<usize>,
    /// How many of them are corners.
    pub corners: usize,
}

/// Whether no two cells share a point, as files of discontinuous fields have it.
pub fn have_own_points(cells: &[Cell]) -> bool {
    let all: Vec<usize> = cells.iter().flat_map(|cell| cell.nodes.iter().copied()).collect();
    cells.len() > 1 && all.iter().collect::<HashSet<_>>().len() == all.len()
}

/// The nodes of the edges on the contact side within the candidate stretch, in pairs or, with mid-sides, in threes.
pub fn edges(scene: &Scene, contact: usize, points: &[[f64; 2]], cells: &[Cell]) -> Vec<Vec<usize>> {
    let pair = &scene.contacts[contact];
    let all = outline(points, cells);
    let depth = |node: usize| pair.path.depth(points[node]);
    let within = |edge: &&Vec<usize>| {
        edge.iter().all(|&node| pair.path.coordinate(points[node]).abs() <= pair.stretch * (1.0 + SAME))
    };
    let own = all.iter().filter(within).filter(|edge| faces(pair, points, edge));
    own.filter(|edge| {
        let [a, b] = [edge[0], edge[1]].map(|node| points[node]);
        let length = (a[0] - b[0]).hypot(a[1] - b[1]);
        edge.iter().all(|&node| {
            let wanted = surface(scene, pair, points[node]);
            wanted.is_none_or(|wanted| (depth(node) - wanted).abs() <= NEAR * length)
        })
    })
    .cloned()
    .collect()
}

/// How deep the first body's side lies where a point is; none where only its mesh tells.
fn surface(scene: &Scene, pair: &ContactPair, point: [f64; 2]) -> Option<f64> {
    let origin = pair.path.origin();
    if let (Path::Arc(circle), false) = (&pair.path, matches!(pair.profile, Profile::Drawn)) {
        return Some(circle.radius);
    }
    // The side that the contact is on: a body may have another one on its other side.
    let below = pair.normal(point)[1] < 0.0;
    match (&scene.bodies[pair.first].shape, pair.path.is_straight()) {
        (Shape::Rectangle { y, .. }, true) => Some(origin[1] - if below { y[0] } else { y[1] }),
        (Shape::Disc { centre, radius, .. }, true) => {
            let away = point[0] - centre[0];
            let root = (radius * radius - away * away).max(0.0).sqrt();
            let height = if below { centre[1] - root } else { centre[1] + root };
            Some(origin[1] - height)
        }
        // On a mesh that is given, the side is one of its boundaries; others of the body may face the same way.
        (Shape::Given(mesh), _) => {
            let s = pair.path.coordinate(point);
            mesh.curves(pair.side(pair.first))?.iter().find_map(|curve| curve.depth(&pair.path, s))
        }
        _ => None,
    }
}

/// Whether an edge faces the other side of the contact: the body is to its left.
fn faces(pair: &ContactPair, points: &[[f64; 2]], edge: &[usize]) -> bool {
    let [a, b] = [edge[0], edge[1]].map(|node| points[node]);
    let length = (b[0] - a[0]).hypot(b[1] - a[1]);
    let middle = [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
    let normal = [(b[1] - a[1]) / length, (a[0] - b[0]) / length];
    let wanted = pair.normal(middle);
    normal[0] * wanted[0] + normal[1] * wanted[1] >= ALONG
}

/// Edges of one cell only, each with the cell to its left.
fn outline(points: &[[f64; 2]], cells: &[Cell]) -> Vec<Vec<usize>> {
    let mut known: HashMap<[usize; 2], Option<Vec<usize>>> = HashMap::new();
    for Cell { nodes, corners } in cells {
        let at = |k: usize| points[nodes[k % corners]];
        let area: f64 = (0..*corners).map(|k| at(k)[0] * at(k + 1)[1] - at(k + 1)[0] * at(k)[1]).sum();
        for k in 0..*corners {
            let [a, b] = [nodes[k], nodes[(k + 1) % corners]];
            let ends = if area < 0.0 { [b, a] } else { [a, b] };
            let edge = ends.into_iter().chain(nodes.get(corners + k).copied()).collect();
            known.entry([a.min(b), a.max(b)]).and_modify(|edge| *edge = None).or_insert(Some(edge));
        }
    }
    known.into_values().flatten().collect()
}
