//! Where the contact found on a mesh begins and ends.

use crate::scene::ContactPair;
use crate::solution::{PointState, Solution};

/// Pressure over the largest one from which on a point or an element counts as pressed: iterations that stop at a residual
/// leave less outside the contact.
const FAINT: f64 = 1e-3;

/// Candidate elements within the contact, from the symmetry line on where there is one, and from x = 0 to its outer end.
pub fn pressed(solution: &Solution, pair: &ContactPair) -> [usize; 2] {
    let edges = &solution.edges;
    let (Some(first), Some(last)) = (first_pressed(edges), last_pressed(edges)) else { return [0, 0] };
    if !pair.path.has_both_sides() {
        return [last + 1, last + 1];
    }
    let middle = edges.len() / 2;
    [last + 1 - first, (last + 1).saturating_sub(middle).max(middle.saturating_sub(first))]
}

/// Whether the contact goes on to the outermost candidate on the left and on the right; on a symmetry line it does not end.
pub fn filled(solution: &Solution, pair: &ContactPair) -> [bool; 2] {
    let points = &solution.points;
    let left = pair.path.has_both_sides() && first_pressed(points) == Some(0);
    [left, last_pressed(points).is_some_and(|last| last + 1 == points.len())]
}

/// Where the contact begins and ends \[mm, or rad\]: at the outermost candidate where it goes on to that, and as far to the
/// left as to the right of a symmetry line.
///
/// Each end of a contact with both sides is found from its own half, the left one seen in a mirror.
pub fn ends(solution: &Solution, pair: &ContactPair) -> [f64; 2] {
    let (edges, stretch) = (&solution.edges, pair.stretch);
    let filled = filled(solution, pair);
    let outermost =
        |filled: bool, edges: &[PointState], from: f64| if filled { stretch } else { edge(edges, [from, stretch]) };
    if !pair.path.has_both_sides() {
        let edge = outermost(filled[1], edges, 0.0);
        return [-edge, edge];
    }
    let (Some(first), Some(last)) = (first_pressed(edges), last_pressed(edges)) else { return [f64::NAN; 2] };
    // Where the element in the middle ends and begins; the corner there, where there is none.
    let [after, before] = [(first + last) / 2 + 1, (first + last).div_ceil(2)];
    let corner = |k: usize| stretch * (2.0 * area(&edges[..k]) / area(edges) - 1.0);
    let mirrored: Vec<PointState> = edges[..after].iter().rev().copied().collect();
    [-outermost(filled[0], &mirrored, -corner(after)), outermost(filled[1], &edges[before..], corner(before))]
}

/// Where the contact ends on candidate elements between two contact coordinates \[mm, or rad\].
///
/// Near a smooth end `p ∝ √(a − s)`, so that the force beyond s, `F = ∫ p ds`, goes with `(a − s)^{3/2}`: `F^{2/3}` at the
/// corners of the last elements, as a polynomial through up to three of them, vanishes at a. The element in which the
/// contact ends has felt the end most and is left out where there are enough others.
pub fn edge(edges: &[PointState], [from, to]: [f64; 2]) -> f64 {
    let Some(last) = last_pressed(edges) else { return f64::NAN };
    let total = area(edges);
    let beyond = |from: usize| -> f64 { edges[from..=last].iter().map(force).sum() };
    let begin = |k: usize| from + (to - from) * area(&edges[..k]) / total;
    let newest = if last >= 3 { last - 1 } else { last };
    let nodes: Vec<[f64; 2]> =
        (newest.saturating_sub(2)..=newest).map(|k| [beyond(k).powf(2.0 / 3.0), begin(k)]).collect();
    let at_zero = (0..nodes.len()).map(|i| {
        let others = (0..nodes.len()).filter(|&k| k != i);
        others.fold(nodes[i][1], |term, k| term * nodes[k][0] / (nodes[k][0] - nodes[i][0]))
    });
    let found: f64 = at_zero.sum();
    // One element alone, or a profile that does not end smoothly, says no more than where the last element is.
    let (low, end) = (begin(last), begin(last + 1));
    if nodes.len() > 1 && found.is_finite() { found.clamp(low, end + (end - low)) } else { end }
}

fn area(edges: &[PointState]) -> f64 {
    edges.iter().map(|edge| edge.weight).sum()
}

fn force(edge: &PointState) -> f64 {
    edge.weight * edge.pressure
}

fn first_pressed(states: &[PointState]) -> Option<usize> {
    let least = faint(states);
    states.iter().position(|state| state.pressure > least)
}

fn last_pressed(states: &[PointState]) -> Option<usize> {
    let least = faint(states);
    states.iter().rposition(|state| state.pressure > least)
}

fn faint(states: &[PointState]) -> f64 {
    FAINT * states.iter().map(|state| state.pressure).fold(0.0, f64::max)
}
