//! What the outlines need to know of the scene, and the positions that follow from it.

use crate::mesh::block::Point;
use crate::mesh::spacing;
use crate::mesh::{Order, Resolution};
use crate::scene::contact_pair::CONTACT;
use crate::scene::{ContactPair, Grading, Path, Scene};

/// What the outlines need to know of the scene: where the candidates end and how fine they are.
pub(crate) struct Layout<'a> {
    pub grading: &'a Grading,
    pub path: &'a Path,
    /// Candidate stretch in the contact coordinate.
    pub stretch: f64,
    /// Whether another contact lies on the side opposite to that called `contact`.
    pub opposite: bool,
    /// Contact coordinates at which nodes must lie: kinks of the gap, which no edge shall straddle.
    pub kinks: Vec<f64>,
    /// Contact coordinates at which the contact is expected to end; none where the mesh knows nothing of it.
    pub ends: Vec<f64>,
    /// The candidates of every contact of the body, where there are several that differ.
    pub several: Vec<Fine>,
    /// Elements per grading unit before refinement.
    pub elements: f64,
    /// Times the whole mesh is halved.
    pub refinement: u32,
    /// Element order.
    pub order: Order,
}

impl<'a> Layout<'a> {
    pub fn new(scene: &'a Scene, resolution: Resolution, body: usize) -> Self {
        let pair = scene.contact_of(body);
        let elements = resolution.elements as f64 * scene.bodies[body].density;
        let per_length = elements / scene.grading.unit;
        let own: Vec<Fine> = scene.contacts_of(body).map(|pair| Fine::of(pair, per_length)).collect();
        Self {
            grading: &scene.grading,
            path: &pair.path,
            stretch: pair.stretch,
            kinks: pair.profile.kinks(),
            ends: pair.ends.places.clone(),
            opposite: scene.contacts_of(body).any(|other| other.side(body) != CONTACT),
            several: if own.iter().all(|one| *one == own[0]) { vec![] } else { own },
            elements,
            refinement: resolution.refinement,
            order: resolution.order,
        }
    }

    /// Positions of the candidate stretch in the contact coordinate, from 0 on.
    pub fn candidates(&self) -> Vec<f64> {
        if !self.ends.is_empty() {
            return self.between_ends(self.ends.iter().map(|end| end.abs()), 0.0);
        }
        let n = elements_on(self.stretch * self.path.metric(), self.elements / self.grading.unit);
        spacing::broken(0.0, self.stretch, n, self.grading.end, &self.kinks)
    }

    /// Positions of the candidate stretch from a place on: the ends of the contact, as far again beyond the last, and the end of
    /// the stretch, each interval in so many elements.
    pub fn between_ends(&self, ends: impl Iterator<Item = f64>, from: f64) -> Vec<f64> {
        let mut breaks: Vec<f64> = ends.chain(self.kinks.iter().copied()).filter(|s| *s > from).collect();
        breaks.sort_by(f64::total_cmp);
        let near = SAME * self.stretch;
        breaks.retain(|s| *s < self.stretch - near);
        breaks.dedup_by(|next, before| *next - *before <= near);
        let last = breaks.last().copied().unwrap_or(from);
        let beyond = last + self.half_width();
        let wide = self.stretch - beyond > 0.5 * self.half_width();
        let all = [from].into_iter().chain(breaks).chain(wide.then_some(beyond)).chain([self.stretch]);
        let all: Vec<f64> = all.collect();
        let widest = if self.path.is_straight() { f64::INFINITY } else { WIDEST };
        let pieces = all.windows(2).map(|two| {
            let fewest = ((two[1] - two[0]) / widest - near).ceil();
            spacing::uniform(two[0], two[1], self.elements.round().max(fewest).max(1.0) as usize)
        });
        spacing::joined(&pieces.collect::<Vec<_>>())
    }

    /// Half the width of the contact that is expected: from s = 0 to its end, or half way from its first to its last.
    pub fn half_width(&self) -> f64 {
        match self.ends[..] {
            [.., last] if !self.path.has_both_sides() => last,
            [first, .., last] => 0.5 * (last - first),
            _ => self.stretch,
        }
    }

    /// Positions of the candidate stretch from `−stretch` on, with a position half way between neighbouring ends.
    pub fn across_ends(&self) -> Vec<f64> {
        let middles = self.ends.windows(2).map(|two| 0.5 * (two[0] + two[1]));
        let all: Vec<f64> = self.ends.iter().copied().chain(middles).collect();
        let beyond = self.ends[0] - self.half_width();
        let begins = (beyond + self.stretch > 0.5 * self.half_width()).then_some(beyond);
        self.between_ends(all.into_iter().chain(begins), -self.stretch)
    }

    /// Positions across a box on the contact: its ends, and half its width beyond them, or up to the end of the stretch where
    /// that is about as near; none where a kink of the gap lies outside.
    ///
    /// From the left side of the body on, or on both sides of the path's origin.
    pub fn columns_of_box(&self, left: f64) -> Option<Vec<f64>> {
        let both = self.path.has_both_sides();
        let far = (1.5 + SAME) * self.half_width();
        let [from, to] = [self.ends[0] - far, self.ends[self.ends.len() - 1] + far];
        let is_near = |s: &f64| (!both || *s >= from) && *s <= to;
        let all = if both { self.across_ends() } else { self.candidates() };
        let columns: Vec<f64> = all.into_iter().filter(is_near).collect();
        let origin = if both { self.path.origin()[0] } else { left };
        let holds_all = columns.len() > 1 && self.kinks.iter().all(is_near);
        holds_all.then(|| columns.iter().map(|s| origin + s).collect())
    }

    /// Positions of an arc: the candidates, then growing element sizes up to each of the given angles in turn.
    pub fn arc(&self, radius: f64, until: &[f64]) -> Vec<f64> {
        let mut angles: Vec<f64> = match self.path {
            _ if !self.several.is_empty() => self.angles_of_all(radius),
            Path::Straight(_) => self.candidates().iter().map(|x| (x / radius).asin()).collect(),
            Path::Arc(_) => self.candidates(),
        };
        for &end in until {
            let [before, last] = last_two(&angles);
            if end > last + 1e-9 {
                let first = (last - before) * self.grading.along;
                let more = spacing::growing(last, end, first, self.grading.along, self.grading.coarsest * 1.6);
                angles = spacing::joined(&[angles, more]);
            }
        }
        angles
    }

    /// Angles of the candidates of all contacts on an arc: every stretch ends on one, and elements are as fine as each asks.
    fn angles_of_all(&self, radius: f64) -> Vec<f64> {
        let angle = |fine: &Fine, s: f64| if fine.straight { (s / radius).asin() } else { s };
        let pieces = self.several.iter().flat_map(|one| one.pieces().map(move |[from, to]| (one, from, to)));
        let fine: Vec<[f64; 3]> =
            pieces.map(|(one, from, to)| [angle(one, from), angle(one, to), angle(one, one.size)]).collect();
        let end = fine.iter().map(|one| one[1]).fold(0.0, f64::max);
        spacing::fine_within([0.0, end], &fine, self.grading.along, self.grading.coarsest)
    }

    /// Depth positions from 0 (surface) to `depth`, starting near the size `surface` of the elements along the surface.
    pub fn depth(&self, surface: f64, depth: f64) -> Vec<f64> {
        let grading = self.grading;
        spacing::growing(0.0, depth, surface * grading.first, grading.depth, grading.coarsest * depth)
    }

    /// The same from one side of a body to the opposite one, fine there too where another contact lies on it.
    pub fn across(&self, surface: f64, depth: f64) -> Vec<f64> {
        let grading = self.grading;
        let first = surface * grading.first;
        match self.opposite {
            true => spacing::growing_from_both(0.0, depth, [first; 2], grading.depth, grading.coarsest * depth),
            false => self.depth(surface, depth),
        }
    }

    pub fn lattice(&self, breaks: &[f64]) -> Vec<f64> {
        spacing::lattice(breaks, self.refinement, self.order)
    }

    /// Points `at(s)` on the lattice of the given positions.
    pub fn along(&self, breaks: &[f64], at: impl Fn(f64) -> Point) -> Vec<Point> {
        self.lattice(breaks).into_iter().map(at).collect()
    }
}

/// The candidates of one contact of a body.
#[derive(PartialEq)]
pub(crate) struct Fine {
    /// Where s = 0 lies along x; 0 on an arc.
    pub origin: f64,
    /// Candidate stretch in its contact coordinate.
    pub stretch: f64,
    /// Size of its elements in that coordinate.
    pub size: f64,
    /// Where nodes must lie within it.
    pub kinks: Vec<f64>,
    pub both_sides: bool,
    pub straight: bool,
}

impl Fine {
    fn of(pair: &ContactPair, per_length: f64) -> Self {
        let (straight, both_sides) = (pair.path.is_straight(), pair.path.has_both_sides());
        let size = pair.stretch / elements_on(pair.stretch * pair.path.metric(), per_length) as f64;
        let origin = if straight { pair.path.origin()[0] } else { 0.0 };
        Self { origin, stretch: pair.stretch, size, kinks: pair.profile.kinks(), both_sides, straight }
    }

    /// The stretch from s = 0 on, cut at the kinks.
    pub fn pieces(&self) -> impl Iterator<Item = [f64; 2]> {
        let within = self.kinks.iter().copied().filter(|s| *s < self.stretch);
        let ends: Vec<f64> = [0.0].into_iter().chain(within).chain([self.stretch]).collect();
        (1..ends.len()).map(move |k| [ends[k - 1], ends[k]])
    }
}

/// Widest cell on an arc that carries a contact \[rad\].
const WIDEST: f64 = 0.8;
/// Difference of positions, over the stretch, below which they are one.
const SAME: f64 = 1e-9;

/// Elements on a length.
fn elements_on(length: f64, per_length: f64) -> usize {
    (per_length * length).round().max(1.0) as usize
}

/// The last two positions of a list.
pub(super) fn last_two(positions: &[f64]) -> [f64; 2] {
    match positions {
        [.., before, last] => [*before, *last],
        _ => [0.0, 0.0],
    }
}
