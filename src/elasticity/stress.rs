//! Nodal stresses: from 2×2 Gauss points to the corners, averaged over the cells that meet at a node.

use crate::elasticity::{element, shape_functions};
use crate::error::Error;
use crate::mesh::Mesh;
use crate::scene::{PlaneHypothesis, Scene};

/// Mean over the adjoining cells of `σ = D B q`, taken at the 2×2 Gauss points (where it is most accurate; Barlow 1976)
/// and extrapolated bilinearly to the nodes: `[σ_x, σ_y, τ_xy]` at every node \[MPa\], tension positive.
pub fn at_nodes(scene: &Scene, mesh: &Mesh, displacements: &[[f64; 2]]) -> Result<Vec<[f64; 3]>, Error> {
    let mut sums = vec![[0.0; 3]; mesh.points.len()];
    let mut counts = vec![0.0; mesh.points.len()];
    for (body, part) in mesh.bodies.iter().enumerate() {
        let elasticity = scene.bodies[body].material.stiffness(scene.plane);
        for cell in part.cells.clone() {
            let nodes = mesh.cell(cell);
            let corners = gauss_stresses(mesh, nodes, &elasticity, displacements)
                .map_err(|jacobian| Error::DegenerateCell { cell, body: scene.bodies[body].name.clone(), jacobian })?;
            for (&node, at) in nodes.iter().zip(shape_functions::NODES) {
                let weights = shape_functions::cell(4, at.map(|x| x * 3f64.sqrt()));
                for (stress, (weight, _)) in corners.iter().zip(weights) {
                    (0..3).for_each(|k| sums[node][k] += weight * stress[k]);
                }
                counts[node] += 1.0;
            }
        }
    }
    Ok(sums.iter().zip(counts).map(|(sum, count)| sum.map(|s| s / count)).collect())
}

/// Stresses at the four Gauss points `(±1/√3, ±1/√3)`, in the order of the corners.
fn gauss_stresses(
    mesh: &Mesh,
    nodes: &[usize],
    d: &[[f64; 3]; 3],
    displacements: &[[f64; 2]],
) -> Result<[[f64; 3]; 4], f64> {
    let points: Vec<[f64; 2]> = nodes.iter().map(|&n| mesh.points[n]).collect();
    let mut stresses = [[0.0; 3]; 4];
    for (corner, stress) in shape_functions::NODES.into_iter().zip(&mut stresses) {
        let (gradients, _) = element::gradients(&points, corner.map(|x| x / 3f64.sqrt()))?;
        let mut strain = [0.0; 3];
        for ([x, y], &node) in gradients.into_iter().zip(nodes) {
            let [u, v] = displacements[node];
            strain[0] += x * u;
            strain[1] += y * v;
            strain[2] += y * u + x * v;
        }
        *stress = std::array::from_fn(|i| (0..3).map(|j| d[i][j] * strain[j]).sum());
    }
    Ok(stresses)
}

/// Von Mises stress `√(½ ((σ_x − σ_y)² + (σ_y − σ_z)² + (σ_z − σ_x)²) + 3 τ²)` \[MPa\] of `[σ_x, σ_y, τ]`, with `σ_z = 0` in
/// plane stress and `ν (σ_x + σ_y)` in plane strain.
pub fn von_mises([x, y, shear]: [f64; 3], plane: PlaneHypothesis, poisson: f64) -> f64 {
    let z = match plane {
        PlaneHypothesis::Stress => 0.0,
        PlaneHypothesis::Strain => poisson * (x + y),
    };
    (0.5 * ((x - y).powi(2) + (y - z).powi(2) + (z - x).powi(2)) + 3.0 * shear * shear).sqrt()
}
