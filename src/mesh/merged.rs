//! Meshes made elsewhere, coarser: four cells made one where all of a mesh was halved from a coarser one, or cells without the nodes
//! on their sides.

use std::collections::{BTreeMap, VecDeque};

use super::given::on_side;
use crate::scene::GivenMesh;

/// What a corner of a cell is in the coarser mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Corner,
    Side,
    Centre,
}

impl Kind {
    /// Of the corners of a cell, counter-clockwise from that of the coarser mesh on.
    const AROUND: [Self; 4] = [Self::Corner, Self::Side, Self::Centre, Self::Side];
}

/// A cell of the coarser mesh: its corners counter-clockwise, and the nodes on its sides from the first on.
struct Four {
    corners: [usize; 4],
    sides: [usize; 4],
}

impl GivenMesh {
    /// The mesh whose cells, halved both ways, are those of this one; none where there is no such mesh, or where a boundary of it
    /// would end within a side.
    pub fn merged(&self) -> Option<Self> {
        let fours = (0..4).find_map(|first| self.fours(&self.kinds(first)?))?;
        let is_quadratic = self.cells[0].len() == 8;
        let arcs = self.arcs();
        let mut coarse = Coarse { fine: self, points: Vec::new(), numbers: BTreeMap::new() };
        let mut middles: BTreeMap<[usize; 2], usize> = BTreeMap::new();
        let mut cells = Vec::with_capacity(fours.len());
        for Four { corners, sides } in &fours {
            let mut cell: Vec<usize> = corners.iter().map(|&node| coarse.kept(node)).collect();
            for k in (0..4).filter(|_| is_quadratic) {
                let [a, b] = [corners[k], corners[(k + 1) % 4]];
                let middle = *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
                    let centre = [[a, sides[k]], [sides[k], b], [b, sides[k]], [sides[k], a]];
                    let centre = centre.iter().find_map(|half| arcs.get(half).copied());
                    coarse.add(self.middle([a, sides[k], b], centre))
                });
                cell.push(middle);
            }
            cells.push(cell);
        }
        let mut boundaries = BTreeMap::new();
        for (name, edges) in &self.boundaries {
            let mut merged = Vec::with_capacity(edges.len() / 2);
            for [a, b] in halves(edges, &fours)? {
                let middle = middles.get(&[a.min(b), a.max(b)]).copied();
                merged.push([coarse.kept(a), coarse.kept(b)].into_iter().chain(middle).collect());
            }
            boundaries.insert(name.clone(), merged);
        }
        Some(Self { points: coarse.points, cells, boundaries, inner: self.inner.clone() })
    }

    /// The same cells without the nodes on their sides; none where they have none.
    pub fn without_sides(&self) -> Option<Self> {
        if self.cells.iter().any(|cell| cell.len() != 8) {
            return None;
        }
        let mut coarse = Coarse { fine: self, points: Vec::new(), numbers: BTreeMap::new() };
        let cells = self.cells.iter().map(|cell| cell[..4].iter().map(|&node| coarse.kept(node)).collect()).collect();
        let mut boundaries = BTreeMap::new();
        for (name, edges) in &self.boundaries {
            let straight = edges.iter().map(|edge| edge[..2].iter().map(|&node| coarse.kept(node)).collect());
            boundaries.insert(name.clone(), straight.collect());
        }
        Some(Self { points: coarse.points, cells, boundaries, inner: self.inner.clone() })
    }

    /// What every corner of a cell would be in the coarser mesh, if one of the first cell's were a corner there; none where that
    /// contradicts itself, or some cell is in another piece.
    fn kinds(&self, first: usize) -> Option<Vec<Option<Kind>>> {
        let mut beside: BTreeMap<[usize; 2], Vec<usize>> = BTreeMap::new();
        let edge = |cell: &[usize], k: usize| {
            let [a, b] = [cell[k], cell[(k + 1) % 4]];
            [a.min(b), a.max(b)]
        };
        for (index, cell) in self.cells.iter().enumerate() {
            (0..4).for_each(|k| beside.entry(edge(cell, k)).or_default().push(index));
        }
        let mut kinds = vec![None; self.points.len()];
        let mut is_known = vec![false; self.cells.len()];
        let mut next = VecDeque::from([(0, first)]);
        while let Some((index, corner)) = next.pop_front() {
            let cell = &self.cells[index];
            for (k, kind) in Kind::AROUND.into_iter().enumerate() {
                let known = kinds[cell[(corner + k) % 4]].get_or_insert(kind);
                if *known != kind {
                    return None;
                }
            }
            if std::mem::replace(&mut is_known[index], true) {
                continue;
            }
            for other in (0..4).flat_map(|k| &beside[&edge(cell, k)]).filter(|other| !is_known[**other]) {
                next.push_back((*other, self.corner_of(*other, &kinds)?));
            }
        }
        is_known.into_iter().all(|known| known).then_some(kinds)
    }

    /// Which corner of a cell is one of the coarser mesh, told by another corner that is known.
    fn corner_of(&self, cell: usize, kinds: &[Option<Kind>]) -> Option<usize> {
        (0..4).find_map(|k| match kinds[self.cells[cell][k]]? {
            Kind::Corner => Some(k),
            Kind::Centre => Some((k + 2) % 4),
            Kind::Side => None,
        })
    }

    /// The cells in fours around their centres, in the order of their first ones; none where a centre has not four.
    fn fours(&self, kinds: &[Option<Kind>]) -> Option<Vec<Four>> {
        let mut around: BTreeMap<usize, Vec<[usize; 3]>> = BTreeMap::new();
        let mut order = Vec::new();
        for cell in &self.cells {
            let corner = (0..4).find(|&k| kinds[cell[k]] == Some(Kind::Corner))?;
            let [out, centre, into] = [1, 2, 3].map(|k| cell[(corner + k) % 4]);
            let known = around.entry(centre).or_default();
            if known.is_empty() {
                order.push(centre);
            }
            known.push([into, cell[corner], out]);
        }
        order.iter().map(|centre| four(&around[centre])).collect()
    }

    /// Middle of a side of the coarser mesh through three corners: on its circle, or where a parabola through them is halfway along.
    fn middle(&self, nodes: [usize; 3], centre: Option<[f64; 2]>) -> [f64; 2] {
        let [a, m, b] = nodes.map(|node| self.points[node]);
        if centre.is_some() {
            return on_side([a, b], None, centre, 0.5);
        }
        let length = |from: [f64; 2], to: [f64; 2]| (to[0] - from[0]).hypot(to[1] - from[1]);
        let part = length(a, m) / (length(a, m) + length(m, b));
        let [first, second, last] =
            [0.5 * (part - 0.5) / part, 0.25 / (part * (1.0 - part)), 0.5 * (0.5 - part) / (1.0 - part)];
        [0, 1].map(|k| first * a[k] + second * m[k] + last * b[k])
    }
}

/// The nodes of a coarser mesh.
struct Coarse<'a> {
    fine: &'a GivenMesh,
    points: Vec<[f64; 2]>,
    /// By the numbers of the finer one.
    numbers: BTreeMap<usize, usize>,
}

impl Coarse<'_> {
    /// Number of a node of the finer mesh.
    fn kept(&mut self, node: usize) -> usize {
        *self.numbers.entry(node).or_insert_with(|| {
            self.points.push(self.fine.points[node]);
            self.points.len() - 1
        })
    }

    /// Number of a new node.
    fn add(&mut self, point: [f64; 2]) -> usize {
        self.points.push(point);
        self.points.len() - 1
    }
}

/// Four cells, each as the side before its corner, that corner, and the side after it, in a ring.
fn four(cells: &[[usize; 3]]) -> Option<Four> {
    let [first, ..] = cells else { return None };
    let mut ring = vec![*first];
    while ring.len() < cells.len() {
        let last = ring[ring.len() - 1];
        ring.push(*cells.iter().find(|cell| cell[0] == last[2])?);
    }
    let ring: [[usize; 3]; 4] = ring.try_into().ok()?;
    (ring[3][2] == ring[0][0]).then(|| Four { corners: ring.map(|cell| cell[1]), sides: ring.map(|cell| cell[2]) })
}

/// Ends of the sides of the coarser mesh on a boundary, each of two edges of it; none where one has no other half.
fn halves(edges: &[Vec<usize>], fours: &[Four]) -> Option<Vec<[usize; 2]>> {
    let sides: BTreeMap<usize, [usize; 2]> = fours
        .iter()
        .flat_map(|four| (0..4).map(move |k| (four.sides[k], [four.corners[k], four.corners[(k + 1) % 4]])))
        .collect();
    let ends: BTreeMap<usize, usize> = edges.iter().map(|edge| (edge[0], edge[1])).collect();
    let begun = edges.iter().filter(|edge| sides.contains_key(&edge[1]));
    let all: Vec<[usize; 2]> = begun.filter_map(|edge| Some([edge[0], *ends.get(&edge[1])?])).collect();
    (2 * all.len() == edges.len()).then_some(all)
}
