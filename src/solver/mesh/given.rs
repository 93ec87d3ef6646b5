//! Bodies whose mesh was made elsewhere: taken as they are, or with every cell cut into a lattice of smaller ones.

use std::collections::BTreeMap;

use super::block::{Block, Side, on_side};
use super::spacing;
use super::{BodyMesh, Mesh, Order};
use crate::error::Error;
use crate::scene::{BoundaryName, GivenMesh, Scene, Shape};

impl Mesh {
    /// Adds a body with the nodes, cells and boundaries it came with.
    pub(super) fn append_given(&mut self, given: &GivenMesh) {
        let (first_node, first_cell) = (self.points.len(), self.cells());
        let shifted = |edge: &Vec<usize>| edge.iter().map(|node| first_node + node).collect();
        let boundaries = given.boundaries.iter();
        let boundaries = boundaries.map(|(name, edges)| (name.clone(), edges.iter().map(shifted).collect())).collect();
        self.points.extend_from_slice(&given.points);
        self.connectivity.extend(given.cells.iter().flatten().map(|node| first_node + node));
        self.bodies.push(BodyMesh {
            nodes: first_node..self.points.len(),
            cells: first_cell..self.cells(),
            boundaries,
            lines: Default::default(),
            candidates: Vec::new(),
        });
    }
}

/// Refuses an order that the given meshes of a scene do not have.
pub(super) fn refuse_others(scene: &Scene, order: Order) -> Result<(), Error> {
    for (index, body) in scene.bodies.iter().enumerate() {
        let Shape::Given(given) = &body.shape else { continue };
        let own = given.order();
        if own != order {
            let expected = format!("its mesh has cells of {} nodes", own.nodes_per_cell());
            let (place, remedy) = (scene.place_of_body(index), "give all bodies cells of one order");
            return Err(Error::value(place, "order", order.number(), expected, remedy));
        }
    }
    Ok(())
}

impl Mesh {
    /// The part of a body, as if it had been made elsewhere.
    pub fn given(&self, body: usize) -> GivenMesh {
        let own = &self.bodies[body];
        let shifted = |nodes: &[usize]| nodes.iter().map(|node| node - own.nodes.start).collect();
        let all = own.boundaries.iter().chain(&own.lines);
        GivenMesh {
            points: self.points[own.nodes.clone()].to_vec(),
            cells: own.cells.clone().map(|cell| shifted(self.cell(cell))).collect(),
            boundaries: all
                .map(|(name, edges)| (name.clone(), edges.iter().map(|edge| shifted(edge)).collect()))
                .collect(),
            half_told: Default::default(),
            inner: own.lines.keys().cloned().collect(),
            turned: 0,
            rounding: 0.0,
        }
    }
}

impl GivenMesh {
    /// Order of its cells.
    pub fn order(&self) -> Order {
        let own = self.cells.first().and_then(|cell| Order::of_nodes(cell.len()));
        own.unwrap_or(Order::Quadratic)
    }

    /// Every cell as a block, halved both ways so many times. Sides on the arcs of the outline stay on their circle.
    pub(super) fn blocks(&self, refinement: u32) -> Vec<Block> {
        let fractions = spacing::lattice(&[0.0, 1.0], refinement, self.order());
        let arcs = self.arcs();
        let mut names: BTreeMap<[usize; 2], Vec<&BoundaryName>> = BTreeMap::new();
        for (name, edge) in self.boundaries.iter().flat_map(|(name, edges)| edges.iter().map(move |edge| (name, edge)))
        {
            names.entry([edge[0], edge[1]]).or_default().push(name);
        }
        // Edges lie with their body to the left, as the sides of cells do.
        let side = |cell: &[usize], k: usize| {
            let ends = [cell[k], cell[(k + 1) % 4]];
            let middle = cell.get(4 + k).map(|&node| self.points[node]);
            let at = |t: &f64| on_side(ends.map(|node| self.points[node]), middle, arcs.get(&ends).copied(), *t);
            let names: Vec<BoundaryName> = names.get(&ends).into_iter().flatten().map(|name| (*name).clone()).collect();
            let inside = names.iter().any(|name| self.inner.contains(name));
            Side { points: fractions.iter().map(at).collect(), names, inside }
        };
        let block = |cell: &Vec<usize>| Block {
            bottom: side(cell, 0),
            right: side(cell, 1),
            top: side(cell, 2).backwards(),
            left: side(cell, 3).backwards(),
        };
        self.cells.iter().map(block).collect()
    }
}
