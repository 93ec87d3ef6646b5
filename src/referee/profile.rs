//! What was handed in as the profile that measures are taken of: contact points and edge means, by the formulas of
//! every run.

use std::f64::consts::TAU;

use crate::elasticity::quadrature::lobatto;
use crate::error::Error;
use crate::mesh::Order;
use crate::referee::answer::{Handed, Point, ordered};
use crate::referee::between;
use crate::referee::truth::Truth;
use crate::scene::{ContactPair, Path, Scene};
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
    /// The same with more of them between: on roots where pressures alone were handed in, on straight lines where their
    /// forces are known along edges with two nodes; none elsewhere.
    pub between: Vec<PointState>,
    /// Places between which pressures alone lie on straight lines; none elsewhere.
    pub lines: Vec<f64>,
    /// Means over the edges between them.
    pub edges: Vec<EdgeState>,
    /// Contact coordinate and pressure of the points as they were handed in, of forces that over the area, where no
    /// means over edges stand beside them \[mm or rad, MPa\].
    pub alone: Vec<[f64; 2]>,
    /// Whether these are of corners and mid-sides by turns though no order was told.
    pub is_by_turns: bool,
    /// Whether means over edges stand beside them.
    pub has_means: bool,
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
        let is_whole = across && !scene.contacts[handed.contact].path.has_both_sides();
        let scene = if is_whole { on_both_sides(scene, handed.contact) } else { scene.clone() };
        let pair = &scene.contacts[handed.contact];
        let begun = begun(&scene, handed, across);
        let handed = begun.as_ref().unwrap_or(handed);
        let has_forces = handed.forces || handed.points.iter().all(|point| point.area.is_some());
        let is_of_points = handed.order == Order::Linear && handed.edges.is_empty();
        let plain = handed;
        let is_open = is_of_points && !has_forces;
        let lines = if is_open { between::lines(&handed.points) } else { vec![] };
        let drawn = |handed: &Handed| states(&scene, pair, &handed.points, handed.order, false);
        let roots = is_open.then(|| drawn(&Handed { points: between::by_roots(&handed.points), ..handed.clone() }));
        let with_middles = is_open.then(|| between::by_lines(handed));
        let handed = with_middles.as_ref().unwrap_or(handed);
        let mut points = states(&scene, pair, &handed.points, handed.order, handed.forces);
        let has_means = !plain.edges.is_empty();
        let may_lend = scene.is_around_axis(handed.contact) || begun.is_some() && handed.forces;
        let on_axis = may_lend && lends_to_axis(&mut points, handed);
        // What a node on the axis is said to press with by one who says that it has no area is none: it had nothing to
        // divide its force by.
        let lent = usize::from(on_axis && plain.points[0].area.is_some());
        let (alone, is_by_turns) = match (has_means, plain.forces) {
            (true, _) => (Vec::new(), false),
            (false, true) => of_nodes(&scene, plain, &points[usize::from(on_axis)..]),
            (false, false) => (plain.points[lent..].iter().map(|point| [point.position, point.value]).collect(), false),
        };
        let edges =
            if handed.edges.is_empty() { means(&scene, pair, &points, handed.order) } else { handed.edges.clone() };
        let of_forces = || {
            // Whatever areas are told, what is drawn has the forces.
            let areas = tributary(&scene, pair, &handed.points, handed.order);
            let bare = |((one, state), area): ((&Point, &PointState), f64)| {
                let value = if area > 0.0 { state.pressure * state.weight / area } else { state.pressure };
                Point { value, area: None, ..*one }
            };
            let pressed = handed.points.iter().zip(&points).zip(areas).map(bare);
            drawn(&between::by_lines(&Handed { points: pressed.collect(), ..handed.clone() }))
        };
        let between = roots.or_else(|| is_of_points.then(of_forces)).unwrap_or_default();
        points.drain(..usize::from(on_axis));
        let has_gaps = handed.points.iter().all(|point| point.gap.is_some());
        let (contact, order) = (handed.contact, handed.order);
        Self {
            contact,
            order,
            points,
            between,
            lines,
            edges,
            alone,
            is_by_turns,
            has_means,
            across,
            has_gaps,
            has_forces,
            scene,
        }
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

/// Contact points by the areas handed in, or else those that belong to them; `forces` tells whether values are nodal
/// forces.
fn states(scene: &Scene, pair: &ContactPair, points: &[Point], order: Order, forces: bool) -> Vec<PointState> {
    let state = |(point, area): (&Point, f64)| {
        let weight = point.area.unwrap_or(area);
        let pressure = if forces { point.value / weight } else { point.value };
        PointState { position: point.position, weight, pressure, gap: point.gap.unwrap_or(f64::NAN) }
    };
    points.iter().zip(tributary(scene, pair, points, order)).map(state).collect()
}

/// Places and pressures of nodes by their forces. Corners and mid-sides of 8-node cells have by turns a third and two
/// thirds of an edge: where neither areas nor the order are told, they are those of the order by which they vary less,
/// which is said.
fn of_nodes(scene: &Scene, handed: &Handed, states: &[PointState]) -> (Vec<[f64; 2]>, bool) {
    let points = &handed.points;
    let is_of_one_order = handed.is_told || scene.is_of_revolution();
    if is_of_one_order || states.len() < points.len() || points.iter().any(|point| point.area.is_some()) {
        let pressed = |state: &PointState| [state.position, state.pressure];
        return (states.iter().map(pressed).filter(|[_, p]| p.is_finite()).collect(), false);
    }
    let of = |order: Order, points: &[Point]| -> Vec<[f64; 2]> {
        let areas = tributary(scene, &scene.contacts[handed.contact], points, order);
        points.iter().zip(areas).map(|(point, area)| [point.position, point.value / area]).collect()
    };
    let varies = |all: &[[f64; 2]]| -> f64 {
        all.windows(3).map(|three| (three[1][1] - 0.5 * (three[0][1] + three[2][1])).abs()).sum()
    };
    // Without a last one that lies beyond the others.
    let by_turns = of(Order::Quadratic, &points[..points.len() - 1 + points.len() % 2]);
    let own = of(Order::Linear, points);
    let is_by_turns = varies(&by_turns) < varies(&own[..by_turns.len()]);
    (if is_by_turns { by_turns } else { own }, is_by_turns)
}

/// Part of the largest position that rounding explains.
const SAME: f64 = 1e-9;
/// Edges of the answer within which an end counts as that of the contact, which ours is read to a part of one.
pub const EDGES: f64 = 1.1;
/// Steps before the last candidate at which the middle of an edge lies: half of one where edges are alike.
pub const HALF: std::ops::Range<f64> = 0.3..0.7;

/// What was handed in of a contact, with the points beyond that carry nothing where those that press alone are listed,
/// and its ends where the points are the middles of edges and it reaches to the last candidates.
pub fn ended(truth: &Truth, handed: &Handed) -> Handed {
    let (mut all, ours) = (handed.clone(), &truth.run.contacts[handed.contact].measures);
    let is_plain = handed.order == Order::Linear && handed.edges.is_empty();
    if !is_plain || handed.points.iter().any(|point| point.area.is_some()) {
        return all;
    }
    let (Some(begin), Some(end)) = (ours.stretches.first(), ours.stretches.last()) else { return all };
    let beyond = |k: usize, next: usize, place: f64, reaches: bool| {
        let [last, before] = [handed.points[k], handed.points[next]];
        let (step, left) = (last.position - before.position, place - last.position);
        let position = if reaches { place } else { last.position + step };
        let value = if reaches { last.value } else { 0.0 };
        let is_end = match reaches {
            true => !handed.forces && HALF.contains(&(left / step)),
            false => left.abs() <= EDGES * step.abs(),
        };
        (last.value > 0.0 && is_end && place * last.position > 0.0).then_some(Point { position, value, ..last })
    };
    let (last, begins) = (all.points.len() - 1, ours.begin());
    // A symmetric contact ends on its other half as it does on this one.
    let is_image = begins < 0.0 && !truth.case.scene.contacts[handed.contact].path.has_both_sides();
    let image = if is_image { end } else { begin };
    all.points.extend(beyond(last, last - 1, end.end, end.reaches[1]));
    all.points.splice(0..0, beyond(0, 1, begins, image.reaches[usize::from(is_image)]));
    all
}

/// The scene with a contact of which it has one half on both sides of its middle: none is left to be counted twice.
fn on_both_sides(scene: &Scene, contact: usize) -> Scene {
    let mut scene = scene.clone();
    let pair = &mut scene.contacts[contact];
    if let Path::Straight { both_sides, .. } = &mut pair.path {
        *both_sides = true;
    }
    pair.symmetric = false;
    scene
}

/// Part of the area of its neighbour that a point on the axis has at most, whose edge is of order 2 or more: none but
/// for rounding.
const NO_AREA: f64 = 1e-6;

/// Whether the first point lies on the axis and has no area, `∫ N r dr = 0`: it then gets the pressure of its
/// neighbour, to which its force is added.
fn lends_to_axis(points: &mut [PointState], handed: &Handed) -> bool {
    let [first, second, ..] = points else { return false };
    let has_no_area = first.weight.abs() <= NO_AREA * second.weight;
    if has_no_area && handed.forces {
        second.pressure += handed.points[0].value / second.weight;
    }
    if has_no_area {
        first.pressure = second.pressure;
    }
    has_no_area
}

/// The same begun on the symmetry line, where points such as the middles of edges do not: the first pressure holds up
/// to there, and a first force is of all the area up to there. None where it begins there, or lies on both sides.
/// Tables of bodies of revolution may leave out the axis, where nodes have no area.
fn begun(scene: &Scene, handed: &Handed, across: bool) -> Option<Handed> {
    let [first, second] = [handed.points[0], handed.points[1]];
    let (length, revolves) = (second.position - first.position, scene.is_around_axis(handed.contact));
    let near = match handed.forces && !revolves {
        true => HALF.contains(&(first.position / length)),
        false => first.position < length || revolves && first.position <= length * (1.0 + SAME),
    };
    if across
        || scene.contacts[handed.contact].path.has_both_sides()
        || first.position <= SAME * second.position
        || !near
        || handed.order != Order::Linear
        || first.area.is_some() && (handed.forces || !revolves)
    {
        return None;
    }
    let mut points = vec![Point { position: 0.0, area: first.area.map(|_| 0.0), ..first }];
    points.extend(&handed.points);
    if handed.forces {
        let areas = tributary(scene, &scene.contacts[handed.contact], &points, Order::Linear);
        // On straight lines it is an edge of which the first point is the middle; of rings their hat functions have the
        // area of the first.
        points[1].area = Some(areas[1] + if revolves { 0.0 } else { areas[0] });
        points[0] = Point { value: 0.0, area: Some(0.0), ..points[0] };
    }
    Some(Handed { points, ..handed.clone() })
}

/// Shares of an edge that belong to its nodes, by the Lobatto rule on them: 1/2, 1/2; 1/6, 4/6, 1/6; and so on.
fn shares(order: Order) -> Vec<f64> {
    lobatto(usize::from(order.number()) + 1).into_iter().map(|(_, weight)| 0.5 * weight).collect()
}

/// The same of an edge of bodies of revolution, each times its mean radius, `∫ N_k r ds / ∫ ds` \[mm\]; the rule is
/// exact from order 2 on.
fn radii(radii: &[f64], order: Order) -> Vec<f64> {
    match (order, radii) {
        (Order::Linear, [a, b]) => vec![(2.0 * a + b) / 6.0, (a + 2.0 * b) / 6.0],
        _ => shares(order).iter().zip(radii).map(|(share, r)| share * r).collect(),
    }
}

/// Area that belongs to each point \[mm²\]: its shares of its edges times the thickness; of bodies of revolution
/// `∫ N_k 2πr dr`.
pub fn tributary(scene: &Scene, pair: &ContactPair, points: &[Point], order: Order) -> Vec<f64> {
    let (mut sums, plain) = (vec![0.0; points.len()], shares(order));
    let steps = plain.len() - 1;
    let positions: Vec<f64> = points.iter().map(|point| point.position).collect();
    for first in (0..points.len() - 1).step_by(steps) {
        let own = &positions[first..=first + steps];
        let shares = match scene.plane.radial() {
            Some(radial) => radii(&own.iter().map(|s| pair.path.point(*s)[radial]).collect::<Vec<_>>(), order),
            None => plain.clone(),
        };
        shares.iter().enumerate().for_each(|(k, share)| sums[first + k] += share * (own[steps] - own[0]));
    }
    let across = pair.path.metric() * if scene.is_of_revolution() { TAU } else { scene.thickness };
    sums.into_iter().map(|sum| sum * across).collect()
}

/// What was handed in of a contact by its points, in any order: those of edges of an order, or, where none is told, of
/// that of which their areas tell. Refused as [`ordered`] says.
pub fn handed(
    (scene, contact): (&Scene, usize),
    points: Vec<Point>,
    order: Option<Order>,
    forces: bool,
    refused: impl Fn(String, &str) -> Error,
) -> Result<Handed, Error> {
    let pair = &scene.contacts[contact];
    let points = from_axis((scene, contact), points, order.unwrap_or(Order::Linear));
    let points = ordered(points, order.unwrap_or(Order::Linear), pair, refused)?;
    let is_told = order.is_some();
    let order = order.unwrap_or_else(|| order_of_areas(scene, pair, &points));
    Ok(Handed { contact, points, order, is_told, edges: vec![], forces })
}

/// Points of 8-node cells with that of the axis, whose area is 0, where it alone lacks to make edges whole, the first
/// one being in the middle of an edge: answers leave it out.
pub fn from_axis((scene, contact): (&Scene, usize), mut points: Vec<Point>, order: Order) -> Vec<Point> {
    points.sort_by(|a, b| a.position.total_cmp(&b.position));
    let lacks = order == Order::Quadratic && points.len().is_multiple_of(2) && scene.is_around_axis(contact);
    if let [first, second, ..] = points[..]
        && lacks
        && first.position > 0.0
        && (first.position / second.position - 0.5).abs() <= OFF
    {
        points.insert(0, Point { position: 0.0, value: 0.0, area: Some(0.0), ..first });
    }
    points
}

/// Part of the largest area, or of an edge, by which areas, or its middle, may be off from those of an order.
const OFF: f64 = 0.01;

/// The order of the edges of which the areas of points tell: 2 where they are theirs and not those of edges with two
/// nodes; else 1.
fn order_of_areas(scene: &Scene, pair: &ContactPair, points: &[Point]) -> Order {
    let Some(areas) = points.iter().map(|point| point.area).collect::<Option<Vec<f64>>>() else { return Order::Linear };
    let largest = areas.iter().copied().fold(0.0, f64::max);
    let are_of = |order: Order| {
        let wanted = tributary(scene, pair, points, order);
        areas.iter().zip(wanted).all(|(own, wanted)| (own - wanted).abs() <= OFF * largest)
    };
    let is_whole = points.len() % 2 == 1;
    if is_whole && are_of(Order::Quadratic) && !are_of(Order::Linear) { Order::Quadratic } else { Order::Linear }
}

/// Means over the edges, by the same shares.
fn means(scene: &Scene, pair: &ContactPair, points: &[PointState], order: Order) -> Vec<EdgeState> {
    let plain = shares(order);
    let steps = plain.len() - 1;
    let mean = |first: usize| {
        let own = &points[first..=first + steps];
        let ends = [own[0].position, own[steps].position];
        let sum = |shares: &[f64]| own.iter().zip(shares).map(|(point, share)| share * point.pressure).sum::<f64>();
        let length = ends[1] - ends[0];
        let Some(radial) = scene.plane.radial() else {
            let weight = length * (pair.path.metric() * scene.thickness);
            return EdgeState { ends, weight, pressure: sum(&plain), axis: None };
        };
        let places: Vec<f64> = own.iter().map(|point| pair.path.point(point.position)[radial]).collect();
        let shares = radii(&places, order);
        let pressure = sum(&shares) / shares.iter().sum::<f64>();
        let weight = length * pair.path.metric() * scene.depth(pair.path.point(0.5 * (ends[0] + ends[1])));
        EdgeState { ends, weight, pressure, axis: pair.path.axis(radial, ends) }
    };
    (0..points.len() - 1).step_by(steps).map(mean).collect()
}
