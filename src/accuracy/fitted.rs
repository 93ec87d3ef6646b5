//! Meshes fitted to the contact: its ends at a fixed place within an element, so that errors fall smoothly with the mesh.
//!
//! On a mesh that does not know the contact its end lies anywhere within an element, and the error of the half-width
//! wanders with it by several times its mean: on truncated Hertz with 8 8-node cells per half-width from −0.20 % to
//! +0.14 %. With the end at one and the same place of the element it falls with the square of the element.
//!
//! A contact across x = 0 need not lie in its middle, and the candidates are the same on both sides of it. In geometric
//! progression from x = 0 on they have both ends at that place.

use crate::mesh::{Order, Resolution};
use crate::scene::{Grading, Scene};

/// Where the contact ends, in elements beyond the end of its last whole one.
///
/// An eighth before it. The points of 8-node cells that are pressed change where the contact ends a little beyond a corner
/// or a middle, and the error leaps there; here it is as far from either as it is small (truncated Hertz: +0.05 % in the
/// half-width on 8 elements, against −0.2 % to +0.14 % over all places).
const INTO: f64 = -0.125;
/// Last element within the contact over the first one, or the first over the last, that is not exceeded for its inner end.
const GRADED: f64 = 3.0;
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
    /// Elements within the contact, within half of it where it has both sides.
    pub elements: usize,
    /// Candidate elements on each side of x = 0 that has any.
    pub candidates: usize,
    /// Candidate stretch \[mm, or rad\].
    pub stretch: f64,
    /// Last candidate element of a side over the first one.
    pub end: f64,
    /// Level of growth: every two levels the logarithm of the growth is halved.
    pub level: u32,
}

impl Plan {
    /// So many equal elements over a stretch.
    pub fn even(order: Order, elements: usize, stretch: f64, level: u32) -> Self {
        Self { order, elements, candidates: elements, stretch, end: 1.0, level }
    }

    /// So many elements within half of a contact between its ends, and a quarter as many beyond the outer one, within the
    /// longest stretch; where the contact begins on a symmetry line, that is the middle between its ends.
    pub fn around([begin, edge]: [f64; 2], longest: f64, elements: usize, order: Order, level: u32) -> Self {
        let [inner, outer] = [edge.min(-begin), edge.max(-begin)];
        // Where the outer end is that of the longest stretch, elements end there too.
        let (into, beyond) = if outer < longest { (INTO, elements.div_ceil(4)) } else { (0.0, 0) };
        let wanted = (elements as f64 + into) * 2.0 * outer / (edge - begin);
        let within = (wanted - into).round().max(1.0);
        let place = within + into;
        let slope = slope(inner / outer, [(place * inner / outer - INTO).round() + INTO, place]);
        let candidates = within as usize + beyond;
        let stretch = outer * reach(slope, candidates as f64) / reach(slope, place);
        if stretch <= longest * (1.0 + 1e-9) {
            let end = (slope * (candidates as f64 - 1.0)).exp();
            return Self { order, elements, candidates, stretch: stretch.min(longest), end, level };
        }
        let candidates = ((longest * place / outer).ceil() as usize).max(1);
        Self { order, elements, candidates, stretch: longest, end: 1.0, level }
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
        fitted.grading = Grading { unit, along, depth, first: 1.0, coarsest, end: self.end };
        fitted.contacts[0].stretch = self.stretch;
        fitted
    }

    /// How fine it is.
    pub fn resolution(&self) -> Resolution {
        Resolution { elements: self.elements, refinement: 0, order: self.order }
    }
}

/// How far so many elements of a side reach, over its first one, of which each is `e^slope` times the one before.
fn reach(slope: f64, elements: f64) -> f64 {
    if slope.abs() < 1e-9 { elements } else { (slope * elements).exp_m1() / slope.exp_m1() }
}

/// Slope at which the inner end of a contact, over the outer one, lies at its place in elements, as the outer one does; 0
/// where none within [`GRADED`] does.
///
/// An inner end on the side of the outer one counts as negative.
fn slope(inner: f64, places: [f64; 2]) -> f64 {
    let at = |slope: f64| places[0].signum() * reach(slope, places[0].abs()) / reach(slope, places[1]);
    let steepest = GRADED.ln() / places[1].max(1.0);
    // Growing elements draw the inner end towards x = 0.
    let short = |slope: f64| at(slope).abs() < inner.abs();
    if places[0].abs() >= places[1] || inner * places[0] <= 0.0 || short(-steepest) || !short(steepest) {
        return 0.0;
    }
    let (mut low, mut high) = (-steepest, steepest);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        *if short(middle) { &mut high } else { &mut low } = middle;
    }
    low
}
