//! Ends of a contact where the faces end at a corner that is pressed: the geometry tells whether the pressure has a
//! limit there.

use std::f64::consts::{FRAC_PI_2, LN_2, PI};

use crate::elasticity::loads::{self, Traction};
use crate::error::Error;
use crate::measure::ACTIVE;
use crate::mesh::{Edge, candidates};
use crate::scene::{ContactPair, Profile};
use crate::solution::{EdgeState, PointState};
use crate::solve::Discretisation;
use crate::solve::outline::Outline;
use crate::solve::run::{Run, Unbounded};
use crate::solve::wedge::{Wedge, exponent};

/// Difference of contact coordinates, over the stretch, that rounding explains.
const SAME: f64 = 1e-9;

/// Growth at the last halving, over the peak, below which a tip, a sheared corner or a series is as good as at its
/// limit.
pub(super) const SMALL: f64 = 0.01;
/// Angle by which a corner may depart from a right one, as chords of an arc do \[rad\].
const RIGHT: f64 = 1e-3;

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

/// The ends of a contact towards which its pressure grows, of those where a face or the gap ends and that are pressed.
pub(super) fn pressed(discretisation: &Discretisation, run: &Run, contact: usize) -> Result<Vec<Unbounded>, Error> {
    let pair = &discretisation.scene.contacts[contact];
    let faces = Face::both(discretisation, pair)?;
    let reach = if let Profile::Punch { half_width } = pair.profile { Some(half_width) } else { None };
    let of_gap = reach
        .into_iter()
        .flat_map(|reach| [(-reach, false), (reach, true)].map(|(at, is_last)| End { at, is_last, node: None }));
    let all = faces.iter().flat_map(|face| face.ends.iter().copied()).chain(of_gap);
    let growing = all.filter(|end| is_pressed(run, contact, pair, end)).filter_map(|end| {
        let wedges: Vec<Wedge> = faces.iter().map(|face| face.wedge(&end)).collect();
        let position = pair.path.reported(end.at);
        if let Some(exponent) = exponent(&wedges) {
            return Some(Unbounded {
                position,
                growth: 1.0 - 2f64.powf(exponent - 1.0),
                exponent: Some(1.0 - exponent),
            });
        }
        let growth = sheared(&faces, &wedges, &end) * LN_2 / run.contacts[contact].measures.peak.pressure;
        (growth > SMALL).then_some(Unbounded { position, growth, exponent: None })
    });
    Ok(growing.collect())
}

/// The c of `p = c ln 1/r` at an end where bodies end at right angles and their sides carry a shear stress τ towards
/// the contact, whose faces carry none \[MPa\]: mirrored at a rigid plane, a side is a half-plane whose shear leaps by
/// 2τ, so that `c = 4τ/π`; of two bodies `Σ cᵢ/Eᵢ / Σ 1/Eᵢ`.
fn sheared(faces: &[Face], wedges: &[Wedge], end: &End) -> f64 {
    let is_right = |wedge: &Wedge| wedge.held.is_none() && (wedge.angle - FRAC_PI_2).abs() <= RIGHT;
    if !wedges.iter().all(is_right) {
        return 0.0;
    }
    let [mut sum, mut compliance] = [0.0; 2];
    for (face, wedge) in faces.iter().zip(wedges) {
        sum += 4.0 / PI * face.shear_towards(end) / wedge.modulus;
        compliance += 1.0 / wedge.modulus;
    }
    sum / compliance
}

/// Whether the contact is pressed up to an end, within the edge next to it; never on the symmetry line of a half.
fn is_pressed(run: &Run, contact: usize, pair: &ContactPair, end: &End) -> bool {
    if !pair.path.has_both_sides() && end.at <= SAME * pair.stretch {
        return false;
    }
    let floor = ACTIVE * run.contacts[contact].measures.largest.pressure;
    let (edges, points) = (run.solution.edges_of(contact), run.solution.points_of(contact));
    // Where meshes do not match, no node of the first body need lie where the second one ends.
    let inwards = |edge: &EdgeState| if end.is_last { end.at - edge.ends[1] } else { edge.ends[0] - end.at };
    let is_near =
        |edge: &&EdgeState| inwards(edge) > -0.5 * edge.length() && inwards(edge) < (1.0 - SAME) * edge.length();
    let nearest = edges.iter().filter(is_near).min_by(|a, b| inwards(a).abs().total_cmp(&inwards(b).abs()));
    // Edges beyond the contact may be missing from the solution; points are not.
    let slack = SAME * pair.stretch;
    let is_inwards =
        |p: &&PointState| if end.is_last { p.position <= end.at + slack } else { p.position >= end.at - slack };
    let last = points
        .iter()
        .filter(is_inwards)
        .min_by(|a, b| (a.position - end.at).abs().total_cmp(&(b.position - end.at).abs()));
    nearest.is_some_and(|edge| edge.pressure > floor) && last.is_some_and(|point| point.pressure > floor)
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
    /// What its loads leave on its sides.
    tractions: Vec<Vec<Traction>>,
}

/// A side that meets the end of a face.
struct Side {
    edge: Edge,
    /// Direction along it, away from the face, and out of the body.
    away: [f64; 2],
    outwards: [f64; 2],
    /// Direction of the face away from the side, and whether the outline runs so.
    face: [f64; 2],
    face_leaves: bool,
    /// Components in which it is fixed.
    fixed: [bool; 2],
}

impl<'a> Face<'a> {
    /// Those of the bodies of a contact.
    fn both(discretisation: &'a Discretisation, pair: &'a ContactPair) -> Result<Vec<Self>, Error> {
        let of = |body: usize| {
            let edges = candidates::facing_edges(&discretisation.mesh, &discretisation.scene, pair, body)?;
            let tractions = loads::tractions(&discretisation.scene, &discretisation.mesh, body)?;
            Ok(Self { discretisation, pair, body, ends: ends(discretisation, pair, &edges), edges, tractions })
        };
        pair.bodies().map(of).collect()
    }

    /// Shear stress towards the contact that loads leave on the side where the face ends \[MPa\].
    fn shear_towards(&self, end: &End) -> f64 {
        let Some((node, side)) = self.ending(end).and_then(|own| Some((own.node?, self.side(own.node?)?))) else {
            return 0.0;
        };
        let Side { edge, away, .. } = side;
        let at_end = self.tractions.iter().flatten().filter_map(|one| one.at(&edge, usize::from(edge[1] == node)));
        at_end.map(|[x, y]| 0.0 - x * away[0] - y * away[1]).sum()
    }

    /// The end of its own face at an end of the contact.
    fn ending(&self, at: &End) -> Option<&End> {
        let near = SAME * self.pair.stretch;
        self.ends.iter().find(|end| (end.at - at.at).abs() <= near && end.is_last == at.is_last)
    }

    /// The side that meets the face at a node, and the face's own direction; none where the outline does not tell.
    fn side(&self, node: usize) -> Option<Side> {
        let outline = Outline::of(self.discretisation, self.body);
        let [arriving, leaving] = outline.at(node)?;
        let is_face = |edge: &Edge| self.edges.iter().any(|own| own[..2] == edge[..2]);
        // Directions away from the node; the body lies to the left of the leaving one.
        let face_leaves = is_face(leaving);
        let [from, to] = [outline.tangent(leaving, -1.0), outline.tangent(arriving, 1.0).map(|x| 0.0 - x)];
        let (face, away) = if face_leaves { (from, to) } else { (to, from) };
        let outwards = if face_leaves { [0.0 - away[1], away[0]] } else { [away[1], 0.0 - away[0]] };
        let edge = if face_leaves { arriving } else { leaving };
        Some(Side { edge: edge.clone(), away, outwards, face, face_leaves, fixed: outline.fixed(edge) })
    }

    /// The body at an end of the contact, whether it ends there or goes on.
    fn wedge(&self, at: &End) -> Wedge {
        let scene = &self.discretisation.scene;
        let material = &scene.bodies[self.body].material;
        let whole = Wedge::half_plane(material.plane_modulus(scene.plane));
        let own = self.ending(at).and_then(|end| self.corner(end.node?));
        own.map_or(whole, |(angle, held)| Wedge { angle, held, ..whole })
    }

    /// Interior angle at a node where the face ends, and what holds the side beside it; none where the outline does not
    /// tell.
    fn corner(&self, node: usize) -> Option<(f64, Option<[f64; 2]>)> {
        let Side { away, outwards, face, face_leaves, fixed, .. } = self.side(node)?;
        let face = self.along_path(node, face);
        let cross = face[0] * away[1] - face[1] * away[0];
        let turn = cross.atan2(face[0] * away[0] + face[1] * away[1]);
        let angle = (if face_leaves { turn } else { 0.0 - turn }).rem_euclid(2.0 * PI);
        // In one direction at most: contact is to find the other displacement.
        Some((angle, (0..2).find(|&k| fixed[k]).map(|k| [away[k], outwards[k]])))
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
