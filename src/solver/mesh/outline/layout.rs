//! What the outlines need to know of the scene, and the positions that follow from it.

use std::f64::consts::FRAC_PI_2;

use super::known_ends::KnownEnds;
use super::points::points;
use crate::mesh::block::{Point, exact_sin};
use crate::mesh::spacing;
use crate::mesh::{Order, Resolution};
use crate::scene::contact_pair::CONTACT;
use crate::scene::{Circle, ContactPair, Grading, Path, Scene, Shape};

/// Angle of the widest cell on an arc over the coarsest element's part of the body \[rad\].
const WIDEST: f64 = 1.6;
/// Thickness of a ring over its radius from which on it bends no more like a curved beam.
const THIN: f64 = 0.25;
/// The same of a thinner ring over the root of that: a cell whose length squared is not small against thickness times
/// radius stretches where it shall bend (membrane locking).
const CURVED: f64 = 3.0;
/// The same of 4-node cells over it: those longer than thick shear where they shall bend (shear locking).
const SHEARED: f64 = 1.5;

/// Angle of the widest cell on an arc of a shape \[rad\].
pub(crate) fn widest(shape: &Shape, grading: &Grading, order: Order) -> f64 {
    let part = match shape {
        Shape::Ring { inner, outer, .. } if inner.radius > (1.0 - THIN) * outer.radius => {
            let thin = 1.0 - inner.radius / outer.radius;
            if order == Order::Linear { SHEARED * thin } else { CURVED * thin.sqrt() }
        }
        _ => WIDEST,
    };
    part * grading.coarsest
}

/// What the outlines need to know of the scene: where the candidates end and how fine they are.
pub(crate) struct Layout<'a> {
    scene: &'a Scene,
    pub grading: &'a Grading,
    pub path: &'a Path,
    /// Candidate stretch in the contact coordinate.
    pub stretch: f64,
    /// The contact on the side called `contact` and that on the side opposite, where there is one.
    pub opposite: Option<[&'a ContactPair; 2]>,
    /// Contact coordinates at which nodes must lie: kinks of the gap, which no edge shall straddle.
    pub kinks: Vec<f64>,
    /// Where the contact is expected to end; none where the mesh knows nothing of it.
    pub ends: Option<KnownEnds<'a>>,
    /// Points of the body that are held or pressed.
    pub points: Vec<Point>,
    /// The candidates of every contact of the body, where there are several that differ.
    pub several: Vec<Fine>,
    /// Elements per grading unit before refinement.
    pub elements: f64,
    /// Times the whole mesh is halved.
    pub refinement: u32,
    /// Element order.
    pub order: Order,
    /// Widest cell on an arc beyond the candidates \[rad\].
    pub widest: f64,
}

impl<'a> Layout<'a> {
    pub fn new(scene: &'a Scene, resolution: Resolution, body: usize) -> Self {
        let pair = scene.contact_of(body);
        let elements = resolution.elements as f64 * scene.bodies[body].density;
        let per_length = elements / scene.grading.unit;
        let parts = parts(elements);
        let is_rectangle = matches!(scene.bodies[body].shape, Shape::Rectangle { .. });
        let own: Vec<Fine> =
            scene.contacts_of(body).map(|pair| Fine::of(scene, pair, per_length, parts, is_rectangle)).collect();
        Self {
            scene,
            grading: &scene.grading,
            path: &pair.path,
            stretch: pair.stretch,
            kinks: pair.profile.kinks(),
            ends: KnownEnds::of(scene, pair, parts),
            opposite: scene.contacts_of(body).find(|other| other.side(body) != CONTACT).map(|other| [pair, other]),
            points: points(&scene.bodies[body]),
            several: if own.iter().all(|one| *one == own[0]) { vec![] } else { own },
            elements,
            refinement: resolution.refinement,
            order: resolution.order,
            widest: widest(&scene.bodies[body].shape, &scene.grading, resolution.order),
        }
    }

    /// What the outline would need to know if this were the only contact of the body.
    pub fn alone(&self, pair: &'a ContactPair) -> Self {
        Self {
            path: &pair.path,
            stretch: pair.stretch,
            kinks: pair.profile.kinks(),
            ends: KnownEnds::of(self.scene, pair, self.parts()),
            opposite: None,
            several: vec![],
            points: self.points.clone(),
            ..*self
        }
    }

    /// The same of both contacts, on opposite sides, where they are all that the body has, their ends are known and
    /// differ: lines of both side by side would leave no room for layers towards either.
    pub fn each_of_two(&self) -> Option<[Self; 2]> {
        let has_ends = |pairs: &[&ContactPair; 2]| pairs.iter().all(|pair| !pair.ends.places.is_empty());
        let are_two = |pairs: &[&ContactPair; 2]| self.several.len() == 2 && !std::ptr::eq(pairs[0], pairs[1]);
        let pairs = self.opposite.filter(has_ends).filter(are_two)?;
        Some(pairs.map(|pair| self.alone(pair)))
    }

    /// Positions of the candidate stretch in the contact coordinate, from 0 on.
    pub fn candidates(&self) -> Vec<f64> {
        if let Some(ends) = &self.ends {
            return ends.to_the_right();
        }
        let n = elements_on(self.stretch * self.path.metric(), self.elements / self.grading.unit);
        spacing::broken(0.0, self.stretch, n, self.grading.end, &self.kinks)
    }

    /// The ends of the contact where they are known and all contacts of the body have the same.
    pub fn same_ends(&self) -> Option<&KnownEnds<'a>> {
        self.ends.as_ref().filter(|_| self.several.is_empty())
    }

    /// Into how many a side of a cell is cut where the mesh is finer.
    pub fn parts(&self) -> usize {
        parts(self.elements)
    }

    /// Positions of an arc about a pole: the candidates, then growing element sizes up to each of the given angles in
    /// turn.
    pub fn arc(&self, on: Rays, until: &[f64]) -> Vec<f64> {
        let mut angles: Vec<f64> = match self.several.is_empty() {
            false => self.angles_of_all(on.circle.radius),
            true => self.candidates().iter().map(|s| on.angle(self.path, *s)).collect(),
        };
        for &end in until {
            let [before, last] = last_two(&angles);
            if end > last + 1e-9 {
                let next = (last - before) * self.grading.along;
                // Where a body bends around its contact.
                let first = if self.path.is_straight() { next } else { next.min(self.widest) };
                let more = spacing::growing(last, end, first, self.grading.along, self.widest);
                angles = spacing::joined(&[angles, more]);
            }
        }
        angles
    }

    /// Angles of the candidates of all contacts on an arc: every stretch ends on one, and elements are as fine as each
    /// asks.
    fn angles_of_all(&self, radius: f64) -> Vec<f64> {
        let angle = |fine: &Fine, s: f64| if fine.straight { (s / radius).asin() } else { s };
        let pieces = self.several.iter().flat_map(|one| one.pieces().map(move |[from, to]| (one, from, to)));
        let fine: Vec<[f64; 3]> =
            pieces.map(|(one, from, to)| [angle(one, from), angle(one, to), angle(one, one.size)]).collect();
        let end = fine.iter().map(|one| one[1]).fold(0.0, f64::max);
        spacing::fine_within([0.0, end], &fine, self.grading.along, self.grading.coarsest.min(self.widest))
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
        match self.opposite.is_some() {
            true => spacing::growing_from_both(0.0, depth, [first; 2], grading.depth, grading.coarsest * depth),
            false => self.depth(surface, depth),
        }
    }

    pub fn lattice(&self, breaks: &[f64]) -> Vec<f64> {
        spacing::lattice(breaks, self.refinement, self.order)
    }

    /// Points at the angles of an arc that lie evenly along the contact in every cell: bodies have their nodes at the
    /// same places there.
    pub fn along_contact(&self, on: Rays, angles: &[f64], at: impl Fn(f64) -> Point) -> Vec<Point> {
        let coordinates: Vec<f64> = angles.iter().map(|angle| on.coordinate(self.path, *angle)).collect();
        self.along(&coordinates, |s| at(on.angle(self.path, s)))
    }

    /// Points `at(s)` on the lattice of the given positions.
    pub fn along(&self, breaks: &[f64], at: impl Fn(f64) -> Point) -> Vec<Point> {
        self.lattice(breaks).into_iter().map(at).collect()
    }
}

/// Part of the height of a body that a line may lean over from one side to the opposite one.
const LEAN: f64 = 0.5;

/// Whether lines can be drawn from such places on one side to those on the opposite one, which lies so high: they are
/// as many, and none leans too far.
pub(super) fn can_lean([low, high]: [&[f64]; 2], height: f64) -> bool {
    low.len() == high.len() && low.iter().zip(high).all(|(low, high)| (low - high).abs() <= LEAN * height)
}

/// A circle seen from a pole inside it, by the angles from the downward vertical of the rays that meet it.
#[derive(Clone, Copy)]
pub(crate) struct Rays {
    pub pole: Point,
    pub circle: Circle,
}

impl Rays {
    /// A circle seen from its centre.
    pub fn of(centre: Point, radius: f64) -> Self {
        Self { pole: centre, circle: Circle { centre, radius } }
    }

    /// Angle of the ray to the point of the circle that has a contact coordinate: on an arc about another point of the
    /// pole's vertical, where the ray from there meets the circle.
    pub fn angle(&self, path: &Path, s: f64) -> f64 {
        match path {
            Path::Straight { .. } => (s / self.circle.radius).asin(),
            Path::Arc(own) if self.is_beside(own) => {
                let [x, y] = on_ray(self.circle, own.centre, s);
                (x - self.pole[0]).atan2(self.pole[1] - y)
            }
            Path::Arc(_) => s,
        }
    }

    /// The contact coordinate at such an angle.
    pub fn coordinate(&self, path: &Path, angle: f64) -> f64 {
        match path {
            Path::Straight { .. } => self.circle.radius * angle.sin(),
            Path::Arc(own) if self.is_beside(own) => path.coordinate(on_ray(self.circle, self.pole, angle)),
            Path::Arc(_) => angle,
        }
    }

    /// Whether the contact runs about another point of the same vertical.
    fn is_beside(&self, own: &Circle) -> bool {
        let [x, y] = [0, 1].map(|k| (own.centre[k] - self.pole[k]).abs());
        x <= SAME * own.radius && y > SAME * own.radius
    }
}

/// Where the ray at angle `θ` from the pole meets a circle.
pub(super) fn on_ray(circle: Circle, pole: Point, angle: f64) -> Point {
    let r = circle.along_ray(pole, angle);
    [pole[0] + r * exact_sin(angle), pole[1] - r * exact_sin(FRAC_PI_2 - angle)]
}

/// Distance of two points, over a radius, up to which they are one.
const SAME: f64 = 1e-12;

/// The candidates of one contact of a body.
#[derive(PartialEq)]
pub(crate) struct Fine {
    /// Where s = 0 lies along x; 0 on an arc.
    pub origin: f64,
    /// Positions on which nodes must lie: ends of the candidates and of the contact, s = 0, and kinks of the gap.
    pub positions: Vec<f64>,
    /// Largest size of elements between them.
    pub size: f64,
    pub straight: bool,
}

impl Fine {
    /// On a rectangle from its left to its right; other bodies have both sides of s = 0 alike, and one of them here.
    fn of(scene: &Scene, pair: &ContactPair, per_length: f64, parts: usize, is_rectangle: bool) -> Self {
        let (straight, both_sides) = (pair.path.is_straight(), is_rectangle && pair.path.has_both_sides());
        let origin = if straight { pair.path.origin()[0] } else { 0.0 };
        if let Some(ends) = KnownEnds::of(scene, pair, parts) {
            let positions = if both_sides { ends.across() } else { ends.to_the_right() };
            return Self { origin, positions, size: ends.half_width() / parts as f64, straight };
        }
        let size = pair.stretch / elements_on(pair.stretch * pair.path.metric(), per_length) as f64;
        let within = pair.profile.kinks().into_iter().filter(|s| *s < pair.stretch);
        let right: Vec<f64> = [0.0].into_iter().chain(within).chain([pair.stretch]).collect();
        let left = right[1..].iter().rev().map(|s| -s).filter(|_| both_sides);
        Self { origin, positions: left.chain(right.iter().copied()).collect(), size, straight }
    }

    /// The stretches between neighbouring positions.
    pub fn pieces(&self) -> impl Iterator<Item = [f64; 2]> {
        self.positions.windows(2).map(|two| [two[0], two[1]])
    }
}

/// Into how many so many elements on a length cut it.
fn parts(elements: f64) -> usize {
    elements.round().max(1.0) as usize
}

/// Elements on a length.
fn elements_on(length: f64, per_length: f64) -> usize {
    (per_length * length).round().max(1.0) as usize
}

/// The last two positions of a list.
pub(super) fn last_two(positions: &[f64]) -> [f64; 2] {
    positions.last_chunk().copied().unwrap_or_default()
}
