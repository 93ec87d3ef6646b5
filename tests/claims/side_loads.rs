//! Loads on parts of sides, total forces and couples have their resultant and their moment, wherever their ends lie.

use contact_vv::case::Case;
use contact_vv::elasticity::loads;
use contact_vv::mesh::{Mesh, Order};
use contact_vv::scene::{Action, Along, Component, Load, Scene, SidePart, VectorField};

use crate::scene_file::{folder, text_of};
use crate::workbench::{ORDERS, block, distance, resolution};

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
    let mut scene = Case::parse(&folder().join("whole-disc.toml"), &text_of("whole-disc.toml")).expect("sound").scene;
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
        // The ends lie on the curve of the cells, which is the circle in the limit, with the third power of their length.
        let error = |refinement| {
            let mesh = Mesh::of(&scene, resolution(8, refinement, Order::Quadratic)).expect("mesh");
            distance(&sums(&scene, &mesh), &[fx, fy, -50.0 * fx]) / (50.0 * fx.hypot(fy))
        };
        let [coarse, fine] = [0, 2].map(error);
        assert!(coarse <= 1e-3 && fine <= 1e-12 + coarse / 32.0, "{from}, {to}: {coarse}, {fine}");
    }
}
