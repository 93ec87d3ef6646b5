//! The outline of a body: its edges, the angles between them, and how they are fixed.

use std::collections::HashMap;
use std::f64::consts::{FRAC_PI_4, PI};

use crate::elasticity::{axis, shape_functions};
use crate::mesh::{Edge, Mesh};
use crate::solve::Discretisation;

/// Angle by which curved edges may turn at a node of a smooth side \[rad\]: from π on λ falls by 2/π of it (both sides
/// free), and no mesh sees `r^-0.0006`.
pub(super) const TURN: f64 = 1e-3;

/// The outline of a body, itself to the left of every edge.
pub(super) struct Outline<'a> {
    mesh: &'a Mesh,
    /// Edges by the node that they begin at.
    pub(super) leaving: HashMap<usize, Edge>,
    /// The same by that they end at.
    arriving: HashMap<usize, Edge>,
    /// Components in which an edge is fixed, by its first and last node.
    fixed: HashMap<[usize; 2], [bool; 2]>,
}

impl<'a> Outline<'a> {
    pub(super) fn of(discretisation: &'a Discretisation, body: usize) -> Self {
        let (scene, mesh) = (&discretisation.scene, &discretisation.mesh);
        let edges = mesh.outline(body);
        let arriving = edges.iter().map(|edge| (edge[1], edge.clone())).collect();
        let leaving: HashMap<usize, Edge> = edges.into_iter().map(|edge| (edge[0], edge)).collect();
        let mut fixed: HashMap<[usize; 2], [bool; 2]> = HashMap::new();
        let own = &scene.bodies[body];
        for (name, edges) in &mesh.bodies[body].boundaries {
            let held = own.held(name);
            for edge in edges {
                let known = fixed.entry([edge[0], edge[1]]).or_default();
                *known = [0, 1].map(|k| known[k] || held[k]);
            }
        }
        let on_axis = axis::holds(scene, mesh, body);
        for edge in leaving.values().filter(|edge| edge[..2].iter().all(|node| on_axis(*node))) {
            fixed.entry([edge[0], edge[1]]).or_default()[axis::radial(scene).index()] = true;
        }
        Self { mesh, leaving, arriving, fixed }
    }

    /// The edges that end and begin at a node.
    pub(super) fn at(&self, node: usize) -> Option<[&Edge; 2]> {
        Some([self.arriving.get(&node)?, self.leaving.get(&node)?])
    }

    /// Interior angle at a node \[rad\].
    pub(super) fn angle(&self, node: usize) -> Option<f64> {
        let [arriving, leaving] = self.at(node)?;
        let ([x, y], [u, v]) = (self.tangent(arriving, 1.0), self.tangent(leaving, -1.0));
        Some(PI - (x * v - y * u).atan2(x * u + y * v))
    }

    /// Its nodes, in their order.
    pub(super) fn nodes(&self) -> Vec<usize> {
        let mut nodes: Vec<usize> = self.leaving.keys().copied().collect();
        nodes.sort_unstable();
        nodes
    }

    /// How far it turns at the nodes before and after one \[rad\].
    pub(super) fn next_turns(&self, node: usize) -> [f64; 2] {
        let Some([arriving, leaving]) = self.at(node) else { return [f64::NAN; 2] };
        [arriving[0], leaving[1]].map(|node| self.turn(node))
    }

    /// Whether it is smooth at a node: an arc drawn by chords turns at each of its nodes, a corner more than the nodes
    /// next to it, or far.
    pub(super) fn is_smooth(&self, node: usize) -> bool {
        let [before, after] = self.next_turns(node);
        let turn = self.turn(node).abs();
        turn <= before.abs() + after.abs() + TURN && turn < FRAC_PI_4
    }

    pub(super) fn turn(&self, node: usize) -> f64 {
        self.angle(node).map_or(0.0, |angle| angle - PI)
    }

    /// Components in which an edge is fixed.
    pub(super) fn fixed(&self, edge: &Edge) -> [bool; 2] {
        self.fixed.get(&[edge[0], edge[1]]).copied().unwrap_or_default()
    }

    /// Unit direction of an edge, from its first node to its last, at a natural coordinate of it.
    pub(super) fn tangent(&self, edge: &Edge, xi: f64) -> [f64; 2] {
        let (_, _, [dx, dy]) = shape_functions::on_edge(self.mesh, edge, xi);
        let length = dx.hypot(dy);
        [dx / length, dy / length]
    }
}
