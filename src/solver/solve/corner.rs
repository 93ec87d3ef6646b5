//! Ends of a contact where the faces end at a corner that is pressed: the geometry tells whether the pressure has a limit there.

use crate::error::Error;
use crate::measure::ACTIVE;
use crate::mesh::{Edge, candidates};
use crate::scene::{ContactPair, Profile};
use crate::solution::EdgeState;
use crate::solve::Discretisation;
use crate::solve::outline::Outline;
use crate::solve::run::{Run, Unbounded};
use crate::solve::wedge::{Wedge, exponent};

/// Difference of contact coordinates, over the stretch, that rounding explains.
const SAME: f64 = 1e-9;

/// An end of a contact face.
#[derive(Clone, Copy)]
struct End {
    /// Contact coordinate.
    at: f64,
    /// Whether the face lies at smaller contact coordinates.
    is_last: bool,
    /// Node of the body there; none where the gap ends, and not a body.
    node: Option<usize>,
}

/// The end of a contact whose pressure grows fastest towards it, of those where a face or the gap ends and that are pressed.
pub(super) fn strongest(
    discretisation: &Discretisation,
    run: &Run,
    contact: usize,
) -> Result<Option<Unbounded>, Error> {
    let (scene, mesh) = (&discretisation.scene, &discretisation.mesh);
    let pair = &scene.contacts[contact];
    let faces = pair.bodies().map(|body| {
        let edges = candidates::facing_edges(mesh, scene, pair, body)?;
        Ok(Face { discretisation, pair, body, ends: ends(discretisation, pair, &edges), edges })
    });
    let faces = faces.collect::<Result<Vec<Face>, Error>>()?;
    let reach = if let Profile::Punch { half_width } = pair.profile { Some(half_width) } else { None };
    let of_gap = reach
        .into_iter()
        .flat_map(|reach| [(-reach, false), (reach, true)].map(|(at, is_last)| End { at, is_last, node: None }));
    // On one side of s = 0 that is a symmetry line.
    let is_free = |end: &End| pair.path.has_both_sides() || end.at > SAME * pair.stretch;
    let all = faces.iter().flat_map(|face| face.ends.iter().copied()).chain(of_gap).filter(is_free);
    let growing = all.filter(|end| is_pressed(run, contact, end)).filter_map(|end| {
        let wedges: Vec<Wedge> = faces.iter().map(|face| face.wedge(&end)).collect();
        let exponent = exponent(&wedges)?;
        let position = pair.path.reported(end.at);
        Some(Unbounded { position, growth: 1.0 - 2f64.powf(exponent - 1.0), exponent: Some(1.0 - exponent) })
    });
    Ok(growing.max_by(|a, b| a.growth.total_cmp(&b.growth)))
}

/// Whether the contact is pressed up to an end, within the edge next to it.
fn is_pressed(run: &Run, contact: usize, end: &End) -> bool {
    let floor = ACTIVE * run.contacts[contact].measures.largest.pressure;
    let (edges, points) = (run.solution.edges_of(contact), run.solution.points_of(contact));
    // Where meshes do not match, no node of the first body need lie where the second one ends.
    let inwards = |edge: &EdgeState| if end.is_last { end.at - edge.ends[1] } else { edge.ends[0] - end.at };
    let is_near =
        |edge: &&EdgeState| inwards(edge) > -0.5 * edge.length() && inwards(edge) < (1.0 - SAME) * edge.length();
    let nearest = edges.iter().filter(is_near).min_by(|a, b| inwards(a).abs().total_cmp(&inwards(b).abs()));
    nearest.is_some_and(|edge| {
        let on_it = points.iter().filter(|p| edge.ends[0] <= p.position && p.position <= edge.ends[1]);
        let last = on_it.min_by(|a, b| (a.position - end.at).abs().total_cmp(&(b.position - end.at).abs()));
        edge.pressure > floor && last.is_some_and(|point| point.pressure > floor)
    })
}

/// Where the edges of a face begin and end: nodes of one of them alone.
fn ends(discretisation: &Discretisation, pair: &ContactPair, edges: &[Edge]) -> Vec<End> {
    let coordinate = |node: usize| pair.path.coordinate(discretisation.mesh.points[node]);
    let of_edge = |edge: &Edge| [[edge[0], edge[1]], [edge[1], edge[0]]];
    let all = edges.iter().flat_map(of_edge);
    let mut nodes: Vec<[usize; 2]> = all.collect();
    nodes.sort_unstable();
    let alone = nodes.chunk_by(|a, b| a[0] == b[0]).filter(|same| same.len() == 1).map(|same| same[0]);
    let end = |[node, other]: [usize; 2]| {
        let at = coordinate(node);
        End { at, is_last: at > coordinate(other), node: Some(node) }
    };
    alone.map(end).collect()
}

/// The side of a body that takes part in a contact.
struct Face<'a> {
    discretisation: &'a Discretisation,
    pair: &'a ContactPair,
    body: usize,
    edges: Vec<Edge>,
    ends: Vec<End>,
}

impl Face<'_> {
    /// The body at an end of the contact, whether it ends there or goes on.
    fn wedge(&self, at: &End) -> Wedge {
        let scene = &self.discretisation.scene;
        let material = &scene.bodies[self.body].material;
        let whole = Wedge::half_plane(material.plane_modulus(scene.plane));
        let near = SAME * self.pair.stretch;
        let is_here = |end: &&End| (end.at - at.at).abs() <= near && end.is_last == at.is_last;
        let own = self.ends.iter().find(is_here).and_then(|end| self.corner(end.node?));
        own.map_or(whole, |(angle, held)| Wedge { angle, held, ..whole })
    }

    /// Interior angle at a node where the face ends, and what holds the side beside it; none where the outline does not tell.
    fn corner(&self, node: usize) -> Option<(f64, Option<[f64; 2]>)> {
        let outline = Outline::of(self.discretisation, self.body);
        let [arriving, leaving] = outline.at(node)?;
        let is_face = |edge: &Edge| self.edges.iter().any(|own| own[..2] == edge[..2]);
        // Directions away from the node; the body lies to the left of the leaving one.
        let face_leaves = is_face(leaving);
        let [from, to] = [outline.tangent(leaving, -1.0), outline.tangent(arriving, 1.0).map(|x| 0.0 - x)];
        let (face, side) = if face_leaves { (from, to) } else { (to, from) };
        let face = self.along_path(node, face);
        let cross = face[0] * side[1] - face[1] * side[0];
        let turn = cross.atan2(face[0] * side[0] + face[1] * side[1]);
        let angle = (if face_leaves { turn } else { 0.0 - turn }).rem_euclid(2.0 * std::f64::consts::PI);
        let outwards = if face_leaves { [0.0 - side[1], side[0]] } else { [side[1], 0.0 - side[0]] };
        // In one direction at most: contact is to find the other displacement.
        let fixed = outline.fixed(if face_leaves { arriving } else { leaving });
        Some((angle, (0..2).find(|&k| fixed[k]).map(|k| [side[k], outwards[k]])))
    }

    /// A direction along the face; on an arc that of the path, which chords of it miss by half of what they turn.
    fn along_path(&self, node: usize, direction: [f64; 2]) -> [f64; 2] {
        if self.pair.path.is_straight() {
            return direction;
        }
        let [nx, ny] = self.pair.path.direction(self.discretisation.mesh.points[node]);
        let sign = (nx * direction[1] - ny * direction[0]).signum();
        [0.0 - sign * ny, sign * nx]
    }
}
