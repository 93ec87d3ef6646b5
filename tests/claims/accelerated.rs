//! What is added to the paper's iterations: named, exact, and what makes all nine converge as they are typed.

use approx::assert_relative_eq;
use contact_vv::algorithm::{Acceleration, StiffnessRule, StiffnessUnit};
use contact_vv::case::Verdict;
use contact_vv::case::library::{self, Cylinder, Patch, PinRod, TruncatedHertz};
use contact_vv::mesh::Order;
use contact_vv::solution::Solution;
use contact_vv::solve::{Discretisation, Element, Formulation, Iteration, Run};
use contact_vv::study::Study;
use contact_vv::study::atlas::{Numbers, Saved};

use crate::workbench::{distance, meshed};

fn of_library(name: &str, elements: usize) -> Discretisation {
    meshed(library::find(name, None).expect("a scene of the library").scene, elements, Order::Quadratic)
}

fn solved(discretisation: &Discretisation, formulation: &Formulation) -> Solution {
    discretisation.solve(formulation).unwrap_or_else(|error| panic!("{}: {error}", formulation.name()))
}

/// Iterations to convergence.
fn iterations(discretisation: &Discretisation, formulation: &Formulation) -> usize {
    let solution = solved(discretisation, formulation);
    assert!(solution.converged(), "{}: {}", formulation.name(), solution.outcome);
    solution.work.iterations
}

fn plain(element: Element) -> Formulation {
    let mut plain = Formulation::new(element, Iteration::Varying);
    plain.settings.max_iterations = 20_000;
    plain
}

#[test]
fn plain_iterations_grow_with_the_square_of_the_elements_and_accelerated_ones_do_not() {
    let meshes = [4, 8].map(|elements| of_library("cylinder", elements));
    let growth = |formulation: &Formulation| {
        let [coarse, fine] = [0, 1].map(|mesh: usize| iterations(&meshes[mesh], formulation) as f64);
        fine / coarse
    };
    for element in [Element::Line, Element::Layer] {
        let [plain, accelerated] =
            [plain(element), Formulation::accelerated(element, Iteration::Varying)].map(|each| growth(&each));
        assert!(plain > 3.0 && accelerated < 2.5, "{}: {plain} and {accelerated}", element.name());
    }
}

#[test]
fn accelerated_iteration_is_the_plain_one_until_the_pressing_points_have_stood() {
    let discretisation = of_library("cylinder", 8);
    let history = |acceleration| {
        let formulation = Formulation { acceleration, ..Formulation::new(Element::Node, Iteration::Varying) };
        solved(&discretisation, &formulation).history.iter().map(|one| one.error.largest()).collect::<Vec<f64>>()
    };
    let [plain, accelerated] = [Acceleration::None, Acceleration::Newton].map(history);
    let same = plain.iter().zip(&accelerated).take_while(|(a, b)| (*a - *b).abs() <= 0.0).count();
    assert!((4..50).contains(&same), "{same} iterations are the same");
    assert!(2 * accelerated.len() < plain.len(), "{} and {}", accelerated.len(), plain.len());
}

#[test]
fn all_nine_converge_as_typed_also_on_candidates_of_twenty_and_fifty_half_widths() {
    let (radius, young) = (Cylinder::default().radius, Cylinder::default().young);
    let long = [20.0, 50.0].map(|stretch| {
        let scene = TruncatedHertz { stretch, size: 3.0 * stretch, radius, young, ..TruncatedHertz::default() }.scene();
        meshed(scene, 4, Order::Quadratic)
    });
    for discretisation in &long {
        for formulation in Formulation::compared() {
            let iterations = iterations(discretisation, &formulation);
            let stretch = discretisation.scene.contact().stretch;
            assert!(iterations <= 500, "{stretch}, {}: {iterations} iterations", formulation.name());
        }
    }
}

#[test]
fn stiffness_by_the_bodies_does_not_depend_on_the_reference() {
    let scene = Cylinder::default().scene();
    let mut other = scene.clone();
    (other.reference.length, other.reference.gap) = (1e4 * scene.reference.length, 1e3 * scene.reference.gap);
    let [own, other] = [scene, other].map(|scene| meshed(scene, 6, Order::Quadratic));
    let by_bodies = Formulation::accelerated(Element::Line, Iteration::Kinematic);
    let reference = Formulation { stiffness_unit: StiffnessUnit::Reference, ..by_bodies.clone() };
    let initial = |discretisation: &Discretisation, formulation: &Formulation| {
        let points = discretisation.points(formulation);
        discretisation.problem(formulation, &points).initial
    };
    let [a, b] = [&own, &other].map(|discretisation| initial(discretisation, &by_bodies));
    assert!(distance(&a, &b) <= 1e-12 * a[0], "{} and {}", a[0], b[0]);
    let [a, b] = [&own, &other].map(|discretisation| initial(discretisation, &reference));
    assert!(a[0] > 1e3 * b[0], "of the reference they do");
}

#[test]
fn layer_by_the_bodies_has_the_total_stiffness_of_the_line() {
    let discretisation = of_library("cylinder", 6);
    let total = |element| {
        let formulation = Formulation::accelerated(element, Iteration::Kinematic);
        let points = discretisation.points(&formulation);
        let problem = discretisation.problem(&formulation, &points);
        let area: f64 = points.iter().map(|point| point.weight).sum();
        points.iter().zip(&problem.initial).map(|(point, k)| point.weight * k).sum::<f64>() / area
    };
    let [line, layer] = [Element::Line, Element::Layer].map(total);
    assert!((layer / line - 1.0).abs() <= 0.05, "{line} and {layer}");
}

#[test]
fn springs_that_opened_under_one_load_press_again_under_the_next() {
    let discretisation = of_library("truncated-hertz", 6);
    for element in Element::ALL {
        let with = |acceleration| {
            let mut formulation = Formulation { acceleration, ..Formulation::new(element, Iteration::Varying) };
            formulation.settings.increments = 8;
            solved(&discretisation, &formulation)
        };
        assert!(with(Acceleration::Newton).converged(), "{}", element.name());
        assert!(!with(Acceleration::None).converged(), "{}: by the rule alone they do not in time", element.name());
    }
}

#[test]
fn only_the_rule_whose_factor_tends_to_one_is_accelerated_under_varying_stiffness() {
    let scene = Cylinder::default().scene();
    for rule in Iteration::Varying.rules().iter().chain(Iteration::Varying.further_rules()) {
        let own = Formulation::with(Element::Line, Iteration::Varying, Some(*rule), None);
        assert!(own.validate(&scene).is_ok(), "{}", own.name());
        assert_eq!(own.acceleration == Acceleration::Newton, *rule == StiffnessRule::Secant, "{}", own.name());
        let asked = Formulation::with(Element::Line, Iteration::Varying, Some(*rule), Some(Acceleration::Newton));
        assert_eq!(asked.validate(&scene).is_ok(), *rule == StiffnessRule::Secant, "{}", asked.name());
    }
    let bare = Formulation::with(Element::Line, Iteration::Constant, None, Some(Acceleration::None));
    assert_eq!(bare.name(), "line.constant");
    assert_eq!((bare.stiffness, bare.stiffness_unit), (1.0, StiffnessUnit::Reference));
}

#[test]
fn bodies_in_free_motion_are_brought_together() {
    let patch = of_library("patch", 4);
    for stiffness in [10.0, 100.0] {
        let stiffness_unit = StiffnessUnit::Reference;
        let accelerated = Formulation::accelerated(Element::Node, Iteration::Constant);
        let solution = solved(&patch, &Formulation { stiffness, stiffness_unit, ..accelerated });
        assert!(solution.converged(), "κ₀ = {stiffness}: {}", solution.outcome);
    }
}

#[test]
fn formulation_that_does_not_converge_turns_red() {
    let trial = Numbers::plan().into_iter().find(|trial| trial.case == "before and after, cylinder").expect("planned");
    let mut numbers = trial.run().expect("run");
    let mut verdicts = |spoil: fn(&mut Saved)| {
        let Numbers::Saved(_, saved) = &mut numbers else { panic!("another trial") };
        spoil(&mut saved[3]);
        numbers.judge().expect("judged").iter().map(|one| one.verdict.clone()).collect::<Vec<_>>()
    };
    assert_eq!(verdicts(|_| ()), [Verdict::Pass]);
    assert_eq!(verdicts(|saved| saved[1].1 = None), [Verdict::Fail]);
}

#[test]
fn recovered_displacements_have_the_approach_of_the_solution() {
    let discretisation = meshed(PinRod::default().scene(), 12, Order::Quadratic);
    let solution = discretisation.solve(&Formulation::verification()).expect("solved");
    assert!(solution.converged(), "{}", solution.outcome);
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
