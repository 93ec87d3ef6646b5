//! Cells of order 4 to 8: shape functions, areas, exactness of their degree, and contact on them.

use approx::assert_relative_eq;
use contact_vv::case::library::{Cylinder, Patch, PressFit, TruncatedHertz};
use contact_vv::contact::Quadrature;
use contact_vv::elasticity::{ElasticSystem, Freedom, stress};
use contact_vv::measure::relative_error;
use contact_vv::mesh::{Mesh, Order};
use contact_vv::scene::{Component, Face, Place, Support};
use contact_vv::solve::{Discretisation, Displaced, Element, Formulation, Iteration, Run};

use crate::workbench::{STEEL, area, block, distance, held, held_at, meshed, resolution, ring, solved};

/// All orders of tensor cells.
const TENSOR: [Order; 6] =
    [Order::Biquadratic, Order::Quartic, Order::Quintic, Order::Sextic, Order::Septic, Order::Octic];

/// Elements on the half-width that are enough for a few digits.
fn few(order: Order) -> usize {
    if order.is_high() { 2 } else { 8 }
}

/// Displacements of degree p in x and y without body forces: `u = Re z^p`, `v = −Im z^p` is harmonic and without
/// dilatation.
fn harmonic(p: i32, [x, y]: [f64; 2]) -> [f64; 2] {
    let (radius, angle) = (x.hypot(y), y.atan2(x));
    let size = 1e-3 * radius.powi(p);
    [size * (f64::from(p) * angle).cos(), -size * (f64::from(p) * angle).sin()]
}

#[test]
fn displacements_of_the_degree_are_found_to_round_off() {
    for order in Order::ALL {
        let p = i32::from(order.number());
        let scene = block([1.0, 1.0], vec![], vec![]);
        let mesh = Mesh::of(&scene, resolution(2, 0, order)).expect("mesh").shaken(0.0);
        let outer = |at: &[f64; 2]| at[0].min(at[1]).min(1.0 - at[0]).min(1.0 - at[1]) < 1e-12;
        let supports: Vec<Support> = mesh
            .points
            .iter()
            .filter(|point| outer(point))
            .flat_map(|&point| {
                let [u, v] = harmonic(p, point);
                [held_at(point, Component::X, u), held_at(point, Component::Y, v)]
            })
            .collect();
        let mut scene = block([1.0, 1.0], supports, vec![]);
        scene.contacts.iter_mut().for_each(|pair| pair.stretch = 1e-6);
        let mut mesh = mesh;
        mesh.bodies[0].candidates.clear();
        let system = ElasticSystem::assemble(&scene, &mesh).expect("system");
        let u = system.nodal_displacements(1.0, &[solved(&system.bodies[0])]);
        for (point, found) in mesh.points.iter().zip(&u) {
            assert!(distance(found, &harmonic(p, *point)) <= 1e-15, "{order:?} at {point:?}");
        }
        // Stresses of degree p − 1 are told exactly, `σ_x = −σ_y = 2μ p Re z^{p−1}`.
        let modulus = STEEL.young / (1.0 + STEEL.poisson);
        for (point, stress) in mesh.points.iter().zip(stress::at_nodes(&scene, &mesh, &u).expect("stress")) {
            let wanted = modulus * f64::from(p) * harmonic(p - 1, *point)[0];
            assert!((stress[0] - wanted).abs() <= 1e-8 && (stress[1] + wanted).abs() <= 1e-8, "{order:?} at {point:?}");
        }
    }
}

#[test]
fn patch_has_the_applied_pressure_with_every_element_and_order() {
    for order in Order::ALL {
        let discretisation = meshed(Patch::default().scene(), 2, order);
        for formulation in Formulation::nine() {
            let solution = discretisation.solve(&formulation.clone().tolerance(1e-8)).expect("solution");
            assert!(solution.converged(), "{} {order:?}: {}", formulation.name(), solution.outcome);
            for point in &solution.points {
                assert!((point.pressure - 100.0).abs() <= 1e-5, "{} {order:?}: {point:?}", formulation.name());
            }
        }
    }
}

#[test]
fn shaken_and_mirrored_patches_keep_the_uniform_pressure() {
    for order in TENSOR {
        let scene = Patch::default().scene();
        let mesh = Mesh::of(&scene, resolution(2, 0, order)).expect("mesh").shaken(0.2);
        for mesh in [mesh.clone(), mesh.mirrored().mirrored(), mesh.renumbered()] {
            let system = ElasticSystem::assemble(&scene, &mesh).expect("system");
            let made = Discretisation::of_system(scene.clone(), resolution(2, 0, order), mesh, system).expect("system");
            let solution = made.solve(&Formulation::verification()).expect("solution");
            for point in &solution.points {
                assert!((point.pressure - 100.0).abs() <= 1e-5, "{order:?}: {point:?}");
            }
        }
    }
}

#[test]
fn areas_of_contact_nodes_are_the_lobatto_weights() {
    for order in Order::ALL {
        let scene = block([3.0, 3.0], vec![held("left", Component::X, 0.0)], vec![]);
        let discretisation = meshed(scene, 1, order);
        let points = discretisation.points(&Formulation::verification());
        let rule = Quadrature::Lobatto.rule(usize::from(order.number()) + 1);
        assert_eq!(points.len(), rule.len(), "{order:?}");
        for (point, (_, weight)) in points.iter().zip(rule) {
            // Half the length of the edge, times the thickness.
            assert_relative_eq!(point.weight, weight * 1.5 * 2.5, max_relative = 1e-12);
        }
    }
}

#[test]
fn area_between_arcs_converges_as_fast_as_the_order_and_nodes_lie_on_them() {
    let wanted = std::f64::consts::FRAC_PI_4 * (400.0 - 100.0);
    for (order, bound) in TENSOR[1..].iter().copied().zip([1e-7, 1e-9, 1e-11, 1e-12, 1e-12]) {
        let scene = ring([10.0, 20.0], Face::Top, 0.5, vec![], vec![]);
        let mesh = Mesh::of(&scene, resolution(1, 0, order)).expect("mesh");
        let error = relative_error(area(&mesh), wanted);
        assert!(error <= bound, "{order:?}: {error:.1e}");
        for (name, radius) in [("inner", 10.0), ("contact", 20.0)] {
            for &node in mesh.bodies[0].boundaries[name].iter().flatten() {
                let [x, y] = mesh.points[node];
                assert_relative_eq!(x.hypot(y), radius, max_relative = 1e-13);
            }
        }
    }
}

#[test]
fn press_fit_has_the_pressure_of_lame_to_more_digits_with_the_order() {
    let numbers = PressFit::default();
    let wanted = numbers.case().reference_pressure(0, 0.0);
    let quadratic = [(Order::Quadratic, 12, 1e-3)];
    let tensor =
        TENSOR[1..].iter().copied().zip([3e-4, 5e-6, 5e-7, 2e-8, 2e-8]).map(|(order, bound)| (order, 2, bound));
    for (order, elements, bound) in quadratic.into_iter().chain(tensor) {
        let solution = meshed(numbers.scene(), elements, order).solve(&Formulation::verification()).expect("solution");
        for point in &solution.points {
            assert!(relative_error(point.pressure, wanted) <= bound, "{order:?}: {point:?} {wanted}");
        }
    }
}

#[test]
fn every_element_finds_hertz_on_cells_of_every_order() {
    let hertz = TruncatedHertz::default();
    for order in TENSOR {
        let discretisation = meshed(hertz.scene(), few(order), order);
        for element in Element::ALL {
            let formulation = Formulation::new(element, Iteration::Kinematic).tolerance(1e-8);
            let run = Run::of(&discretisation, &formulation).expect("run");
            assert!(run.solution.converged(), "{order:?} {element:?}");
            let measures = run.measures();
            // The edge of the contact lies within an element.
            let errors = [
                relative_error(measures.second_moment_width, hertz.half_width()),
                relative_error(measures.peak.pressure, hertz.closed_form().peak_pressure()),
            ];
            assert!(errors.iter().all(|error| *error <= 4e-3), "{order:?} {element:?}: {errors:?}");
        }
    }
}

#[test]
fn forces_of_nearly_incompressible_cells_do_not_lock() {
    // A square that a rigid parabola presses, ν = 0.4999: without locking p₀ is that of any other material.
    let hertz = TruncatedHertz { poisson: 0.4999, ..TruncatedHertz::default() };
    let peak = hertz.closed_form().peak_pressure();
    for order in TENSOR {
        let run = Run::of(&meshed(hertz.scene(), few(order), order), &Formulation::verification()).expect("run");
        let error = relative_error(run.measures().peak.pressure, peak);
        assert!(error <= 4e-3, "{order:?}: {error:.1e}");
    }
}

#[test]
fn mean_displacement_of_a_side_is_exact_for_fields_of_the_order_of_the_cells() {
    for order in Order::ALL {
        let degree = i32::from(order.number());
        let supports = vec![held("left", Component::X, 0.0)];
        let scene = block([4.0, 3.0], supports, vec![]);
        let discretisation = meshed(scene, 2, order);
        let power = |x: f64| x.powi(degree);
        let field: Vec<[f64; 2]> = discretisation.mesh.points.iter().map(|[x, _]| [power(*x), 0.0]).collect();
        let of = Displaced { body: 0, at: Place::Boundary("far".into()), component: Component::X };
        let mean = discretisation.displaced(&field, &of).expect("mean");
        // ∫ x^p dx over 0 … 4, divided by 4.
        assert_relative_eq!(mean, power(4.0) / f64::from(degree + 1), max_relative = 1e-12);
    }
}

#[test]
fn insides_of_cells_are_eliminated_before_the_sides_that_cells_share() {
    // Condensing them cell by cell first would be the same elimination: no entry of theirs lies outside their own cell.
    for order in TENSOR {
        for (scene, elements) in [(TruncatedHertz::default().scene(), 3), (Cylinder::default().scene(), 4)] {
            let mesh = Mesh::of(&scene, resolution(elements, 0, order)).expect("mesh");
            let system = ElasticSystem::assemble(&scene, &mesh).expect("system");
            let components = &system.bodies[0].dofs.components;
            let equations = |node: usize| components[node].iter().filter_map(Freedom::equation);
            let mut cells_of = vec![0; mesh.points.len()];
            (0..mesh.cells()).flat_map(|cell| mesh.cell(cell)).for_each(|&node| cells_of[node] += 1);
            for cell in 0..mesh.cells() {
                let shared = mesh.cell(cell).iter().filter(|&&node| cells_of[node] > 1);
                let inside = mesh.cell(cell)[4 * order.intervals()..].iter();
                let last = inside.flat_map(|&node| equations(node)).max().expect("inside");
                let first = shared.flat_map(|&node| equations(node)).min().expect("shared");
                assert!(last < first, "{}, {order:?}, cell {cell}: {last} {first}", scene.name);
            }
        }
    }
}
