//! Where the closed stretches of a contact begin and end.

use crate::measure::fit::ROUNDING;
use crate::measure::nodal;
use crate::scene::ContactPair;
use crate::solution::{EdgeState, Part, PointState};

/// A stretch that is pressed throughout.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Stretch {
    /// Contact coordinate where it begins; 0 on a symmetry line \[mm, or rad on an arc\].
    pub begin: f64,
    /// Where it ends.
    pub end: f64,
    /// Whether it goes on to the first, and to the last candidate.
    pub reaches: [bool; 2],
    /// Whether it begins on a symmetry line.
    #[serde(skip)]
    pub on_line: bool,
    /// Where the first of the edges that tell it begins, and the last one ends.
    #[serde(skip)]
    pub edges: [f64; 2],
}

impl Stretch {
    /// Half its width, or all of it where it begins on a symmetry line \[mm, or rad\].
    pub fn half_width(&self) -> f64 {
        if self.begins_within() { 0.5 * (self.end - self.begin) } else { self.end }
    }

    /// Whether it begins at an end of its own, and not on a symmetry line.
    pub fn begins_within(&self) -> bool {
        !self.on_line
    }
}

/// Every closed stretch: runs of edges whose mean is above a floor.
///
/// One that goes on to the outermost candidate ends there, or begins on the symmetry line; elsewhere its ends are found
/// by `end`.
pub fn closed(pair: &ContactPair, part: Part, floor: f64) -> Vec<Stretch> {
    let pressed: Vec<bool> = part.edges.iter().map(|edge| edge.pressure > floor).collect();
    let mut stretches = Vec::new();
    let mut first = 0;
    for run in pressed.chunk_by(|a, b| a == b) {
        if run[0] {
            stretches.push(one(pair, part, floor, [first, first + run.len()]));
        }
        first += run.len();
    }
    stretches
}

/// How far points press by more than a floor beyond the ends of stretches, one after the other from the edges that tell
/// these, and up to those of the next stretch \[mm, or rad\].
pub fn faint(points: &[PointState], stretches: &[Stretch], floor: f64) -> f64 {
    let beyond = |k: usize| {
        let Stretch { begin, end, edges: [first, last], .. } = stretches[k];
        let [low, high] = [k.checked_sub(1), Some(k + 1)].map(|other| stretches.get(other?).map(|other| other.edges));
        let [low, high] =
            [low.map_or(f64::NEG_INFINITY, |edges| edges[1]), high.map_or(f64::INFINITY, |edges| edges[0])];
        let presses = |point: &&PointState| point.pressure > floor && (low..=high).contains(&point.position);
        let after = points.iter().skip_while(|point| point.position <= last).take_while(presses).last();
        let before = points.iter().rev().skip_while(|point| point.position >= first).take_while(presses).last();
        before.map_or(0.0, |first| begin - first.position).max(after.map_or(0.0, |last| last.position - end))
    };
    (0..stretches.len()).map(beyond).fold(0.0, f64::max)
}

/// Part of the floor of pressures from which on the edge beside a stretch belongs to it.
const LEAST: f64 = 0.1;

/// The stretch of the edges from one on, up to another.
fn one(pair: &ContactPair, part: Part, floor: f64, [from, to]: [usize; 2]) -> Stretch {
    let Part { points, edges, .. } = part;
    let [first, last] = [points.first(), points.last()].map(|p| p.is_some_and(|point| point.pressure > floor));
    // A cell with many points may be open on the symmetry line and pressed farther out.
    let begins_there = edges[0].ends[0] >= -ROUNDING * edges[0].length();
    let on_line = from == 0 && !pair.path.has_both_sides() && begins_there && (first || !nodal::are_many(part));
    let reaches = [from == 0 && !on_line && first, to == edges.len() && last];
    // The half that ends there, so that a mirror image ends where its image does.
    let half = if on_line { to - from } else { (to - from).div_ceil(2) };
    let many = nodal::are_many(part);
    let [low, high] = [edges[from].ends[0], edges[to - 1].ends[1]];
    let within = |point: &&PointState| point.pressure > floor && (low..=high).contains(&point.position);
    let pressed: Vec<PointState> = points.iter().filter(within).copied().collect();
    let images = || pressed.iter().rev().map(PointState::mirrored).collect::<Vec<_>>();
    // The edge in which a contact ends may press by less.
    let presses = |k: usize| edges.get(k).is_some_and(|edge| edge.pressure > LEAST * floor);
    let before = if from > 0 && presses(from - 1) { from - 1 } else { from };
    let behind = if presses(to) { to + 1 } else { to };
    let mirrored: Vec<EdgeState> = edges[before..from + half].iter().rev().map(EdgeState::mirrored).collect();
    let begin = match () {
        _ if on_line => 0.0,
        _ if reaches[0] => edges[0].ends[0],
        _ if many && pair.path.has_both_sides() => -nodal::end(&images()),
        _ if many => (-nodal::end(&images())).max(0.0),
        _ => -end(&mirrored, from - before),
    };
    let end = match () {
        _ if reaches[1] => edges[to - 1].ends[1],
        _ if many => nodal::end(&pressed),
        _ => end(&edges[to - half..behind], behind - to),
    };
    let told = [edges[before].ends[0], edges[behind - 1].ends[1]];
    Stretch { begin, end, reaches, on_line: on_line || is_at_line(pair, begin), edges: told }
}

/// Whether a contact that begins at a place begins on its symmetry line, if it has one.
pub(crate) fn is_at_line(pair: &ContactPair, begin: f64) -> bool {
    !pair.path.has_both_sides() && begin <= ROUNDING * pair.stretch
}

/// Where a contact ends on edges that are all pressed, in the order towards that end, the last ones by less than a
/// floor \[mm, or rad\].
///
/// Near a smooth end `p ∝ √(a − s)`, so that the force beyond s, `F = ∫ p ds`, goes with `(a − s)^{3/2}`: `F^{2/3}` at
/// the corners of the last edges, as a polynomial through up to three of them, vanishes at a. Of rings it is one of the
/// squares of their radii, with which Hertz's goes all the way from the axis. The edge in which the contact ends has
/// felt the end most and is left out where there are enough others.
fn end(edges: &[EdgeState], less: usize) -> f64 {
    let Some(last) = edges.len().checked_sub(1) else { return f64::NAN };
    let beyond = |from: usize| -> f64 { edges[from..].iter().map(|edge| edge.measure() * edge.pressure).sum() };
    let newest = if last >= 3 { last - 1 } else { last };
    let axis = edges[last].axis;
    let place = |s: f64| axis.map_or(s, |axis| (s - axis).powi(2));
    let nodes: Vec<[f64; 2]> =
        (newest.saturating_sub(2)..=newest).map(|k| [beyond(k).powf(2.0 / 3.0), place(edges[k].ends[0])]).collect();
    let at_zero = (0..nodes.len()).map(|i| {
        let others = (0..nodes.len()).filter(|&k| k != i);
        others.fold(nodes[i][1], |term, k| term * nodes[k][0] / (nodes[k][0] - nodes[i][0]))
    });
    let found: f64 = at_zero.sum();
    let found = axis.map_or(found, |axis| axis + found.sqrt().copysign(edges[last].ends[1] - axis));
    // One edge alone, or a profile that does not end smoothly, says no more than where the last edge is.
    let ([low, _], [begin, end]) = (edges[last - less].ends, edges[last].ends);
    if nodes.len() > 1 && found.is_finite() { found.clamp(low, end + (end - begin)) } else { end }
}
