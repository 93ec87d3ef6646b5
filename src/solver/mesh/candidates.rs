//! The candidate contact nodes of each body, with the outward normals that make their normal dofs.

use std::collections::BTreeSet;
use std::f64::consts::FRAC_PI_2;
use std::ops::Range;

use crate::error::{Error, Kind, Part};
use crate::mesh::{BodyMesh, Candidate, Edge, Mesh};
use crate::scene::{ContactPair, Scene, Shape};

/// Difference of contact coordinates, over the stretch, that rounding explains.
const SAME: f64 = 1e-9;

/// Finds the nodes of the candidate edges, contact by contact and sorted by `s`; a stretch that holds no edge of the
/// first body is refused, and a node that would belong to two contacts.
pub(super) fn find(mesh: &mut Mesh, scene: &Scene) -> Result<(), Error> {
    for (contact, pair) in scene.contacts.iter().enumerate() {
        for body in pair.bodies() {
            let found = of_body(mesh, scene, contact, body)?;
            let known = &mut mesh.bodies[body].candidates;
            if let Some(twice) = found.iter().find(|new| known.iter().any(|old| old.node == new.node)) {
                let [x, y] = mesh.points[twice.node];
                let message = format!(
                    "the node of `{}` at ({x:.6}, {y:.6}) mm would be a candidate of two contacts, but has one normal \
                    displacement",
                    scene.bodies[body].name
                );
                let remedy = "shorten the candidate stretch of one of them";
                return Err(Error::at(scene.place_of(contact, Part::Stretch), message, remedy));
            }
            known.extend(found);
        }
        if mesh.bodies[pair.first].candidates_of(contact).is_empty() {
            let (place, stretch) = (scene.place_of(contact, Part::Stretch), pair.path.reported(pair.stretch));
            let expected = format!("it must hold at least one element edge of `{}`", scene.bodies[pair.first].name);
            let error = Error::value(place, "candidate stretch", stretch, expected, "lengthen it or refine the mesh");
            return Err(Error { kind: Kind::EmptyStretch, ..error });
        }
    }
    Ok(())
}

/// Candidates of one body in one contact, sorted by `s`.
fn of_body(mesh: &Mesh, scene: &Scene, contact: usize, body: usize) -> Result<Vec<Candidate>, Error> {
    let pair = &scene.contacts[contact];
    let outward = |normal: [f64; 2]| if body == pair.first { normal } else { normal.map(|n| 0.0 - n) };
    let nodes: BTreeSet<usize> = candidate_edges(mesh, scene, pair, body)?.into_iter().flatten().collect();
    let candidate = |node| {
        let point = mesh.points[node];
        Candidate { node, normal: outward(pair.normal(point)), coordinate: pair.path.coordinate(point), contact }
    };
    let mut candidates: Vec<Candidate> = nodes.into_iter().map(candidate).collect();
    candidates.sort_by(|a, b| a.coordinate.total_cmp(&b.coordinate));
    Ok(candidates)
}

/// Edges of the boundary of a body that touches, as far as they face the other side: a closed boundary turns away from
/// it.
pub fn facing_edges(mesh: &Mesh, scene: &Scene, pair: &ContactPair, body: usize) -> Result<Vec<Edge>, Error> {
    // Other sides that are named here look one way.
    let shape = &scene.bodies[body].shape;
    let is_round = matches!(shape, Shape::Ring { sweep, .. } if *sweep > FRAC_PI_2 * (1.0 + SAME));
    let may_turn = shape.has_given_mesh() || is_round && pair.path.is_straight();
    let faces = |edge: &&Edge| !may_turn || pair.faces(body, [edge[0], edge[1]].map(|node| mesh.points[node]), 0.0);
    Ok(mesh.boundary(scene, body, pair.side(body))?.iter().filter(faces).cloned().collect())
}

/// Those of them that lie within the candidate stretch, of the first body, or that reach into it, of the second, so
/// that every point of the first has an edge to face.
pub fn candidate_edges(mesh: &Mesh, scene: &Scene, pair: &ContactPair, body: usize) -> Result<Vec<Edge>, Error> {
    let coordinates =
        |edge: &Edge| -> Vec<f64> { edge.iter().map(|&n| pair.path.coordinate(mesh.points[n])).collect() };
    let taken = |edge: &Edge| match body == pair.first {
        true => coordinates(edge).iter().all(|s| s.abs() <= pair.stretch * (1.0 + SAME)),
        false => {
            let within = pair.stretch * (1.0 - SAME);
            let ends = coordinates(edge);
            ends.iter().any(|s| *s < within) && ends.iter().any(|s| *s > -within)
        }
    };
    Ok(facing_edges(mesh, scene, pair, body)?.into_iter().filter(taken).collect())
}

impl BodyMesh {
    /// Which of the candidates belong to a contact.
    pub fn candidates_of(&self, contact: usize) -> Range<usize> {
        let begin = self.candidates.partition_point(|candidate| candidate.contact < contact);
        begin..self.candidates.partition_point(|candidate| candidate.contact <= contact)
    }

    /// Index of a node among the candidates.
    pub fn candidate_index(&self, node: usize) -> Option<usize> {
        self.candidates.iter().position(|c| c.node == node)
    }
}
