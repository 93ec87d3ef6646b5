//! The mesh: exact areas and curves, nesting, orientation, closed boundaries; growth that follows the elements, so that
//! refinement goes to the solution.

use std::collections::HashMap;
use std::f64::consts::{FRAC_PI_2, PI};

use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact_vv::accuracy::fitted::{Plan, level};
use contact_vv::case::library::{Cylinder, PinRod, PressFit, TruncatedHertz};
use contact_vv::elasticity::{element, quadrature};
use contact_vv::mesh::candidates::candidate_edges;
use contact_vv::mesh::{Mesh, Order};
use contact_vv::scene::{BlockShape, Grading, Path, Scene, Sector, Shape};
use contact_vv::solve::{Formulation, Run};

use crate::scene_file::text_of;
use crate::workbench::{ORDERS, library, meshed, of_shape, parsed, resolution};

/// Area by quadrature of the Jacobian determinant; 3 × 3 points are exact for 8-node cells.
fn area(mesh: &Mesh, body: usize) -> f64 {
    let cells = mesh.bodies[body].cells.clone();
    cells.map(|cell| determinants(mesh, cell).iter().map(|(d, w)| d * w).sum::<f64>()).sum()
}

/// Jacobian determinants at the 3 × 3 Gauss points, with the weights; zero where the mapping is refused.
fn determinants(mesh: &Mesh, cell: usize) -> Vec<(f64, f64)> {
    let points: Vec<[f64; 2]> = mesh.cell(cell).iter().map(|&n| mesh.points[n]).collect();
    let at = |(at, weight)| (element::gradients(&points, at).map_or_else(|refused| refused, |(_, d)| d), weight);
    quadrature::gauss_square(3).into_iter().map(at).collect()
}

/// Area of the outline in closed form.
fn exact_area(shape: &Shape) -> f64 {
    match *shape {
        Shape::Rectangle { x, y, .. } => (x[1] - x[0]) * (y[1] - y[0]),
        Shape::Disc { radius, sector, .. } => PI * radius * radius / if sector.has_upper_part() { 2.0 } else { 4.0 },
        Shape::Ring { inner, outer, sweep, .. } => 0.5 * sweep * (outer.radius.powi(2) - inner.radius.powi(2)),
        Shape::Eye { hole, outer_radius, shank_half_width, shank_end, .. } => {
            let (w, r) = (shank_half_width, outer_radius);
            // ∫₀ʷ √(r² − x²) dx
            let below_arc = 0.5 * (w * (r * r - w * w).sqrt() + r * r * (w / r).asin());
            FRAC_PI_2 * (r * r - hole.radius.powi(2)) + w * shank_end - below_arc
        }
        Shape::Blocks(_) | Shape::Given(_) => unreachable!("no shape of the library"),
    }
}

fn mesh_of(scene: &Scene, elements: usize, refinement: u32, order: Order) -> Mesh {
    Mesh::of(scene, resolution(elements, refinement, order)).expect("library scenes can be meshed")
}

#[test]
fn area_converges_to_the_exact_one_with_the_order_of_the_arcs() {
    for (scene, elements) in library() {
        for order in ORDERS {
            let relative = |refinement: u32| -> Vec<f64> {
                let mesh = mesh_of(&scene, elements, refinement, order);
                let bodies = scene.bodies.iter().enumerate();
                bodies.map(|(b, body)| (area(&mesh, b) / exact_area(&body.shape) - 1.0).abs()).collect()
            };
            for ((body, coarse), fine) in scene.bodies.iter().zip(relative(1)).zip(relative(3)) {
                let what = format!("{}, {}, {order:?}: {coarse:e} then {fine:e}", scene.name, body.name);
                // Chords err with h², quadratic arcs with h⁴: 16 and 256 times less after two halvings, less what
                // is left of higher orders on coarse arcs. Straight sides err by round-off only.
                let (limit, gain) = if order == Order::Linear { (2e-3, 14.0) } else { (1e-6, 120.0) };
                assert!(fine <= limit, "{what}");
                assert!(coarse <= 1e-11 || fine <= coarse / gain, "{what}");
            }
        }
    }
}

/// Directed corner pairs of cell edges without a neighbour, with their mid-side node.
fn outer_edges(mesh: &Mesh, body: usize) -> HashMap<(usize, usize), Option<usize>> {
    let mut edges = HashMap::new();
    for cell in mesh.bodies[body].cells.clone() {
        let nodes = mesh.cell(cell);
        for k in 0..4 {
            let (a, b) = (nodes[k], nodes[(k + 1) % 4]);
            if edges.remove(&(b, a)).is_none() {
                edges.insert((a, b), nodes.get(4 + k).copied());
            }
        }
    }
    edges
}

#[test]
fn boundaries_are_exactly_the_cell_edges_without_a_neighbour_and_run_counter_clockwise() {
    for (scene, elements) in library() {
        for order in ORDERS {
            let mesh = mesh_of(&scene, elements, 0, order);
            for (b, body) in mesh.bodies.iter().enumerate() {
                let mut outer = outer_edges(&mesh, b);
                for (name, edge) in
                    body.boundaries.iter().flat_map(|(name, edges)| edges.iter().map(move |e| (name, e)))
                {
                    let mid = outer.remove(&(edge[0], edge[1]));
                    assert_eq!(mid, Some(edge.get(2).copied()), "{}, boundary {name}, edge {edge:?}", scene.name);
                }
                assert!(outer.is_empty(), "{}: {} edges without a name", scene.name, outer.len());
            }
        }
    }
}

#[test]
fn named_boundaries_lie_where_their_names_say() {
    for (scene, elements) in library() {
        let mesh = mesh_of(&scene, elements, 1, Order::Quadratic);
        for (b, body) in scene.bodies.iter().enumerate() {
            for (name, edges) in &mesh.bodies[b].boundaries {
                for point in edges.iter().flatten().map(|&n| mesh.points[n]) {
                    let off = distance_from(&body.shape, name, point);
                    assert!(off <= 1e-12 * size(&body.shape), "{}, {}, {name}: {off:e} off", scene.name, body.name);
                }
            }
        }
    }
}

fn size(shape: &Shape) -> f64 {
    match shape {
        Shape::Rectangle { x, y, .. } => x[1].abs().max(y[1].abs()).max(y[0].abs()),
        Shape::Disc { radius, .. } => *radius,
        Shape::Ring { outer, .. } => outer.radius,
        Shape::Eye { shank_end, .. } => *shank_end,
        Shape::Blocks(_) | Shape::Given(_) => unreachable!("no shape of the library"),
    }
}

/// Distance of a point from the line or circle that a boundary name stands for [mm].
fn distance_from(shape: &Shape, name: &str, [x, y]: [f64; 2]) -> f64 {
    use contact_vv::scene::Face;
    let circle = |c: [f64; 2], r: f64| ((x - c[0]).hypot(y - c[1]) - r).abs();
    match (shape, name) {
        (Shape::Rectangle { x: range, .. }, "left") => (x - range[0]).abs(),
        (Shape::Rectangle { x: range, .. }, "right") => (x - range[1]).abs(),
        (Shape::Rectangle { y: range, contact, .. }, "contact" | "far") => {
            let lower = (*contact == Face::Bottom) == (name == "contact");
            (y - range[usize::from(!lower)]).abs()
        }
        (Shape::Disc { centre, .. }, "axis") => (x - centre[0]).abs(),
        (Shape::Disc { centre, sector: Sector::Quarter, .. }, "cut") => (y - centre[1]).abs(),
        (Shape::Disc { centre, radius, .. }, "contact") if y <= centre[1] + 1e-9 => circle(*centre, *radius),
        (Shape::Disc { centre, radius, sector: Sector::RightHalf, .. }, "top") if y >= centre[1] - 1e-9 => {
            circle(*centre, *radius)
        }
        (Shape::Ring { .. }, "start") => x.abs() + y.max(0.0),
        (Shape::Ring { pole, sweep, .. }, "end") => {
            let (sin, cos) = sweep.sin_cos();
            ((x - pole[0]) * cos + (y - pole[1]) * sin).abs()
        }
        (Shape::Ring { inner, outer, contact, .. }, _) => {
            let on_inner = (*contact == Face::Bottom) == (name == "contact");
            let c = if on_inner { inner } else { outer };
            circle(c.centre, c.radius)
        }
        (Shape::Eye { hole, .. }, "contact") => circle(hole.centre, hole.radius),
        (Shape::Eye { .. }, "axis") => x.abs(),
        (Shape::Eye { hole, outer_radius, .. }, "outer") => circle(hole.centre, *outer_radius),
        (Shape::Eye { shank_half_width, .. }, "shank") => (x - shank_half_width).abs(),
        (Shape::Eye { hole, shank_end, .. }, "end") => (y - hole.centre[1] - shank_end).abs(),
        _ => f64::INFINITY,
    }
}

#[test]
fn no_cell_is_degenerate_in_any_library_scene_at_any_usual_resolution() {
    for (scene, elements) in library() {
        for order in ORDERS {
            for (n, refinement) in
                [(elements, 0), (2 * elements, 0), (3 * elements + 1, 0), (elements, 1), (5 * elements, 0)]
            {
                let mesh = mesh_of(&scene, n, refinement, order);
                for cell in 0..mesh.cells() {
                    let worst = determinants(&mesh, cell).iter().map(|(d, _)| *d).fold(f64::INFINITY, f64::min);
                    assert!(worst > 0.0, "{} at {n}/{refinement} {order:?}: cell {cell} has {worst:e}", scene.name);
                }
            }
        }
    }
}

#[test]
fn bodies_of_a_press_fit_overlap_by_the_interference_in_the_model_only() {
    let scene = PressFit::default().scene();
    let mesh = mesh_of(&scene, 4, 0, Order::Quadratic);
    for (a, b) in mesh.bodies[0].candidates.iter().zip(&mesh.bodies[1].candidates) {
        let (p, q) = (mesh.points[a.node], mesh.points[b.node]);
        assert_abs_diff_eq!((p[0] - q[0]).hypot(p[1] - q[1]), 0.0, epsilon = 1e-12 * 40.0);
    }
}

#[test]
fn candidates_are_sorted_and_fill_the_stretch_with_the_asked_number_of_elements() {
    for (scene, elements) in library() {
        for (order, refinement) in [(Order::Linear, 0), (Order::Quadratic, 0), (Order::Quadratic, 1)] {
            let mesh = mesh_of(&scene, elements, refinement, order);
            let pair = scene.contact();
            let edges = candidate_edges(&mesh, &scene, pair, pair.first).expect("contact exists").len();
            let wanted = (elements as f64 * pair.stretch * pair.path.metric() / scene.grading.unit).round() as usize;
            assert_eq!(edges, wanted << refinement, "{}", scene.name);
            for body in pair.bodies() {
                let list = &mesh.bodies[body].candidates;
                assert_eq!(list.len(), edges * order.number() as usize + 1, "{}", scene.name);
                assert!(list.windows(2).all(|two| two[0].coordinate < two[1].coordinate), "{}", scene.name);
                assert_abs_diff_eq!(list[0].coordinate, 0.0, epsilon = 1e-12);
                assert_relative_eq!(list[list.len() - 1].coordinate, pair.stretch, max_relative = 1e-9);
                for (index, candidate) in list.iter().enumerate() {
                    assert_eq!(mesh.bodies[body].candidate_index(candidate.node), Some(index));
                }
            }
        }
    }
}

#[test]
fn normals_are_units_that_leave_their_own_body() {
    for (scene, elements) in library() {
        let straight = mesh_of(&scene, elements, 0, Order::Quadratic);
        for (mesh, scene) in [(straight.mirrored(), scene.mirrored()), (straight, scene)] {
            for body in scene.contact().bodies() {
                let part = &mesh.bodies[body];
                for candidate in &part.candidates {
                    let [x, y] = mesh.points[candidate.node];
                    let cells = part.cells.clone().filter(|&c| mesh.cell(c).contains(&candidate.node));
                    let inside: f64 = cells
                        .flat_map(|c| &mesh.cell(c)[..4])
                        .map(|&n| {
                            (mesh.points[n][0] - x) * candidate.normal[0]
                                + (mesh.points[n][1] - y) * candidate.normal[1]
                        })
                        .sum();
                    assert!(inside < 0.0, "{}: normal at ({x}, {y}) points into the body", scene.name);
                    assert_abs_diff_eq!(candidate.normal[0].hypot(candidate.normal[1]), 1.0, epsilon = 1e-14);
                }
            }
        }
    }
}

#[test]
fn boundary_nodes_of_a_mesh_are_nodes_of_its_refinement() {
    for (scene, elements) in library() {
        for order in ORDERS {
            for level in [0, 1] {
                let (coarse, fine) =
                    (mesh_of(&scene, elements, level, order), mesh_of(&scene, elements, level + 1, order));
                for (b, body) in coarse.bodies.iter().enumerate() {
                    for (name, edges) in &body.boundaries {
                        let there = &fine.bodies[b].boundaries[name];
                        assert_eq!(there.len(), 2 * edges.len());
                        let found: Vec<[f64; 2]> = there.iter().flatten().map(|&n| fine.points[n]).collect();
                        for p in edges.iter().flatten().map(|&n| coarse.points[n]) {
                            let near = found.iter().map(|q| (p[0] - q[0]).hypot(p[1] - q[1])).fold(f64::MAX, f64::min);
                            let scale = size(&scene.bodies[b].shape);
                            assert!(near <= 1e-12 * scale, "{}, {name}, level {level}: {near:e}", scene.name);
                        }
                    }
                }
                assert_eq!(fine.cells(), 4 * coarse.cells(), "{}", scene.name);
            }
        }
    }
}

#[test]
fn mid_side_nodes_of_curved_contact_edges_halve_the_angle() {
    let scene = PinRod::default().scene();
    let mesh = mesh_of(&scene, 6, 0, Order::Quadratic);
    for body in 0..2 {
        for edge in candidate_edges(&mesh, &scene, scene.contact(), body).expect("contact exists") {
            let at = |k: usize| scene.contact().path.coordinate(mesh.points[edge[k]]);
            assert_abs_diff_eq!(at(2), 0.5 * (at(0) + at(1)), epsilon = 1e-13);
        }
    }
}

#[test]
fn elements_grow_away_from_the_contact_and_no_faster_than_asked() {
    let scene = Cylinder::default().scene();
    let mesh = mesh_of(&scene, 12, 0, Order::Linear);
    let axis = mesh.boundary(&scene, 0, "axis").expect("a disc has an axis");
    let mut heights: Vec<f64> = axis.iter().flatten().map(|&n| mesh.points[n][1]).collect();
    heights.sort_by(f64::total_cmp);
    heights.dedup();
    let first = heights[1] - heights[0];
    let along = scene.contact().stretch / 24.0;
    assert!((0.3..=1.5).contains(&(first / along)), "first element {first} deep and {along} long");
    let sizes: Vec<f64> = heights.windows(2).map(|two| two[1] - two[0]).collect();
    assert!(sizes.iter().all(|s| *s >= 0.99 * first));
}

#[test]
fn eye_has_no_element_longer_than_its_coarsest() {
    let mut scene = PinRod::default().scene();
    // Elements that would soon outgrow it.
    (scene.grading.along, scene.grading.coarsest) = (3.0, 0.05);
    let rod = scene.bodies.len() - 1;
    let mesh = Mesh::of(&scene, resolution(24, 0, Order::Linear)).expect("mesh");
    let edges = mesh.boundary(&scene, rod, "contact").expect("a side");
    let Shape::Eye { hole, .. } = scene.bodies[rod].shape else { panic!("the rod has an eye") };
    let angle = |node: usize| (mesh.points[node][0] - hole.centre[0]).atan2(mesh.points[node][1] - hole.centre[1]);
    let longest = edges.iter().map(|edge| (angle(edge[1]) - angle(edge[0])).abs()).fold(0.0, f64::max);
    assert!(longest <= 1.01 * 1.6 * scene.grading.coarsest, "{longest}");
}

#[test]
fn no_cell_of_a_ring_is_wider_beyond_its_candidates_than_its_coarsest() {
    let scene = PinRod::default().scene();
    let text = include_str!("../../src/cli/new/pin-in-hole.toml");
    let ring = parsed(text).scene;
    for (scene, elements) in [(&scene, 2), (&ring, 2), (&ring, 3), (&ring, 8)] {
        let plan = Plan::around([-0.8, 0.8], 1.5, elements, Order::Quadratic, level(elements));
        let (scene, resolution) = plan.laid(scene);
        let mesh = Mesh::of(&scene, resolution).expect("mesh");
        let body = scene.bodies.len() - 1;
        let centre = match scene.bodies[body].shape {
            Shape::Eye { hole, .. } => hole.centre,
            Shape::Ring { inner, .. } => inner.centre,
            _ => panic!("neither ring nor eye"),
        };
        let angle = |node: usize| (mesh.points[node][0] - centre[0]).atan2(centre[1] - mesh.points[node][1]);
        let edges = mesh.boundary(&scene, body, "contact").expect("a side");
        let beyond = edges.iter().map(|edge| [edge[0], edge[1]].map(angle));
        let beyond = beyond.filter(|ends| ends.iter().all(|end| *end > 0.999 * scene.contact().stretch));
        let widest = beyond.map(|[from, to]| (to - from).abs()).fold(0.0, f64::max);
        assert!(widest > 0.0 && widest <= 33f64.to_radians(), "{elements}: {}°", widest.to_degrees());
    }
}

#[test]
fn refinement_of_default_meshes_goes_to_the_solution() {
    let numbers = TruncatedHertz::default();
    let mut scene = TruncatedHertz::default().scene();
    // The growth that scene files have by default.
    scene.grading = Grading { along: 1.7, depth: 1.6, coarsest: 0.3, ..scene.grading };
    let peak = 2.0 * numbers.load() / (PI * numbers.half_width());
    for (order, most) in [(Order::Linear, 3e-4), (Order::Quadratic, 2e-4)] {
        let error = |elements: usize, follows: bool| {
            let mut scene = scene.clone();
            if follows {
                scene.grading = order.refined(&scene.grading, elements as f64 / 8.0);
            }
            let discretisation = meshed(scene, elements, order);
            let run = Run::of(&discretisation, &Formulation::verification()).expect("solved");
            (run.measures().peak.pressure / peak - 1.0).abs()
        };
        let [coarse, fine] = [error(8, true), error(48, true)];
        assert!(fine <= most && fine < 0.2 * coarse, "{order:?}: {coarse:e}, {fine:e}");
        if order == Order::Linear {
            let stays = error(48, false);
            assert!(stays > 3.0 * fine, "growth that stays leaves {stays:e}");
        }
    }
    // In scene files it follows the elements beyond sixteen, where none is given.
    let text = |elements: usize, growth: &str| {
        let text = text_of("two-cylinders.toml");
        text.replace("elements = 12\n", &format!("elements = {elements}\n{growth}"))
    };
    let grading = |elements: usize, growth: &str| {
        let file = parsed(&text(elements, growth));
        file.scene.grading
    };
    assert!((grading(16, "").along - 1.7).abs() < 1e-12 && (grading(64, "").along - 1.7_f64.sqrt()).abs() < 1e-12);
    let given = grading(64, "growth = { along = 1.4, depth = 1.2, coarsest = 0.4, first = 0.5, end = 0.6 }\n");
    assert_eq!([given.along, given.depth, given.coarsest, given.first, given.end], [1.4, 1.2, 0.4, 0.5, 0.6]);
}

#[test]
fn corners_of_blocks_that_differ_by_rounding_are_one_node_whichever_way_they_differ() {
    // Nodes are looked up between lines 1e-9 of the size apart: half-way between two of them rounding leads to either.
    let (at, off) = (1.0 + 1e-9, 1e-12);
    for (dx, dy) in [(0.0, 1.0), (0.0, -1.0), (1.0, 0.0), (-1.0, 0.0), (1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)] {
        let corner = |times: f64| [at + times * dx * off, at + times * dy * off];
        let block = |corners: [[f64; 2]; 4]| BlockShape {
            corners,
            arcs: [None; 4],
            names: [Some("contact".into()), None, None, None],
            elements: [1, 1],
            growth: [1.0; 2],
        };
        let left = block([[0.0, 0.0], [at, 0.0], corner(-1.0), [0.0, at]]);
        let right = block([[at, 0.0], [2.0, 0.0], [2.0, at], corner(1.0)]);
        let scene = of_shape(Shape::Blocks(vec![left, right]), Path::HORIZONTAL, 2.0, vec![], vec![]);
        let mesh = Mesh::of(&scene, resolution(1, 0, Order::Linear)).expect("meshed");
        assert_eq!(mesh.points.len(), 6, "{dx}, {dy}");
    }
}

#[test]
fn growth_and_coarsest_element_of_finer_meshes_follow_the_order_of_the_cells() {
    // Of n times as many elements q^(n^−1/p), and the coarsest over n^(1/p); of coarser ones by a ratio the other way,
    // their unit times that.
    let grading = Grading { unit: 3.0, along: 1.7, depth: 1.4, first: 1.0, coarsest: 0.3, end: 1.0 };
    for order in [Order::Linear, Order::Quadratic, Order::Octic] {
        let power = f64::from(order.number()).recip();
        for (found, ratio, unit) in [
            (order.refined(&grading, 4.0), 0.25, 3.0),
            (order.refined(&grading, 0.5), 1.0, 3.0),
            (order.coarsened(&grading, 2.0), 2.0, 6.0),
        ] {
            let faster = f64::powf(ratio, power);
            assert_relative_eq!(found.along, 1.7_f64.powf(faster), max_relative = 1e-12);
            assert_relative_eq!(found.depth, 1.4_f64.powf(faster), max_relative = 1e-12);
            assert_relative_eq!(found.coarsest, 0.3 * faster, max_relative = 1e-12);
            assert_relative_eq!(found.unit, unit);
        }
    }
}
