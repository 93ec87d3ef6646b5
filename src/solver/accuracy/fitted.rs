//! Where the contact found on a mesh begins and ends, and meshes fitted to it: its ends at a fixed place within an
//! element, so that errors fall smoothly with the mesh.
//!
//! On a mesh that does not know the contact its end lies anywhere within an element, and the error of the second-moment
//! width wanders with it by several times its mean: on truncated Hertz with 8 8-node cells per half-width from −0.20 %
//! to +0.14 %. With the end at one and the same place of the element it falls with the square of the element.
//!
//! A contact across x = 0 need not lie in its middle, and the candidates are the same on both sides of it. In geometric
//! progression from x = 0 on they have both ends at that place.

use crate::measure::ACTIVE;
use crate::mesh::{Order, Resolution};
use crate::scene::{Grading, Scene};
use crate::solve::run::Run;

/// Where the contact ends, in elements beyond the end of its last whole one.
///
/// An eighth before it. The points of 8-node cells that are pressed change where the contact ends a little beyond a
/// corner or a middle, and the error leaps there; here it is as far from either as it is small (truncated Hertz: +0.05
/// % in the half-width on 8 elements, against −0.2 % to +0.14 % over all places).
const INTO: f64 = -0.125;
/// Last element within the contact over the first one, or the first over the last, that is not exceeded for its inner
/// end.
const GRADED: f64 = 3.0;
/// Growth along the surface and into the depth at level 0, and the coarsest element over the body.
const STEEPEST: [f64; 3] = [4.0, 3.5, 1.0];
/// The coarsest element where a body bends: an arc's cell then spans at most 32°. With 1.0 one cell reached from 90° to
/// 180° of a ring on every mesh of the search, and 53 of 176 accuracies called met were not; with this none.
const BENDING: f64 = 0.35;
/// Elements in the contact up to which growth is the steepest, and fewest of an answer.
pub(super) const FEWEST: usize = 3;
/// Elements of the first mesh with bars over the reciprocal root of the error asked for.
const BEGIN: f64 = 0.2;
/// Part of the contact's length by which one that was too short is lengthened on each side.
const WIDER: f64 = 0.05;
/// Order of the cells.
pub(super) const ORDER: Order = Order::Quadratic;

/// Level of growth of a mesh with so many elements in the contact: halving those, the logarithm of the growth falls by
/// √2, as it does from mesh to mesh of a refinement.
///
/// What growth leaves falls with the fourth power of its logarithm, what the elements leave with their square.
pub fn level(elements: usize) -> f64 {
    (elements as f64 / FEWEST as f64).log2().max(0.0)
}

/// Elements in the contact with which to begin.
pub(super) fn elements(asked: f64) -> usize {
    ((BEGIN / asked.sqrt()).ceil() as usize).max(FEWEST)
}

/// Meshes fitted to the contact of a scene as it is known so far.
pub(super) struct Fitted {
    pub(super) scene: Scene,
    /// Longest candidate stretch that the bodies allow.
    pub(super) longest: f64,
    /// Where the contact begins and ends.
    pub(super) ends: [f64; 2],
}

impl Fitted {
    /// A mesh with so many elements within the contact.
    pub(super) fn plan(&self, elements: usize) -> Plan {
        Plan::around(self.ends, self.longest, elements, ORDER, level(elements))
    }

    /// Takes the ends of the contact from a run, unless an outermost candidate is pressed although the bodies allow
    /// more: the penetration beyond it is seen at nodes only, and the next one may lie where the surfaces have parted
    /// again.
    pub(super) fn looks(&mut self, scene: &Scene, run: &Run) -> bool {
        let is_short = scene.contact().stretch < self.longest * (1.0 - 1e-9) && is_filled(run, 0);
        if is_short {
            return self.widens();
        }
        self.ends = ends(run, 0);
        false
    }

    /// Makes the contact known longer; whether the bodies allow it.
    pub(super) fn widens(&mut self) -> bool {
        let [begin, edge] = self.ends;
        let more = WIDER * (edge - begin);
        self.ends = [(begin - more).max(-self.longest), (edge + more).min(self.longest)];
        self.ends != [begin, edge]
    }
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
    pub level: f64,
}

impl Plan {
    /// So many equal elements over a stretch.
    pub fn even(order: Order, elements: usize, stretch: f64, level: f64) -> Self {
        Self { order, elements, candidates: elements, stretch, end: 1.0, level }
    }

    /// So many elements within half of a contact between its ends, and a quarter as many beyond the outer one, within
    /// the longest stretch; where the contact begins on a symmetry line, that is the middle between its ends.
    pub fn around([begin, edge]: [f64; 2], longest: f64, elements: usize, order: Order, level: f64) -> Self {
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

    /// Growth along the surface and into the depth: `q₀^(2^(−level/2))`.
    pub fn growth(&self) -> [f64; 2] {
        let [along, depth, _] = STEEPEST;
        [along, depth].map(|growth| growth.powf(self.slower()))
    }

    /// Over those of level 0, the logarithm of the growth and the coarsest element.
    fn slower(&self) -> f64 {
        0.5_f64.powf(0.5 * self.level)
    }

    /// The scene on this mesh, and how fine it is.
    pub fn laid(&self, scene: &Scene) -> (Scene, Resolution) {
        let mut fitted = scene.clone();
        let [along, depth] = self.growth();
        let coarsest = self.slower() * if scene.bends() { BENDING } else { STEEPEST[2] };
        let unit = self.stretch * scene.contact().path.metric() * self.elements as f64 / self.candidates as f64;
        fitted.grading = Grading { unit, along, depth, first: 1.0, coarsest, end: self.end };
        fitted.contacts[0].stretch = self.stretch;
        (fitted, Resolution { elements: self.elements, refinement: 0, order: self.order })
    }
}

/// How far so many elements of a side reach, over its first one, of which each is `e^slope` times the one before.
fn reach(slope: f64, elements: f64) -> f64 {
    if slope.abs() < 1e-9 { elements } else { (slope * elements).exp_m1() / slope.exp_m1() }
}

/// Slope at which the inner end of a contact, over the outer one, lies at its place in elements, as the outer one does;
/// 0 where none within [`GRADED`] does.
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

/// Candidate elements within a contact, from the symmetry line on where there is one, and from x = 0 to its outer end.
pub fn pressed(run: &Run, contact: usize) -> [usize; 2] {
    let (edges, measures) = (run.solution.edges_of(contact), &run.contacts[contact].measures);
    let floor = ACTIVE * measures.largest.pressure;
    let first = edges.iter().position(|edge| edge.pressure > floor);
    let last = edges.iter().rposition(|edge| edge.pressure > floor);
    let (Some(first), Some(last)) = (first, last) else { return [0, 0] };
    if !measures.across {
        return [last + 1, last + 1];
    }
    let middle = edges.len() / 2;
    [last + 1 - first, (last + 1).saturating_sub(middle).max(middle.saturating_sub(first))]
}

/// Whether it reaches an outermost candidate; on a symmetry line it does not end.
pub fn is_filled(run: &Run, contact: usize) -> bool {
    let stretches = &run.contacts[contact].measures.stretches;
    stretches.first().is_some_and(|one| one.reaches[0]) || stretches.last().is_some_and(|one| one.reaches[1])
}

/// Where it begins and ends \[mm, or rad\]: as far to the left as to the right of a symmetry line. NaN where there is
/// none.
pub fn ends(run: &Run, contact: usize) -> [f64; 2] {
    let measures = &run.contacts[contact].measures;
    match measures.stretches.first() {
        None => [f64::NAN; 2],
        Some(first) if measures.across => [first.begin, measures.edge()],
        Some(_) => [-measures.edge(), measures.edge()],
    }
}
