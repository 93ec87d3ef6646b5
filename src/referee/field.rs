//! Displacements on another code's mesh, brought to the nodes of ours: from there equilibrium, energy and all else follow by our own formulas.

use nalgebra::{Matrix2, Vector2};

use crate::elasticity::shape_functions;
use crate::error::Error;
use crate::referee::side::Cell;
use crate::solve::Discretisation;

/// Displacements of the nodes of a mesh of plane cells.
#[derive(Clone, Debug)]
pub struct Field {
    /// Nodes \[mm\].
    pub points: Vec<[f64; 2]>,
    /// Cells.
    pub cells: Vec<Cell>,
    /// Displacements \[mm\].
    pub displacement: Vec<[f64; 2]>,
}

/// How far outside a cell, over its size, a point still belongs to it: edges only approach a curved outline.
const OUTSIDE: f64 = 0.05;
/// Iterations of Newton's method, and the change of a natural coordinate at which they end.
const STEPS: usize = 30;
const AT_REST: f64 = 1e-12;

impl Field {
    /// The displacement at every node of our mesh; why not, where it does not reach one.
    pub fn at_nodes(&self, own: &Discretisation) -> Result<Vec<[f64; 2]>, String> {
        let bodies: Vec<Option<usize>> = self.cells.iter().map(|cell| self.body(own, cell)).collect();
        let mut found = vec![[0.0; 2]; own.mesh.points.len()];
        for (body, part) in own.mesh.bodies.iter().enumerate() {
            let own_cells = self.cells.iter().zip(&bodies).filter(|(_, of)| **of == Some(body));
            let cells: Vec<Placed> = own_cells.map(|(cell, _)| self.placed(cell)).collect();
            for node in part.nodes.clone() {
                let point = own.mesh.points[node];
                let name = &own.scene.bodies[body].name;
                let missing = || format!("no cell of `{name}` holds the point ({:.4}, {:.4})", point[0], point[1]);
                found[node] = self.at(&cells, point.into()).ok_or_else(missing)?;
            }
        }
        Ok(found)
    }

    /// The body of the scene that a cell belongs to.
    fn body(&self, own: &Discretisation, cell: &Cell) -> Option<usize> {
        let of = |axis: usize| cell.nodes.iter().map(|&node| self.points[node][axis]).sum::<f64>();
        let middle = [0, 1].map(|axis| of(axis) / cell.nodes.len() as f64);
        let bodies = 0..own.scene.bodies.len();
        let holds = |body: &usize| {
            let shapes: Result<_, Error> = crate::elasticity::point::shapes_at(&own.scene, &own.mesh, *body, middle);
            shapes.is_ok()
        };
        bodies.into_iter().find(holds)
    }

    fn placed<'a>(&self, cell: &'a Cell) -> Placed<'a> {
        let nodes: Vec<Vector2<f64>> = cell.nodes.iter().map(|&node| self.points[node].into()).collect();
        let middle = nodes.iter().sum::<Vector2<f64>>() / nodes.len() as f64;
        let size = nodes.iter().map(|node| (node - middle).norm()).fold(0.0, f64::max);
        Placed { cell, nodes, middle, size }
    }

    /// The displacement at a point, from the cell that holds it best.
    fn at(&self, cells: &[Placed], point: Vector2<f64>) -> Option<[f64; 2]> {
        let near =
            cells.iter().filter_map(|placed| placed.natural(point).map(|(outside, at)| (outside, placed.cell, at)));
        let (outside, cell, at) = near.min_by(|a, b| a.0.total_cmp(&b.0))?;
        // NaN belongs to no cell.
        if outside.is_nan() || outside > OUTSIDE {
            return None;
        }
        let shapes = shapes(cell, at);
        let of = |axis: usize| -> f64 {
            cell.nodes.iter().zip(&shapes).map(|(&node, (value, _))| value * self.displacement[node][axis]).sum()
        };
        Some([of(0), of(1)])
    }
}

/// A cell with the places of its nodes: as many points are looked for in it as there are nodes of ours.
struct Placed<'a> {
    cell: &'a Cell,
    nodes: Vec<Vector2<f64>>,
    middle: Vector2<f64>,
    /// Largest distance of a node from the middle \[mm\].
    size: f64,
}

impl Placed<'_> {
    /// How far outside the cell a point lies, and its natural coordinates; none of cells away from it.
    fn natural(&self, point: Vector2<f64>) -> Option<(f64, [f64; 2])> {
        let Self { cell, nodes, middle, size } = self;
        if (point - middle).norm() > size * (1.0 + OUTSIDE) {
            return None;
        }
        let triangle = cell.corners == 3;
        let mut at: Vector2<f64> = if triangle { Vector2::new(1.0 / 3.0, 1.0 / 3.0) } else { Vector2::zeros() };
        for _ in 0..STEPS {
            let (mut missing, mut jacobian) = (point, Matrix2::zeros());
            for (node, (value, gradient)) in nodes.iter().zip(shapes(cell, at.into())) {
                missing -= node * value;
                jacobian += node * nalgebra::RowVector2::new(gradient[0], gradient[1]);
            }
            let change = jacobian.try_inverse()? * missing;
            at += change;
            if change.norm() <= AT_REST {
                break;
            }
        }
        let outside = match triangle {
            true => [0.0 - at.x, 0.0 - at.y, at.x + at.y - 1.0].into_iter().fold(0.0, f64::max),
            false => 0.5 * (at.x.abs().max(at.y.abs()) - 1.0).max(0.0),
        };
        at.iter().all(|x| x.is_finite()).then_some((outside, at.into()))
    }
}

/// Values and gradients of the shape functions of a cell: triangles of 3 and 6 nodes, quadrilaterals of 4, 8 and 9, in VTK's order.
fn shapes(cell: &Cell, [x, y]: [f64; 2]) -> Vec<(f64, [f64; 2])> {
    match (cell.corners, cell.nodes.len()) {
        (3, n) => triangle(n, [1.0 - x - y, x, y]),
        (_, n) => shape_functions::cell(n, [x, y]),
    }
}

/// Gradients of the area coordinates.
const SLOPES: [[f64; 2]; 3] = [[-1.0, -1.0], [1.0, 0.0], [0.0, 1.0]];

fn triangle(nodes: usize, area: [f64; 3]) -> Vec<(f64, [f64; 2])> {
    let along = |k: usize, factor: f64| SLOPES[k].map(|slope| factor * slope);
    if nodes == 3 {
        return (0..3).map(|k| (area[k], SLOPES[k])).collect();
    }
    let corner = |k: usize| (area[k] * (2.0 * area[k] - 1.0), along(k, 4.0 * area[k] - 1.0));
    let middle = |k: usize| {
        let next = (k + 1) % 3;
        let (a, b) = (along(k, 4.0 * area[next]), along(next, 4.0 * area[k]));
        (4.0 * area[k] * area[next], [a[0] + b[0], a[1] + b[1]])
    };
    (0..3).map(corner).chain((0..3).map(middle)).collect()
}
