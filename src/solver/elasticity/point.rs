//! Where in the cells of a mesh a point lies.

use nalgebra::{Matrix2, Vector2};

use crate::elasticity::shape_functions;
use crate::error::Error;
use crate::mesh::Mesh;
use crate::scene::Scene;

/// How far outside a cell, over its size, a point still belongs to it: edges only approach a curved outline.
const OUTSIDE: f64 = 0.02;
/// Iterations of Newton's method, and what is missing of the point, over the size of the cell, at which they end.
const STEPS: usize = 30;
const AT_REST: f64 = 1e-13;

/// Nodes of the cell that holds a point, with their shape functions `N_a` there; the node alone where one stands there.
///
/// A force at the point is handed out as `N_a F`, which has the same resultant and moment: `Σ N_a = 1`,
/// `Σ N_a x_a = x`.
pub fn shapes_at(scene: &Scene, mesh: &Mesh, body: usize, point: [f64; 2]) -> Result<Vec<(usize, f64)>, Error> {
    let refused = match mesh.node_at(scene, body, point) {
        Ok(node) => return Ok(vec![(node, 1.0)]),
        Err(nearest) => nearest,
    };
    let Some((found, shapes)) = Cells::of_body(mesh, body).shapes_at(point, OUTSIDE) else {
        let message = format!("there is no cell around `({}, {})`", point[0], point[1]);
        return Err(Error { message, ..refused });
    };
    let nodes = mesh.cell(mesh.bodies[body].cells.start + found);
    Ok(nodes.iter().copied().zip(shapes).collect())
}

/// Cells to look points up in, ours or those of another mesh.
#[derive(Clone, Debug)]
pub struct Cells(Vec<Cell>);

/// A quadrilateral, or a triangle of 3 or 6 nodes, by the places of its nodes in the order of [`shape_functions`].
#[derive(Clone, Debug)]
struct Cell {
    triangle: bool,
    middle: Vector2<f64>,
    /// Places from the middle, so that a small cell far from the origin loses no digits.
    nodes: Vec<Vector2<f64>>,
    /// The box around them.
    low: Vector2<f64>,
    high: Vector2<f64>,
    /// Largest distance of a node from the middle \[mm\].
    size: f64,
}

impl Cells {
    /// Cells of so many corners and nodes at these places.
    pub fn of(cells: impl IntoIterator<Item = (usize, Vec<[f64; 2]>)>) -> Self {
        Self(cells.into_iter().map(|(corners, nodes)| Cell::of(corners == 3, nodes)).collect())
    }

    /// Those of a body of a mesh, in its order.
    pub fn of_body(mesh: &Mesh, body: usize) -> Self {
        let places = |cell| mesh.cell(cell).iter().map(|&node| mesh.points[node]).collect();
        Self(mesh.bodies[body].cells.clone().map(|cell| Cell::of(false, places(cell))).collect())
    }

    /// The cell that holds a point best, with its shape functions there; none where it lies farther outside of all than
    /// so many of their sizes.
    pub fn shapes_at(&self, point: [f64; 2], outside: f64) -> Option<(usize, Vec<f64>)> {
        let near = self.0.iter().enumerate().filter_map(|(place, cell)| {
            let (slack, point) = (outside * cell.size, Vector2::from(point) - cell.middle);
            let boxed = (0..2).all(|k| cell.low[k] - slack <= point[k] && point[k] <= cell.high[k] + slack);
            let (natural, distance) = boxed.then(|| cell.natural(point)).flatten()?;
            (distance <= outside).then_some((distance, place, natural))
        });
        let (_, place, natural) = near.min_by(|a, b| a.0.total_cmp(&b.0))?;
        Some((place, self.0[place].shapes(natural).into_iter().map(|(value, _)| value).collect()))
    }
}

impl Cell {
    fn of(triangle: bool, nodes: Vec<[f64; 2]>) -> Self {
        let nodes: Vec<Vector2<f64>> = nodes.into_iter().map(Vector2::from).collect();
        let middle = nodes.iter().sum::<Vector2<f64>>() / nodes.len() as f64;
        let nodes: Vec<Vector2<f64>> = nodes.into_iter().map(|node| node - middle).collect();
        let size = nodes.iter().map(Vector2::norm).fold(0.0, f64::max);
        let [low, high] = nodes.iter().fold([Vector2::zeros(); 2], |[low, high], node| [low.inf(node), high.sup(node)]);
        Self { triangle, middle, nodes, low, high, size }
    }

    /// Values and gradients of its shape functions.
    fn shapes(&self, at: [f64; 2]) -> Vec<(f64, [f64; 2])> {
        match self.triangle {
            true => shape_functions::triangle(self.nodes.len(), at),
            false => shape_functions::cell(self.nodes.len(), at),
        }
    }

    /// (ξ, η) with `Σ N_a(ξ, η) x_a = x` by Newton's method, x and x_a from the middle, and how far outside the cell
    /// the point lies, over its size.
    fn natural(&self, point: Vector2<f64>) -> Option<([f64; 2], f64)> {
        let mut natural = if self.triangle { Vector2::repeat(1.0 / 3.0) } else { Vector2::zeros() };
        for _ in 0..STEPS {
            let (mut missing, mut jacobian) = (point, Matrix2::zeros());
            for (node, (value, gradient)) in self.nodes.iter().zip(self.shapes(natural.into())) {
                missing -= node * value;
                jacobian += node * Vector2::from(gradient).transpose();
            }
            if missing.norm() <= AT_REST * self.size {
                let shapes = self.shapes(self.inside(natural).into());
                let nearest: Vector2<f64> = self.nodes.iter().zip(shapes).map(|(node, (value, _))| node * value).sum();
                return Some((natural.into(), (point - nearest).norm() / self.size));
            }
            natural += jacobian.try_inverse()? * missing;
        }
        None
    }

    /// The natural coordinates that are next to these and inside.
    fn inside(&self, natural: Vector2<f64>) -> Vector2<f64> {
        if !self.triangle {
            return natural.map(|x| x.clamp(-1.0, 1.0));
        }
        let beyond = 0.5 * (natural.sum() - 1.0).max(0.0);
        natural.map(|x| (x - beyond).clamp(0.0, 1.0))
    }
}
