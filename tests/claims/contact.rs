//! Contact elements: areas, rows, stiffnesses and shares of the points they make.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact_vv::case::library::{Cylinder, PinRod, PressFit};
use contact_vv::contact::interface::ContactNode;
use contact_vv::contact::primary::{PrimaryNode, PrimarySurface};
use contact_vv::contact::{ContactPoint, Interface, Quadrature, layer, line, node};
use contact_vv::elasticity::ElasticSystem;
use contact_vv::mesh::{Mesh, Order};
use contact_vv::scene::{Circle, ContactPair, Path, Profile, Scene};
use nalgebra::{DMatrix, Vector2};

use crate::workbench::{ORDERS, resolution};

const RULES: [Quadrature; 3] = [Quadrature::Gauss, Quadrature::GaussFull, Quadrature::Lobatto];

type Points = Box<dyn Fn(&Interface) -> Vec<ContactPoint>>;

/// Node element, and line and layer with each quadrature.
pub fn elements() -> Vec<(String, Points)> {
    let mut all: Vec<(String, Points)> = vec![("node".into(), Box::new(node::points))];
    for quadrature in RULES {
        all.push((format!("line {quadrature:?}"), Box::new(move |one| line::points(one, quadrature))));
        all.push((format!("layer {quadrature:?}"), Box::new(move |one| layer::points(one, quadrature, 0.05))));
    }
    all
}

/// Interface of a scene of the library.
pub fn interface(scene: &Scene, elements: usize, order: Order) -> Interface {
    let mesh = Mesh::of(scene, resolution(elements, 0, order)).expect("mesh");
    let condensed = ElasticSystem::assemble(scene, &mesh).expect("system").condense().expect("condensed");
    Interface::between(scene, &mesh, &condensed, 0).expect("interface")
}

/// A flat interface made by hand, of edges between the given corners; `bodies` = 1 is a rigid other side.
pub fn flat(corners: &[f64], order: Order, bodies: usize, profile: Profile) -> Interface {
    let path = Path::HORIZONTAL;
    on_path(corners, order, bodies, profile, path, |s| ([s, 0.0], [0.0, -1.0]))
}

/// The same on an arc of radius `radius`.
pub fn arc(corners: &[f64], order: Order, radius: f64, profile: Profile) -> Interface {
    let path = Path::Arc(Circle { centre: [0.0, 0.0], radius });
    on_path(corners, order, 2, profile, path, |s| {
        let n = [s.sin(), -s.cos()];
        ([radius * n[0], radius * n[1]], n)
    })
}

fn on_path(
    corners: &[f64],
    order: Order,
    bodies: usize,
    profile: Profile,
    path: Path,
    place: impl Fn(f64) -> ([f64; 2], [f64; 2]),
) -> Interface {
    let per = usize::from(order.number());
    let mut coordinates = vec![corners[0]];
    for two in corners.windows(2) {
        coordinates.extend((1..=per).map(|k| two[0] + (two[1] - two[0]) * k as f64 / per as f64));
    }
    let count = coordinates.len();
    let nodes = coordinates.into_iter().enumerate().map(|(i, coordinate)| {
        let (point, normal) = place(coordinate);
        ContactNode {
            coordinate,
            point,
            normal,
            gap: profile.gap(coordinate),
            dof: i,
            opposite: (1..bodies).map(|b| (b * count + i, 1.0)).collect(),
        }
    });
    let nodes: Vec<ContactNode> = nodes.collect();
    let edges = (0..corners.len() - 1).map(|e| {
        let first = e * per;
        if per == 1 { vec![first, first + 1] } else { vec![first, first + 2, first + 1] }
    });
    let edges: Vec<Vec<usize>> = edges.collect();
    let second = (bodies == 2).then_some(1);
    let primary = second.map(|_| {
        let node = |&i: &usize| PrimaryNode {
            dof: count + i,
            coordinate: nodes[i].coordinate,
            depth: 0.0,
            normal: nodes[i].normal,
        };
        PrimarySurface { edges: edges.iter().map(|edge| edge.iter().map(node).collect()).collect(), same: 1e-9 }
    });
    let stretch = corners[corners.len() - 1];
    Interface {
        nodes,
        edges,
        primary,
        contact: 0,
        pair: ContactPair::new(second, path, profile, stretch),
        thickness: 2.5,
        radial: None,
    }
}

pub const CORNERS: [f64; 5] = [0.0, 0.3, 0.5, 1.1, 1.3];

/// Row as a dense vector.
pub fn expanded(point: &ContactPoint, dofs: usize) -> Vec<f64> {
    let mut row = vec![0.0; dofs];
    point.add_row(1.0, &mut row);
    row
}

#[test]
fn weights_of_the_points_add_up_to_the_area_of_an_arc() {
    // Of a flat one they do edge by edge; nodes project the area of an arc on their own normals.
    for order in ORDERS {
        for (name, points_of) in elements().into_iter().skip(1) {
            let sample = arc(&CORNERS, order, 7.0, Profile::Hole { radius: 7.0, clearance: 0.1 });
            let area: f64 = points_of(&sample).iter().map(|p| p.weight).sum();
            assert!((area - 1.3 * 7.0 * 2.5).abs() <= 1e-12, "{name}: {area}");
        }
    }
}

#[test]
fn weights_of_nodes_on_an_arc_project_the_area_on_their_own_normals() {
    let (radius, corners) = (7.0, [0.2_f64, 0.8]);
    let points = node::points(&arc(&corners, Order::Quadratic, radius, Profile::Uniform(0.0)));
    let half = 0.5 * (corners[1] - corners[0]);
    // ∫ N cos(s − s_a) ds in closed form with ξ = x/δ: mid-side N = 1 − ξ², corner N = ξ(ξ+1)/2, x from the middle.
    let (sin, cos) = half.sin_cos();
    let second_moment = 2.0 * sin - 4.0 / half * (sin / half - cos);
    let middle = 2.0 * sin - second_moment;
    let even = 0.5 * second_moment * cos;
    let odd = 0.5 * sin * 2.0 * (sin / half - cos);
    // Three Gauss points miss 8/175 of the term ξ⁶ δ⁴/24: 1.2e-5 of the mid-side weight at δ = 0.3, and of the
    // corner's, a quarter as large, four times that at most. The projection itself is worth 1e-2.
    assert_relative_eq!(points[1].weight, middle * radius * 2.5, max_relative = 1.3e-5);
    assert_relative_eq!(points[0].weight, (even + odd) * radius * 2.5, max_relative = 5e-5);
    assert_relative_eq!(points[0].weight, points[2].weight, max_relative = 1e-13);
}

#[test]
fn rows_interpolate_a_quadratic_approach_between_the_nodes() {
    let sample = flat(&CORNERS, Order::Quadratic, 1, Profile::Uniform(0.1));
    let approach = |s: f64| 1.0 + 0.5 * s - 0.2 * s * s;
    let u: Vec<f64> = sample.nodes.iter().map(|node| approach(node.coordinate)).collect();
    for (name, points_of) in elements() {
        for point in points_of(&sample) {
            assert!((point.approach(&u) - approach(point.position)).abs() <= 1e-14, "{name} at {}", point.position);
        }
    }
}

#[test]
fn points_are_sorted_carry_the_exact_gap_of_their_position_and_press_both_bodies_alike() {
    for order in ORDERS {
        for (name, points_of) in elements() {
            let sample = flat(&CORNERS, order, 2, Profile::Parabola { radius: 5.0 });
            let (points, count) = (points_of(&sample), sample.nodes.len());
            assert!(points.windows(2).all(|two| two[0].position <= two[1].position), "{name}");
            for point in &points {
                let exact = point.position * point.position / 10.0;
                assert!((point.gap - exact).abs() <= 1e-16, "{name} at {}", point.position);
                let row = expanded(point, 2 * count);
                assert!((0..count).all(|k| (row[k] - row[k + count]).abs() <= 1e-13), "{name}: action and reaction");
            }
            if name == "node" {
                for (node, point) in sample.nodes.iter().zip(&points) {
                    assert_relative_eq!(point.position, node.coordinate);
                    assert_eq!(point.row, node.row().collect::<Vec<_>>());
                    assert_relative_eq!(point.relative_stiffness, 1.0);
                }
            }
        }
    }
}

#[test]
fn quadratures_have_their_numbers_of_points_at_their_places() {
    let wanted = [
        (Quadrature::Gauss, Order::Linear, vec![0.0]),
        (Quadrature::Gauss, Order::Quadratic, vec![-1.0 / 3f64.sqrt(), 1.0 / 3f64.sqrt()]),
        (Quadrature::GaussFull, Order::Linear, vec![-1.0 / 3f64.sqrt(), 1.0 / 3f64.sqrt()]),
        (Quadrature::GaussFull, Order::Quadratic, vec![-0.6f64.sqrt(), 0.0, 0.6f64.sqrt()]),
        (Quadrature::Lobatto, Order::Linear, vec![-1.0, 1.0]),
        (Quadrature::Lobatto, Order::Quadratic, vec![-1.0, 0.0, 1.0]),
    ];
    for (quadrature, order, places) in wanted {
        let points = line::points(&flat(&[0.0, 2.0], order, 1, Profile::Uniform(0.0)), quadrature);
        assert_eq!(points.len(), places.len());
        for (point, place) in points.iter().zip(places) {
            assert_abs_diff_eq!(point.position, 1.0 + place, epsilon = 1e-14);
        }
    }
}

#[test]
fn layer_between_parallel_faces_has_the_rows_of_the_line_and_equal_springs() {
    for order in ORDERS {
        for quadrature in RULES {
            let sample = flat(&[0.0, 0.5, 1.0], order, 2, Profile::Uniform(0.1));
            let line = line::points(&sample, quadrature);
            let layer = layer::points(&sample, quadrature, 0.05);
            let dofs = 2 * sample.nodes.len();
            for (a, b) in line.iter().zip(&layer) {
                for (x, y) in expanded(a, dofs).iter().zip(expanded(b, dofs)) {
                    assert_abs_diff_eq!(*x, y, epsilon = 1e-14);
                }
                assert_relative_eq!(a.weight, b.weight, max_relative = 1e-14);
                assert_relative_eq!(b.relative_stiffness, 1.0, max_relative = 1e-14);
            }
        }
    }
}

#[test]
fn layer_spring_is_its_modulus_over_its_thickness() {
    // k_i = E_n/t(ξ_i), t = t₀ + g, with E_n = k_n · mean t: the ratio of two springs is the inverse one of their t.
    let t0 = 0.05;
    let sample = flat(&[0.0, 1.0, 2.0], Order::Quadratic, 1, Profile::Parabola { radius: 5.0 });
    let points = layer::points(&sample, Quadrature::Gauss, t0);
    // Edges are 1 mm long, so that t₀ is 0.05 mm.
    let thickness = |point: &ContactPoint| t0 + point.position * point.position / 10.0;
    let mean = points.iter().map(thickness).sum::<f64>() / points.len() as f64;
    for point in &points {
        assert_relative_eq!(point.relative_stiffness, mean / thickness(point), max_relative = 1e-13);
    }
    assert!(points.windows(2).all(|two| two[0].relative_stiffness > two[1].relative_stiffness));
}

#[test]
fn layer_thickness_grows_with_the_edge_and_ignores_interference() {
    let springs = |profile: Profile| -> Vec<f64> {
        let sample = flat(&[0.0, 1.0, 4.0], Order::Linear, 1, profile);
        let points = layer::points(&sample, Quadrature::Gauss, 0.1);
        points.iter().map(|p| p.relative_stiffness).collect()
    };
    // Without a gap t is 0.1 and 0.3: mean 0.2.
    for found in [springs(Profile::Uniform(0.0)), springs(Profile::Uniform(-0.05))] {
        assert_relative_eq!(found[0], 2.0, max_relative = 1e-13);
        assert_relative_eq!(found[1], 2.0 / 3.0, max_relative = 1e-13);
    }
}

#[test]
fn layer_rows_on_an_arc_turn_the_nodal_normals_on_the_director() {
    // On η = 0 the derivative along the director e is ∂/∂η over |∂x/∂η|, so that w = Σ N_a (n_a·e)(u_a + u'_a).
    let (t0, radius) = (0.05, 7.0);
    let profile = Profile::Hole { radius, clearance: 0.4 };
    let sample = arc(&[0.4, 1.0], Order::Quadratic, radius, profile);
    let length = 0.6 * radius;
    let shapes = |x: f64| [x * (x - 1.0) / 2.0, 1.0 - x * x, x * (x + 1.0) / 2.0];
    for point in layer::points(&sample, Quadrature::Gauss, t0) {
        let values = shapes((point.position - 0.7) / 0.3);
        let normals: Vec<Vector2<f64>> = sample.nodes.iter().map(|s| Vector2::from(s.normal)).collect();
        let across = (0..3).fold(Vector2::zeros(), |sum: Vector2<f64>, a| {
            sum + normals[a] * (t0 * length + sample.nodes[a].gap) * values[a]
        });
        let director = across.normalize();
        let row = expanded(&point, 6);
        for a in 0..3 {
            let wanted = values[a] * normals[a].dot(&director);
            assert_abs_diff_eq!(row[a], wanted, epsilon = 1e-12);
            assert_abs_diff_eq!(row[a + 3], wanted, epsilon = 1e-12);
        }
    }
}

#[test]
fn shares_of_the_points_add_up_to_the_edges_and_to_the_points() {
    for order in ORDERS {
        for (name, points_of) in elements() {
            let points = points_of(&flat(&CORNERS, order, 1, Profile::Uniform(0.0)));
            let mut edges = vec![0.0; CORNERS.len() - 1];
            for point in &points {
                let shared: f64 = point.shares.iter().map(|(_, area)| area).sum();
                assert_relative_eq!(shared, point.weight, max_relative = 1e-14);
                point.shares.iter().for_each(|&(edge, area)| edges[edge] += area);
            }
            for (two, area) in CORNERS.windows(2).zip(edges) {
                assert!((area - 2.5 * (two[1] - two[0])).abs() <= 1e-13, "{name}: {area}");
            }
        }
    }
}

#[test]
fn as_many_gauss_points_as_nodes_ask_for_more_pressures_than_the_nodes_can_balance() {
    for order in ORDERS {
        for (quadrature, unique) in [(Quadrature::Gauss, true), (Quadrature::GaussFull, false)] {
            let sample = flat(&CORNERS, order, 1, Profile::Uniform(0.0));
            let points = line::points(&sample, quadrature);
            let count = sample.nodes.len();
            // Columns are the nodal forces of each point's pressure.
            let matrix = DMatrix::from_fn(count, points.len(), |i, j| expanded(&points[j], count)[i]);
            assert_eq!(matrix.rank(1e-10) == points.len(), unique, "{quadrature:?} {order:?}");
        }
    }
}

#[test]
fn edges_of_a_mesh_follow_the_contact_coordinate() {
    let swapped = PinRod::default().scene().swapped().expect("two bodies");
    for scene in [Cylinder::default().scene(), PinRod::default().scene(), PressFit::default().scene(), swapped] {
        for order in ORDERS {
            let sample = interface(&scene, 6, order);
            let mut reached = 0;
            for edge in &sample.edges {
                let mut sorted = edge.clone();
                sorted.sort_unstable();
                let wanted: Vec<usize> = (reached..=reached + usize::from(order.number())).collect();
                assert_eq!(sorted, wanted, "{}", scene.name);
                if let Some(&middle) = edge.get(2) {
                    assert_eq!(middle, reached + 1, "{}", scene.name);
                }
                reached += usize::from(order.number());
            }
            assert_eq!(reached + 1, sample.nodes.len());
            let bodies = scene.contact().bodies().count();
            assert!(sample.nodes.iter().all(|node| node.row().count() == bodies));
            // Those of the second body follow, or come before, in the same order.
            let count = sample.nodes.len();
            let [first, second] = if scene.contact().first == 0 { [0, count] } else { [count, 0] };
            for (i, node) in sample.nodes.iter().enumerate() {
                let wanted = [(first + i, 1.0), (second + i, 1.0)];
                assert_eq!(node.row().collect::<Vec<_>>(), wanted[..bodies], "{}", scene.name);
            }
        }
    }
}

#[test]
fn position_and_length_on_an_edge_follow_the_contact_coordinate_whichever_way_the_edge_runs() {
    let sample = arc(&[0.4, 1.0], Order::Quadratic, 7.0, Profile::Uniform(0.0));
    for (edge, sign) in [(vec![0, 2, 1], 1.0), (vec![2, 0, 1], -1.0)] {
        for xi in [-0.5, 0.0, 0.8] {
            let (shapes, position, length) = sample.at(&edge, xi);
            assert_abs_diff_eq!(position, 0.7 + sign * 0.3 * xi, epsilon = 1e-14);
            assert_relative_eq!(length, 0.3 * 7.0, max_relative = 1e-13);
            assert_abs_diff_eq!(shapes.iter().sum::<f64>(), 1.0, epsilon = 1e-14);
        }
    }
}
