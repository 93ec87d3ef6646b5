//! Fields of cells of high order, as ParaView reads them: Lagrange cells, whose nodes lie evenly.

use contact_vv::case::library::{PinPlate, TruncatedHertz};
use contact_vv::cli::vtu;
use contact_vv::elasticity::shape_functions;
use contact_vv::measure::relative_error;
use contact_vv::mesh::Order;
use contact_vv::scene::Scene;
use contact_vv::solve::{Discretisation, Fitted, Formulation, Run};
use vtkio::model::{CellType, IOBuffer, VertexNumbers};

use crate::outputs::{numbers, piece};

/// Lattice places of the nodes of VTK's Lagrange quadrilateral: corners around, then the sides, each along its axis, then the
/// inside row by row (vtkHigherOrderQuadrilateral::PointIndexFromIJK).
fn place(m: usize, [i, j]: [usize; 2]) -> usize {
    let inner = m - 1;
    match ([i, j].map(|k| k == 0 || k == m), [i, j]) {
        ([true, true], _) => [[0, 3], [1, 2]][usize::from(i == m)][usize::from(j == m)],
        ([false, true], _) => 4 + (i - 1) + if j == m { 2 * inner } else { 0 },
        ([true, false], _) => 4 + (j - 1) + if i == m { inner } else { 3 * inner },
        ([false, false], _) => 4 + 4 * inner + (i - 1) + inner * (j - 1),
    }
}

/// Polynomials through even positions from −1 to 1.
fn even(m: usize, x: f64) -> Vec<f64> {
    let at = |k: usize| 2.0 * k as f64 / m as f64 - 1.0;
    let others = |a: usize| (0..=m).filter(move |&k| k != a);
    (0..=m).map(|a| others(a).map(|k| (x - at(k)) / (at(a) - at(k))).product()).collect()
}

/// The value that VTK interpolates in a cell of the file.
fn read(nodes: &[u64], m: usize, values: &[f64], stride: usize, [x, y]: [f64; 2]) -> f64 {
    let (along, up) = (even(m, x), even(m, y));
    let all = (0..=m).flat_map(|j| (0..=m).map(move |i| [i, j]));
    all.map(|[i, j]| along[i] * up[j] * values[stride * nodes[place(m, [i, j])] as usize]).sum()
}

fn scenes() -> Vec<(Scene, Fitted)> {
    let block = |order| (TruncatedHertz::default().scene(), Fitted { order, layers: 1 });
    let pin = |order| (PinPlate::of_half_angle(60.0).scene(), Fitted { order, layers: 1 });
    vec![block(Order::Quartic), block(Order::Octic), pin(Order::Quintic), pin(Order::Septic)]
}

#[test]
fn fields_of_high_order_are_read_as_the_polynomials_that_were_solved() {
    for (scene, fitted) in scenes() {
        let answer = fitted.solve(&scene, &Formulation::verification()).expect("answer");
        let (discretisation, run): (Discretisation, Run) = (answer.discretisation, answer.run);
        let piece = piece(&vtu::text(&discretisation, &run).expect("written"));
        let (mesh, case) = (&discretisation.mesh, format!("{} {:?}", scene.name, fitted.order));
        let m = mesh.order.intervals();
        assert!(piece.cells.types.iter().all(|kind| *kind == CellType::LagrangeQuadrilateral), "{case}");
        let VertexNumbers::XML { connectivity, .. } = &piece.cells.cell_verts else { panic!("cells") };
        let IOBuffer::F64(points) = &piece.points else { panic!("points") };
        let fields = discretisation.recover(&run.solution).expect("fields");
        let (moved, stress) = (numbers(&piece, "displacement"), numbers(&piece, "stress_yy"));
        let largest = |values: &[f64]| values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        let scales = [largest(points), largest(&moved), largest(&stress)];
        for (cell, nodes) in connectivity.chunks((m + 1) * (m + 1)).enumerate() {
            for at in [[0.3, -0.7], [-0.95, 0.1], [1.0, 0.4]] {
                let shapes = shape_functions::cell(nodes.len(), at);
                let own = |of: &dyn Fn(usize) -> f64| -> f64 {
                    mesh.cell(cell).iter().zip(&shapes).map(|(&node, (shape, _))| shape * of(node)).sum()
                };
                // Nodes that two cells share have the mean of both stresses in ours as in the file.
                let pairs = [
                    (own(&|node| mesh.points[node][0]), read(nodes, m, points, 3, at)),
                    (own(&|node| fields.displacement[node][0]), read(nodes, m, &moved, 3, at)),
                    (own(&|node| fields.stress[node][1]), read(nodes, m, &stress, 1, at)),
                ];
                for ((ours, theirs), scale) in pairs.into_iter().zip(scales) {
                    assert!((ours - theirs).abs() <= 1e-9 * scale, "{case}, cell {cell}: {ours} is read as {theirs}");
                }
            }
        }
        let pressed = largest(&numbers(&piece, "contact_pressure"));
        let peak = run.solution.points.iter().fold(0.0_f64, |most, point| most.max(point.pressure));
        assert!(relative_error(pressed, peak) <= 2e-2, "{case}: {pressed} of {peak}");
    }
}
