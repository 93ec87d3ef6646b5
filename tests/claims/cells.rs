//! Shape functions, integration rules and element stiffness of the isoparametric quadrilaterals of every order.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact_vv::elasticity::element::{self, CellStiffness};
use contact_vv::elasticity::point::Cells;
use contact_vv::elasticity::{quadrature, shape_functions};
use contact_vv::mesh::{Order, lobatto};
use contact_vv::scene::{LARGEST_POISSON, Material, PlaneHypothesis};
use nalgebra::{DMatrix, DVector, Matrix3, Vector3};

use crate::workbench::{ORDERS, STEEL, noise};

/// Poisson's ratios on both sides of the last ordinary one.
pub const RATIOS: [f64; 3] = [0.3, 0.49, LARGEST_POISSON];

/// Natural coordinates of the nodes of a cell.
pub fn nodes(order: Order) -> Vec<[f64; 2]> {
    let points = lobatto::points(order.intervals() + 1);
    order.places().into_iter().map(|place| place.map(|k| points[k])).collect()
}

/// A distorted but convex cell; the 8-node one has bulging sides.
pub fn distorted(order: Order) -> Vec<[f64; 2]> {
    let all = [[0.1, -0.2], [2.3, 0.1], [2.0, 1.7], [-0.3, 1.4], [1.2, -0.1], [2.25, 0.9], [0.9, 1.6], [-0.15, 0.6]];
    let between_corners = |node: [f64; 2]| {
        let shapes = shape_functions::cell(4, node);
        [0, 1].map(|k| shapes.iter().zip(all).map(|((n, _), corner)| n * corner[k]).sum::<f64>())
    };
    match order {
        Order::Quadratic => all.to_vec(),
        order => nodes(order).into_iter().map(between_corners).collect(),
    }
}

/// Stiffness of the cell with nodes at these points.
pub fn stiffness(kernel: &CellStiffness, points: &[[f64; 2]]) -> DMatrix<f64> {
    let mut k = vec![f64::NAN; kernel.entries()];
    kernel.integrate(points.iter().copied(), &mut k).expect("the sample is convex");
    DMatrix::from_row_slice(2 * points.len(), 2 * points.len(), &k)
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
fn shape_functions_are_one_at_their_own_node_and_sum_to_one_everywhere() {
    let mut number = noise(7);
    for order in Order::ALL {
        let nodes = nodes(order);
        assert_eq!(nodes.len(), order.nodes_per_cell());
        for (a, at) in nodes.iter().enumerate() {
            for (b, (value, _)) in shape_functions::cell(nodes.len(), *at).into_iter().enumerate() {
                assert_abs_diff_eq!(value, if a == b { 1.0 } else { 0.0 }, epsilon = 1e-14);
            }
        }
        for _ in 0..20 {
            let shapes = shape_functions::cell(nodes.len(), [number(), number()]);
            assert_abs_diff_eq!(shapes.iter().map(|s| s.0).sum::<f64>(), 1.0, epsilon = 1e-13);
            for k in 0..2 {
                assert_abs_diff_eq!(shapes.iter().map(|s| s.1[k]).sum::<f64>(), 0.0, epsilon = 1e-11);
            }
        }
    }
}

#[test]
fn sides_of_a_cell_run_counter_clockwise_and_edges_have_its_shape_functions_and_slopes() {
    for order in Order::ALL {
        let n = order.nodes_per_cell();
        for (k, side) in order.sides().into_iter().enumerate() {
            let along = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]][k];
            for x in [-1.0, -0.3, 0.0, 0.62, 1.0] {
                let at = [[x, -1.0], [1.0, x], [-x, 1.0], [-1.0, -x]][k];
                let (cell, edge) = (shape_functions::cell(n, at), shape_functions::edge(side.len(), x));
                for (&a, (value, slope)) in side.iter().zip(&edge) {
                    let (wanted, gradient) = cell[a];
                    assert_abs_diff_eq!(wanted, *value, epsilon = 1e-13);
                    assert_abs_diff_eq!(gradient[0] * along[0] + gradient[1] * along[1], *slope, epsilon = 1e-11);
                }
            }
        }
    }
}

#[test]
fn polynomials_of_the_order_are_reproduced_with_their_gradients() {
    let mut number = noise(3);
    for order in Order::ALL {
        let p = i32::from(order.number());
        let at = [number(), number()];
        let shapes = shape_functions::cell(order.nodes_per_cell(), at);
        // The 8-node cell has all of the 9-node one but x² y².
        let has = |i: i32, j: i32| order != Order::Quadratic || i + j < 4;
        for (i, j) in (0..=p).flat_map(|i| (0..=p).map(move |j| (i, j))).filter(|&(i, j)| has(i, j)) {
            // Of the values and of both slopes.
            let sums = shapes.iter().zip(nodes(order)).fold([0.0; 3], |sums, ((value, slopes), node)| {
                let power = node[0].powi(i) * node[1].powi(j);
                [sums[0] + value * power, sums[1] + slopes[0] * power, sums[2] + slopes[1] * power]
            });
            let power = |x: f64, n: i32| if n < 0 { 0.0 } else { x.powi(n) };
            let slope = |x: f64, n: i32| f64::from(n) * power(x, n - 1);
            assert_abs_diff_eq!(sums[0], at[0].powi(i) * at[1].powi(j), epsilon = 1e-12);
            assert_abs_diff_eq!(sums[1], slope(at[0], i) * power(at[1], j), epsilon = 1e-10);
            assert_abs_diff_eq!(sums[2], power(at[0], i) * slope(at[1], j), epsilon = 1e-10);
        }
    }
}

/// `∫ xᵏ` over −1 … 1.
fn monomial(k: i32) -> f64 {
    if k % 2 == 1 { 0.0 } else { 2.0 / (k as f64 + 1.0) }
}

#[test]
fn rules_of_gauss_and_lobatto_are_exact_to_their_degree_and_no_further() {
    let gauss = (1..=16).map(|n| ("Gauss", quadrature::gauss(n), 2 * n as i32 - 1));
    let lobatto = (2..=9).map(|n| ("Lobatto", quadrature::lobatto(n), 2 * n as i32 - 3));
    for (name, rule, degree) in gauss.chain(lobatto) {
        let integral = |k: i32| rule.iter().map(|(x, w)| w * x.powi(k)).sum::<f64>();
        for k in 0..=degree {
            assert_abs_diff_eq!(integral(k), monomial(k), epsilon = 1e-13);
        }
        let beyond = (integral(degree + 1) - monomial(degree + 1)).abs();
        assert!(beyond > 1e-6 || degree > 15, "{name}: {} points integrate degree {}", rule.len(), degree + 1);
        assert!(rule.iter().all(|(x, w)| x.abs() <= 1.0 && *w > 0.0), "{name}: {rule:?}");
        let ends = [rule[0].0, rule[rule.len() - 1].0];
        assert_eq!(ends == [-1.0, 1.0], name == "Lobatto", "{name}: {ends:?}");
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

/// Number of eigenvalues of a symmetric matrix below a limit: that of negative pivots of K − limit·I (Sylvester's law
/// of inertia).
fn eigenvalues_below(k: &DMatrix<f64>, limit: f64) -> usize {
    let n = k.nrows();
    let mut left = k - DMatrix::identity(n, n) * limit;
    let mut negative = 0;
    for at in 0..n {
        let pivot = left[(at, at)];
        negative += usize::from(pivot.is_nan() || pivot < 0.0);
        for column in at + 1..n {
            let factor = left[(column, at)] / pivot;
            for row in column..n {
                left[(row, column)] -= factor * left[(row, at)];
            }
        }
    }
    negative
}

#[test]
fn element_stiffness_is_symmetric_with_exactly_the_three_rigid_motions_and_as_many_stiff_ones_as_dilatations() {
    for order in Order::ALL {
        for plane in [PlaneHypothesis::Strain, PlaneHypothesis::Stress] {
            for (points, poisson) in [distorted(order), nodes(order)].iter().flat_map(|one| RATIOS.map(|nu| (one, nu)))
            {
                let material = Material { poisson, ..STEEL };
                let shear = material.stiffness(plane)[2][2];
                let k = stiffness(&CellStiffness::of(order, &material, plane, 1.3), points);
                let (scale, what) = (k.amax(), format!("{order:?}, {plane:?}, ν = {poisson}"));

                assert!((&k - k.transpose()).amax() <= 1e-12 * scale, "{what}");
                for motion in [|_: [f64; 2]| [1.0, 0.0], |_: [f64; 2]| [0.0, 1.0], |[x, y]: [f64; 2]| [-y, x]] {
                    let u = DVector::from_iterator(2 * points.len(), points.iter().flat_map(|p| motion(*p)));
                    assert!((&k * u).amax() <= 1e-11 * scale, "{what}");
                }
                // These three have no energy, and nothing else has less than a stiff cell.
                let below = |limit: f64| eigenvalues_below(&k, limit);
                assert_eq!([-1e-12 * scale, 1e-3 * shear].map(below), [0, 3], "{what}");
                // Dilatations of degree p − 1.
                if plane == PlaneHypothesis::Strain && poisson >= LARGEST_POISSON {
                    let p = usize::from(order.number());
                    assert_eq!(2 * points.len() - below(100.0 * shear), p * (p + 1) / 2, "{what}");
                }
            }
        }
    }
}

#[test]
fn cells_of_revolution_shift_along_their_axis_alone_without_a_stress() {
    for (order, (plane, along)) in Order::ALL.into_iter().flat_map(|order| {
        [(PlaneHypothesis::Axisymmetric, 1), (PlaneHypothesis::AxisymmetricAboutX, 0)].map(|about| (order, about))
    }) {
        for poisson in RATIOS {
            let material = Material { poisson, ..STEEL };
            let points: Vec<[f64; 2]> = distorted(order).iter().map(|[x, y]| [x + 1.0, y + 1.0]).collect();
            let k = stiffness(&CellStiffness::of(order, &material, plane, 1.0), &points);
            let (scale, shear) = (k.amax(), material.stiffness(plane)[2][2]);
            let what = format!("{order:?}, {plane:?}, ν = {poisson}");
            let shift = DVector::from_fn(2 * points.len(), |row, _| if row % 2 == along { 1.0 } else { 0.0 });
            assert!((&k * shift).amax() <= 1e-11 * scale, "{what}");
            assert_eq!([-1e-12 * scale, 1e-3 * shear].map(|limit| eigenvalues_below(&k, limit)), [0, 1], "{what}");
        }
    }
}

#[test]
fn strain_energy_of_a_uniform_strain_is_half_stress_times_strain_times_volume() {
    let (thickness, strain) = (1.3, Vector3::new(1e-3, -2e-3, 0.7e-3));
    for order in ORDERS {
        let (n, points) = (order.nodes_per_cell(), distorted(order));
        let d = STEEL.stiffness(PlaneHypothesis::Strain);
        let k = stiffness(&CellStiffness::new(order, &d, thickness), &points);
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
    for order in Order::ALL {
        let points = distorted(order);
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
fn a_point_beside_a_triangle_is_as_far_from_it_as_from_its_nearest_side() {
    let cells = Cells::of([(3, vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])]);
    // Over the distance of the corners from the middle, (1/3, 1/3).
    let size = 5_f64.sqrt() / 3.0;
    for (point, away) in [([0.52, 0.52], 0.04 / 2_f64.sqrt()), ([0.4, -0.03], 0.03), ([-0.03, -0.04], 0.05)] {
        let found = |outside: f64| cells.shapes_at(point, outside / size);
        assert!(found(1.001 * away).is_some() && found(0.999 * away).is_none(), "{point:?}");
        let (_, shapes) = found(1.001 * away).expect("beside it");
        assert_relative_eq!(shapes[1], point[0], epsilon = 1e-12);
        assert_relative_eq!(shapes[2], point[1], epsilon = 1e-12);
    }
}
