//! Meshes fitted to the contact: its end at a fixed place within an element, so that errors fall smoothly with the mesh.
//!
//! On a mesh that does not know the contact its end lies anywhere within an element, and the error of the half-width
//! wanders with it by several times its mean: on truncated Hertz with 8 8-node cells per half-width from −0.20 % to
//! +0.14 %. With the end at one and the same place of the element it falls with the square of the element.

use crate::mesh::{Order, Resolution};
use crate::scene::{Grading, Profile, Scene, Shape};
use crate::solution::{PointState, Solution};

/// Where the contact ends, in elements beyond the end of its last whole one.
///
/// An eighth before it. The points of 8-node cells that are pressed change where the contact ends a little beyond a corner
/// or a middle, and the error leaps there; here it is as far from either as it is small (truncated Hertz: +0.05 % in the
/// half-width on 8 elements, against −0.2 % to +0.14 % over all places).
const INTO: f64 = -0.125;
/// Gentlest growth of an answer: 4^(1/16).
pub const LEVELS: u32 = 8;
/// Growth along the surface and into the depth at level 0, and the coarsest element over the body.
const STEEPEST: [f64; 3] = [4.0, 3.5, 1.0];

/// Level of growth with which to begin: on Hertz scenes it takes about a quarter of the relative error asked for.
///
/// Level 0 leaves about 0.3 % in peak and half-width of truncated Hertz, and the error falls with the fourth power of the
/// logarithm. Whatever the scene, the growth is judged afterwards.
pub fn level(asked: f64) -> u32 {
    (0.5 * (0.012 / asked).log2()).round().max(0.0) as u32
}

/// A mesh by what it costs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plan {
    /// Element order.
    pub order: Order,
    /// Elements within the contact.
    pub elements: usize,
    /// Candidate elements.
    pub candidates: usize,
    /// Candidate stretch \[mm, or rad\].
    pub stretch: f64,
    /// Level of growth: every two levels the logarithm of the growth is halved.
    pub level: u32,
}

impl Plan {
    /// So many equal elements over a stretch.
    pub fn even(order: Order, elements: usize, stretch: f64, level: u32) -> Self {
        Self { order, elements, candidates: elements, stretch, level }
    }

    /// So many elements within a contact that ends at `edge`, and a quarter as many beyond it, within the longest stretch.
    pub fn around(edge: f64, longest: f64, elements: usize, order: Order, level: u32) -> Self {
        let size = edge / (elements as f64 + INTO);
        let candidates = elements + elements.div_ceil(4);
        let stretch = size * candidates as f64;
        if stretch <= longest {
            return Self { order, elements, candidates, stretch, level };
        }
        let candidates = ((longest / size).ceil() as usize).max(1);
        Self { order, elements, candidates, stretch: longest, level }
    }

    /// Growth along the surface, into the depth, and the coarsest element over the body: `q₀^(2^(−level/2))`.
    pub fn growth(&self) -> [f64; 3] {
        let slower = 0.5_f64.powf(0.5 * f64::from(self.level));
        let [along, depth, coarsest] = STEEPEST;
        [along.powf(slower), depth.powf(slower), coarsest * slower]
    }

    /// The scene on this mesh.
    pub fn scene(&self, scene: &Scene) -> Scene {
        let mut fitted = scene.clone();
        let [along, depth, coarsest] = self.growth();
        let unit = self.stretch * scene.contact().path.metric() * self.elements as f64 / self.candidates as f64;
        fitted.grading = Grading { unit, along, depth, first: 1.0, coarsest, end: 1.0 };
        fitted.contacts[0].stretch = self.stretch;
        fitted
    }

    /// How fine it is.
    pub fn resolution(&self) -> Resolution {
        Resolution { elements: self.elements, refinement: 0, order: self.order }
    }
}

/// Longest candidate stretch that the sides of the bodies and the gap allow \[mm, or rad\].
pub fn longest(scene: &Scene) -> f64 {
    let pair = scene.contact();
    let straight = pair.path.is_straight();
    let side = |body: usize| match scene.bodies[body].shape {
        Shape::Rectangle { x, .. } => x[1] - x[0],
        Shape::Disc { radius, .. } if straight => radius * std::f64::consts::FRAC_1_SQRT_2,
        Shape::Ring { sweep, .. } => sweep.min(std::f64::consts::FRAC_PI_2),
        Shape::Disc { .. } | Shape::Eye { .. } => std::f64::consts::FRAC_PI_2,
        Shape::Blocks(_) | Shape::Given(_) => f64::INFINITY,
    };
    let gap = match &pair.profile {
        Profile::Punch { half_width } => *half_width,
        Profile::Table(points) => points.last().map_or(0.0, |[s, _]| *s),
        Profile::Circle { radius } => radius * std::f64::consts::FRAC_1_SQRT_2,
        // Beyond the trough the next crest comes near.
        Profile::Cosine { wavelength, .. } => 0.5 * wavelength,
        _ => f64::INFINITY,
    };
    pair.bodies().map(side).fold(gap, f64::min)
}

/// Pressure over the largest one from which on a point or an element counts as pressed: iterations that stop at a residual
/// leave less outside the contact.
const FAINT: f64 = 1e-3;

/// Candidate elements that carry force, up to the last one.
pub fn pressed(solution: &Solution) -> usize {
    last_pressed(&solution.edges).map_or(0, |last| last + 1)
}

/// Whether the contact goes on to the last candidate.
pub fn filled(solution: &Solution) -> bool {
    last_pressed(&solution.points).is_some_and(|last| last + 1 == solution.points.len())
}

fn last_pressed(states: &[PointState]) -> Option<usize> {
    let most = states.iter().map(|state| state.pressure).fold(0.0, f64::max);
    states.iter().rposition(|state| state.pressure > FAINT * most)
}

/// Where the contact ends \[mm, or rad\].
///
/// Near a smooth end `p ∝ √(a − s)`, so that the force beyond s, `F = ∫ p ds`, goes with `(a − s)^{3/2}`: `F^{2/3}` at the
/// corners of the last elements, as a polynomial through up to three of them, vanishes at a. The element in which the
/// contact ends has felt the end most and is left out where there are enough others.
pub fn edge(solution: &Solution, stretch: f64) -> f64 {
    let edges = &solution.edges;
    let Some(last) = last_pressed(edges) else { return f64::NAN };
    let size = stretch / edges.len() as f64;
    let beyond = |from: usize| -> f64 { edges[from..=last].iter().map(force).sum() };
    let begin = |k: usize| size * k as f64;
    let newest = if last >= 3 { last - 1 } else { last };
    let nodes: Vec<[f64; 2]> =
        (newest.saturating_sub(2)..=newest).map(|k| [beyond(k).powf(2.0 / 3.0), begin(k)]).collect();
    let at_zero = (0..nodes.len()).map(|i| {
        let others = (0..nodes.len()).filter(|&k| k != i);
        others.fold(nodes[i][1], |term, k| term * nodes[k][0] / (nodes[k][0] - nodes[i][0]))
    });
    let found: f64 = at_zero.sum();
    // One element alone, or a profile that does not end smoothly, says no more than where the last element is.
    let (low, high) = (begin(last), begin(last + 1) + size);
    if nodes.len() > 1 && found.is_finite() { found.clamp(low, high) } else { begin(last + 1) }
}

fn force(edge: &PointState) -> f64 {
    edge.weight * edge.pressure
}
