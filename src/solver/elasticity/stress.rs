//! Nodal stresses: from Gauss points to the nodes, averaged over the cells that meet at a node.

use crate::elasticity::element::{CellStiffness, Tabulated, degenerate};
use crate::elasticity::{quadrature, shape_functions};
use crate::error::Error;
use crate::mesh::{Mesh, Order, lobatto};
use crate::scene::{Material, PlaneHypothesis, Scene};

/// Mean over the adjoining cells of `σ = D B q`, taken at the p × p Gauss points of order p, 2 × 2 at least (where it
/// is most accurate; Barlow 1976), and extrapolated to the nodes: `[σ_x, σ_y, τ_xy]` at every node \[MPa\], tension
/// positive.
///
/// Where the stiffness has a smoothed dilatation, so have the stresses.
pub fn at_nodes(scene: &Scene, mesh: &Mesh, displacements: &[[f64; 2]]) -> Result<Vec<[f64; 3]>, Error> {
    let all = (0..mesh.bodies.len()).map(|body| of_body(scene, mesh, displacements, body, &|_| true));
    Ok(all.collect::<Result<Vec<_>, _>>()?.concat())
}

/// The same at some nodes of a body, counted from its first, from the cells around them; NaN at its others.
pub fn of_body(
    scene: &Scene,
    mesh: &Mesh,
    displacements: &[[f64; 2]],
    body: usize,
    is_wanted: &dyn Fn(usize) -> bool,
) -> Result<Vec<[f64; 3]>, Error> {
    let (part, first) = (&mesh.bodies[body], mesh.bodies[body].nodes.start);
    let mut sums = vec![[0.0; 3]; part.nodes.len()];
    let mut counts = vec![0.0; part.nodes.len()];
    let (places, weights) = extrapolation(mesh.order);
    let places: Vec<Tabulated> = places.into_iter().map(|at| Tabulated::of(mesh.order.nodes_per_cell(), at)).collect();
    let kernel = CellStiffness::of(mesh.order, &scene.bodies[body].material, scene.plane, scene.thickness);
    for cell in part.cells.clone() {
        let nodes = mesh.cell(cell);
        if !nodes.iter().any(|&node| is_wanted(node - first)) {
            continue;
        }
        let points: Vec<[f64; 2]> = nodes.iter().map(|&n| mesh.points[n]).collect();
        let moved: Vec<[f64; 2]> = nodes.iter().map(|&n| displacements[n]).collect();
        let sampled =
            (kernel.stresses(&points, &moved, &places)).map_err(|jacobian| degenerate(scene, body, cell, jacobian))?;
        for (&node, weights) in nodes.iter().zip(&weights) {
            for (stress, weight) in sampled.iter().zip(weights) {
                (0..3).for_each(|k| sums[node - first][k] += weight * stress[k]);
            }
            counts[node - first] += 1.0;
        }
    }
    let mean = |(node, (sum, count)): (usize, (&[f64; 3], f64))| match is_wanted(node) {
        true => sum.map(|stress| stress / count),
        false => [f64::NAN; 3],
    };
    Ok(sums.iter().zip(counts).enumerate().map(mean).collect())
}

/// Gauss points of a cell, and for each of its nodes their weights: the polynomials through the points at the node.
fn extrapolation(order: Order) -> (Vec<[f64; 2]>, Vec<Vec<f64>>) {
    if !order.is_tensor() {
        let points = [0, 1, 2, 3].map(|corner| shape_functions::NODES[corner].map(|x| x / 3f64.sqrt()));
        let weights = |node: &[f64; 2]| shape_functions::cell(4, node.map(|x| x * 3f64.sqrt()));
        let of_node = |node: &[f64; 2]| weights(node).into_iter().map(|(weight, _)| weight).collect();
        return (points.to_vec(), shape_functions::NODES[..order.nodes_per_cell()].iter().map(of_node).collect());
    }
    let count = usize::from(order.number());
    let line: Vec<f64> = quadrature::gauss(count).into_iter().map(|(x, _)| x).collect();
    let at = |x: f64| lobatto::lagrange(&line, x);
    let on_line: Vec<Vec<(f64, f64)>> = lobatto::points(count + 1).iter().map(|&x| at(x)).collect();
    let of_node = |[i, j]: [usize; 2]| {
        let rows = on_line[j].iter();
        rows.flat_map(|(m, _)| on_line[i].iter().map(move |(n, _)| n * m)).collect()
    };
    let points = quadrature::gauss_square(count).into_iter().map(|(at, _)| at).collect();
    (points, order.places().into_iter().map(of_node).collect())
}

/// Stress across the plane σ_z \[MPa\] of `[σ_x, σ_y, τ]`: 0 in plane stress, `ν (σ_x + σ_y)` in plane strain, and in
/// bodies of revolution, where it is the hoop stress, `ν (σ_r + σ_z) + E ε_θ` with a hoop strain that plane scenes have
/// not.
pub fn across([x, y, _]: [f64; 3], plane: PlaneHypothesis, material: &Material, hoop_strain: f64) -> f64 {
    match plane {
        PlaneHypothesis::Stress => 0.0,
        PlaneHypothesis::Strain => material.poisson * (x + y),
        PlaneHypothesis::Axisymmetric | PlaneHypothesis::AxisymmetricAboutX => {
            material.poisson * (x + y) + material.young * hoop_strain
        }
    }
}

/// Principal stresses σ₁ ≥ σ₂ ≥ σ₃ \[MPa\] of `[σ_x, σ_y, τ]` and σ_z: `½ (σ_x + σ_y) ± √(¼ (σ_x − σ_y)² + τ²)`, and
/// σ_z itself.
pub fn principal([x, y, shear]: [f64; 3], z: f64) -> [f64; 3] {
    let (mean, radius) = (0.5 * (x + y), (0.5 * (x - y)).hypot(shear));
    let mut all = [mean + radius, mean - radius, z];
    all.sort_by(|a, b| b.total_cmp(a));
    all
}

/// Von Mises stress `√(½ ((σ_x − σ_y)² + (σ_y − σ_z)² + (σ_z − σ_x)²) + 3 τ²)` \[MPa\] of `[σ_x, σ_y, τ]` and the
/// stress [`across`] them.
///
/// In a cell of smoothed dilatation this σ_z is off by `2νμ (λ₁/λ)(θ̄ − θ)`, which has no mean over the cell.
pub fn von_mises([x, y, shear]: [f64; 3], z: f64) -> f64 {
    (0.5 * ((x - y).powi(2) + (y - z).powi(2) + (z - x).powi(2)) + 3.0 * shear * shear).sqrt()
}
