//! Bodies whose mesh was made elsewhere: taken as they are.

use super::{BodyMesh, Mesh, Order};
use crate::error::Error;
use crate::scene::{GivenMesh, Scene, Shape};

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

/// Refuses an order or a refinement that the given meshes of a scene do not have.
pub(super) fn refuse_others(scene: &Scene, order: Order, refinement: u32) -> Result<(), Error> {
    for body in &scene.bodies {
        let Shape::Given(given) = &body.shape else { continue };
        let place = format!("{}, body `{}`", scene.name, body.name);
        let own = given.order();
        if own != order {
            let expected = format!("its mesh has cells of {} nodes", own.nodes_per_cell());
            return Err(Error::value(place, "order", order.number(), expected, "give all bodies cells of one order"));
        }
        if refinement > 0 {
            let expected = "its mesh is given and is not refined here";
            return Err(Error::value(place, "refinement", refinement, expected, "give a finer mesh"));
        }
    }
    Ok(())
}

impl GivenMesh {
    /// Order of its cells.
    pub fn order(&self) -> Order {
        match self.cells.first().map(Vec::len) {
            Some(4) => Order::Linear,
            _ => Order::Quadratic,
        }
    }
}
