//! Stiffness, loads, supports and stresses of whole bodies, against exact solutions.

use std::f64::consts::FRAC_PI_2;

use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact_vv::case::library::{Cylinder, PinRod};
use contact_vv::elasticity::{ElasticSystem, Freedom, loads, numbered, reactions};
use contact_vv::mesh::{BodyMesh, Mesh, Order};
use contact_vv::scene::{Action, Along, Component, Face, Load, Path, Place, Scene, Shape, SidePart, VectorField};
use nalgebra::DVector;

use crate::scene_file::case;
use crate::workbench::{ORDERS, block, dense, displaced, distance, held, held_at, noise, resolution, ring};

/// Resultant and moment about the origin of a body's load vector, by virtual rigid motions.
fn resultant(scene: &Scene, mesh: &Mesh) -> [f64; 3] {
    let system = ElasticSystem::assemble(scene, mesh).expect("system");
    let body = &system.bodies[0];
    let mut sums = [0.0; 3];
    for (node, point) in mesh.points.iter().enumerate() {
        for (dof, axis) in body.dofs.of_node(node).into_iter().zip(body.dofs.frame(node)) {
            let Freedom::Equation(equation) = dof else { continue };
            let [fx, fy] = axis.map(|a| a * body.force[equation]);
            sums = [sums[0] + fx, sums[1] + fy, sums[2] + point[0] * fy - point[1] * fx];
        }
    }
    sums
}

/// A scene whose only support is a rotation that the candidates' normals do not hold; it takes no load here.
fn loaded(load: Load, order: Order) -> (Scene, Mesh) {
    let scene = block([4.0, 3.0], vec![], vec![load]);
    let mesh = Mesh::of(&scene, resolution(2, 0, order)).expect("mesh");
    let mut scene = scene;
    // Held sideways at one corner of the contact side only, where no load acts.
    scene.bodies[0].supports.push(held_at([0.0, 0.0], Component::X, 0.0));
    (scene, mesh)
}

#[test]
fn loads_have_their_resultant_and_their_moment() {
    let (t, width, height) = (2.5, 4.0, 3.0);
    for order in ORDERS {
        let traction = Load::on("far", Action::Uniform([2.0, -7.0]));
        let (scene, mesh) = loaded(traction, order);
        let [fx, fy] = [2.0 * width * t, -7.0 * width * t];
        assert!(distance(&resultant(&scene, &mesh), &[fx, fy, 0.5 * width * fy - height * fx]) <= 1e-12 * 200.0);

        // At a node, on a side between nodes, and inside a cell.
        for at in [[4.0, 3.0], [4.0, 1.234], [1.7, 3.0], [2.345, 1.618]] {
            let (scene, mesh) = loaded(Load::Force { at, force: [5.0, 6.0] }, order);
            assert!(distance(&resultant(&scene, &mesh), &[5.0, 6.0, at[0] * 6.0 - at[1] * 5.0]) <= 1e-13 * 200.0);
        }

        let pull = VectorField::of(|[_, y]| [y * y, 0.0, 3.0]);
        let (scene, mesh) = loaded(Load::on("right", Action::Stress(pull)), order);
        // ∫ y² = H³/3 and its moment −∫ y³ = −H⁴/4; shear 3 H at x = 4.
        let wanted = [9.0 * t, 9.0 * t, t * (4.0 * 9.0 - 81.0 / 4.0)];
        assert!(distance(&resultant(&scene, &mesh), &wanted) <= 1e-12 * 200.0);
    }
}

#[test]
fn force_at_any_point_of_a_disc_has_its_resultant_and_its_moment() {
    let outline = |angle: f64| [50.0 * angle.sin(), 50.0 - 50.0 * angle.cos()];
    for order in ORDERS {
        for at in [[3.1, 7.7], [21.0, 48.3], [0.0, 20.123], [17.0, 50.0], outline(0.05), outline(0.3)] {
            let mut scene = Cylinder::default().scene();
            scene.bodies[0].loads = vec![Load::Force { at, force: [5.0, -6.0] }];
            let mesh = Mesh::of(&scene, resolution(4, 0, order)).expect("mesh");
            let (forces, sums) = (loads::at_nodes(&scene, &mesh, 0).expect("inside"), sums(&scene, &mesh));
            let wanted = [5.0, -6.0, at[0] * -6.0 - at[1] * 5.0];
            assert!(distance(&sums, &wanted) <= 1e-10, "{order:?} {at:?}: {sums:?}, not {wanted:?}");
            let taking = forces.iter().filter(|force| force[0].abs() > 0.0).count();
            assert!(taking <= order.nodes_per_cell(), "{at:?}: {taking} nodes");
        }
    }
}

#[test]
fn body_force_has_the_weight_of_the_body_as_its_resultant() {
    for order in Order::ALL {
        let (scene, mesh) = loaded(Load::BodyForce([0.0, -2.0]), order);
        let weight = -2.0 * 4.0 * 3.0 * 2.5;
        // The held corner takes no vertical force out of the list: only its x component is prescribed.
        assert!(distance(&resultant(&scene, &mesh), &[0.0, weight, 2.0 * weight]) <= 1e-12 * 200.0);
        if !ORDERS.contains(&order) {
            continue;
        }
        let (scene, mesh) = loaded(Load::BodyForce([1.0, 0.0]), order);
        let corner = if order == Order::Linear { 1.0 / 4.0 } else { -1.0 / 12.0 };
        let cells = mesh.cells() as f64;
        let lost = corner * 30.0 / cells;
        assert_relative_eq!(resultant(&scene, &mesh)[0], 30.0 - lost, max_relative = 1e-12);
    }
}

#[test]
fn stiffness_and_surface_loads_are_proportional_to_thickness() {
    let (thin, mesh) = loaded(Load::on("far", Action::Uniform([2.0, -7.0])), Order::Quadratic);
    let thick = Scene { thickness: 3.0 * thin.thickness, ..thin.clone() };
    let [one, three] = [&thin, &thick].map(|scene| ElasticSystem::assemble(scene, &mesh).expect("system"));
    let (one, three) = (&one.bodies[0], &three.bodies[0]);
    let scale = dense(one).amax();
    assert!((dense(one) * 3.0 - dense(three)).amax() <= 1e-14 * 3.0 * scale);
    let tripled: Vec<f64> = one.force.iter().map(|f| 3.0 * f).collect();
    assert!(distance(&tripled, &three.force) <= 1e-12);
    assert!(one.force.iter().any(|f| f.abs() > 1.0));
    let doubled = numbered(&thin, &mesh)
        .and_then(|own| ElasticSystem::assemble_numbered(&thin, &mesh, own, &|_| 2.0))
        .expect("system");
    assert!((dense(one) * 2.0 - dense(&doubled.bodies[0])).amax() <= 1e-14 * scale);
}

#[test]
fn frames_along_the_contact_normals_leave_the_solution_unchanged() {
    let supports = vec![held("start", Component::X, 0.0), held("end", Component::Y, 1e-3)];
    let loads = vec![
        Load::on("outer", Action::Uniform([30.0, -20.0])),
        Load::on("contact", Action::Uniform([5.0, 8.0])),
        Load::BodyForce([1.0, 2.0]),
    ];
    for order in ORDERS {
        // Three quarters of the arc, so that no support meets an oblique normal.
        let scene = ring([2.0, 4.0], Face::Bottom, 1.2, supports.clone(), loads.clone());
        let turned = Mesh::of(&scene, resolution(6, 0, order)).expect("mesh");
        let mut straight = turned.clone();
        straight.bodies[0].candidates.clear();

        let [a, b] = [&turned, &straight].map(|mesh| displaced(&scene, mesh));

        let size = a.iter().flatten().fold(0.0_f64, |m, u| m.max(u.abs()));
        for (one, two) in a.iter().zip(&b) {
            assert!(distance(one, two) <= 1e-12 * size, "{order:?}: {one:?} {two:?}");
        }
        let systems = [&turned, &straight].map(|mesh| ElasticSystem::assemble(&scene, mesh).expect("system"));
        assert_relative_eq!(
            systems[0].bodies[0].applied_vertical(),
            systems[1].bodies[0].applied_vertical(),
            max_relative = 1e-12
        );
    }
}

#[test]
fn retained_freedoms_are_displacements_along_the_outward_normals() {
    let scene = PinRod::default().scene();
    let mesh = Mesh::of(&scene, resolution(6, 0, Order::Quadratic)).expect("mesh");
    let system = ElasticSystem::assemble(&scene, &mesh).expect("system");
    for (body, part) in system.bodies.iter().zip(&mesh.bodies) {
        assert_eq!(body.dofs.retained.len(), part.candidates.len());
        for (candidate, equation) in part.candidates.iter().zip(body.dofs.retained.clone()) {
            let mut unit = vec![0.0; body.dofs.equations];
            unit[equation] = 1.0;
            let u = body.dofs.displacements(1.0, &unit);
            let moved = u[candidate.node - body.dofs.first];
            assert!(distance(&moved, &candidate.normal) <= 1e-15);
            let others = u.iter().map(|u| u[0].hypot(u[1])).sum::<f64>();
            assert_abs_diff_eq!(others, 1.0, epsilon = 1e-14);
            // The tangent is the normal turned counter-clockwise.
            let [n, t] = body.dofs.frame(candidate.node);
            assert!(distance(&n, &candidate.normal) <= 0.0);
            assert!(distance(&t, &[-n[1], n[0]]) <= 1e-14, "{n:?}, {t:?}");
        }
    }
}

#[test]
fn rigid_face_stays_flat_and_takes_the_whole_force() {
    let supports = vec![held("left", Component::X, 0.0), held("contact", Component::Y, 0.0)];
    let loads = vec![
        Load::RigidFace { boundary: "far".into(), component: Component::Y, force: -50.0 },
        Load::Force { at: [4.0, 3.0], force: [0.0, -7.0] },
    ];
    for order in ORDERS {
        let scene = block([4.0, 3.0], supports.clone(), loads.clone());
        let mut mesh = Mesh::of(&scene, resolution(3, 0, order)).expect("mesh");
        mesh.bodies[0].candidates.clear();
        let u = displaced(&scene, &mesh);
        let at = |side: &'static str| mesh.nodes_at(&scene, 0, &Place::Boundary(side.into())).expect(side);
        let far = at("far");
        let common = u[far[0]][1];
        assert!(common < 0.0);
        assert!(far.iter().all(|&n| (u[n][1] - common).abs() <= 0.0), "the face is not flat");
        assert!(far.iter().any(|&n| (u[n][0] - u[far[0]][0]).abs() > 1e-9), "the face must stay free to widen");
        // The reaction on the held side balances face and corner force.
        let internal = reactions::internal_forces(&scene, &mesh, 0, &u, &|_| true).expect("forces");
        assert_relative_eq!(at("contact").iter().map(|&n| internal[n][1]).sum::<f64>(), 57.0, max_relative = 1e-10);
    }
}

#[test]
fn product_is_that_of_the_full_symmetric_matrix() {
    let scene = PinRod::default().scene();
    let mesh = Mesh::of(&scene, resolution(2, 0, Order::Linear)).expect("mesh");
    let system = ElasticSystem::assemble(&scene, &mesh).expect("system");
    for body in &system.bodies {
        let mut number = noise(5);
        let u: Vec<f64> = (0..body.dofs.equations).map(|_| number()).collect();
        let wanted = dense(body) * DVector::from_vec(u.clone());
        let scale = wanted.amax();
        assert!(distance(&body.product(&u), wanted.as_slice()) <= 1e-13 * scale);
    }
}

#[test]
fn prescribed_displacement_along_a_normal_that_points_downwards_keeps_its_sign() {
    // On the contact side n = (0, −1) and t = (1, 0); a support along x is one along t, one along y is refused.
    let supports = vec![held_at([4.0, 0.0], Component::X, 0.02), held("left", Component::X, 0.0)];
    let scene = block([4.0, 3.0], supports, vec![]);
    let mesh = Mesh::of(&scene, resolution(2, 0, Order::Linear)).expect("mesh");
    let system = ElasticSystem::assemble(&scene, &mesh).expect("system");
    let node = mesh.node_at(&scene, 0, [4.0, 0.0]).expect("corner");
    let zeros = vec![0.0; system.bodies[0].dofs.equations];
    assert_relative_eq!(system.nodal_displacements(1.0, &[zeros])[node][0], 0.02);
    // A mirrored arc: the tangent of a node at 90° is vertical, its sign must not turn the prescribed value.
    let supports = vec![held("start", Component::X, 0.0), held("end", Component::Y, 0.01)];
    let scene = ring([2.0, 4.0], Face::Bottom, FRAC_PI_2, supports, vec![]);
    for (scene, mesh) in {
        let mesh = Mesh::of(&scene, resolution(4, 0, Order::Quadratic)).expect("mesh");
        [(scene.mirrored(), mesh.mirrored()), (scene.clone(), mesh)]
    } {
        let system = ElasticSystem::assemble(&scene, &mesh).expect("system");
        let zeros = vec![0.0; system.bodies[0].dofs.equations];
        let u = system.nodal_displacements(1.0, &[zeros]);
        for node in mesh.nodes_at(&scene, 0, &Place::Boundary("end".into())).expect("end") {
            assert_relative_eq!(u[node][1], 0.01, max_relative = 1e-14);
        }
    }
}

#[test]
fn load_does_the_work_of_its_tractions_on_any_motion() {
    let held = |at, component| held_at(at, component, 0.0);
    let supports = vec![held([0.0, 0.0], Component::X), held([0.0, 0.0], Component::Y), held([4.0, 0.0], Component::Y)];
    let traction = Load::on("far", Action::Uniform([2.0, -7.0]));
    for order in ORDERS {
        let scene = block([4.0, 3.0], supports.clone(), vec![traction.clone()]);
        let mut mesh = Mesh::of(&scene, resolution(3, 0, order)).expect("mesh");
        // Its bottom is supported.
        mesh.bodies[0].candidates.clear();
        let system = ElasticSystem::assemble(&scene, &mesh).expect("system");
        // u = (y/2, 3 + x) on y = 3 over 0 … 4, 2.5 thick.
        let [work, _] = system.bodies[0].work_of_load(&|node| {
            let [x, y] = mesh.points[node];
            [0.5 * y, 3.0 + x]
        });
        let exact = 2.5 * (2.0 * 1.5 * 4.0 - 7.0 * (3.0 * 4.0 + 8.0));
        assert_relative_eq!(work, exact, max_relative = 1e-12);
    }
}

/// Force along x and y, and moment about the origin, of all nodal forces of a scene's first body.
pub fn sums(scene: &Scene, mesh: &Mesh) -> [f64; 3] {
    let forces = loads::at_nodes(scene, mesh, 0).expect("loads");
    mesh.points
        .iter()
        .zip(&forces)
        .fold([0.0; 3], |sum, ([x, y], [fx, fy])| [sum[0] + fx, sum[1] + fy, sum[2] + x * fy - y * fx])
}

fn on(boundary: &'static str, part: Option<SidePart>, action: Action) -> Load {
    Load::OnSide { boundary: boundary.into(), part, action }
}

fn along(component: Component, from: f64, to: f64) -> Option<SidePart> {
    Some(SidePart { along: Along::Axis(component), from, to })
}

/// Of a block 4 × 3, 2.5 mm thick, with elements of 2 mm along and 1.5 or 3 mm across.
fn of_block(load: Load, order: Order) -> [f64; 3] {
    let scene = block([4.0, 3.0], vec![], vec![load]);
    sums(&scene, &Mesh::of(&scene, resolution(2, 0, order)).expect("mesh"))
}

#[test]
fn load_on_a_part_of_a_side_has_its_resultant_and_moment_wherever_its_ends_lie() {
    // At nodes, within one element, across several, and to the end of the side.
    for (from, to) in [(0.0, 2.0), (0.3, 0.7), (1.3, 3.9), (0.1, 4.0), (0.0, 4.0)] {
        for order in ORDERS {
            let integral = |n: i32| (f64::powi(to, n + 1) - f64::powi(from, n + 1)) / f64::from(n + 1);
            // p = 5 + 2 x, inwards: downwards on the upper side.
            let pressure = VectorField::of(|[x, _]: [f64; 2]| [-5.0 - 2.0 * x, -5.0 - 2.0 * x, 0.0]);
            let part = along(Component::X, from, to);
            let found = of_block(on("far", part, Action::Stress(pressure)), order);
            let [force, moment] = [0, 1].map(|n| -2.5 * (5.0 * integral(n) + 2.0 * integral(n + 1)));
            assert!(distance(&found, &[0.0, force, moment]) <= 1e-12 * 200.0, "{from}, {to}: {found:?}");

            let found = of_block(on("far", part, Action::Total([3.0, -7.0])), order);
            let wanted = [3.0, -7.0, -7.0 * 0.5 * (from + to) - 3.0 * 3.0];
            assert!(distance(&found, &wanted) <= 1e-12 * 50.0, "{from}, {to}: {found:?}");
        }
    }
    // On an upright side, whose nodes run the other way.
    let found = of_block(on("right", along(Component::Y, 0.4, 2.9), Action::Uniform([2.0, 0.0])), Order::Quadratic);
    assert!(distance(&found, &[12.5, 0.0, -12.5 * 1.65]) <= 1e-12 * 50.0, "{found:?}");
}

#[test]
fn moment_is_a_couple_of_no_force_on_any_side_and_any_part() {
    let linear = |boundary, part, order| of_block(on(boundary, part, Action::Moment(90.0)), order);
    for order in ORDERS {
        for found in [
            linear("far", None, order),
            linear("right", None, order),
            linear("far", along(Component::X, 0.3, 1.1), order),
            linear("left", along(Component::Y, 0.2, 2.7), order),
        ] {
            assert!(distance(&found, &[0.0, 0.0, 90.0]) <= 1e-12 * 500.0, "{found:?}");
        }
        let scene = disc(vec![on("top", None, Action::Moment(70.0))]);
        let found = sums(&scene, &Mesh::of(&scene, resolution(4, 0, order)).expect("mesh"));
        assert!(distance(&found, &[0.0, 0.0, 70.0]) <= 1e-12 * 1e4, "{found:?}");
    }
}

/// The whole disc of a scene file, radius 50 about (0, 50), with other loads.
fn disc(loads: Vec<Load>) -> Scene {
    let mut scene = case("whole-disc").scene;
    scene.bodies[0].loads = loads;
    scene
}

#[test]
fn part_of_an_arc_lies_between_two_angles_even_across_the_top() {
    let part = |from: f64, to: f64| {
        let along = Along::Angle { centre: [0.0, 50.0] };
        Some(SidePart { along, from: from.to_radians(), to: to.to_radians() })
    };
    let pressure = || Action::Stress(VectorField::of(|_| [-3.0, -3.0, 0.0]));
    for (from, to) in [(170.0, 190.0), (103.7, 131.9), (-121.0, -97.3)] {
        let scene = disc(vec![on("top", part(from, to), pressure())]);
        // A uniform pressure on any curve: p t times the turned chord between its ends, and no moment about the centre.
        let [a, b] = [from, to].map(|angle: f64| {
            let (s, c) = angle.to_radians().sin_cos();
            [50.0 * s, 50.0 - 50.0 * c]
        });
        let [fx, fy] = [-3.0 * (b[1] - a[1]), 3.0 * (b[0] - a[0])].map(|f| f * scene.thickness);
        // The ends lie on the curve of the cells, which is the circle in the limit, with the third power of their
        // length.
        let error = |refinement| {
            let mesh = Mesh::of(&scene, resolution(8, refinement, Order::Quadratic)).expect("mesh");
            distance(&sums(&scene, &mesh), &[fx, fy, -50.0 * fx]) / (50.0 * fx.hypot(fy))
        };
        let [coarse, fine] = [0, 2].map(error);
        assert!(coarse <= 1e-3 && fine <= 1e-12 + coarse / 32.0, "{from}, {to}: {coarse}, {fine}");
    }
}

#[test]
fn part_of_a_side_that_turns_back_within_an_edge_lies_on_both_of_its_flanks() {
    // The upper side of one cell is y = −x²/4 from x = −1 to 2, whose top is no node.
    let height = |x: f64| -0.25 * x * x;
    let upper = [2.0, -1.0, 0.5].map(|x| [x, height(x)]);
    let lower = [[-1.0, -5.0], [2.0, -5.0]];
    let points = vec![lower[0], lower[1], upper[0], upper[1], [0.5, -5.0], [2.0, -3.0], upper[2], [-1.0, -2.625]];
    let boundaries = [("top".into(), vec![vec![2, 3, 6]])].into();
    let (nodes, cells, lines, candidates) = (0..8, 0..1, Default::default(), Vec::new());
    let body = BodyMesh { nodes, cells, boundaries, lines, candidates };
    let mesh = Mesh { order: Order::Quadratic, points, connectivity: (0..8).collect(), bodies: vec![body] };
    let part = Some(SidePart { along: Along::Axis(Component::Y), from: -0.2, to: height(0.5) });
    let pressure = Action::Stress(VectorField::of(|_| [-3.0, -3.0, 0.0]));
    let scene = block([3.0, 5.0], vec![], vec![on("top", part, pressure)]);
    let forces = loads::at_nodes(&scene, &mesh, 0).expect("a part of the side");
    // From |x| = 0.5 to √0.8 on either flank: what presses sideways cancels.
    let wanted = -3.0 * scene.thickness * 2.0 * (0.8_f64.sqrt() - 0.5);
    let [x, y] = [0, 1].map(|k| forces.iter().map(|force| force[k]).sum::<f64>());
    assert_relative_eq!(y, wanted, max_relative = 1e-12);
    assert_abs_diff_eq!(x, 0.0, epsilon = 1e-12);
}

#[test]
fn a_block_that_supports_stretch_is_strained_evenly_whichever_side_touches() {
    let (size, stretched) = ([4.0, 3.0], 0.01);
    for (order, contact) in ORDERS.into_iter().flat_map(|order| [Face::Bottom, Face::Top].map(|face| (order, face))) {
        let ends = [("left", 0.0), ("right", stretched)].map(|(side, value)| held(side, Component::X, value));
        let mut scene = block(size, [&ends[..], &[held("far", Component::Y, 0.0)]].concat(), vec![]);
        scene.bodies[0].shape = Shape::Rectangle { x: [0.0, size[0]], y: [0.0, size[1]], contact };
        // On the upper side the tangent of the candidates runs against x.
        let [touching, far] = if contact == Face::Bottom { [0.0, size[1]] } else { [size[1], 0.0] };
        let pair = &mut scene.contacts[0];
        (pair.above, pair.path) =
            (contact == Face::Bottom, Path::Straight { origin: [0.0, touching], both_sides: false });
        let mesh = Mesh::of(&scene, resolution(2, 0, order)).expect("mesh");
        // No stress along y: ε_y = −ν/(1 − ν) ε_x in plane strain.
        let strain = stretched / size[0];
        for ([u, v], [x, y]) in displaced(&scene, &mesh).into_iter().zip(&mesh.points) {
            assert_abs_diff_eq!(u, strain * x, epsilon = 1e-12);
            assert_abs_diff_eq!(v, -0.3 / 0.7 * strain * (y - far), epsilon = 1e-12);
        }
    }
}
