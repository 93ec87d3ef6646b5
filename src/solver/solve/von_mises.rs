//! The largest von Mises stress of a body.

use std::collections::HashSet;

use crate::elasticity::stress;
use crate::error::Error;
use crate::solve::largest::{NEAR, grid, largest_around};
use crate::solve::without_limit::PRESSURE;
use crate::solve::{Discretisation, Run, WithoutLimit};

/// The largest von Mises stress of a body.
#[derive(Clone, Debug)]
pub struct VonMises {
    /// Index of the body.
    pub body: usize,
    /// It and its place; none where it lies beside a place at which the stress has no limit.
    pub largest: Option<Largest>,
    /// The places of the body at which the stress has none.
    pub without_limit: Vec<WithoutLimit>,
}

/// A largest stress, and where it is.
#[derive(Clone, Copy, Debug)]
pub struct Largest {
    /// `√(½ ((σ_x − σ_y)² + (σ_y − σ_z)² + (σ_z − σ_x)²) + 3 τ²)`, where σ_z is 0 in plane stress, `ν (σ_x + σ_y)` in
    /// plane strain, and in bodies of revolution the hoop stress \[MPa\].
    pub stress: f64,
    /// Its place \[mm\].
    pub at: [f64; 2],
    /// Width of the cell that it lies in \[mm\].
    pub within: f64,
}

impl Discretisation {
    /// The largest von Mises stress of every body under the displacements of all nodes \[mm\] that a run found.
    pub fn largest_von_mises(&self, run: &Run, displacement: &[[f64; 2]]) -> Result<Vec<VonMises>, Error> {
        let stress = stress::at_nodes(&self.scene, &self.mesh, displacement)?;
        let across = self.across(displacement, &stress);
        let tensors: Vec<[f64; 4]> = stress.iter().zip(across).map(|(&[x, y, xy], z)| [x, y, xy, z]).collect();
        let grid = grid(self.mesh.order.nodes_per_cell());
        let of_body = |body: usize| {
            let without_limit = self.without_limit(run, displacement, body)?;
            let largest = self.largest_of(body, &tensors, &grid, &without_limit);
            Ok(VonMises { body, largest, without_limit })
        };
        (0..self.scene.bodies.len()).map(of_body).collect()
    }

    /// The largest one inside the cells of a body, but for those at places without limit: none where those have a
    /// larger one, since it grows with every finer mesh.
    fn largest_of(
        &self,
        body: usize,
        tensors: &[[f64; 4]],
        grid: &[([f64; 2], Vec<f64>)],
        without_limit: &[WithoutLimit],
    ) -> Option<Largest> {
        if without_limit.iter().any(|one| one.because == PRESSURE) {
            return None;
        }
        let singular: HashSet<usize> = without_limit.iter().flat_map(|one| one.nodes.iter().copied()).collect();
        let cells = self.mesh.bodies[body].cells.clone();
        let first = self.mesh.bodies[body].nodes.start;
        let at_nodes: Vec<f64> = tensors[self.mesh.bodies[body].nodes.clone()].iter().copied().map(von_mises).collect();
        let at_nodes = |cell: usize| self.mesh.cell(cell).iter().map(|&node| at_nodes[node - first]);
        let largest = |cell: usize| at_nodes(cell).fold(f64::NEG_INFINITY, f64::max);
        let is_beside = |cell: &usize| self.mesh.cell(*cell).iter().any(|node| singular.contains(node));
        let (beside, elsewhere): (Vec<usize>, Vec<usize>) = cells.partition(is_beside);
        let most = elsewhere.iter().map(|&cell| largest(cell)).fold(f64::NEG_INFINITY, f64::max);
        // Nodes that both share are no larger on one side than on the other.
        if !beside.iter().all(|&cell| largest(cell) < most) {
            return None;
        }
        let near = elsewhere.into_iter().filter(|&cell| largest(cell) >= NEAR * most);
        let all =
            near.flat_map(|cell| grid.iter().map(move |(at, shapes)| (cell, *at, self.inside(cell, shapes, tensors))));
        let (cell, at, _) = all.max_by(|a, b| a.2.stress.total_cmp(&b.2.stress))?;
        let inside = |shapes: &[f64]| Some(self.inside(cell, shapes, tensors));
        largest_around(self.mesh.order.nodes_per_cell(), at, inside, |one| one.stress)
    }

    /// The stress at a place of a cell, given its shape functions.
    fn inside(&self, cell: usize, shapes: &[f64], tensors: &[[f64; 4]]) -> Largest {
        let (mut at, mut tensor) = ([0.0; 2], [0.0; 4]);
        let nodes = self.mesh.cell(cell);
        for (&node, shape) in nodes.iter().zip(shapes) {
            (0..2).for_each(|k| at[k] += shape * self.mesh.points[node][k]);
            (0..4).for_each(|k| tensor[k] += shape * tensors[node][k]);
        }
        let [a, b] = [nodes[0], nodes[2]].map(|node| self.mesh.points[node]);
        Largest { stress: von_mises(tensor), at, within: (b[0] - a[0]).hypot(b[1] - a[1]) }
    }
}

fn von_mises([x, y, xy, z]: [f64; 4]) -> f64 {
    stress::von_mises([x, y, xy], z)
}
