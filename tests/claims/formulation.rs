//! The nine formulations on whole scenes: agreement with one another, with closed forms and with themselves told differently.

use approx::assert_relative_eq;
use contact_vv::case::library::{Cylinder, Patch, PinRod};
use contact_vv::mesh::Order;
use contact_vv::solution::Solution;
use contact_vv::solve::{Discretisation, Element, Formulation, Iteration, Run};

use crate::workbench::meshed;

fn solved(discretisation: &Discretisation, formulation: &Formulation) -> Solution {
    let solution = discretisation.solve(formulation).expect("solution");
    assert!(solution.converged(), "{}: {}", formulation.name(), solution.outcome);
    solution
}

#[test]
fn recovered_displacements_have_the_approach_of_the_solution() {
    let discretisation = meshed(PinRod::default().scene(), 12, Order::Quadratic);
    let solution = solved(&discretisation, &Formulation::verification());
    let fields = discretisation.recover(&solution).expect("fields");
    let [first, second] = [0, 1].map(|b| &discretisation.mesh.bodies[b].candidates);
    for ((a, b), state) in first.iter().zip(second).zip(&solution.points) {
        let along = |node: usize| {
            let u = fields.displacement[node];
            u[0] * a.normal[0] + u[1] * a.normal[1]
        };
        let gap = discretisation.scene.contact().profile.gap(a.coordinate);
        // Moving apart along the pin's normal opens; displacements are of the order of the clearance 0.05.
        assert!((gap - along(a.node) + along(b.node) - state.gap).abs() <= 1e-10);
    }
}

#[test]
fn spring_stiffness_is_kappa_times_modulus_over_length_times_pattern_and_layer() {
    let discretisation = meshed(Patch::default().scene(), 2, Order::Quadratic);
    let mut formulation = Formulation::new(Element::Node, Iteration::Varying);
    formulation.stiffness = 3.0;
    formulation.stiffness_pattern = vec![1.0, 0.5];
    let points = discretisation.points(&formulation);
    let problem = discretisation.problem(&formulation, &points);
    // E* of two equal bodies in plane strain is half of E/(1−ν²); ℓ = 10 mm.
    let unit = 0.5 * 210e3 / (1.0 - 0.09) / 10.0;
    for (i, k) in problem.initial.iter().enumerate() {
        assert_relative_eq!(*k, 3.0 * unit * [1.0, 0.5][i % 2], max_relative = 1e-13);
    }
    assert_relative_eq!(problem.scale.stiffness, unit, max_relative = 1e-13);
    assert_relative_eq!(problem.scale.gap, 100.0 * 10.0 / (unit * 10.0), max_relative = 1e-13);

    let cylinder = meshed(Cylinder::default().scene(), 4, Order::Quadratic);
    let layer = Formulation::new(Element::Layer, Iteration::Varying);
    let points = cylinder.points(&layer);
    let problem = cylinder.problem(&layer, &points);
    for (k, point) in problem.initial.iter().zip(&points) {
        assert_relative_eq!(*k, problem.scale.stiffness * point.relative_stiffness, max_relative = 1e-13);
    }
    assert!(problem.initial[0] > problem.initial[points.len() - 1]);
}

#[test]
fn work_and_answer_do_not_depend_on_the_unit_of_force() {
    let run = |unit: f64| {
        let cylinder = Cylinder::default();
        let scene = Cylinder { young: unit * cylinder.young, ..cylinder }.scene();
        let discretisation = meshed(scene, 6, Order::Quadratic);
        Run::of(&discretisation, &Formulation::verification()).expect("solved")
    };
    let (newton, tiny) = (run(1.0), run(1e-12));
    assert_eq!(tiny.solution.work.iterations, newton.solution.work.iterations);
    assert_eq!(tiny.solution.work.back_substitutions, newton.solution.work.back_substitutions);
    assert_relative_eq!(1e12 * tiny.measures().peak.pressure, newton.measures().peak.pressure, max_relative = 1e-9);
}
