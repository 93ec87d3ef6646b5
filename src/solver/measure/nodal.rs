//! The peak of a profile whose edges hold many contact points, as on cells of order 4 and more: the top of a polynomial
//! over the pressures of the points around the highest.
//!
//! Means over pairs of edges, which peaks of other profiles are read from, are there as wide as the contact itself.

use std::ops::Range;

use crate::measure::fit::{Fit, Peak, ROUNDING, least_squares, powers};
use crate::measure::peak::{BEYOND, DROP, PARABOLA, QUARTIC, on_one_side};
use crate::measure::profile;
use crate::mesh::lobatto::{self, lagrange, legendre};
use crate::solution::{EdgeState, Part, PointState};

/// Length of an edge over that of the one around the highest point, from which on its points are left out of a fit:
/// cells that shrink towards a place do so for the pressure has a cusp there, which no polynomial over wider ones
/// tells.
const WIDER: f64 = 4.0;
/// Nodes of an edge beyond which its points tell the profile better than means over edges.
const MANY: usize = 3;
/// Fewest points of a fit, where there are so many: two more than the coefficients of a quartic, so that it smooths.
const FEWEST: usize = 7;
/// Points of the other reading, through which the quartic passes.
const THROUGH: usize = 5;

/// Fewest points whose squares make a parabola, where there are so many.
const SQUARES: usize = 4;
/// Most coefficients of a polynomial over few points, and over many.
const SEXTIC: usize = 7;
const OCTIC: usize = 9;
/// Fewest nodes inside the first edge that tell the pressure on the axis, those of order 6.
const INNER: usize = 5;
/// Parts of that edge over which its shape functions are integrated, and Lobatto points of each.
const PARTS: usize = 4;
const RULE: usize = 9;
/// Departure from the polynomial, over the pressure, up to which its means are those of a profile that it draws.
const DEPARTS: f64 = 1e-4;
/// Part of a stretch, from its end on, in which points tell where it ends.
const OUTER: f64 = 0.35;

/// What the points of a contact tell, where they are many: its largest pressure, at `centre` where the pressure is the
/// same all around; the same by the quartic through the five points around the highest, and the pressure at s = 0
/// \[MPa\].
pub fn read(part: Part, centre: f64) -> Option<(Peak, [f64; 2])> {
    if !are_many(part) {
        return None;
    }
    let mut points = with_images(part);
    let highest = nearest_to(&points, |point| -point.pressure)?;
    let [from, to] = of_like_edges(part, points[highest].position);
    points.retain(|point| from <= point.position && point.position <= to);
    let highest = nearest_to(&points, |point| -point.pressure)?;
    let top = around(&points, highest, DROP, FEWEST);
    let PointState { position, pressure, .. } = points[highest];
    let peak = Some(top.top()).filter(|top| top.pressure <= BEYOND * pressure).unwrap_or(Peak { position, pressure });
    let flat = top.value(centre).is_some_and(|middle| peak.pressure <= middle * (1.0 + ROUNDING));
    let origin = nearest_to(&points, |point| point.position.abs())?;
    let at_origin = match points[origin].pressure > 0.0 {
        true => around(&points, origin, DROP, FEWEST).value(0.0).unwrap_or(f64::NAN),
        false => 0.0,
    };
    let through_points = around(&points, highest, 0.0, THROUGH).top().pressure;
    if let Some([pressure, ..]) = beside_axis(part).as_deref().filter(|_| highest == origin) {
        let pressure = *pressure;
        return Some((Peak { position: 0.0, pressure }, [through_points, pressure]));
    }
    Some((if flat { Peak { position: centre, ..peak } } else { peak }, [through_points, at_origin]))
}

/// From where to where edges around a point are not [far wider](WIDER) than its own; with their images where they begin
/// on a symmetry line, s = 0.
fn of_like_edges(part: Part, at: f64) -> [f64; 2] {
    let edges = part.edges;
    let at = if on_one_side(edges) { at.abs() } else { at };
    let own = edges.iter().position(|edge| at <= edge.ends[1]).unwrap_or(edges.len() - 1);
    let is_like = |edge: &&EdgeState| edge.length() <= WIDER * edges[own].length();
    let last = edges[own..].iter().take_while(is_like).count() + own - 1;
    let first = own + 1 - edges[..=own].iter().rev().take_while(is_like).count();
    let [from, to] = [edges[first].ends[0], edges[last].ends[1]];
    [if first == 0 && on_one_side(edges) { -to } else { from }, to]
}

/// The coefficients of `(r/h)^{2k}` in the pressure over the first edge of a body of revolution, from the axis to r =
/// h, by the means that its nodes carry.
///
/// The pressure of a node is `∫ N_a p r dr / ∫ N_a r dr`; where an edge reaches far, as on meshes fitted to the
/// contact, such means lie above and below the profile from node to node, and a polynomial through them misses the
/// axis. The even polynomial of one coefficient fewer than there are nodes inside the edge whose own means are theirs
/// halves that at order 6 and 7, at order 8 it leaves a third. None where points are no nodes, are [few](INNER), or one
/// does not press, or where the means depart from it.
fn beside_axis(part: Part) -> Option<Vec<f64>> {
    let is_at_0 = |s: f64, edge: &EdgeState| s.abs() <= ROUNDING * edge.ends[1];
    let first = part.edges.first().filter(|edge| edge.axis.is_some_and(|axis| is_at_0(axis, edge)))?;
    let first = Some(first).filter(|edge| is_at_0(edge.ends[0], edge))?;
    let nodes: Vec<f64> = lobatto::points(part.nodes).iter().map(|x| 0.5 * (1.0 + x)).collect();
    let inside = part.nodes.checked_sub(2).filter(|inside| *inside >= INNER)?;
    let points = part.points.get(..inside)?;
    let is_node = |(point, node): (&PointState, &f64)| {
        point.pressure > 0.0 && (point.position / first.ends[1] - node).abs() <= ROUNDING
    };
    if !points.iter().zip(&nodes[1..]).all(is_node) {
        return None;
    }
    // Exact on each part for polynomials of degree 15, beyond which `N_a r^{2k+1}` there has next to nothing.
    let rule = lobatto::points(RULE).iter().map(|&x| (x, 1.0 / legendre(RULE - 1, x)[1].powi(2)));
    let part_of = |k: usize| rule.clone().map(move |(x, weight)| ((k as f64 + 0.5 * (1.0 + x)) / PARTS as f64, weight));
    let at: Vec<_> = (0..PARTS).flat_map(part_of).map(|(x, weight)| (x, weight * x, lagrange(&nodes, x))).collect();
    let rows = points.iter().zip(1..).map(|(point, a): (_, usize)| {
        let over = |k: i32| at.iter().map(|(x, area, shapes)| area * shapes[a].0 * x.powi(2 * k)).sum::<f64>();
        (point.weight, powers(inside - 1, |k| over(k) / over(0)), point.pressure)
    });
    let rows: Vec<_> = rows.collect();
    let (coefficients, misfit) = least_squares(inside - 1, rows.into_iter());
    (misfit <= DEPARTS * coefficients[0]).then_some(coefficients)
}

/// Whether the points of a contact are many because its edges have many nodes; of others a few may be cut into many
/// pieces where meshes do not match, and single pressures then hang on round-off.
pub fn are_many(part: Part) -> bool {
    !part.edges.is_empty() && part.nodes > MANY
}

/// Pressure at a place: where all points of an edge press that are as many as its nodes, the polynomial through them,
/// which is the edge's own; beside the axis of revolution, whose node carries none, the even one of the means that the
/// others carry; elsewhere the line between the two points around it, and between the outermost point and the end of
/// the candidates the line through the last two where both press, but for a symmetry line. Zero beyond the candidate
/// stretch.
pub fn pressure_at(part: Part, stretch: f64, position: f64) -> f64 {
    let near = ROUNDING * stretch;
    let on = |[from, to]: [f64; 2]| move |at: f64| from - near <= at && at <= to + near;
    let own = part.edges.iter().find(|edge| on(edge.ends)(position)).filter(|_| are_many(part)).map(|edge| {
        part.points.iter().filter(|point| on(edge.ends)(point.position) && point.pressure > 0.0).collect::<Vec<_>>()
    });
    let first = part.edges.first().filter(|edge| on(edge.ends)(position) && own.is_some());
    if let Some((even, x)) = first.and_then(|edge| Some((beside_axis(part)?, position / edge.ends[1]))) {
        return even.iter().rfold(0.0, |sum, coefficient| coefficient + x * x * sum);
    }
    match own.filter(|own| own.len() == part.nodes) {
        Some(own) => {
            let places: Vec<f64> = own.iter().map(|point| point.position).collect();
            lagrange(&places, position).iter().zip(own).map(|((shape, _), point)| shape * point.pressure).sum()
        }
        None if position.abs() <= stretch + near => {
            beyond(part, position).unwrap_or_else(|| profile::interpolate(part.points, stretch, position))
        }
        None => 0.0,
    }
}

/// Pressure between the outermost point and the end of the candidates, by the line through the last two points where
/// both press, and not below 0; none elsewhere, nor at a symmetry line, s = 0.
fn beyond(Part { points, edges, .. }: Part, position: f64) -> Option<f64> {
    let line = |a: &PointState, b: &PointState| {
        let slope = (b.pressure - a.pressure) / (b.position - a.position);
        (a.pressure > 0.0 && b.pressure > 0.0).then(|| (b.pressure + slope * (position - b.position)).max(0.0))
    };
    match points {
        [.., a, b] if position > b.position => line(a, b),
        [b, a, ..] if position < b.position && !on_one_side(edges) => line(a, b),
        _ => None,
    }
}

/// Where a stretch ends, from its pressed points in the order towards that end \[mm, or rad\].
///
/// Near a smooth end `p ∝ √(a − s)`, so that p² is as smooth as the contact itself: its parabola over the last third of
/// the stretch, but for the outermost point, which has felt the end most, vanishes at a.
pub fn end(pressed: &[PointState]) -> f64 {
    let [first, .., before, last] = pressed else { return pressed.last().map_or(f64::NAN, |point| point.position) };
    let (width, gap) = (last.position - first.position, last.position - before.position);
    let near = pressed.iter().rev().skip(1).enumerate();
    let near = near.take_while(|(k, point)| *k < SQUARES || last.position - point.position <= OUTER * width);
    let squares = near.map(|(_, p)| PointState { pressure: p.pressure.powi(2), weight: 1.0, ..*p }).collect::<Vec<_>>();
    let found = Fit::of_points(&squares, squares.len().min(PARABOLA)).root(last.position);
    // A profile that does not end smoothly says no more than where its last point is.
    if found.is_finite() { found.clamp(before.position, last.position + 2.0 * gap) } else { last.position }
}

/// The points, with their images where the contact begins on a symmetry line, s = 0.
fn with_images(part: Part) -> Vec<PointState> {
    let (first, last) = (part.edges[0].ends[0], part.edges[part.edges.len() - 1].ends[1]);
    let near = ROUNDING * last;
    let images = part.points.iter().rev().filter(|point| first.abs() <= near && point.position > near);
    images.map(PointState::mirrored).chain(part.points.iter().copied()).collect()
}

fn nearest_to(points: &[PointState], away: impl Fn(&PointState) -> f64) -> Option<usize> {
    (0..points.len()).min_by(|&a, &b| away(&points[a]).total_cmp(&away(&points[b])))
}

/// The fit over the pressed points around one: those that differ from it by no more than a drop, and so many at least.
fn around(points: &[PointState], at: usize, drop: f64, fewest: usize) -> Fit {
    let size = points[at].pressure;
    let off = |k: usize| (points[k].pressure - size).abs() / size;
    let Range { mut start, mut end } = at..at + 1;
    loop {
        let within = |k: &usize| points[*k].pressure > 0.0 && (off(*k) <= drop || end - start < fewest);
        let before = start.checked_sub(1).filter(within);
        let after = Some(end).filter(|&k| k < points.len()).filter(within);
        match (before, after) {
            // The nearer one first, so that the window stays around the point; two as near, images, together.
            (Some(k), Some(l)) if away(points, at, k) < away(points, at, l) * (1.0 - ROUNDING) => start = k,
            (Some(k), Some(l)) if away(points, at, k) <= away(points, at, l) * (1.0 + ROUNDING) => {
                (start, end) = (k, l + 1);
            }
            (_, Some(l)) => end = l + 1,
            (Some(k), None) => start = k,
            (None, None) => return over_points(&points[start..end]),
        }
    }
}

/// Distance of two points.
fn away(points: &[PointState], a: usize, b: usize) -> f64 {
    (points[a].position - points[b].position).abs()
}

/// Least squares over the pressures of some points, weighted by their areas: from a quartic to a sextic with one
/// coefficient fewer than points, and up to an octic where there are twice as many. Of a profile that peaks off its
/// middle, as the pin's in the rod, a quartic misses the top by 1e-5.
fn over_points(points: &[PointState]) -> Fit {
    let few = points.len().saturating_sub(1).clamp(QUARTIC, SEXTIC);
    let count = few.max((points.len() / 2).min(OCTIC));
    Fit::of_points(points, if points.len() >= QUARTIC { count } else { 1 })
}
