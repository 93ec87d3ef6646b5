//! From outlines to structured blocks: one file per shape.

mod blocks;
mod disc;
mod eye;
mod rectangle;
mod ring;

use crate::mesh::Resolution;
use crate::mesh::block::{Block, Point};
use crate::mesh::spacing;
use crate::scene::contact_pair::CONTACT;
use crate::scene::{ContactPair, Face, Grading, Line, Path, Scene, Shape};

/// What the outlines need to know of the scene: where the candidates end and how fine they are.
pub(crate) struct Layout<'a> {
    pub grading: &'a Grading,
    pub path: &'a Path,
    /// Candidate stretch in the contact coordinate.
    pub stretch: f64,
    /// Whether another contact lies on the side opposite to that called `contact`.
    pub opposite: bool,
    /// Where candidates lie along x on straight paths: the body's own stretch first, then those of its other contacts.
    pub spans: Vec<Span>,
    /// Elements per grading unit before refinement.
    pub elements: f64,
    /// Times the whole mesh is halved.
    pub refinement: u32,
}

impl<'a> Layout<'a> {
    pub fn new(scene: &'a Scene, resolution: Resolution, body: usize) -> Self {
        let pair = scene.contact_of(body);
        Self {
            grading: &scene.grading,
            path: &pair.path,
            stretch: pair.stretch,
            opposite: scene.contacts.iter().any(|other| is_opposite(other, body)),
            spans: spans(scene, body),
            elements: resolution.elements as f64 * scene.bodies[body].density,
            refinement: resolution.refinement,
        }
    }

    /// Blocks of a shape.
    pub fn blocks(&self, shape: &Shape) -> Vec<Block> {
        match shape {
            Shape::Rectangle { x, y, contact } => rectangle::blocks(self, *x, *y, *contact),
            Shape::Disc { centre, radius, sector, contact: Face::Bottom } => {
                disc::blocks(self, *centre, *radius, *sector)
            }
            Shape::Disc { centre, radius, sector, contact: Face::Top } => {
                let blocks = disc::blocks(self, *centre, *radius, *sector);
                blocks.iter().map(|block| block.turned_over(centre[1])).collect()
            }
            Shape::Ring { pole, inner, outer, sweep, contact } => {
                ring::blocks(self, *pole, [*inner, *outer], *sweep, *contact)
            }
            Shape::Eye { .. } => eye::blocks(self, shape),
            Shape::Blocks(shapes) => blocks::blocks(self, shapes),
            Shape::Given(_) => Vec::new(),
        }
    }

    /// Stations of the candidate stretch in the contact coordinate, from 0 on.
    fn candidates(&self) -> Vec<f64> {
        self.candidates_of(self.stretch)
    }

    /// The same of another contact of the body.
    fn candidates_of(&self, stretch: f64) -> Vec<f64> {
        let length = stretch * self.path.metric();
        let n = (self.elements * length / self.grading.unit).round().max(1.0) as usize;
        spacing::stretched(0.0, stretch, n, self.grading.end)
    }

    /// Stations of an arc: the candidates, then growing element sizes up to each of the given angles in turn.
    fn arc(&self, radius: f64, until: &[f64]) -> Vec<f64> {
        let mut angles: Vec<f64> = match self.path {
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

    /// Depth stations from 0 (surface) to `depth`, starting near the size `surface` of the elements along the surface.
    fn depth(&self, surface: f64, depth: f64) -> Vec<f64> {
        let grading = self.grading;
        spacing::growing(0.0, depth, surface * grading.first, grading.depth, grading.coarsest * depth)
    }

    /// The same from one side of a body to the opposite one, fine there too where another contact lies on it.
    fn across(&self, surface: f64, depth: f64) -> Vec<f64> {
        let grading = self.grading;
        let first = surface * grading.first;
        match self.opposite {
            true => spacing::growing_from_both(0.0, depth, [first; 2], grading.depth, grading.coarsest * depth),
            false => self.depth(surface, depth),
        }
    }

    fn lattice(&self, breaks: &[f64]) -> Vec<f64> {
        spacing::lattice(breaks, self.refinement)
    }

    /// Points `at(s)` on the lattice of the given stations.
    fn along(&self, breaks: &[f64], at: impl Fn(f64) -> Point) -> Vec<Point> {
        self.lattice(breaks).into_iter().map(at).collect()
    }
}

/// Candidates along x about an origin, or from it on.
#[derive(Clone, Copy)]
pub(crate) struct Span {
    pub origin: f64,
    pub stretch: f64,
    pub both_sides: bool,
}

impl Span {
    fn of(pair: &ContactPair) -> Option<Self> {
        let Path::Straight(Line { origin, both_sides }) = pair.path else { return None };
        Some(Self { origin: origin[0], stretch: pair.stretch, both_sides })
    }

    /// Where it begins and ends.
    fn ends(&self) -> [f64; 2] {
        [if self.both_sides { self.origin - self.stretch } else { self.origin }, self.origin + self.stretch]
    }

    fn is_apart(&self, other: &Self) -> bool {
        let ([begin, end], [from, to]) = (self.ends(), other.ends());
        end < from || begin > to
    }
}

/// The spans of the contacts of a body, without those that meet one before.
fn spans(scene: &Scene, body: usize) -> Vec<Span> {
    let own = scene.contacts.iter().filter(|pair| pair.bodies().any(|other| other == body));
    let mut spans: Vec<Span> = Span::of(scene.contact_of(body)).into_iter().collect();
    for span in own.filter_map(Span::of) {
        if spans.iter().all(|other| other.is_apart(&span)) {
            spans.push(span);
        }
    }
    spans
}

/// Whether a contact of a body lies on another side of it than that called `contact`.
fn is_opposite(pair: &ContactPair, body: usize) -> bool {
    pair.bodies().any(|other| other == body) && pair.side(body) != CONTACT
}

/// The last two stations of a list.
fn last_two(stations: &[f64]) -> [f64; 2] {
    match stations {
        [.., before, last] => [*before, *last],
        _ => [0.0, 0.0],
    }
}

/// Point at the fraction `t` between two points.
fn between(a: Point, b: Point, t: f64) -> Point {
    [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t]
}

/// Point at radius `r` and angle `θ` from the downward vertical about a centre.
fn polar(centre: Point, radius: f64, angle: f64) -> Point {
    [centre[0] + radius * exact_sin(angle), centre[1] - radius * exact_sin(std::f64::consts::FRAC_PI_2 - angle)]
}

/// `sin` that is exactly zero at multiples of π, so that symmetry lines are met to the last bit.
fn exact_sin(angle: f64) -> f64 {
    let sin = angle.sin();
    if sin.abs() < 1e-15 { 0.0 } else { sin }
}
