//! What was handed in as the profile that measures are taken of: contact points and edge means, by the formulas of every run.

use crate::elasticity::quadrature::lobatto;
use crate::mesh::Order;
use crate::referee::answer::{Handed, Point};
use crate::scene::{ContactPair, Line, Path, Scene};
use crate::solution::{EdgeState, Part, PointState};

/// The profile of one contact.
#[derive(Clone, Debug)]
pub struct Profile {
    /// The scene, whose contact lies on both sides where the answer does.
    pub scene: Scene,
    /// Index of the contact.
    pub contact: usize,
    /// How its points follow one another.
    pub order: Order,
    /// Contact points, in the order of the contact coordinate.
    pub points: Vec<PointState>,
    /// Means over the edges between them.
    pub edges: Vec<EdgeState>,
    /// Whether it lies on both sides of the middle.
    pub across: bool,
    /// Whether gaps were handed in.
    pub has_gaps: bool,
    /// Whether its forces are known, by themselves or by the areas, and not by straight lines between pressures.
    pub has_forces: bool,
}

impl Profile {
    /// The profile of what was handed in of a contact of a scene.
    pub fn of(scene: &Scene, handed: &Handed) -> Self {
        let across = handed.points[0].position < 0.0 - SAME * handed.points[handed.points.len() - 1].position.abs();
        let scene = if across { on_both_sides(scene, handed.contact) } else { scene.clone() };
        let pair = &scene.contacts[handed.contact];
        let begun = begun(pair, handed, across);
        let handed = begun.as_ref().unwrap_or(handed);
        let has_forces = handed.forces || handed.points.iter().all(|point| point.area.is_some());
        let lines =
            (handed.order == Order::Linear && !has_forces && handed.edges.is_empty()).then(|| with_middles(handed));
        let handed = lines.as_ref().unwrap_or(handed);
        let lengths = tributary(&handed.points, handed.order);
        let across_path = pair.path.metric() * scene.thickness;
        let state = |(point, length): (&Point, &f64)| {
            let weight = point.area.unwrap_or(length * across_path);
            let pressure = if handed.forces { point.value / weight } else { point.value };
            PointState { position: point.position, weight, pressure, gap: point.gap.unwrap_or(f64::NAN) }
        };
        let points: Vec<PointState> = handed.points.iter().zip(&lengths).map(state).collect();
        let edges =
            if handed.edges.is_empty() { means(&points, handed.order, across_path) } else { handed.edges.clone() };
        let has_gaps = handed.points.iter().all(|point| point.gap.is_some());
        Self { contact: handed.contact, order: handed.order, points, edges, across, has_gaps, has_forces, scene }
    }

    /// The contact.
    pub fn pair(&self) -> &ContactPair {
        &self.scene.contacts[self.contact]
    }

    /// Points and edges, as measures take them.
    pub fn part(&self) -> Part<'_> {
        Part { points: &self.points, edges: &self.edges, nodes: usize::from(self.order.number()) + 1 }
    }
}

/// Part of the largest position that rounding explains.
const SAME: f64 = 1e-9;

/// The scene with a contact on both sides of its middle: no half of it is left to be counted twice.
fn on_both_sides(scene: &Scene, contact: usize) -> Scene {
    let mut scene = scene.clone();
    let pair = &mut scene.contacts[contact];
    if let Path::Straight(line) = pair.path {
        pair.path = Path::Straight(Line { both_sides: true, ..line });
    }
    pair.symmetric = false;
    scene
}

/// The same begun on the symmetry line, where points such as the middles of edges do not: the first pressure holds up to there.
/// None where it begins there, or lies on both sides.
fn begun(pair: &ContactPair, handed: &Handed, across: bool) -> Option<Handed> {
    let [first, second] = [handed.points[0], handed.points[1]];
    let between = first.position > SAME * second.position && first.position < second.position - first.position;
    if across
        || pair.path.has_both_sides()
        || !between
        || handed.order != Order::Linear
        || handed.forces
        || first.area.is_some()
    {
        return None;
    }
    let start = Point { position: 0.0, ..first };
    Some(Handed { points: [&[start], &handed.points[..]].concat(), ..handed.clone() })
}

/// Straight lines between pressures with their middles, so that Simpson's rule takes their second moments exactly.
fn with_middles(handed: &Handed) -> Handed {
    let middle = |pair: &[Point]| Point {
        position: 0.5 * (pair[0].position + pair[1].position),
        value: 0.5 * (pair[0].value + pair[1].value),
        area: None,
        gap: pair[0].gap.zip(pair[1].gap).map(|(a, b)| 0.5 * (a + b)),
    };
    let mut points: Vec<Point> = handed.points.windows(2).flat_map(|pair| [pair[0], middle(pair)]).collect();
    points.extend(handed.points.last());
    Handed { points, order: Order::Quadratic, ..handed.clone() }
}

/// Shares of an edge that belong to its nodes, by the Lobatto rule on them: 1/2, 1/2; 1/6, 4/6, 1/6; and so on.
fn shares(order: Order) -> Vec<f64> {
    lobatto(usize::from(order.number()) + 1).into_iter().map(|(_, weight)| 0.5 * weight).collect()
}

/// Length of the path that belongs to each point: its shares of its edges.
pub fn tributary(points: &[Point], order: Order) -> Vec<f64> {
    let (mut lengths, shares) = (vec![0.0; points.len()], shares(order));
    let steps = shares.len() - 1;
    for first in (0..points.len() - 1).step_by(steps) {
        let length = points[first + steps].position - points[first].position;
        shares.iter().enumerate().for_each(|(k, share)| lengths[first + k] += share * length);
    }
    lengths
}

/// Means over the edges, by the same shares.
fn means(points: &[PointState], order: Order, across: f64) -> Vec<EdgeState> {
    let shares = shares(order);
    let steps = shares.len() - 1;
    let mean = |first: usize| {
        let own = &points[first..=first + steps];
        let ends = [own[0].position, own[steps].position];
        let pressure = own.iter().zip(&shares).map(|(point, share)| share * point.pressure).sum();
        EdgeState { ends, weight: (ends[1] - ends[0]) * across, pressure, is_ring: false }
    };
    (0..points.len() - 1).step_by(steps).map(mean).collect()
}
