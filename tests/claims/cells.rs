//! Shape functions, Gauss rules and element stiffness of the isoparametric quadrilaterals.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact_vv::elasticity::element::{self, CellStiffness};
use contact_vv::elasticity::{quadrature, shape_functions};
use contact_vv::mesh::Order;
use contact_vv::scene::PlaneHypothesis;
use nalgebra::{DMatrix, DVector, Matrix3, SymmetricEigen, Vector3};

use crate::workbench::{STEEL, noise};

/// A distorted but convex cell; the 8-node one has bulging sides.
pub fn distorted(nodes: usize) -> Vec<[f64; 2]> {
    let all = [[0.1, -0.2], [2.3, 0.1], [2.0, 1.7], [-0.3, 1.4], [1.2, -0.1], [2.25, 0.9], [0.9, 1.6], [-0.15, 0.6]];
    all[..nodes].to_vec()
}

#[test]
fn natural_coordinates_run_counter_clockwise_with_mid_sides_after_corners() {
    let n = shape_functions::NODES;
    assert_eq!(n[..4], [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]);
    for k in 0..4 {
        let (p, q) = (n[k], n[(k + 1) % 4]);
        assert_eq!(n[4 + k], [0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])]);
    }
}

#[test]
fn serendipity_functions_reproduce_every_complete_quadratic() {
    let mut number = noise(2);
    let field = |[x, y]: [f64; 2]| 1.0 + 2.0 * x - y + 3.0 * x * x - 0.5 * x * y + 0.7 * y * y;
    for _ in 0..20 {
        let at = [number(), number()];
        let shapes = shape_functions::cell(8, at);
        let found: f64 = shapes.iter().zip(shape_functions::NODES).map(|((n, _), node)| n * field(node)).sum();
        assert_abs_diff_eq!(found, field(at), epsilon = 1e-13);
    }
}

#[test]
fn gradients_of_shape_functions_are_their_difference_quotients() {
    let h = 1e-5;
    let mut number = noise(3);
    for n in [4, 8] {
        for _ in 0..10 {
            let at = [number(), number()];
            for k in 0..2 {
                let moved = |s: f64| {
                    let mut there = at;
                    there[k] += s * h;
                    shape_functions::cell(n, there)
                };
                for ((plus, minus), (_, slope)) in moved(1.0).iter().zip(moved(-1.0)).zip(shape_functions::cell(n, at))
                {
                    // Central differences err by h² f‴/6 (≈ 1e-10) and ε/h (≈ 1e-11).
                    assert_abs_diff_eq!((plus.0 - minus.0) / (2.0 * h), slope[k], epsilon = 1e-9);
                }
            }
        }
    }
    for n in [2, 3] {
        let x = 0.37;
        let (plus, minus) = (shape_functions::edge(n, x + h), shape_functions::edge(n, x - h));
        for ((plus, minus), (_, slope)) in plus.iter().zip(minus).zip(shape_functions::edge(n, x)) {
            assert_abs_diff_eq!((plus.0 - minus.0) / (2.0 * h), slope, epsilon = 1e-9);
        }
    }
}

/// `∫ xᵏ` over −1 … 1.
fn monomial(k: i32) -> f64 {
    if k % 2 == 1 { 0.0 } else { 2.0 / (k as f64 + 1.0) }
}

#[test]
fn gauss_rules_are_exact_to_degree_two_n_less_one_and_no_further() {
    for n in 1..=16 {
        let integral = |k: i32| quadrature::gauss(n).iter().map(|(x, w)| w * x.powi(k)).sum::<f64>();
        for k in 0..2 * n as i32 {
            assert_abs_diff_eq!(integral(k), monomial(k), epsilon = 1e-14 * 10.0);
        }
        if n <= 8 {
            let next = 2 * n as i32;
            assert!((integral(next) - monomial(next)).abs() > 1e-6, "{n} points integrate degree {next}");
        }
        assert!(quadrature::gauss(n).iter().all(|(x, w)| x.abs() < 1.0 && *w > 0.0));
    }
}

#[test]
fn square_rules_integrate_what_they_promise() {
    for n in [2, 3] {
        for (a, b) in [(0, 0), (2, 0), (2, 2), (3, 2), (1, 3)] {
            let found: f64 = quadrature::gauss_square(n).iter().map(|([x, y], w)| w * x.powi(a) * y.powi(b)).sum();
            assert_abs_diff_eq!(found, monomial(a) * monomial(b), epsilon = 1e-14);
        }
        let first = quadrature::gauss_square(n)[1].0;
        assert!(first[0] > quadrature::gauss_square(n)[0].0[0]);
    }
}

/// Stiffness of the cell with nodes at some points; a Jacobian that is not positive is the error.
pub fn cell_stiffness(points: &[[f64; 2]], elasticity: &[[f64; 3]; 3], thickness: f64) -> Result<DMatrix<f64>, f64> {
    let order = if points.len() == 4 { Order::Linear } else { Order::Quadratic };
    let kernel = CellStiffness::new(order, elasticity, thickness);
    let mut k = vec![f64::NAN; kernel.entries()];
    kernel.integrate(points.iter().copied(), &mut k)?;
    Ok(DMatrix::from_row_slice(2 * points.len(), 2 * points.len(), &k))
}

#[test]
fn element_stiffness_is_symmetric_with_exactly_the_three_rigid_motions() {
    for n in [4, 8] {
        for plane in [PlaneHypothesis::Strain, PlaneHypothesis::Stress] {
            let points = distorted(n);
            let k = cell_stiffness(&points, &STEEL.stiffness(plane), 1.3).expect("the sample is convex");
            let scale = k.amax();

            assert!((&k - k.transpose()).amax() <= 1e-14 * scale);
            for motion in [|_: [f64; 2]| [1.0, 0.0], |_: [f64; 2]| [0.0, 1.0], |[x, y]: [f64; 2]| [-y, x]] {
                let u = DVector::from_iterator(2 * n, points.iter().flat_map(|p| motion(*p)));
                assert!((&k * u).amax() <= 1e-13 * scale);
            }
            let mut eigenvalues: Vec<f64> = SymmetricEigen::new(k).eigenvalues.iter().copied().collect();
            eigenvalues.sort_by(f64::total_cmp);
            assert!(eigenvalues[2] <= 1e-13 * scale && eigenvalues[3] >= 1e-3 * scale, "{eigenvalues:?}");
        }
    }
}

#[test]
fn strain_energy_of_a_uniform_strain_is_half_stress_times_strain_times_volume() {
    let (thickness, strain) = (1.3, Vector3::new(1e-3, -2e-3, 0.7e-3));
    for n in [4, 8] {
        let points = distorted(n);
        let d = STEEL.stiffness(PlaneHypothesis::Strain);
        let k = cell_stiffness(&points, &d, thickness).expect("the sample is convex");
        let u: Vec<f64> = points
            .iter()
            .flat_map(|[x, y]| [strain[0] * x + 0.2 * strain[2] * y, strain[1] * y + 0.8 * strain[2] * x])
            .collect();
        let energy: f64 =
            (0..2 * n).flat_map(|i| (0..2 * n).map(move |j| (i, j))).map(|(i, j)| 0.5 * u[i] * k[(i, j)] * u[j]).sum();
        let density = 0.5 * strain.dot(&(Matrix3::from_fn(|i, j| d[i][j]) * strain));
        // Area inside four parabolas: the polygon of corners and 2/3 of the triangles at each bulge.
        let area = green(&points);
        assert_relative_eq!(energy, density * area * thickness, max_relative = 1e-12);
    }
}

/// Area by Green's theorem along straight or parabolic sides.
fn green(points: &[[f64; 2]]) -> f64 {
    let cross = |a: [f64; 2], b: [f64; 2]| a[0] * b[1] - a[1] * b[0];
    let side = |k: usize| {
        let (p, q) = (points[k], points[(k + 1) % 4]);
        let chord = 0.5 * cross(p, q);
        let Some(&m) = points.get(4 + k) else { return chord };
        let bulge = [m[0] - p[0], m[1] - p[1]];
        chord + 2.0 / 3.0 * cross(bulge, [q[0] - p[0], q[1] - p[1]])
    };
    (0..4).map(side).sum()
}

#[test]
fn gradients_of_a_linear_field_are_constant_on_any_cell() {
    for n in [4, 8] {
        let points = distorted(n);
        for (at, _) in quadrature::gauss_square(3) {
            let (gradients, determinant) = element::gradients(&points, at).expect("the sample is convex");
            let slope = |k: usize| -> f64 {
                gradients.iter().zip(&points).map(|(g, p)| g[k] * (2.0 * p[0] - 3.0 * p[1])).sum()
            };
            assert_abs_diff_eq!(slope(0), 2.0, epsilon = 1e-13);
            assert_abs_diff_eq!(slope(1), -3.0, epsilon = 1e-13);
            assert!(determinant > 0.0);
        }
    }
}

#[test]
fn cell_turned_inside_out_is_refused_with_its_determinant() {
    let clockwise = vec![[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]];
    let refused = cell_stiffness(&clockwise, &STEEL.stiffness(PlaneHypothesis::Stress), 1.0);
    // The unit square seen from −1 … 1 has the Jacobian 1/4.
    assert_relative_eq!(refused.expect_err("a clockwise cell has a negative Jacobian"), -0.25);
}
