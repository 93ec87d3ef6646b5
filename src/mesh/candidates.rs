//! The candidate contact nodes of each body, with the outward normals that make their normal freedoms.

use crate::error::Error;
use crate::mesh::{BodyMesh, Edge, Mesh};
use crate::scene::Scene;

/// A node that may come into contact.
#[derive(Clone, Copy, Debug)]
pub struct Candidate {
    /// Node index.
    pub node: usize,
    /// Outward unit normal of the body.
    pub normal: [f64; 2],
    /// Contact coordinate `s` \[mm, or rad on an arc\].
    pub coordinate: f64,
}

/// Finds the nodes of the boundary `contact` with `s ≤ stretch`, sorted by `s`.
pub(super) fn find(mesh: &mut Mesh, scene: &Scene) -> Result<(), Error> {
    let pair = &scene.contact;
    for (side, body) in pair.bodies().enumerate() {
        let sign = if side == 0 { 1.0 } else { -1.0 };
        let mut nodes: Vec<usize> = candidate_edges(mesh, scene, body)?.iter().flatten().copied().collect();
        nodes.sort_unstable();
        nodes.dedup();
        let mut candidates: Vec<Candidate> = nodes
            .into_iter()
            .map(|node| {
                let point = mesh.points[node];
                let normal = pair.path.direction(point).map(|n| sign * n);
                Candidate { node, normal, coordinate: pair.path.coordinate(point) }
            })
            .collect();
        candidates.sort_by(|a, b| a.coordinate.total_cmp(&b.coordinate));
        mesh.bodies[body].candidates = candidates;
    }
    Ok(())
}

/// Edges of the boundary `contact` that lie within the candidate stretch.
pub fn candidate_edges(mesh: &Mesh, scene: &Scene, body: usize) -> Result<Vec<Edge>, Error> {
    let limit = scene.contact.stretch * (1.0 + 1e-9);
    let within = |edge: &&Edge| edge.iter().all(|&n| scene.contact.path.coordinate(mesh.points[n]) <= limit);
    Ok(mesh.boundary(scene, body, "contact")?.iter().filter(within).cloned().collect())
}

impl BodyMesh {
    /// Index of a node among the candidates.
    pub fn candidate_index(&self, node: usize) -> Option<usize> {
        self.candidates.iter().position(|c| c.node == node)
    }
}
