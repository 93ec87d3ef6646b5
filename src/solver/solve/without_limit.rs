//! Places of a body at which its stress has no limit: forces and supports at points, contacts whose pressure has none, and corners.
//!
//! At a corner of interior angle θ stresses grow as `r^(λ−1)`, and λ < 1 from an angle on that the sides beside it tell (Williams 1952):
//!
//! | sides | θ above |
//! |---|---|
//! | both free, or both fixed | π |
//! | one fixed along its normal, the other one too, free or fixed | π/2 |
//! | one free, one fixed | `arcsin √((κ+1)/4)`, 57° in plane strain with ν = 0.3 |
//! | one fixed in another direction | π/4, the smallest there is |
//!
//! A side fixed along its normal is a line of symmetry, beside which the corner is one of 2θ. Finite tractions change none of it; where
//! shear on a side ends, stresses grow as a logarithm, which is not looked for.

use std::collections::{HashMap, HashSet};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use crate::elasticity::axis;
use crate::error::Error;
use crate::mesh::{Edge, candidates};
use crate::scene::{Load, Place};
use crate::solve::corner::tangent;
use crate::solve::{Discretisation, Run};

/// Part of the largest force that a support at a point must exert to leave a stress without limit.
const AT_POINT: f64 = 1e-6;
/// Angle that rounding explains \[rad\].
const ROUNDING: f64 = 1e-6;
/// Cosine of the angle between the direction in which a side is fixed and its normal, from which on they are one.
const NORMAL: f64 = 1.0 - 1e-6;

/// A node at which the stress of its body has no limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WithoutLimit {
    /// Node of the mesh.
    pub node: usize,
    /// What makes it so.
    pub because: &'static str,
}

const FORCE: &str = "a force at a point";
const SUPPORT: &str = "a support at a point";
pub(super) const PRESSURE: &str = "a contact pressure without limit";
const CORNER: &str = "a corner";

/// How a side of a body is fixed.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Side {
    /// Not at all, whatever acts on it.
    Free,
    /// Along its normal.
    Normal,
    /// In another direction.
    Oblique,
    /// In both directions.
    Fixed,
}

/// Largest angle between two sides at which the stress has a limit, κ Kolosov's constant \[rad\].
fn widest(sides: [Side; 2], kolosov: f64) -> f64 {
    use Side::{Fixed, Free, Normal, Oblique};
    match sides {
        [Free, Free] | [Fixed, Fixed] => PI,
        [Oblique, _] | [_, Oblique] => FRAC_PI_4,
        [Normal, _] | [_, Normal] => FRAC_PI_2,
        [Free, Fixed] | [Fixed, Free] => (0.25 * (kolosov + 1.0)).min(1.0).sqrt().asin(),
    }
}

impl Discretisation {
    /// The nodes of a body at which its stress has no limit, under the displacements of all nodes \[mm\] that a run found.
    pub fn without_limit(&self, run: &Run, displacement: &[[f64; 2]], body: usize) -> Result<Vec<WithoutLimit>, Error> {
        let mut all = self.at_points(run, displacement, body)?;
        let contacts = self.scene.contacts.iter().zip(&run.contacts);
        for (pair, found) in contacts.filter(|(pair, _)| pair.bodies().any(|own| own == body)) {
            let Some(place) = found.unbounded.map(|unbounded| unbounded.position.value()) else { continue };
            let away = |node: usize| (pair.path.coordinate(self.mesh.points[node]).abs() - place.abs()).abs();
            let nodes = candidates::facing_edges(&self.mesh, &self.scene, pair, body)?.into_iter().flatten();
            let nearest = nodes.min_by(|a, b| away(*a).total_cmp(&away(*b)));
            all.extend(nearest.map(|node| WithoutLimit { node, because: PRESSURE }));
        }
        all.extend(self.corners(body));
        let mut seen = HashSet::new();
        all.retain(|one| seen.insert(one.node));
        Ok(all)
    }

    /// Nodes at which a force acts, or a support at a point exerts one.
    fn at_points(&self, run: &Run, displacement: &[[f64; 2]], body: usize) -> Result<Vec<WithoutLimit>, Error> {
        let own = &self.scene.bodies[body];
        let mut all = Vec::new();
        for load in &own.loads {
            if let Load::Force { at, .. } = load {
                all.push(WithoutLimit { node: self.mesh.node_at(&self.scene, body, *at)?, because: FORCE });
            }
        }
        if !own.supports.iter().any(|support| matches!(support.at, Place::Point(_))) {
            return Ok(all);
        }
        let reactions = self.reactions_of(run.share(), displacement)?;
        let pressed = run.contacts.iter().map(|contact| contact.transmitted.abs());
        let largest = reactions.iter().map(|reaction| reaction.force.abs()).chain(pressed).fold(0.0, f64::max);
        for reaction in reactions.iter().filter(|one| one.body == body && one.force.abs() > AT_POINT * largest) {
            if let Place::Point(at) = own.supports[reaction.support].at {
                all.push(WithoutLimit { node: self.mesh.node_at(&self.scene, body, at)?, because: SUPPORT });
            }
        }
        Ok(all)
    }

    /// Corners of the outline that are wider than their sides allow.
    ///
    /// An arc drawn by chords turns at each of its nodes, a corner more than the nodes next to it.
    fn corners(&self, body: usize) -> Vec<WithoutLimit> {
        let outline = Outline::of(self, body);
        let material = &self.scene.bodies[body].material;
        let kolosov = self.scene.plane.kolosov(material.poisson);
        let is_wide = |node: usize| {
            let [arriving, leaving] = outline.at(node)?;
            let turn = |node: usize| outline.angle(node).map_or(0.0, |angle| angle - PI);
            let next = [arriving[0], leaving[1]].map(turn);
            let sides = [outline.side(arriving), outline.side(leaving)];
            let is_smooth = turn(node).abs() <= next[0].abs() + next[1].abs() + ROUNDING;
            let angle = outline.angle(node)? - next[0].max(0.0) - next[1].max(0.0);
            let is_wide = angle > widest(sides, kolosov) + ROUNDING;
            (is_wide && !(is_smooth && sides[0] == sides[1])).then_some(WithoutLimit { node, because: CORNER })
        };
        let mut nodes: Vec<usize> = outline.leaving.keys().copied().collect();
        nodes.sort_unstable();
        nodes.into_iter().filter_map(is_wide).collect()
    }
}

/// The outline of a body, itself to the left of every edge.
struct Outline<'a> {
    discretisation: &'a Discretisation,
    /// Edges by the node that they begin at.
    leaving: HashMap<usize, Edge>,
    /// The same by that they end at.
    arriving: HashMap<usize, Edge>,
    /// Components in which an edge is fixed, by its first and last node.
    fixed: HashMap<[usize; 2], [bool; 2]>,
}

impl<'a> Outline<'a> {
    fn of(discretisation: &'a Discretisation, body: usize) -> Self {
        let (scene, mesh) = (&discretisation.scene, &discretisation.mesh);
        let sides = mesh.order.sides();
        let cells = || mesh.bodies[body].cells.clone().map(|cell| mesh.cell(cell));
        let all: HashSet<[usize; 2]> =
            cells().flat_map(|cell| sides.each_ref().map(|side| [cell[side[0]], cell[side[1]]])).collect();
        let (mut leaving, mut arriving) = (HashMap::new(), HashMap::new());
        for (cell, side) in cells().flat_map(|cell| sides.each_ref().map(|side| (cell, side))) {
            let [from, to] = [cell[side[0]], cell[side[1]]];
            if !all.contains(&[to, from]) {
                let edge: Edge = side.iter().map(|&k| cell[k]).collect();
                leaving.insert(from, edge.clone());
                arriving.insert(to, edge);
            }
        }
        let mut fixed: HashMap<[usize; 2], [bool; 2]> = HashMap::new();
        let own = &scene.bodies[body];
        let supported = own.supports.iter().filter_map(|support| match &support.at {
            Place::Boundary(name) => Some((name, support.component)),
            Place::Point(_) => None,
        });
        let flat = own.loads.iter().filter_map(|load| match load {
            Load::RigidFace { boundary, component, .. } => Some((boundary, *component)),
            _ => None,
        });
        for (name, component) in supported.chain(flat) {
            for edge in mesh.bodies[body].boundaries.get(name).into_iter().flatten() {
                fixed.entry([edge[0], edge[1]]).or_default()[component.index()] = true;
            }
        }
        let on_axis = axis::holds(scene, mesh, body);
        for edge in leaving.values().filter(|edge| edge[..2].iter().all(|node| on_axis(*node))) {
            fixed.entry([edge[0], edge[1]]).or_default()[axis::radial(scene).index()] = true;
        }
        Self { discretisation, leaving, arriving, fixed }
    }

    /// The edges that end and begin at a node.
    fn at(&self, node: usize) -> Option<[&Edge; 2]> {
        Some([self.arriving.get(&node)?, self.leaving.get(&node)?])
    }

    /// Interior angle at a node \[rad\].
    fn angle(&self, node: usize) -> Option<f64> {
        let [arriving, leaving] = self.at(node)?;
        let points = &self.discretisation.mesh.points;
        let ([x, y], [u, v]) = (tangent(points, arriving, 1.0), tangent(points, leaving, -1.0));
        Some(PI - (x * v - y * u).atan2(x * u + y * v))
    }

    /// How an edge is fixed.
    fn side(&self, edge: &Edge) -> Side {
        let direction = match self.fixed.get(&[edge[0], edge[1]]) {
            None | Some([false, false]) => return Side::Free,
            Some([true, true]) => return Side::Fixed,
            Some([true, false]) => 0,
            Some([false, true]) => 1,
        };
        let [dx, dy] = tangent(&self.discretisation.mesh.points, edge, 0.0);
        let normal = [dy, dx][direction].abs();
        if normal >= NORMAL { Side::Normal } else { Side::Oblique }
    }
}
