//! The same mesh told differently: mirrored, or with its nodes renumbered. Results must not notice.

use crate::mesh::{Edge, Mesh, Order};

impl Mesh {
    /// The mesh seen in a mirror on x = 0, its cells and edges still counter-clockwise.
    pub fn mirrored(&self) -> Self {
        let mut mesh = self.clone();
        mesh.points.iter_mut().for_each(|point| point[0] = -point[0]);
        let order: &[usize] = match self.order {
            Order::Linear => &[1, 0, 3, 2],
            Order::Quadratic => &[1, 0, 3, 2, 4, 7, 6, 5],
        };
        mesh.connectivity = (0..self.cells()).flat_map(|cell| order.iter().map(move |&k| self.cell(cell)[k])).collect();
        for body in &mut mesh.bodies {
            let edges = body.boundaries.values_mut().chain(body.lines.values_mut()).flatten();
            edges.for_each(|edge: &mut Edge| edge.swap(0, 1));
            body.candidates.iter_mut().for_each(|candidate| candidate.normal[0] = -candidate.normal[0]);
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
