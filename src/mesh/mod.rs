//! Where: structured, graded, exactly curved meshes of 4-node and 8-node quadrilaterals.
//!
//! * [`spacing`] — one-dimensional laws of element size.
//! * [`block`] — transfinite interpolation inside four sides.
//! * `outline` — from the scene's shapes to blocks.
//! * `given` — meshes made elsewhere, and their halving.
//! * `sound` — whether given meshes hang together.
//! * [`candidates`] — the contact nodes with their normals.
//! * [`order`] — element order.
//! * [`size`] — how large a mesh would be.
//! * [`variant`] — the same mesh mirrored, renumbered or shaken.

pub mod block;
pub mod candidates;
pub mod order;
pub mod size;
pub mod spacing;
pub mod variant;

mod given;
mod merge;
mod outline;
mod sound;

use std::collections::BTreeMap;
use std::ops::Range;

use crate::error::Error;
use crate::scene::{BoundaryName, Place, Scene, Shape};

pub use candidates::Candidate;
pub use order::Order;

/// How fine a mesh is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Resolution {
    /// Elements per half-width, or per 10 mm of arc on pins.
    pub elements: usize,
    /// Times every element of that mesh is halved both ways.
    pub refinement: u32,
    /// Element order.
    pub order: Order,
}

/// An edge on a boundary: first node, last node and, for 8-node cells, the mid-side node; the body lies to its left.
pub type Edge = Vec<usize>;

/// Nodes, cells and boundaries of all bodies; bodies share no nodes.
#[derive(Clone, Debug)]
pub struct Mesh {
    /// Element order.
    pub order: Order,
    /// Node positions \[mm\].
    pub points: Vec<[f64; 2]>,
    /// Node lists of the cells, one after the other: corners counter-clockwise, then mid-sides from the first edge on.
    pub connectivity: Vec<usize>,
    /// What belongs to which body.
    pub bodies: Vec<BodyMesh>,
}

/// The part of a mesh that belongs to one body.
#[derive(Clone, Debug)]
pub struct BodyMesh {
    /// Its nodes.
    pub nodes: Range<usize>,
    /// Its cells.
    pub cells: Range<usize>,
    /// Its boundaries by name.
    pub boundaries: BTreeMap<BoundaryName, Vec<Edge>>,
    /// Named lines inside it, which may carry loads.
    pub lines: BTreeMap<BoundaryName, Vec<Edge>>,
    /// Its candidate contact nodes: contact by contact, in the order of the contact coordinate.
    pub candidates: Vec<Candidate>,
}

impl Mesh {
    /// Meshes every body of a scene.
    pub fn of(scene: &Scene, resolution: Resolution) -> Result<Self, Error> {
        scene.validate()?;
        if resolution.elements == 0 || resolution.elements > 4096 || resolution.refinement > 6 {
            return Err(Error::value(
                scene.name.as_str(),
                "resolution",
                resolution.elements,
                "elements per half-width (or 10 mm of arc) must lie between 1 and 4096",
                "use 8 to 32",
            ));
        }
        given::refuse_others(scene, resolution.order)?;
        let mut mesh = Self { order: resolution.order, points: vec![], connectivity: vec![], bodies: vec![] };
        for (index, body) in scene.bodies.iter().enumerate() {
            match &body.shape {
                Shape::Given(given) if resolution.refinement == 0 => mesh.append_given(given),
                Shape::Given(given) => mesh.append(&given.blocks(resolution.refinement)),
                shape => mesh.append(&outline::Layout::new(scene, resolution, index).blocks(shape)),
            }
        }
        sound::refuse_loose(&mesh, scene)?;
        candidates::find(&mut mesh, scene)?;
        Ok(mesh)
    }

    /// Number of cells.
    pub fn cells(&self) -> usize {
        self.connectivity.len() / self.order.nodes_per_cell()
    }

    /// Nodes of a cell.
    pub fn cell(&self, index: usize) -> &[usize] {
        let n = self.order.nodes_per_cell();
        &self.connectivity[index * n..(index + 1) * n]
    }

    /// Nodes of a boundary, or the node at a point, of one body; `place` names the user of the boundary in errors.
    pub fn nodes_at(&self, scene: &Scene, body: usize, at: &Place) -> Result<Vec<usize>, Error> {
        match at {
            Place::Boundary(name) => {
                let mut nodes: Vec<usize> = self.boundary(scene, body, name)?.iter().flatten().copied().collect();
                nodes.sort_unstable();
                nodes.dedup();
                Ok(nodes)
            }
            Place::Point(point) => Ok(vec![self.node_at(scene, body, *point)?]),
        }
    }

    /// Edges of a named boundary, or of a named line inside the body.
    pub fn boundary(&self, scene: &Scene, body: usize, name: &str) -> Result<&[Edge], Error> {
        let (boundaries, lines) = (&self.bodies[body].boundaries, &self.bodies[body].lines);
        boundaries.get(name).or_else(|| lines.get(name)).map(Vec::as_slice).ok_or_else(|| {
            let known: Vec<&str> = boundaries.keys().chain(lines.keys()).map(AsRef::as_ref).collect();
            let remedy = format!("choose one of {}", known.join(", "));
            Error::at(scene.place_of_body(body), format!("there is no boundary `{name}`"), remedy)
        })
    }

    /// The node at a point.
    pub fn node_at(&self, scene: &Scene, body: usize, point: [f64; 2]) -> Result<usize, Error> {
        let nodes = self.bodies[body].nodes.clone();
        let distance = |n: &usize| (self.points[*n][0] - point[0]).hypot(self.points[*n][1] - point[1]);
        let nearest = nodes.min_by(|a, b| distance(a).total_cmp(&distance(b)));
        match nearest {
            Some(node) if distance(&node) <= 1e-9 * (1.0 + point[0].abs() + point[1].abs()) => Ok(node),
            _ => {
                let [x, y] = nearest.map_or([f64::NAN; 2], |node| self.points[node]);
                let message = format!("there is no node at `({}, {})`", point[0], point[1]);
                let remedy = format!("choose the nearest node, ({x}, {y}), corners of the outline or centres of discs");
                Err(Error::at(scene.place_of_body(body), message, remedy))
            }
        }
    }
}
