//! Which displacement components are unknown, in which frame, under which number.

use std::ops::Range;

use crate::elasticity::{NodeGraph, axis};
use crate::error::Error;
use crate::mesh::Mesh;
use crate::scene::{Component, Load, Place, Scene, Support};

/// A displacement component of a node: unknown, or given.
#[derive(Clone, Copy, Debug)]
pub enum Freedom {
    /// Unknown, with its equation number; tied components share one.
    Equation(usize),
    /// Prescribed value \[mm\].
    Prescribed(f64),
}

impl Freedom {
    /// The equation number, if it is unknown.
    pub fn equation(&self) -> Option<usize> {
        match self {
            Self::Equation(equation) => Some(*equation),
            Self::Prescribed(_) => None,
        }
    }
}

/// Frames and numbering of the nodes of one body.
///
/// Candidate contact nodes have the frame (n, t): outward normal and the tangent `t = (−n_y, n_x)`;
/// all others have (x, y).
#[derive(Clone, Debug)]
pub struct Dofs {
    /// First node of the body in the mesh.
    pub first: usize,
    /// First axis of each node's frame.
    pub axes: Vec<[f64; 2]>,
    /// The two components of each node.
    pub components: Vec<[Freedom; 2]>,
    /// Number of unknowns.
    pub equations: usize,
    /// Equations of the candidates' normal displacements, in the order of the contact coordinate: the last ones.
    pub retained: Range<usize>,
}

/// A component of a node while numbering goes on.
#[derive(Clone, Copy, PartialEq)]
enum Mark {
    Free,
    Prescribed(f64),
    Tied(usize),
}

impl Dofs {
    /// Numbers the unknowns of a body in the order in which they are eliminated: node by node in the graph's order of
    /// minimum degree, then the components that the nodes of a rigid face share, last the candidates' normals.
    ///
    /// Prescribed components have no number.
    pub fn number(scene: &Scene, mesh: &Mesh, body: usize, graph: &NodeGraph) -> Result<Self, Error> {
        let nodes = mesh.bodies[body].nodes.clone();
        let candidates = &mesh.bodies[body].candidates;
        let mut axes = vec![[1.0, 0.0]; nodes.len()];
        let mut is_candidate = vec![false; nodes.len()];
        for candidate in candidates {
            axes[candidate.node - nodes.start] = candidate.normal;
            is_candidate[candidate.node - nodes.start] = true;
        }
        let marks = marks(scene, mesh, body, &axes)?;
        let eliminated = |node: usize, k: usize| marks[node][k] == Mark::Free && !(k == 0 && is_candidate[node]);
        let takes_part: Vec<bool> = (0..nodes.len()).map(|node| (0..2).any(|k| eliminated(node, k))).collect();
        let value = |mark| if let Mark::Prescribed(value) = mark { value } else { f64::NAN };
        let mut components: Vec<[Freedom; 2]> =
            marks.iter().map(|pair| pair.map(|mark| Freedom::Prescribed(value(mark)))).collect();
        let mut numbers = 0..;
        let mut next = || Freedom::Equation(numbers.next().unwrap_or(usize::MAX));
        for node in graph.minimum_degree(&takes_part) {
            for k in (0..2).filter(|&k| eliminated(node, k)) {
                components[node][k] = next();
            }
        }
        let mut tied: Vec<Option<Freedom>> = vec![None; scene.bodies[body].loads.len()];
        for (pair, marks) in components.iter_mut().zip(&marks) {
            for (component, mark) in pair.iter_mut().zip(marks) {
                if let Mark::Tied(face) = *mark {
                    *component = *tied[face].get_or_insert_with(&mut next);
                }
            }
        }
        for candidate in candidates {
            match marks[candidate.node - nodes.start][0] {
                Mark::Free => components[candidate.node - nodes.start][0] = next(),
                Mark::Tied(_) => {
                    return Err(at_candidate((scene, mesh, body), candidate.node, "the `rigid face`", SOUGHT));
                }
                Mark::Prescribed(_) => return Err(fixed_normal((scene, mesh, body), candidate.node, candidate.normal)),
            }
        }
        let equations = numbers.start;
        let retained = equations - candidates.len()..equations;
        Ok(Self { first: nodes.start, axes, components, equations, retained })
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

    /// `k ← Tᵀ k T`, row by row: from Cartesian components to the frames of the nodes.
    pub fn rotate(&self, nodes: &[usize], k: &mut [f64]) {
        let side = 2 * nodes.len();
        for (a, &node) in nodes.iter().enumerate() {
            let [n, t] = self.frame(node);
            if n[1].abs() < f64::MIN_POSITIVE && n[0] > 0.0 {
                continue;
            }
            let turned = |x: f64, y: f64| (x * n[0] + y * n[1], x * t[0] + y * t[1]);
            for row in k.chunks_exact_mut(side) {
                (row[2 * a], row[2 * a + 1]) = turned(row[2 * a], row[2 * a + 1]);
            }
            for j in 0..side {
                let (first, second) = (2 * a * side + j, (2 * a + 1) * side + j);
                (k[first], k[second]) = turned(k[first], k[second]);
            }
        }
    }

    /// Adds a Cartesian nodal force to the load vector.
    pub fn add_force(&self, node: usize, force: [f64; 2], out: &mut [f64]) {
        for (dof, axis) in self.of_node(node).into_iter().zip(self.frame(node)) {
            if let Freedom::Equation(equation) = dof {
                out[equation] += force[0] * axis[0] + force[1] * axis[1];
            }
        }
    }

    /// The equations in the order of the mesh: node by node, the component that the nodes of a face share at its first
    /// one.
    pub fn in_mesh_order(&self) -> Vec<usize> {
        let mut seen = vec![false; self.equations];
        let equations = self.components.iter().flatten().filter_map(Freedom::equation);
        equations.filter(|&equation| !std::mem::replace(&mut seen[equation], true)).collect()
    }

    /// Cartesian displacement of every node of the body, where prescribed displacements are `share` times theirs
    /// \[mm\].
    pub fn displacements(&self, share: f64, solution: &[f64]) -> Vec<[f64; 2]> {
        let value = |dof| match dof {
            Freedom::Equation(equation) => solution[equation],
            Freedom::Prescribed(value) => share * value,
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
    let on_axis = axis::holds(scene, mesh, body);
    for node in mesh.bodies[body].nodes.clone().filter(|&node| on_axis(node)) {
        let radial = axis::radial(scene);
        let (axis, _) =
            aligned(axes[node - first], radial).ok_or_else(|| oblique((scene, mesh, body), node, radial))?;
        marks[node - first][axis] = Mark::Prescribed(0.0);
    }
    let mut set = |at: &Place, component: Component, mark: Mark| -> Result<(), Error> {
        for node in mesh.nodes_at(scene, body, at)? {
            let (axis, sign) =
                aligned(axes[node - first], component).ok_or_else(|| oblique((scene, mesh, body), node, component))?;
            // The tied components of a face share one equation, which must mean the same direction at every node.
            if matches!(mark, Mark::Tied(_)) && (axis != component.index() || sign < 0.0) {
                return Err(at_candidate((scene, mesh, body), node, "the `rigid face`", OBLIQUE));
            }
            let slot = &mut marks[node - first][axis];
            match mark {
                Mark::Prescribed(value) => *slot = Mark::Prescribed(sign * value),
                Mark::Tied(face) if *slot == Mark::Free => *slot = Mark::Tied(face),
                _ => return Err(fixed_face(scene, body, at, node)),
            }
        }
        Ok(())
    };
    for support in &scene.bodies[body].supports {
        set(&support.at, support.component, Mark::Prescribed(support.value))?;
    }
    for (index, load) in scene.bodies[body].loads.iter().enumerate() {
        if let Load::RigidFace { boundary, component, .. } = load {
            set(&Place::Boundary(boundary.clone()), *component, Mark::Tied(index))?;
        }
    }
    Ok(marks)
}

/// Which axis of the frame with first axis `n` is parallel to a Cartesian component, and with which sign.
fn aligned(n: [f64; 2], component: Component) -> Option<(usize, f64)> {
    let along = [n[component.index()], [-n[1], n[0]][component.index()]];
    (0..2).find(|&axis| along[axis].abs() > 1.0 - 1e-12).map(|axis| (axis, along[axis].signum()))
}

fn fixed_face(scene: &Scene, body: usize, at: &Place, node: usize) -> Error {
    let boundary = match at {
        Place::Boundary(name) => name.to_string(),
        Place::Point(point) => format!("{point:?}"),
    };
    let message = format!(
        "node {node} of the rigid face `{boundary}` is fixed, or belongs to another rigid face, in the direction in \
        which the face moves as one"
    );
    Error::at(scene.place_of_body(body), message, "fix the whole face, or none of it")
}

/// What is wrong with a support or a rigid face at a candidate.
const OBLIQUE: &str = "is oblique to the contact normal there";
const SOUGHT: &str = "takes the displacement along the contact normal there, which contact is to find";

fn oblique(of: (&Scene, &Mesh, usize), node: usize, component: Component) -> Error {
    at_candidate(of, node, &format!("the support along `{component}`"), OBLIQUE)
}

/// The support that holds a candidate along its normal.
fn fixed_normal(of: (&Scene, &Mesh, usize), node: usize, normal: [f64; 2]) -> Error {
    let (scene, mesh, body) = of;
    let holds = |support: &&Support| {
        let is_there = mesh.nodes_at(scene, body, &support.at).is_ok_and(|nodes| nodes.contains(&node));
        is_there && aligned(normal, support.component).is_some_and(|(axis, _)| axis == 0)
    };
    let support = scene.bodies[body].supports.iter().find(holds);
    let told = support.map_or("the axis".into(), |one| format!("the support at `{}`, `{}`,", one.at, one.component));
    at_candidate(of, node, &told, SOUGHT)
}

fn at_candidate((scene, mesh, body): (&Scene, &Mesh, usize), node: usize, what: &str, wrong: &str) -> Error {
    let [x, y] = mesh.points[node];
    let message = format!("{what} at node {node}, ({x}, {y}), {wrong}");
    Error::at(scene.place_of_body(body), message, "leave it out, or end the candidate stretch before that node")
}
