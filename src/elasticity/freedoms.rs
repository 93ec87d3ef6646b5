//! Which displacement components are unknown, in which frame, under which number.

use crate::error::Error;
use crate::mesh::Mesh;
use crate::scene::{Component, Load, Place, Scene};

/// A displacement component of a node: unknown, or given.
#[derive(Clone, Copy, Debug)]
pub enum Freedom {
    /// Unknown, with its equation number; tied components share one.
    Equation(usize),
    /// Prescribed value \[mm\].
    Prescribed(f64),
}

/// Frames and numbering of the nodes of one body.
///
/// Candidate contact nodes have the frame (n, t): outward normal and the tangent `t = (−n_y, n_x)`;
/// all others have (x, y).
#[derive(Clone, Debug)]
pub struct Freedoms {
    /// First node of the body in the mesh.
    pub first: usize,
    /// First axis of each node's frame.
    pub axes: Vec<[f64; 2]>,
    /// The two components of each node.
    pub components: Vec<[Freedom; 2]>,
    /// Number of unknowns.
    pub equations: usize,
    /// Equation of each candidate's normal displacement.
    pub retained: Vec<usize>,
}

/// A component of a node while numbering goes on.
#[derive(Clone, Copy, PartialEq)]
enum Mark {
    Free,
    Prescribed(f64),
    Tied(usize),
}

impl Freedoms {
    /// Numbers the unknowns of a body: prescribed components have none, the components of a rigid face share one.
    pub fn number(scene: &Scene, mesh: &Mesh, body: usize) -> Result<Self, Error> {
        let nodes = mesh.bodies[body].nodes.clone();
        let mut axes = vec![[1.0, 0.0]; nodes.len()];
        for candidate in &mesh.bodies[body].candidates {
            axes[candidate.node - nodes.start] = candidate.normal;
        }
        let marks = marks(scene, mesh, body, &axes)?;
        let mut equations = 0;
        let mut tied: Vec<Option<usize>> = vec![None; scene.bodies[body].loads.len()];
        let mut next = || {
            equations += 1;
            equations - 1
        };
        let components: Vec<[Freedom; 2]> = marks
            .iter()
            .map(|pair| {
                pair.map(|mark| match mark {
                    Mark::Free => Freedom::Equation(next()),
                    Mark::Prescribed(value) => Freedom::Prescribed(value),
                    Mark::Tied(face) => Freedom::Equation(*tied[face].get_or_insert_with(&mut next)),
                })
            })
            .collect();
        let mut freedoms = Self { first: nodes.start, axes, components, equations, retained: Vec::new() };
        for candidate in &mesh.bodies[body].candidates {
            match freedoms.of_node(candidate.node)[0] {
                Freedom::Equation(equation) => freedoms.retained.push(equation),
                Freedom::Prescribed(_) => return Err(oblique(scene, body, candidate.node, "normal")),
            }
        }
        Ok(freedoms)
    }

    /// The two components of a node of the mesh.
    pub fn of_node(&self, node: usize) -> [Freedom; 2] {
        self.components[node - self.first]
    }

    /// Both axes of a node's frame.
    pub fn frame(&self, node: usize) -> [[f64; 2]; 2] {
        let n = self.axes[node - self.first];
        [n, [-n[1], n[0]]]
    }

    /// `k ← Tᵀ k T`: from Cartesian components to the frames of the nodes.
    pub fn rotate(&self, nodes: &[usize], k: &mut [Vec<f64>]) {
        for (a, &node) in nodes.iter().enumerate() {
            let [n, t] = self.frame(node);
            if n[1].abs() < f64::MIN_POSITIVE && n[0] > 0.0 {
                continue;
            }
            for row in k.iter_mut() {
                let (x, y) = (row[2 * a], row[2 * a + 1]);
                (row[2 * a], row[2 * a + 1]) = (x * n[0] + y * n[1], x * t[0] + y * t[1]);
            }
            let [first, second] = k.get_disjoint_mut([2 * a, 2 * a + 1]).expect("a cell has two freedoms a node");
            for (u, v) in first.iter_mut().zip(second) {
                let (x, y) = (*u, *v);
                (*u, *v) = (x * n[0] + y * n[1], x * t[0] + y * t[1]);
            }
        }
    }

    /// Adds a Cartesian nodal force to the load vector.
    pub fn add_force(&self, node: usize, force: [f64; 2], out: &mut [f64]) {
        for (freedom, axis) in self.of_node(node).into_iter().zip(self.frame(node)) {
            if let Freedom::Equation(equation) = freedom {
                out[equation] += force[0] * axis[0] + force[1] * axis[1];
            }
        }
    }

    /// Cartesian displacement of every node of the body \[mm\].
    pub fn displacements(&self, solution: &[f64]) -> Vec<[f64; 2]> {
        let value = |freedom| match freedom {
            Freedom::Equation(equation) => solution[equation],
            Freedom::Prescribed(value) => value,
        };
        let nodes = self.components.iter().zip(&self.axes);
        nodes
            .map(|(pair, n)| {
                let [u, v] = pair.map(value);
                [u * n[0] - v * n[1], u * n[1] + v * n[0]]
            })
            .collect()
    }
}

fn marks(scene: &Scene, mesh: &Mesh, body: usize, axes: &[[f64; 2]]) -> Result<Vec<[Mark; 2]>, Error> {
    let first = mesh.bodies[body].nodes.start;
    let mut marks = vec![[Mark::Free; 2]; axes.len()];
    let mut set = |at: &Place, component: Component, mark: Mark| -> Result<(), Error> {
        for node in mesh.nodes_at(scene, body, at)? {
            let (axis, sign) = aligned(axes[node - first], component)
                .ok_or_else(|| oblique(scene, body, node, if component == Component::X { "x" } else { "y" }))?;
            // The tied components of a face share one equation, which must mean the same direction at every node.
            if matches!(mark, Mark::Tied(_)) && (axis != component.index() || sign < 0.0) {
                return Err(oblique(scene, body, node, "rigid face"));
            }
            let slot = &mut marks[node - first][axis];
            match mark {
                Mark::Prescribed(value) => *slot = Mark::Prescribed(sign * value),
                _ if *slot == Mark::Free => *slot = mark,
                _ => {}
            }
        }
        Ok(())
    };
    for support in &scene.bodies[body].supports {
        set(&support.at, support.component, Mark::Prescribed(support.value))?;
    }
    for (index, load) in scene.bodies[body].loads.iter().enumerate() {
        if let Load::RigidFace { boundary, component, .. } = load {
            set(&Place::Boundary(boundary), *component, Mark::Tied(index))?;
        }
    }
    Ok(marks)
}

/// Which axis of the frame with first axis `n` is parallel to a Cartesian component, and with which sign.
fn aligned(n: [f64; 2], component: Component) -> Option<(usize, f64)> {
    let along = [n[component.index()], [-n[1], n[0]][component.index()]];
    (0..2).find(|&axis| along[axis].abs() > 1.0 - 1e-12).map(|axis| (axis, along[axis].signum()))
}

fn oblique(scene: &Scene, body: usize, node: usize, component: &str) -> Error {
    Error::ObliqueSupport { body: scene.bodies[body].name.clone(), node, component: component.into() }
}
