//! Surfaces that meet where no contact point is: beyond the candidates, where the pressure found is that of a shorter
//! body and is refused, and within a candidate edge between its points, which is noted.
//!
//! The gap is a known function, and so is the displacement along an edge: `w − g` is looked at inside every edge of the
//! side that touches, and at every point of a table, wherever nodes are.

use std::collections::HashSet;

use crate::contact::{Interface, primary};
use crate::elasticity::shape_functions;
use crate::error::{Error, Kind, Part};
use crate::measure::ACTIVE;
use crate::mesh::{Edge, candidates};
use crate::scene::{ContactPair, Profile};
use crate::solution::{EdgeState, Solution, Unseen};
use crate::solve::{Change, Discretisation};

/// Difference of contact coordinates, relative, that rounding explains.
const SAME: f64 = 1e-9;
/// Parts of an edge at whose ends it is looked at.
const PARTS: usize = 16;
/// Penetration over the approach of the contact up to which a place of its own is noted instead of refused, beyond
/// candidates that are open, or whose outermost stretch carries no more than that part of the force, as next to a
/// clamp: about as much is not seen.
const ASIDE: f64 = 1e-2;
/// Penetration over the approach of the contact between its points from which on it is noted. A parabola on linear
/// elements, N to a half-width, leaves `1/2πN²`: this for three.
const BETWEEN: f64 = 2e-2;
/// Penetration over the displacements that it is the difference of, which rounding explains.
const ROUNDING: f64 = 1e-9;

/// The ends of the candidates that the surfaces may go on beyond: 1 at the last candidate, −1 at the first one on paths
/// with both sides.
fn ends(pair: &ContactPair) -> &'static [f64] {
    if pair.path.has_both_sides() { &[-1.0, 1.0] } else { &[1.0] }
}

/// The outermost of a list by contact coordinate.
fn outermost<T>(list: &[T], at: f64) -> Option<&T> {
    if at < 0.0 { list.first() } else { list.last() }
}

/// The sides of a contact as a solution displaces them.
struct Sides<'a> {
    discretisation: &'a Discretisation,
    interface: &'a Interface,
    clearance: f64,
    displacement: &'a [[f64; 2]],
    /// Edges of the first body, and of the second one.
    edges: Vec<Vec<Strip>>,
}

/// An edge of a side with the contact coordinates of its nodes.
struct Strip {
    nodes: Edge,
    coordinates: Vec<f64>,
}

impl Strip {
    /// Where it begins and ends.
    fn ends(&self) -> [f64; 2] {
        let [a, b] = [self.coordinates[0], self.coordinates[1]];
        [a.min(b), a.max(b)]
    }

    /// Whether a contact coordinate lies on it.
    fn holds(&self, s: f64) -> bool {
        let [low, high] = self.ends();
        let slack = SAME * (high - low);
        low - slack <= s && s <= high + slack
    }

    /// Shape functions at a contact coordinate.
    fn shapes(&self, s: f64) -> Vec<f64> {
        let xi = primary::natural(&self.coordinates, s).clamp(-1.0, 1.0);
        shape_functions::edge(self.nodes.len(), xi).into_iter().map(|shape| shape.0).collect()
    }
}

impl<'a> Sides<'a> {
    /// Those of an interface, given the displacement of every node \[mm\].
    fn of(
        discretisation: &'a Discretisation,
        interface: &'a Interface,
        change: Change,
        displacement: &'a [[f64; 2]],
    ) -> Result<Self, Error> {
        let strips = interface.pair.bodies().map(|body| strips(discretisation, interface, body));
        let edges = strips.collect::<Result<Vec<_>, Error>>()?;
        Ok(Self { discretisation, interface, clearance: change.clearance, displacement, edges })
    }

    /// The deepest penetration beyond an end of the candidates: contact coordinates of that end and of the place, and
    /// `w − g` there \[mm\]; none where the surface of either body ends with them: a patch, a ring, a punch.
    fn deepest_beyond(&self, at: f64) -> Option<[f64; 3]> {
        let end = outermost(&self.interface.nodes, at)?.coordinate;
        let is_beyond = |strip: &&Strip| {
            let [low, high] = strip.ends();
            at * (0.5 * (low + high)) > at * end * (1.0 + SAME)
        };
        if self.edges.iter().any(|edges| !edges.iter().any(|strip| is_beyond(&strip))) {
            return None;
        }
        // The candidate itself is no place beyond: the other side may end with it.
        let away = |[s, _]: &[f64; 2]| at * s - at * end > SAME * end.abs();
        let places = self.edges[0].iter().filter(is_beyond).flat_map(|strip| self.inside(strip)).filter(away);
        let [position, penetration] = places.max_by(|a, b| a[1].total_cmp(&b[1]))?;
        Some([end, position, penetration])
    }

    /// The deepest penetration within the candidate edges, between their points: contact coordinate and depth \[mm\].
    fn deepest_between(&self) -> Option<[f64; 2]> {
        let nodes = &self.interface.nodes;
        let (first, last) = (nodes.first()?.coordinate, nodes.last()?.coordinate);
        let is_within = |strip: &&Strip| {
            let [low, high] = strip.ends();
            let middle = 0.5 * (low + high);
            first < middle && middle < last
        };
        let places = self.edges[0].iter().filter(is_within).flat_map(|strip| self.inside(strip));
        places.max_by(|a, b| a[1].total_cmp(&b[1]))
    }

    /// Contact coordinates and penetrations at the places where an edge is looked at.
    fn inside<'b>(&'b self, strip: &'b Strip) -> impl Iterator<Item = [f64; 2]> + 'b {
        let [low, high] = strip.ends();
        let even = (0..=PARTS).map(move |k| low + (high - low) * k as f64 / PARTS as f64);
        let told = self.interface.pair.profile.places().into_iter().filter(move |s| low < *s && *s < high);
        even.chain(told).filter_map(|s| self.penetration(strip, s))
    }

    /// Contact coordinate and `w − g` at a place of an edge of the first body; none where nothing faces it.
    fn penetration(&self, strip: &Strip, s: f64) -> Option<[f64; 2]> {
        let shapes = strip.shapes(s);
        let pair = &self.interface.pair;
        let mesh = &self.discretisation.mesh;
        let sum = |strip: &Strip, shapes: &[f64], of: &dyn Fn(usize) -> f64| -> f64 {
            strip.nodes.iter().zip(shapes).map(|(&node, shape)| shape * of(node)).sum()
        };
        let outward = |node: usize| {
            let [n, u] = [pair.normal(mesh.points[node]), self.displacement[node]];
            n[0] * u[0] + n[1] * u[1]
        };
        let depth = |node: usize| pair.path.depth(mesh.points[node]);
        let (opposite, faced) = match self.edges.get(1) {
            None => (0.0, pair.path.own_depth()),
            Some(edges) => {
                let other = edges.iter().find(|other| other.holds(s))?;
                let shapes = other.shapes(s);
                // Both normals are those of the first body: the second body's outward one is their opposite.
                (-sum(other, &shapes, &outward), sum(other, &shapes, &depth))
            }
        };
        let gap = match &pair.profile {
            Profile::Drawn => pair.drawn(sum(strip, &shapes, &depth), faced),
            _ => pair.gap(s),
        };
        let approach = sum(strip, &shapes, &outward) + opposite;
        let penetration = approach - gap - self.clearance;
        // What rounding leaves of surfaces that just touch is no penetration.
        let noise = ROUNDING * (approach.abs() + gap.abs());
        Some([s, if penetration.abs() <= noise && gap.is_finite() { 0.0 } else { penetration }])
    }
}

/// Refuses a converged solution whose contact reaches the end of the candidate surface, or that touches beyond it, by
/// the criterion of the candidates themselves: penetration over the approach that its own force makes within the
/// tolerance. What it passes over is told contact by contact: the deepest penetration between the points, and beside
/// the candidates.
///
/// A contact cut short shows all the same: its pressure rises towards the cut, as under the corner of a punch, where a
/// contact that ends falls to zero.
pub(super) fn look(
    discretisation: &Discretisation,
    solution: &Solution,
    change: Change,
    tolerance: f64,
    displacement: &[[f64; 2]],
) -> Result<Vec<Vec<Unseen>>, Error> {
    let interfaces = discretisation.interfaces.iter();
    interfaces
        .map(|one| {
            let sides = Sides::of(discretisation, one, change, displacement)?;
            let mut unseen = beside(&sides, solution, tolerance)?;
            let approach = solution.contacts[one.contact].approach;
            let deep = sides.deepest_between().filter(|[_, depth]| *depth > BETWEEN * approach);
            let place = |s: f64| one.pair.path.reported(s);
            unseen.extend(deep.map(|[s, penetration]| Unseen { position: place(s), penetration, is_candidate: true }));
            Ok(unseen)
        })
        .collect()
}

/// Refuses what matters beyond the candidates; penetrations there that do not.
fn beside(sides: &Sides, solution: &Solution, tolerance: f64) -> Result<Vec<Unseen>, Error> {
    let interface = sides.interface;
    let approach = solution.contacts[interface.contact].approach;
    let accepted = tolerance * approach;
    let (points, edges) = (solution.points_of(interface.contact), solution.edges_of(interface.contact));
    let mut unseen = Vec::new();
    for &at in ends(&interface.pair) {
        let Some([end, position, penetration]) = sides.deepest_beyond(at) else { continue };
        let largest = points.iter().map(|point| point.pressure).fold(0.0, f64::max);
        let last = outermost(points, at);
        let pressed = last.filter(|point| point.pressure > ACTIVE * largest);
        let touches = pressed.is_some() || last.is_some_and(|point| point.gap <= accepted);
        // An iterate may hold off a point that it presses: the surfaces go on from there.
        let penetration = penetration + pressed.map_or(0.0, |point| point.gap.max(0.0));
        let share = share_at(edges, at);
        let closed = touches && (share > ASIDE || share.is_nan());
        let most = if closed { accepted } else { accepted.max(ASIDE * approach) };
        match penetration {
            deep if deep.is_nan() || deep > most => {
                return Err(too_short(sides.discretisation, interface, end, Some((position, deep))));
            }
            _ if penetration.is_finite() && closed && rises(edges, tolerance, at) => {
                return Err(too_short(sides.discretisation, interface, end, None));
            }
            deep if deep > accepted => {
                let position = interface.pair.path.reported(position);
                unseen.push(Unseen { position, penetration, is_candidate: false });
            }
            _ => {}
        }
    }
    Ok(unseen)
}

/// Error of a contact that reaches the end of the candidate surface, with the deepest penetration beyond, if it is
/// seen.
fn too_short(discretisation: &Discretisation, interface: &Interface, end: f64, deepest: Option<(f64, f64)>) -> Error {
    let told = |s: f64| interface.pair.path.reported(s);
    let gap = |s: f64| interface.pair.gap(s);
    let remedy = match deepest {
        Some((position, _)) if gap(position) < gap(end) => format!(
            "the gap falls beyond the candidates, to {:.3e} mm at s = {}: correct it, end the body before, or widen \
            the candidate stretch",
            gap(position),
            told(position)
        ),
        _ => "widen the candidate stretch".into(),
    };
    let (end, deepest) = (told(end), deepest.map(|(position, depth)| (told(position), depth)));
    let seen = match deepest {
        Some((position, depth)) => format!("at s = {position} the surfaces penetrate by {depth:.3e} mm"),
        None => "the pressure rises towards it although the surfaces go on".into(),
    };
    let message = format!(
        "the contact reaches the end of the candidate surface at s = {end}, or goes on beyond: {seen}, and the \
        pressure found is that of a shorter contact"
    );
    let place = discretisation.scene.place_of(interface.contact, Part::Stretch);
    let kind = Kind::ContactBeyondCandidates { end, deepest };
    Error { kind, ..Error::at(place, message, remedy) }
}

/// Share of the contact's force on the stretch that goes on to an end of the candidates.
fn share_at(edges: &[EdgeState], at: f64) -> f64 {
    let force = |edge: &EdgeState| edge.weight * edge.pressure;
    let presses = |edge: &&EdgeState| edge.pressure > 0.0;
    let outer: f64 = match at < 0.0 {
        true => edges.iter().take_while(presses).map(force).sum(),
        false => edges.iter().rev().take_while(presses).map(force).sum(),
    };
    outer / edges.iter().map(force).sum::<f64>()
}

/// Whether the mean pressure of the outermost edge is above that of its neighbour by more than the tolerance explains.
fn rises(edges: &[EdgeState], tolerance: f64, at: f64) -> bool {
    let [first, after, ..] = edges else { return false };
    let [.., before, last] = edges else { return false };
    let [inner, outer] = if at < 0.0 { [after, first] } else { [before, last] };
    outer.pressure > inner.pressure * (1.0 + tolerance.sqrt())
}

/// Edges of the contact boundary of a body; those between candidates of another contact are left to it.
fn strips(discretisation: &Discretisation, interface: &Interface, body: usize) -> Result<Vec<Strip>, Error> {
    let (scene, mesh, pair) = (&discretisation.scene, &discretisation.mesh, &interface.pair);
    let others = mesh.bodies[body].candidates.iter().filter(|candidate| candidate.contact != interface.contact);
    let others: HashSet<usize> = others.map(|candidate| candidate.node).collect();
    let own = candidates::facing_edges(mesh, scene, pair, body)?.into_iter();
    let own = own.filter(|edge| !edge.iter().any(|node| others.contains(node)));
    let strip = |edge: Edge| {
        let coordinates = edge.iter().map(|&node| pair.path.coordinate(mesh.points[node])).collect();
        Strip { nodes: edge, coordinates }
    };
    Ok(own.map(strip).collect())
}
