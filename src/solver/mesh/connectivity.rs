//! Nodes, cells and boundaries of all bodies.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::ops::Range;

use crate::error::Error;
use crate::mesh::Order;
use crate::scene::{BoundaryName, Place, Scene, Shape};

/// An edge on a boundary: first node, last node, then those between, of 8-node cells the mid-side node; the body lies
/// to its left.
pub type Edge = Vec<usize>;

/// Nodes, cells and boundaries of all bodies; bodies share no nodes.
#[derive(Clone, Debug)]
pub struct Mesh {
    /// Element order.
    pub order: Order,
    /// Node positions \[mm\].
    pub points: Vec<[f64; 2]>,
    /// Node lists of the cells, one after the other: corners counter-clockwise, then those of the sides from the first
    /// on, then those inside ([`Order::places`]).
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

/// A node that may come into contact.
#[derive(Clone, Copy, Debug)]
pub struct Candidate {
    /// Node index.
    pub node: usize,
    /// Outward unit normal of the body.
    pub normal: [f64; 2],
    /// Contact coordinate `s` \[mm, or rad on an arc\].
    pub coordinate: f64,
    /// Index of the contact in the scene.
    pub contact: usize,
}

impl Mesh {
    /// Number of cells.
    pub fn cells(&self) -> usize {
        self.connectivity.len() / self.order.nodes_per_cell()
    }

    /// Nodes of a cell.
    pub fn cell(&self, index: usize) -> &[usize] {
        let n = self.order.nodes_per_cell();
        &self.connectivity[index * n..(index + 1) * n]
    }

    /// Sides of the cells of a body that belong to one of them only, the body to their left.
    pub fn outline(&self, body: usize) -> Vec<Edge> {
        let sides = self.order.sides();
        let mut alone: HashMap<[usize; 2], Option<(usize, &[usize])>> = HashMap::new();
        for (cell, side) in self.bodies[body].cells.clone().flat_map(|cell| sides.each_ref().map(|side| (cell, side))) {
            let [a, b] = [side[0], side[1]].map(|k| self.cell(cell)[k]);
            alone.entry([a.min(b), a.max(b)]).and_modify(|known| *known = None).or_insert(Some((cell, side)));
        }
        let edge = |(cell, side): (usize, &[usize])| side.iter().map(|&k| self.cell(cell)[k]).collect();
        let mut outline: Vec<Edge> = alone.into_values().flatten().map(edge).collect();
        outline.sort_unstable();
        outline
    }

    /// Nodes of a boundary, or the node at a point, of one body; `place` names the user of the boundary in errors.
    pub fn nodes_at(&self, scene: &Scene, body: usize, at: &Place) -> Result<Vec<usize>, Error> {
        match at {
            Place::Boundary(name) => {
                let nodes: BTreeSet<usize> = self.boundary(scene, body, name)?.iter().flatten().copied().collect();
                Ok(nodes.into_iter().collect())
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
                let is_on_side = match scene.bodies[body].shape {
                    Shape::Rectangle { x, y, .. } => x.contains(&point[0]) || y.contains(&point[1]),
                    _ => false,
                };
                let fitted = match is_on_side {
                    true => "; meshes of --fitted and --accuracy have nodes where a rectangle is held on its sides",
                    false => "",
                };
                let remedy =
                    format!("choose the nearest node, ({x}, {y}), corners of the outline or centres of discs{fitted}");
                Err(Error::at(scene.place_of_body(body), message, remedy))
            }
        }
    }
}
