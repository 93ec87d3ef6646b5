//! The candidate contact nodes of each body, with the outward normals that make their normal freedoms.

use crate::error::Error;
use crate::mesh::{BodyMesh, Edge, Mesh};
use crate::scene::Scene;

/// Difference of contact coordinates, over the stretch, that rounding explains.
const SAME: f64 = 1e-9;

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

/// Finds the nodes of the candidate edges, sorted by `s`; a stretch that holds no edge of the first body is refused.
pub(super) fn find(mesh: &mut Mesh, scene: &Scene) -> Result<(), Error> {
    let pair = &scene.contact;
    for body in pair.bodies() {
        let outward = |normal: [f64; 2]| if body == pair.first { normal } else { normal.map(|n| 0.0 - n) };
        let mut nodes: Vec<usize> = candidate_edges(mesh, scene, body)?.iter().flatten().copied().collect();
        nodes.sort_unstable();
        nodes.dedup();
        let mut candidates: Vec<Candidate> = nodes
            .into_iter()
            .map(|node| {
                let point = mesh.points[node];
                Candidate { node, normal: outward(pair.normal(point)), coordinate: pair.path.coordinate(point) }
            })
            .collect();
        candidates.sort_by(|a, b| a.coordinate.total_cmp(&b.coordinate));
        mesh.bodies[body].candidates = candidates;
    }
    if mesh.bodies[pair.first].candidates.is_empty() {
        let expected = "it must hold at least one element edge";
        return Err(Error::value(
            &scene.name,
            "candidate stretch",
            pair.stretch,
            expected,
            "lengthen it or refine the mesh",
        ));
    }
    Ok(())
}

/// Edges of the boundary `contact`: of the first body those that lie within the candidate stretch, of the second those
/// that reach into it, so that every point of the first has an edge to face.
pub fn candidate_edges(mesh: &Mesh, scene: &Scene, body: usize) -> Result<Vec<Edge>, Error> {
    let pair = &scene.contact;
    let coordinates =
        |edge: &Edge| -> Vec<f64> { edge.iter().map(|&n| pair.path.coordinate(mesh.points[n])).collect() };
    let taken = |edge: &&Edge| match body == pair.first {
        true => coordinates(edge).iter().all(|s| s.abs() <= pair.stretch * (1.0 + SAME)),
        false => {
            let within = pair.stretch * (1.0 - SAME);
            let ends = coordinates(edge);
            ends.iter().any(|s| *s < within) && ends.iter().any(|s| *s > -within)
        }
    };
    Ok(mesh.boundary(scene, body, "contact")?.iter().filter(taken).cloned().collect())
}

impl BodyMesh {
    /// Index of a node among the candidates.
    pub fn candidate_index(&self, node: usize) -> Option<usize> {
        self.candidates.iter().position(|c| c.node == node)
    }
}
