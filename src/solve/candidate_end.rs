//! Contact that reaches the end of the candidate surface: the pressure found is that of a shorter body, and is refused.

use std::collections::HashSet;

use crate::contact::Interface;
use crate::error::{Error, Kind, Part};
use crate::scene::{ContactPair, Profile};
use crate::solution::{EdgeState, Solution};
use crate::solve::{Change, Discretisation};

/// Difference of contact coordinates, relative, that rounding explains.
const SAME: f64 = 1e-9;

/// How deep the surfaces penetrate beyond an outermost candidate, at the worst node.
#[derive(Clone, Copy, Debug)]
pub struct Beyond {
    /// Contact coordinate of that candidate \[mm, or rad on an arc\].
    pub end: f64,
    /// Contact coordinate of the node \[mm, or rad on an arc\].
    pub position: f64,
    /// Penetration `w − g` there \[mm\]; negative is a gap.
    pub penetration: f64,
}

/// An end of the candidates that the surfaces may go on beyond.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// The first candidate, on paths with both sides.
    First,
    /// The last candidate.
    Last,
}

impl End {
    /// Those of a contact: where it begins at 0 only the last one.
    fn of(pair: &ContactPair) -> &'static [Self] {
        if pair.path.has_both_sides() { &[Self::First, Self::Last] } else { &[Self::Last] }
    }

    /// The outermost of a list by contact coordinate.
    fn outermost<T>(self, list: &[T]) -> Option<&T> {
        if self == Self::First { list.first() } else { list.last() }
    }

    /// How far a contact coordinate lies outwards \[mm, or rad on an arc\].
    fn outwards(self, coordinate: f64) -> f64 {
        if self == Self::First { -coordinate } else { coordinate }
    }
}

/// The deepest penetration beyond an end of the candidates of an interface, in a solution whose outermost point is
/// closed, its gap being no more than the length accepted, or beyond whose outermost point the initial gap narrows
/// again.
///
/// None where that point is open and the gap goes on widening, and where the surface of either body ends with the
/// candidates: a patch, a ring, a punch.
pub fn deepest(
    discretisation: &Discretisation,
    interface: &Interface,
    solution: &Solution,
    change: Change,
    accepted: f64,
    at: End,
) -> Result<Option<Beyond>, Error> {
    let pair = &interface.pair;
    let Some(last) = at.outermost(&interface.nodes) else { return Ok(None) };
    let end = last.coordinate;
    let surfaces: Vec<Vec<Surface>> =
        pair.bodies().map(|body| surface(discretisation, interface, body)).collect::<Result<_, _>>()?;
    let beyond = |node: &&Surface| at.outwards(node.coordinate) > at.outwards(end) * (1.0 + SAME);
    if surfaces.iter().any(|surface| !surface.iter().any(|node| beyond(&node))) {
        return Ok(None);
    }
    let deep = |node: &Surface| pair.path.depth(discretisation.mesh.points[node.node]);
    let gap = |node: &Surface| match &pair.profile {
        Profile::Drawn => {
            let opposite =
                surfaces.get(1).map_or(Some(pair.path.own_depth()), |other| between(other, node.coordinate, deep));
            opposite.map(|opposite| pair.drawn(deep(node), opposite))
        }
        profile => Some(profile.gap(node.coordinate)),
    };
    let closed = at.outermost(solution.points_of(interface.contact)).is_some_and(|point| point.gap <= accepted);
    let narrows = || surfaces[0].iter().filter(beyond).filter_map(gap).any(|gap| gap <= last.gap);
    if !closed && !narrows() {
        return Ok(None);
    }
    let unknowns = discretisation.condensed.recover_under(change.load, &solution.displacement);
    let displacement = discretisation.system.nodal_displacements(&unknowns);
    let outward =
        |node: &Surface| node.normal[0] * displacement[node.node][0] + node.normal[1] * displacement[node.node][1];
    let depth = |node: &Surface| {
        let opposite = match surfaces.get(1) {
            None => 0.0,
            // Both normals are those of the first body: the second body's outward one is their opposite.
            Some(other) => -between(other, node.coordinate, outward)?,
        };
        let penetration = outward(node) + opposite - gap(node)? - change.clearance;
        Some(Beyond { end, position: node.coordinate, penetration })
    };
    let depths = surfaces[0].iter().filter(beyond).filter_map(depth);
    Ok(depths.max_by(|a, b| a.penetration.total_cmp(&b.penetration)))
}

/// Refuses a converged solution whose contact reaches the end of the candidate surface, by the criterion of the candidates themselves:
/// penetration over the approach that its own force makes within the tolerance.
///
/// Beyond steeply growing elements the next node may lie where the surfaces have parted again. A contact cut short shows all
/// the same: its pressure rises towards the cut, as under the corner of a punch, where a contact that ends falls to zero.
pub(super) fn refuse(
    discretisation: &Discretisation,
    solution: &Solution,
    change: Change,
    tolerance: f64,
) -> Result<(), Error> {
    if !solution.converged() {
        return Ok(());
    }
    discretisation.interfaces.iter().try_for_each(|one| refuse_one(discretisation, one, solution, change, tolerance))
}

fn refuse_one(
    discretisation: &Discretisation,
    interface: &Interface,
    solution: &Solution,
    change: Change,
    tolerance: f64,
) -> Result<(), Error> {
    let accepted = tolerance * solution.contacts[interface.contact].approach;
    let edges = solution.edges_of(interface.contact);
    for &at in End::of(&interface.pair) {
        match deepest(discretisation, interface, solution, change, accepted, at)? {
            Some(Beyond { end, position, penetration }) if penetration.is_nan() || penetration > accepted => {
                return Err(too_short(discretisation, interface, end, Some((position, penetration))));
            }
            Some(Beyond { end, penetration, .. }) if penetration.is_finite() && rises(edges, tolerance, at) => {
                return Err(too_short(discretisation, interface, end, None));
            }
            _ => {}
        }
    }
    Ok(())
}

/// Error of a contact that reaches the end of the candidate surface, with the deepest penetration beyond, if it is seen.
fn too_short(discretisation: &Discretisation, interface: &Interface, end: f64, deepest: Option<(f64, f64)>) -> Error {
    let told = |s: f64| interface.pair.path.reported(s);
    let (end, deepest) = (told(end), deepest.map(|(position, depth)| (told(position), depth)));
    let seen = match deepest {
        Some((position, depth)) => format!("at s = {position} the surfaces penetrate by {depth:.3e} mm"),
        None => "the pressure rises towards it although the surfaces go on".into(),
    };
    let message = format!(
        "the contact reaches the end of the candidate surface at s = {end}: {seen}, and the pressure found is that of a shorter contact"
    );
    let place = discretisation.scene.place_of(interface.contact, Part::Stretch);
    let kind = Kind::ContactBeyondCandidates { end, deepest };
    Error { kind, ..Error::at(place, message, "widen the candidate stretch") }
}

/// Whether the mean pressure of the outermost edge is above that of its neighbour by more than the tolerance explains.
fn rises(edges: &[EdgeState], tolerance: f64, at: End) -> bool {
    let outer = match (at, edges) {
        (End::Last, [.., before, last]) => Some((before, last)),
        (End::First, [first, after, ..]) => Some((after, first)),
        _ => None,
    };
    match outer {
        Some((before, last)) => last.pressure > before.pressure * (1.0 + tolerance.sqrt()),
        None => false,
    }
}

/// A node of a body's contact boundary.
struct Surface {
    node: usize,
    coordinate: f64,
    normal: [f64; 2],
}

/// Nodes of the contact boundary of a body, by contact coordinate, with the normals of the first body; those that are
/// candidates of another contact are left to it.
fn surface(discretisation: &Discretisation, interface: &Interface, body: usize) -> Result<Vec<Surface>, Error> {
    let (scene, mesh, pair) = (&discretisation.scene, &discretisation.mesh, &interface.pair);
    let others = mesh.bodies[body].candidates.iter().filter(|candidate| candidate.contact != interface.contact);
    let others: HashSet<usize> = others.map(|candidate| candidate.node).collect();
    let mut nodes: Vec<usize> = mesh.boundary(scene, body, pair.side(body))?.iter().flatten().copied().collect();
    nodes.sort_unstable();
    nodes.dedup();
    nodes.retain(|node| !others.contains(node));
    let all = nodes.into_iter().map(|node| {
        let point = mesh.points[node];
        Surface { node, coordinate: pair.path.coordinate(point), normal: pair.normal(point) }
    });
    let mut all: Vec<Surface> = all.collect();
    all.sort_by(|a, b| a.coordinate.total_cmp(&b.coordinate));
    Ok(all)
}

/// A nodal value between the nodes of a surface, linear; none beyond its outermost nodes.
fn between(nodes: &[Surface], at: f64, value: impl Fn(&Surface) -> f64) -> Option<f64> {
    if nodes.first().is_some_and(|first| at < first.coordinate) {
        return None;
    }
    let pair = nodes.windows(2).find(|pair| at <= pair[1].coordinate)?;
    let t = (at - pair[0].coordinate) / (pair[1].coordinate - pair[0].coordinate);
    Some(value(&pair[0]) + t * (value(&pair[1]) - value(&pair[0])))
}
