//! Places of a body at which its stress has no limit: forces and supports at points, contacts whose pressure has none,
//! and corners.
//!
//! At a corner of interior angle θ stresses grow as `r^(λ−1)`, and λ < 1 from an angle on that the sides beside it tell
//! (Williams 1952):
//!
//! | sides | θ above |
//! |---|---|
//! | both free, or both fixed | π |
//! | one fixed along its normal, the other one too, free or fixed | π/2 |
//! | one free, one fixed | `arcsin √((κ+1)/4)`, 57° in plane strain with ν = 0.3 |
//! | one fixed in another direction | π/4, the smallest there is: of wider ones it may be |
//!
//! A side fixed along its normal is a line of symmetry, beside which the corner is one of 2θ. Finite tractions change
//! none of it but where the shear stress τ on a smooth side leaps: there `σ = (2 Δτ/π) ln 1/r` along the side, Δτ being
//! 2τ beside a line of symmetry at a right angle. On a line of symmetry itself it is `(κ+3)/(κ+1) Δτ/π ln 1/r`
//! (Kelvin's force in the whole plane, twice τ a length), Δτ being 2τ where two such lines meet at a right angle.

use std::collections::{BTreeMap, HashSet};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use crate::elasticity::loads::{self, Traction};
use crate::elasticity::point::shapes_at;
use crate::elasticity::shape_functions;
use crate::error::Error;
use crate::measure::larger;
use crate::mesh::{Edge, candidates};
use crate::scene::{Load, Place};
use crate::solve::outline::{Outline, TURN};
use crate::solve::unbounded;
use crate::solve::{Discretisation, Run};

/// Part of the largest force that a support at a point must exert to leave a stress without limit.
const AT_POINT: f64 = 1e-6;
/// Leap of a shear stress, over the largest traction, from which on it leaves a stress without limit.
const LEAP: f64 = 1e-3;

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
const OBLIQUE: &str = "what may be such a corner, a side of it held obliquely,";
const SHEAR: &str = "a shear stress on a side that ends";

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
    /// The places of a body at which its stress has no limit, under the displacements of all nodes \[mm\] that a run
    /// found.
    pub fn without_limit(&self, run: &Run, displacement: &[[f64; 2]], body: usize) -> Result<Vec<WithoutLimit>, Error> {
        let mut all = self.at_points(run, displacement, body)?;
        for (contact, pair) in
            self.scene.contacts.iter().enumerate().filter(|(_, pair)| pair.bodies().any(|own| own == body))
        {
            let Some(strongest) = run.contacts[contact].unbounded else { continue };
            let told = unbounded::told(self, run, contact)?.into_iter().chain([strongest]);
            let side = |s: f64| if pair.path.has_both_sides() { s } else { s.abs() };
            let nodes: Vec<usize> =
                candidates::facing_edges(&self.mesh, &self.scene, pair, body)?.into_iter().flatten().collect();
            for place in told.map(|one| one.position.value()) {
                let away = |node: usize| (side(pair.path.coordinate(self.mesh.points[node])) - side(place)).abs();
                let nearest = nodes.iter().copied().min_by(|a, b| away(*a).total_cmp(&away(*b)));
                all.extend(nearest.map(|node| self.at_node(node, PRESSURE)));
            }
        }
        all.extend(self.corners(body));
        all.extend(self.shear_ends(body)?);
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
    fn corners(&self, body: usize) -> Vec<WithoutLimit> {
        let outline = Outline::of(self, body);
        let material = &self.scene.bodies[body].material;
        let kolosov = self.scene.plane.kolosov(material.poisson);
        let is_wide = |node: usize| {
            let sides = sides(&outline, outline.at(node)?);
            let [before, after] = outline.next_turns(node);
            let angle = outline.angle(node)? - before.max(0.0) - after.max(0.0);
            let is_wide = angle > widest(sides, kolosov) + TURN;
            let because = if sides.contains(&Side::Oblique) { OBLIQUE } else { CORNER };
            (is_wide && !(outline.is_smooth(node) && sides[0] == sides[1])).then(|| self.at_node(node, because))
        };
        outline.nodes().into_iter().filter_map(is_wide).collect()
    }

    /// Where the shear stress on a smooth side leaps, since a load ends there, be it within an element, or at a line of
    /// symmetry.
    fn shear_ends(&self, body: usize) -> Result<Vec<WithoutLimit>, Error> {
        use Side::{Free, Normal};
        let outline = Outline::of(self, body);
        let loads = loads::tractions(&self.scene, &self.mesh, body)?;
        let size = |[x, y]: [f64; 2]| x.hypot(y);
        let largest = loads.iter().flatten().flat_map(|one| one.ends).map(|(_, t)| size(t)).fold(0.0, f64::max);
        let shear = |edge: &Edge, (xi, [x, y]): (f64, [f64; 2])| {
            let [dx, dy] = outline.tangent(edge, xi);
            x * dx + y * dy
        };
        let leap = |node: usize| {
            let edges = outline.at(node)?;
            // What acts on both edges is smooth there.
            let of_load = |of: &Vec<Traction>| {
                let at = |side: usize| of.iter().find_map(|one| one.at(edges[side], 1 - side));
                match [at(0), at(1)] {
                    [Some(arriving), None] => [0.0 - shear(edges[0], (1.0, arriving)), 0.0],
                    [None, Some(leaving)] => [0.0, shear(edges[1], (-1.0, leaving))],
                    _ => [0.0; 2],
                }
            };
            let [before, after] = loads.iter().map(of_load).fold([0.0; 2], |[a, b], [c, d]| [a + c, b + d]);
            let is_right = || outline.angle(node).is_some_and(|angle| (angle - FRAC_PI_2).abs() <= TURN);
            match sides(&outline, edges) {
                [Free, Free] | [Normal, Normal] if outline.is_smooth(node) => Some(before + after),
                [Free, Normal] if is_right() => Some(2.0 * (before - after)),
                [Normal, Free] if is_right() => Some(2.0 * (after - before)),
                // Mirrored at both, either is a line of forces in the whole plane, which turn round there.
                [Normal, Normal] if is_right() => Some(2.0 * larger(before.abs(), after.abs())),
                _ => None,
            }
        };
        let has_leap = |leap: f64| leap.abs() > LEAP * largest;
        let at_nodes = outline.nodes().into_iter().filter(|&node| leap(node).is_some_and(has_leap));
        let mut all: Vec<WithoutLimit> = at_nodes.map(|node| self.at_node(node, SHEAR)).collect();
        // Loads that follow one another within an edge leave no leap.
        let mut within: BTreeMap<usize, Vec<(f64, f64)>> = BTreeMap::new();
        for one in loads.iter().flatten() {
            let Some(edge) = outline.leaving.get(&one.edge[0]) else { continue };
            for end in [0, 1].into_iter().filter(|end| !one.reaches(*end)) {
                let leap = shear(edge, one.ends[end]) * if end == 0 { 1.0 } else { -1.0 };
                within.entry(edge[0]).or_default().push((one.ends[end].0, leap));
            }
        }
        for (node, mut leaps) in within {
            let edge = &outline.leaving[&node];
            leaps.sort_by(|a, b| a.0.total_cmp(&b.0));
            for near in leaps.chunk_by(|a, b| b.0 - a.0 <= loads::UNSEEN) {
                if has_leap(near.iter().map(|(_, leap)| leap).sum()) {
                    let (_, at, _) = shape_functions::on_edge(&self.mesh, edge, near[0].0);
                    all.push(WithoutLimit { at, nodes: edge[..2].to_vec(), because: SHEAR });
                }
            }
        }
        Ok(all)
    }
}

/// How the edges that arrive at a node and leave it are fixed there.
fn sides(outline: &Outline, [arriving, leaving]: [&Edge; 2]) -> [Side; 2] {
    [side(outline, arriving, 1.0, arriving[0]), side(outline, leaving, -1.0, leaving[1])]
}

/// How an edge is fixed at ξ, its other end at a node. An edge of an arc turns away from it by half of what edges turn
/// at that node.
fn side(outline: &Outline, edge: &Edge, xi: f64, other: usize) -> Side {
    let direction = match outline.fixed(edge) {
        [false, false] => return Side::Free,
        [true, true] => return Side::Fixed,
        [true, false] => 0,
        [false, true] => 1,
    };
    let of_arc = if outline.is_smooth(other) { 0.5 * outline.turn(other).abs() } else { 0.0 };
    let along = outline.tangent(edge, xi)[direction].abs();
    if along <= TURN + of_arc { Side::Normal } else { Side::Oblique }
}
