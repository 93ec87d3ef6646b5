//! The contact side of the primary (second) body: projection of points along the normal on to its edges.

use crate::elasticity::shape_functions;
use crate::error::Error;
use crate::mesh::{Mesh, candidates};
use crate::scene::{ContactPair, Scene};

/// Difference of contact coordinates, over the stretch, below which two points are one.
const SAME: f64 = 1e-9;
/// Iterations of Newton's method: five reach round-off from a straight edge's guess on 45° of an arc.
const NEWTON: usize = 6;

/// The candidate edges of the second body as functions of the contact coordinate.
#[derive(Clone, Debug)]
pub struct PrimarySurface {
    /// Edges: first node, last node and, on 3-node edges, the middle.
    pub edges: Vec<Vec<PrimaryNode>>,
    /// Difference of contact coordinates below which two points are one \[mm, or rad on an arc\].
    pub same: f64,
}

/// A node of an edge of it.
#[derive(Clone, Copy, Debug)]
pub struct PrimaryNode {
    /// Retained dof of its outward normal displacement.
    pub dof: usize,
    /// Contact coordinate \[mm, or rad on an arc\].
    pub coordinate: f64,
    /// How far it lies along the path's direction \[mm\].
    pub depth: f64,
    /// Inward unit normal of its body, which is how the first body's normals point.
    pub normal: [f64; 2],
}

impl PrimarySurface {
    /// The candidate edges of the second body of a contact, whose retained dofs begin at `offset`.
    pub fn of(scene: &Scene, mesh: &Mesh, pair: &ContactPair, body: usize, offset: usize) -> Result<Self, Error> {
        let part = &mesh.bodies[body];
        let node = |&node: &usize| {
            let index = part.candidate_index(node)?;
            let candidate = part.candidates[index];
            Some(PrimaryNode {
                dof: offset + index,
                coordinate: candidate.coordinate,
                depth: pair.path.depth(mesh.points[node]),
                normal: candidate.normal.map(|n| 0.0 - n),
            })
        };
        let edges = candidates::candidate_edges(mesh, scene, pair, body)?;
        let edges = edges.iter().filter_map(|edge| edge.iter().map(node).collect()).collect();
        Ok(Self { edges, same: SAME * pair.stretch })
    }

    /// The node at a contact coordinate, or those of the edge that holds it, with its shape functions there; none where
    /// no edge faces the point.
    pub fn at(&self, s: f64) -> Option<Vec<(PrimaryNode, f64)>> {
        let node = self.edges.iter().flatten().find(|node| (node.coordinate - s).abs() <= self.same);
        if let Some(node) = node {
            return Some(vec![(*node, 1.0)]);
        }
        let edge = self.edges.iter().find(|edge| (edge[0].coordinate - s) * (edge[1].coordinate - s) < 0.0)?;
        let coordinates: Vec<f64> = edge.iter().map(|node| node.coordinate).collect();
        let shapes = shape_functions::edge(edge.len(), natural(&coordinates, s));
        Some(edge.iter().copied().zip(shapes.into_iter().map(|shape| shape.0)).collect())
    }

    /// Contact coordinates of the ends of the edges \[mm, or rad on an arc\].
    pub fn corners(&self) -> impl Iterator<Item = f64> + '_ {
        self.edges.iter().flat_map(|edge| [edge[0].coordinate, edge[1].coordinate])
    }
}

/// ξ with `Σ N_a(ξ) s_a = s` on an edge of 2 nodes, or of 3 (first, last, middle): the root between the ends of
/// `s_m + ½(s₂ − s₁) ξ + (½(s₁ + s₂) − s_m) ξ² = s`; of more by Newton's method.
pub(crate) fn natural(coordinates: &[f64], s: f64) -> f64 {
    let (first, last) = (coordinates[0], coordinates[1]);
    if coordinates.len() > 3 {
        return inverted(coordinates, s, (2.0 * s - first - last) / (last - first));
    }
    let middle = coordinates.get(2).copied().unwrap_or(0.5 * (first + last));
    let (slope, bend, rest) = (0.5 * (last - first), 0.5 * (first + last) - middle, middle - s);
    let root = (slope * slope - 4.0 * bend * rest).max(0.0).sqrt();
    -2.0 * rest / (slope + root.copysign(slope))
}

/// The same from a first guess; coordinates grow evenly along an edge, but for its curvature.
fn inverted(coordinates: &[f64], s: f64, mut xi: f64) -> f64 {
    for _ in 0..NEWTON {
        let (mut rest, mut slope) = (s, 0.0);
        for ((value, derivative), coordinate) in shape_functions::edge(coordinates.len(), xi).iter().zip(coordinates) {
            rest -= value * coordinate;
            slope += derivative * coordinate;
        }
        xi = (xi + rest / slope).clamp(-1.0, 1.0);
    }
    xi
}
