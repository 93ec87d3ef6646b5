//! A mesh made elsewhere, and the circles that its outline follows.

use std::collections::{BTreeMap, BTreeSet, VecDeque};

use crate::scene::{BoundaryName, Curve};

/// Nodes, cells and boundaries of one body.
#[derive(Clone, Debug)]
pub struct GivenMesh {
    /// Node positions \[mm\].
    pub points: Vec<[f64; 2]>,
    /// Four, eight or nine nodes each: corners counter-clockwise, then mid-sides from the first edge on, then the
    /// middle.
    pub cells: Vec<Vec<usize>>,
    /// Edges by boundary: first node, last node and, for 8-node cells, the mid-side node; the body lies to their left.
    pub boundaries: BTreeMap<BoundaryName, Vec<Vec<usize>>>,
    /// Sets of nodes that are no boundary, as they leave a side half told.
    pub half_told: BTreeMap<BoundaryName, HalfTold>,
    /// Boundaries that run inside the body: no side of them is the outer one.
    pub inner: BTreeSet<BoundaryName>,
    /// Cells that were listed clockwise where they were made, and have been turned.
    pub turned: usize,
    /// Half a unit of the last digit that the coordinates have in their file \[mm\].
    pub rounding: f64,
}

/// What a set of nodes lacks to be a boundary; nodes by their numbers in the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HalfTold {
    /// It has this node, but not all nodes of a side with it.
    Alone(u64),
    /// It lacks this node, between two of its sides that lie along one line.
    Hole(u64),
}

/// Largest turn from one chord of an arc to the next: the corners of a square lie on a circle too \[rad\].
const TURN: f64 = 0.5;
/// Distance of a node from the circle of its neighbours, over the rise of a chord, up to which it lies on it.
const SAME: f64 = 1e-4;
/// The same over the rounding of coordinates: √2 from that of the node, 1.25 times as much from the three nodes by
/// which the circle is found.
const ROUNDED: f64 = 4.0;
/// Rise of an arc over the rounding of coordinates from which it is seen: three chords of a circle and one of its
/// tangent leave their circle by a tenth of their rise.
const SEEN: f64 = 100.0;
/// Most edges from which a circle is found.
const MOST: usize = 256;
/// Radius over the chord above which an arc is a straight line.
const STRAIGHT: f64 = 1e5;

impl GivenMesh {
    /// Edges of the outline that lie on a circle, by their first and last node, and its centre \[mm\]: four neighbours
    /// of two nodes each, or two of three, all of whose nodes lie on it. Three make no circle: those of a flat between
    /// two bevels do.
    pub fn arcs(&self) -> BTreeMap<[usize; 2], [f64; 2]> {
        let outline = self.outline();
        let [before, next] =
            [1, 0].map(|end| outline.iter().map(|edge| (edge[end], edge)).collect::<BTreeMap<usize, &Vec<usize>>>());
        let mut arcs = BTreeMap::new();
        for first in &outline {
            let wanted = if first.len() == 3 { 2 } else { 4 };
            let mut run: VecDeque<&Vec<usize>> =
                std::iter::successors(Some(first), |edge| next.get(&edge[1]).copied()).take(wanted).collect();
            let known =
                self.centre_of(&run).filter(|_| run.len() == wanted && !arcs.contains_key(&[first[0], first[1]]));
            let Some(mut centre) = known else { continue };
            // The longest arc has the centre that rounding moves least.
            for ahead in [true, false] {
                let longer = |run: &VecDeque<_>| {
                    let mut run: VecDeque<&Vec<usize>> = run.clone();
                    match ahead {
                        true => run.push_back(*next.get(&run.back()?[1])?),
                        false => run.push_front(*before.get(&run.front()?[0])?),
                    }
                    Some((self.centre_of(&run).filter(|_| run.len() <= MOST)?, run))
                };
                while let Some(grown) = longer(&run) {
                    (centre, run) = grown;
                }
            }
            for edge in run {
                arcs.entry([edge[0], edge[1]]).or_insert(centre);
            }
        }
        arcs
    }

    /// Edges that belong to one cell only, the body to their left.
    fn outline(&self) -> Vec<Vec<usize>> {
        let mut sides: BTreeMap<[usize; 2], Option<Vec<usize>>> = BTreeMap::new();
        for cell in &self.cells {
            for k in 0..4 {
                let [a, b] = [cell[k], cell[(k + 1) % 4]];
                let edge = [a, b].into_iter().chain(cell.get(4 + k).copied()).collect();
                sides.entry([a.min(b), a.max(b)]).and_modify(|known| *known = None).or_insert(Some(edge));
            }
        }
        sides.into_values().flatten().collect()
    }

    /// Centre of the circle on which all nodes of some edges in a row lie; none where there is none.
    fn centre_of(&self, run: &VecDeque<&Vec<usize>>) -> Option<[f64; 2]> {
        let nodes = run.iter().flat_map(|edge| [Some(edge[0]), edge.get(2).copied()]).flatten();
        let points: Vec<[f64; 2]> = nodes.chain(run.back().map(|edge| edge[1])).map(|node| self.points[node]).collect();
        let (first, last) = (points[0], *points.last()?);
        let off_middle = |point: &[f64; 2]| (distance(*point, first) - distance(*point, last)).abs();
        let middle = points.iter().min_by(|a, b| off_middle(a).total_cmp(&off_middle(b)))?;
        let centre = circumcentre([first, *middle, last])?;
        let radius = distance(first, centre);
        let turn = |three: &[[f64; 2]]| {
            let [a, b] = [1, 2].map(|k| [0, 1].map(|axis| three[k][axis] - three[k - 1][axis]));
            (a[0] * b[1] - a[1] * b[0]).atan2(a[0] * b[0] + a[1] * b[1])
        };
        let is_round = |pair: &[[f64; 2]]| {
            let chord = distance(pair[0], pair[1]);
            let rise = chord * chord / (8.0 * radius);
            let off = (distance(pair[1], centre) - radius).abs();
            radius <= STRAIGHT * chord && off <= SAME * rise + ROUNDED * self.rounding
        };
        let length: f64 = points.windows(2).map(|pair| distance(pair[0], pair[1])).sum();
        let is_seen = length * length >= 8.0 * radius * SEEN * self.rounding;
        let bends = points.windows(3).all(|three| turn(three).abs() <= TURN);
        (is_seen && bends && points.windows(2).all(is_round)).then_some(centre)
    }

    /// The edges of a boundary on the outline as curves, arcs where they lie on a circle; none where it is not there,
    /// or runs inside.
    pub fn curves(&self, boundary: &str) -> Option<Vec<Curve>> {
        let edges = self.boundaries.get(boundary).filter(|_| !self.inner.contains(boundary))?;
        let arcs = self.arcs();
        let curve = |edge: &Vec<usize>| match arcs.get(&[edge[0], edge[1]]) {
            Some(&centre) => Curve::Arc { centre, ends: [0, 1].map(|k| self.points[edge[k]]) },
            None => Curve::Edge(edge.iter().map(|&node| self.points[node]).collect()),
        };
        Some(edges.iter().map(curve).collect())
    }
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// Centre of the circle through three points; none where they lie on a line.
fn circumcentre([a, b, c]: [[f64; 2]; 3]) -> Option<[f64; 2]> {
    let [u, v] = [b, c].map(|p| [p[0] - a[0], p[1] - a[1]]);
    let twice = 2.0 * (u[0] * v[1] - u[1] * v[0]);
    let [uu, vv] = [u, v].map(|p| p[0] * p[0] + p[1] * p[1]);
    let centre = [a[0] + (v[1] * uu - u[1] * vv) / twice, a[1] + (u[0] * vv - v[0] * uu) / twice];
    centre.iter().all(|x| x.is_finite()).then_some(centre)
}
