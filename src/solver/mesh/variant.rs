//! The same mesh told differently: mirrored, or with its nodes renumbered, which results must not notice; or shaken.

use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::PI;

use crate::mesh::{Edge, Mesh, Order};

impl Mesh {
    /// The mesh seen in a mirror on x = 0, its cells and edges still counter-clockwise.
    pub fn mirrored(&self) -> Self {
        let mut mesh = self.clone();
        mesh.points.iter_mut().for_each(|point| point[0] = -point[0]);
        let (places, m) = (self.order.places(), self.order.intervals());
        let image = |place: &[usize; 2]| places.iter().position(|other| *other == [m - place[0], place[1]]);
        let order: Vec<usize> = places.iter().filter_map(image).collect();
        mesh.connectivity = (0..self.cells()).flat_map(|cell| order.iter().map(move |&k| self.cell(cell)[k])).collect();
        for body in &mut mesh.bodies {
            let edges = body.boundaries.values_mut().chain(body.lines.values_mut()).flatten();
            edges.for_each(|edge: &mut Edge| {
                edge.swap(0, 1);
                edge[2..].reverse();
            });
            body.candidates.iter_mut().for_each(|candidate| candidate.normal[0] = -candidate.normal[0]);
            // On both sides of an origin the contact coordinate changes its sign too.
            for contact in body.candidates.chunk_by_mut(|a, b| a.contact == b.contact) {
                if contact.first().is_some_and(|candidate| candidate.coordinate < 0.0) {
                    contact.iter_mut().for_each(|candidate| candidate.coordinate = -candidate.coordinate);
                    contact.reverse();
                }
            }
        }
        mesh
    }

    /// The mesh with every inner corner moved by a fraction of its shortest edge, in a direction that looks random and
    /// is always the same; edges between the moved corners become straight.
    pub fn shaken(&self, fraction: f64) -> Self {
        let mut mesh = self.clone();
        let sides = |cell: usize| (0..4).map(move |k| (self.cell(cell)[k], self.cell(cell)[(k + 1) % 4]));
        let outer: BTreeSet<usize> =
            self.bodies.iter().flat_map(|body| body.boundaries.values().flatten().flatten().copied()).collect();
        let mut shortest = BTreeMap::new();
        for (a, b) in (0..self.cells()).flat_map(sides) {
            let (p, q) = (self.points[a], self.points[b]);
            let length = (p[0] - q[0]).hypot(p[1] - q[1]);
            for node in [a, b].into_iter().filter(|node| !outer.contains(node)) {
                let known = shortest.entry(node).or_insert(length);
                *known = length.min(*known);
            }
        }
        for (node, length) in shortest {
            let (sin, cos) = (PI * noise(node)).sin_cos();
            mesh.points[node][0] += fraction * length * cos;
            mesh.points[node][1] += fraction * length * sin;
        }
        if self.order == Order::Quadratic {
            for cell in 0..self.cells() {
                for (k, (a, b)) in
                    sides(cell).enumerate().filter(|(_, (a, b))| !outer.contains(a) || !outer.contains(b))
                {
                    let (p, q) = (mesh.points[a], mesh.points[b]);
                    mesh.points[self.cell(cell)[4 + k]] = [0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])];
                }
            }
        }
        if self.order.is_tensor() {
            let natural = self.order.fractions();
            let corner = |cell: usize, k: usize| {
                let node = self.cell(cell)[k];
                [0, 1].map(|axis| mesh.points[node][axis] - self.points[node][axis])
            };
            let moved: Vec<[[f64; 2]; 4]> =
                (0..self.cells()).map(|cell| std::array::from_fn(|k| corner(cell, k))).collect();
            // Every node between moves with the corners of its cell, bilinearly.
            for (cell, corners) in moved.iter().enumerate() {
                for (&node, place) in self.cell(cell).iter().zip(self.order.places()).skip(4) {
                    let [x, y] = place.map(|k| natural[k]);
                    let weights = [(1.0 - x) * (1.0 - y), x * (1.0 - y), x * y, (1.0 - x) * y];
                    let by = |axis: usize| weights.iter().zip(corners).map(|(w, c)| w * c[axis]).sum::<f64>();
                    mesh.points[node] = [0, 1].map(|axis| self.points[node][axis] + by(axis));
                }
            }
        }
        mesh
    }

    /// The mesh with the nodes of each body numbered backwards.
    pub fn renumbered(&self) -> Self {
        let mut mesh = self.clone();
        let mut number: Vec<usize> = (0..self.points.len()).collect();
        for body in &self.bodies {
            number[body.nodes.clone()].reverse();
        }
        number.iter().enumerate().for_each(|(old, &new)| mesh.points[new] = self.points[old]);
        mesh.connectivity.iter_mut().for_each(|node| *node = number[*node]);
        for body in &mut mesh.bodies {
            let edges = body.boundaries.values_mut().chain(body.lines.values_mut()).flatten();
            edges.flatten().for_each(|node| *node = number[*node]);
            body.candidates.iter_mut().for_each(|candidate| candidate.node = number[candidate.node]);
        }
        mesh
    }
}

/// A number in −1 … 1 from an index (SplitMix64; Steele, Lea & Flood 2014).
pub fn noise(index: usize) -> f64 {
    let mut z = (index as u64).wrapping_add(1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    (z ^ (z >> 31)) as f64 / u64::MAX as f64 * 2.0 - 1.0
}
