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

use std::collections::HashSet;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use crate::elasticity::point::shapes_at;
use crate::error::Error;
use crate::mesh::{Edge, candidates};
use crate::scene::{Load, Place};
use crate::solve::outline::Outline;
use crate::solve::{Discretisation, Run};

/// Part of the largest force that a support at a point must exert to leave a stress without limit.
const AT_POINT: f64 = 1e-6;
/// Angle by which curved edges may turn at a node of a smooth side \[rad\]: from π on λ falls by 2/π of it (both sides free), and
/// no mesh sees `r^-0.0006`.
const TURN: f64 = 1e-3;
/// Cosine of the angle between the direction in which a side is fixed and its normal, from which on they are one.
const NORMAL: f64 = 1.0 - 1e-6;

/// A place at which the stress of a body has no limit.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct WithoutLimit {
    /// What makes it so.
    pub because: &'static str,
    /// The place \[mm\].
    #[cfg_attr(feature = "schema", schemars(description = "Where: x and y."))]
    pub at: [f64; 2],
    /// The node of the mesh that stands there, or those of the cell around it.
    #[serde(skip)]
    pub nodes: Vec<usize>,
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
    /// The places of a body at which its stress has no limit, under the displacements of all nodes \[mm\] that a run found.
    pub fn without_limit(&self, run: &Run, displacement: &[[f64; 2]], body: usize) -> Result<Vec<WithoutLimit>, Error> {
        let mut all = self.at_points(run, displacement, body)?;
        let contacts = self.scene.contacts.iter().zip(&run.contacts);
        for (pair, found) in contacts.filter(|(pair, _)| pair.bodies().any(|own| own == body)) {
            let Some(place) = found.unbounded.map(|unbounded| unbounded.position.value()) else { continue };
            let side = |s: f64| if pair.path.has_both_sides() { s } else { s.abs() };
            let away = |node: usize| (side(pair.path.coordinate(self.mesh.points[node])) - side(place)).abs();
            let nodes = candidates::facing_edges(&self.mesh, &self.scene, pair, body)?.into_iter().flatten();
            let nearest = nodes.min_by(|a, b| away(*a).total_cmp(&away(*b)));
            all.extend(nearest.map(|node| self.at_node(node, PRESSURE)));
        }
        all.extend(self.corners(body));
        let mut seen = HashSet::new();
        all.retain(|one| seen.insert(one.nodes.clone()));
        Ok(all)
    }

    fn at_node(&self, node: usize, because: &'static str) -> WithoutLimit {
        WithoutLimit { at: self.mesh.points[node], nodes: vec![node], because }
    }

    /// Points at which a force acts, or a support at a point exerts one.
    fn at_points(&self, run: &Run, displacement: &[[f64; 2]], body: usize) -> Result<Vec<WithoutLimit>, Error> {
        let own = &self.scene.bodies[body];
        let mut all = Vec::new();
        for load in &own.loads {
            if let Load::Force { at, .. } = load {
                let nodes = shapes_at(&self.scene, &self.mesh, body, *at)?.into_iter().map(|(node, _)| node).collect();
                all.push(WithoutLimit { at: *at, nodes, because: FORCE });
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
                all.push(self.at_node(self.mesh.node_at(&self.scene, body, at)?, SUPPORT));
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
            let sides = [arriving, leaving].map(|edge| side(&outline, edge));
            let is_smooth = turn(node).abs() <= next[0].abs() + next[1].abs() + TURN;
            let angle = outline.angle(node)? - next[0].max(0.0) - next[1].max(0.0);
            let is_wide = angle > widest(sides, kolosov) + TURN;
            (is_wide && !(is_smooth && sides[0] == sides[1])).then(|| self.at_node(node, CORNER))
        };
        let mut nodes: Vec<usize> = outline.leaving.keys().copied().collect();
        nodes.sort_unstable();
        nodes.into_iter().filter_map(is_wide).collect()
    }
}

/// How an edge is fixed.
fn side(outline: &Outline, edge: &Edge) -> Side {
    let direction = match outline.fixed(edge) {
        [false, false] => return Side::Free,
        [true, true] => return Side::Fixed,
        [true, false] => 0,
        [false, true] => 1,
    };
    let [dx, dy] = outline.tangent(edge, 0.0);
    let normal = [dy, dx][direction].abs();
    if normal >= NORMAL { Side::Normal } else { Side::Oblique }
}
