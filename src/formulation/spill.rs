//! Contact that goes on beyond the last candidate: the pressure found is that of a shorter body, and is refused.

use crate::error::Error;
use crate::formulation::{Change, Discretisation};
use crate::scene::Profile;
use crate::solution::Solution;

/// Difference of contact coordinates, relative, that rounding explains.
const SAME: f64 = 1e-9;

/// How deep the surfaces penetrate beyond the last candidate, at the worst node.
#[derive(Clone, Copy, Debug)]
pub struct Spill {
    /// Contact coordinate of the last candidate \[mm, or rad on an arc\].
    pub end: f64,
    /// Contact coordinate of the node \[mm, or rad on an arc\].
    pub position: f64,
    /// Penetration `w − g` there \[mm\]; negative is a gap.
    pub penetration: f64,
}

/// The deepest penetration beyond the candidates of a solution whose last point is closed, its gap being no more than the
/// length accepted, or beyond whose last point the initial gap narrows again.
///
/// None where the last point is open and the gap goes on widening, and where the surface of either body ends with the
/// candidates: a patch, a ring, a punch.
pub fn deepest(
    discretisation: &Discretisation,
    solution: &Solution,
    change: Change,
    accepted: f64,
) -> Result<Option<Spill>, Error> {
    let pair = &discretisation.scene.contact;
    let Some(last) = discretisation.interface.stations.last() else { return Ok(None) };
    let end = last.coordinate;
    let surfaces: Vec<Vec<Surface>> =
        pair.bodies().map(|body| surface(discretisation, body)).collect::<Result<_, _>>()?;
    let beyond = |node: &&Surface| node.coordinate > end * (1.0 + SAME);
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
    let closed = solution.points.last().is_some_and(|point| point.gap <= accepted);
    let narrows = || surfaces[0].iter().filter(beyond).filter_map(gap).any(|gap| gap <= last.gap);
    if !closed && !narrows() {
        return Ok(None);
    }
    let unknowns = discretisation.condensed.recover_under(change.load, &solution.displacement);
    let displacement = discretisation.system.nodal_displacements(&unknowns);
    let outward =
        |node: &Surface| node.normal[0] * displacement[node.node][0] + node.normal[1] * displacement[node.node][1];
    let depth = |node: &Surface| {
        let facing = match surfaces.get(1) {
            None => 0.0,
            // Both normals are those of the first body: the second body's outward one is their opposite.
            Some(other) => -between(other, node.coordinate, outward)?,
        };
        let penetration = outward(node) + facing - gap(node)? - change.clearance;
        Some(Spill { end, position: node.coordinate, penetration })
    };
    let depths = surfaces[0].iter().filter(beyond).filter_map(depth);
    Ok(depths.max_by(|a, b| a.penetration.total_cmp(&b.penetration)))
}

/// Refuses a solution whose contact goes on beyond the candidates, by the criterion of the candidates themselves:
/// penetration over `g_ref` within the tolerance.
///
/// Beyond steeply growing elements the next node may lie where the surfaces have parted again. A contact cut short shows all
/// the same: its pressure rises towards the cut, as under the corner of a punch, where a contact that ends falls to zero.
pub(super) fn refuse(
    discretisation: &Discretisation,
    solution: &Solution,
    change: Change,
    tolerance: f64,
) -> Result<(), Error> {
    let accepted = tolerance * discretisation.scene.reference.gap;
    match deepest(discretisation, solution, change, accepted)? {
        Some(Spill { end, position, penetration }) if penetration.is_nan() || penetration > accepted => {
            Err(Error::ContactBeyondCandidates { bodies: discretisation.names(), end, position, penetration })
        }
        Some(Spill { end, penetration, .. }) if penetration.is_finite() && rises(solution, tolerance) => {
            Err(Error::ContactCutShort { bodies: discretisation.names(), end })
        }
        _ => Ok(()),
    }
}

/// Whether the mean pressure of the last edge is above that of the one before by more than the tolerance explains.
fn rises(solution: &Solution, tolerance: f64) -> bool {
    match solution.edges[..] {
        [.., before, last] => last.pressure > before.pressure * (1.0 + tolerance.sqrt()),
        _ => false,
    }
}

/// A node of a body's contact boundary.
struct Surface {
    node: usize,
    coordinate: f64,
    normal: [f64; 2],
}

/// Nodes of the contact boundary of a body, by contact coordinate, with the normals of the first body.
fn surface(discretisation: &Discretisation, body: usize) -> Result<Vec<Surface>, Error> {
    let (scene, mesh) = (&discretisation.scene, &discretisation.mesh);
    let pair = &scene.contact;
    let mut nodes: Vec<usize> = mesh.boundary(scene, body, "contact")?.iter().flatten().copied().collect();
    nodes.sort_unstable();
    nodes.dedup();
    let all = nodes.into_iter().map(|node| {
        let point = mesh.points[node];
        Surface { node, coordinate: pair.path.coordinate(point), normal: pair.normal(point) }
    });
    let mut all: Vec<Surface> = all.collect();
    all.sort_by(|a, b| a.coordinate.total_cmp(&b.coordinate));
    Ok(all)
}

/// A nodal value between the nodes of a surface, linear; none beyond its last node.
fn between(nodes: &[Surface], at: f64, value: impl Fn(&Surface) -> f64) -> Option<f64> {
    let pair = nodes.windows(2).find(|pair| at <= pair[1].coordinate)?;
    let t = (at - pair[0].coordinate) / (pair[1].coordinate - pair[0].coordinate);
    Some(value(&pair[0]) + t * (value(&pair[1]) - value(&pair[0])))
}
