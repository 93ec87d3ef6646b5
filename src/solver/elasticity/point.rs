//! Where in the cells of a body a point lies.

use nalgebra::{Matrix2, Vector2};

use crate::elasticity::shape_functions;
use crate::error::Error;
use crate::mesh::Mesh;
use crate::scene::Scene;

/// How far outside a cell, over its size, a point still belongs to it: edges only approach a curved outline.
const OUTSIDE: f64 = 0.02;
/// Iterations of Newton's method, and the last change of a natural coordinate, at which they end.
const STEPS: usize = 30;
const AT_REST: f64 = 1e-12;

/// Nodes of the cell that holds a point, with their shape functions `N_a` there; the node alone where one stands there.
///
/// A force at the point is handed out as `N_a F`, which has the same resultant and moment: `Σ N_a = 1`, `Σ N_a x_a = x`.
pub fn shapes_at(scene: &Scene, mesh: &Mesh, body: usize, point: [f64; 2]) -> Result<Vec<(usize, f64)>, Error> {
    let refused = match mesh.node_at(scene, body, point) {
        Ok(node) => return Ok(vec![(node, 1.0)]),
        Err(nearest) => nearest,
    };
    let near = mesh.bodies[body].cells.clone().filter_map(|cell| {
        let (natural, outside) = natural(mesh, cell, point)?;
        Some((outside, cell, natural))
    });
    let Some((_, cell, natural)) = near.min_by(|a, b| a.0.total_cmp(&b.0)) else {
        let message = format!("there is no cell around `({}, {})`", point[0], point[1]);
        return Err(Error { message, ..refused });
    };
    let nodes = mesh.cell(cell);
    let shapes = shape_functions::cell(nodes.len(), natural);
    Ok(nodes.iter().copied().zip(shapes.into_iter().map(|(value, _)| value)).collect())
}

/// (ξ, η) with `Σ N_a(ξ, η) x_a = x` by Newton's method, and how far outside the cell the point lies, over its size; none
/// for cells away from the point.
pub fn natural(mesh: &Mesh, cell: usize, point: [f64; 2]) -> Option<([f64; 2], f64)> {
    let point = Vector2::from(point);
    let nodes: Vec<Vector2<f64>> = mesh.cell(cell).iter().map(|&node| mesh.points[node].into()).collect();
    let middle = nodes.iter().sum::<Vector2<f64>>() / nodes.len() as f64;
    let size = nodes.iter().map(|node| (node - middle).norm()).fold(0.0, f64::max);
    if (point - middle).norm() > size * (1.0 + OUTSIDE) {
        return None;
    }
    let mut natural = Vector2::zeros();
    for _ in 0..STEPS {
        let (mut missing, mut jacobian) = (point, Matrix2::zeros());
        for (node, (value, gradient)) in nodes.iter().zip(shape_functions::cell(nodes.len(), natural.into())) {
            missing -= node * value;
            jacobian += node * Vector2::from(gradient).transpose();
        }
        let change = jacobian.try_inverse()? * missing;
        natural += change;
        if change.amax() <= AT_REST {
            let inside = natural.map(|x: f64| x.clamp(-1.0, 1.0));
            let shapes = shape_functions::cell(nodes.len(), inside.into());
            let nearest: Vector2<f64> = nodes.iter().zip(shapes).map(|(node, (value, _))| node * value).sum();
            let outside = (point - nearest).norm() / size;
            return (outside <= OUTSIDE).then_some((natural.into(), outside));
        }
    }
    None
}
