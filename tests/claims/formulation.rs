//! The nine formulations on whole scenes: agreement with one another, with closed forms and with themselves told differently.

use approx::assert_relative_eq;
use contact_vv::algorithm::StiffnessRule;
use contact_vv::case::library::{
    Bars, Cylinder, CylinderModel, OwnWeight, Patch, PinPlate, PinRod, PressFit, TruncatedHertz,
};
use contact_vv::elasticity::ElasticSystem;
use contact_vv::mesh::{Mesh, Order};
use contact_vv::scene::Scene;
use contact_vv::solution::Solution;
use contact_vv::solve::{Discretisation, Element, Formulation, Iteration, Run};

use crate::workbench::{ORDERS, distance, resolution};

fn discretised(scene: Scene, elements: usize, order: Order) -> Discretisation {
    Discretisation::of(scene, resolution(elements, 0, order)).expect("discretisation")
}

fn pressures(solution: &Solution) -> Vec<f64> {
    solution.points.iter().map(|p| p.pressure).collect()
}

fn solved(discretisation: &Discretisation, formulation: &Formulation) -> Solution {
    let solution = discretisation.solve(formulation).expect("solution");
    assert!(solution.converged(), "{}: {}", formulation.name(), solution.outcome);
    solution
}

#[test]
fn patch_has_the_applied_pressure_with_all_nine_formulations_and_both_orders() {
    for order in ORDERS {
        let discretisation = discretised(Patch::default().scene(), 3, order);
        for formulation in Formulation::nine() {
            let solution = solved(&discretisation, &formulation.clone().tolerance(1e-8));
            for p in pressures(&solution) {
                assert!((p - 100.0).abs() <= 1e-5, "{} {order:?}: {p}", formulation.name());
            }
        }
    }
}

#[test]
fn bars_close_their_gap_and_share_the_rest_of_the_push() {
    let numbers = Bars { push: 1.7, ..Bars::default() };
    // p = E (u − g) / 2L once closed.
    let wanted = numbers.young * 0.7 * numbers.gap / (2.0 * numbers.length);
    for order in ORDERS {
        let discretisation = discretised(numbers.scene(), 2, order);
        for p in pressures(&solved(&discretisation, &Formulation::verification())) {
            assert_relative_eq!(p, wanted, max_relative = 1e-8);
        }
        let open = discretised(Bars { push: 0.9, ..numbers }.scene(), 2, order);
        assert!(pressures(&solved(&open, &Formulation::verification())).iter().all(|p| p.abs() <= 0.0));
    }
}

#[test]
fn weight_of_a_block_is_the_pressure_below_it() {
    let numbers = OwnWeight::default();
    for order in ORDERS {
        for p in pressures(&solved(&discretised(numbers.scene(), 3, order), &Formulation::verification())) {
            assert_relative_eq!(p, numbers.weight * numbers.height, max_relative = 1e-7);
        }
    }
}

#[test]
fn press_fit_has_the_pressure_of_lame() {
    let numbers = PressFit::default();
    let [inner, outer] = numbers.materials;
    let (a, b, c) = (numbers.inner, numbers.interface, numbers.outer);
    // Timoshenko & Goodier, §28, plane stress: δ = p b [ (b²+a²)/(b²−a²) − ν₁ ]/E₁ + p b [ (c²+b²)/(c²−b²) + ν₂ ]/E₂.
    let shrink = b / inner.young * ((b * b + a * a) / (b * b - a * a) - inner.poisson);
    let widen = b / outer.young * ((c * c + b * b) / (c * c - b * b) + outer.poisson);
    let wanted = numbers.interference / (shrink + widen);
    for p in pressures(&solved(&discretised(numbers.scene(), 12, Order::Quadratic), &Formulation::verification())) {
        // Quadratic elements of 1/12 of the quarter: fourth order.
        assert_relative_eq!(p, wanted, max_relative = 1e-3);
    }
}

#[test]
fn cylinder_carries_its_load_with_all_nine_formulations() {
    let numbers = Cylinder::default();
    let discretisation = discretised(numbers.scene(), 6, Order::Quadratic);
    // Hertz (Johnson 1985, §4.2): p₀ = 2P/πa.
    let peak = 2.0 * numbers.load() / (std::f64::consts::PI * numbers.half_width());
    for formulation in Formulation::nine() {
        let solution = solved(&discretisation, &formulation);
        let total: f64 = solution.points.iter().map(|p| p.weight * p.pressure).sum();
        // Half of the force that is not the solution's is within the tolerance 1e-3.
        assert_relative_eq!(total, 0.5 * numbers.load(), max_relative = 2e-3);
        let measures = contact_vv::measure::Measures::of(&discretisation.scene, 0, solution.part(0));
        // Six elements per half-width: 3 %.
        assert_relative_eq!(measures.peak.pressure, peak, max_relative = 0.03);
        assert_relative_eq!(measures.second_moment_width, numbers.half_width(), max_relative = 0.03);
    }
}

#[test]
fn condensed_and_full_system_give_the_same_contact_pressure() {
    for scene in [Cylinder::default().scene(), PinRod::default().scene(), PinPlate::default().scene()] {
        let discretisation = discretised(scene, 6, Order::Quadratic);
        let formulation = Formulation::verification();
        let solution = solved(&discretisation, &formulation);
        let full = discretisation.uncondensed_pressures(&formulation, &solution).expect("full solve");
        let peak = pressures(&solution).into_iter().fold(0.0, f64::max);
        assert!(distance(&full, &solution.spring_pressures) <= 1e-9 * peak, "{}", discretisation.scene.name);
    }
}

#[test]
fn recovered_displacements_have_the_approach_of_the_solution() {
    let discretisation = discretised(PinRod::default().scene(), 12, Order::Quadratic);
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
fn stress_across_the_interface_is_the_contact_pressure_and_shear_vanishes() {
    let discretisation = discretised(Patch::default().scene(), 3, Order::Quadratic);
    let solution = solved(&discretisation, &Formulation::verification());
    for s in discretisation.recover(&solution).expect("fields").stress {
        assert!((s[1] + 100.0).abs() <= 1e-5 && s[0].abs() <= 1e-5 && s[2].abs() <= 1e-5, "{s:?}");
    }
}

/// The same problem in metres, mirrored, renumbered and with swapped bodies; the factor turns pressures into MPa.
fn variants(scene: &Scene, elements: usize) -> Vec<(&'static str, Discretisation, f64)> {
    let at = resolution(elements, 0, Order::Quadratic);
    let mesh = Mesh::of(scene, at).expect("mesh");
    let with = |scene: Scene, mesh: Mesh| {
        let system = ElasticSystem::assemble(&scene, &mesh).expect("system");
        Discretisation::of_system(scene, at, mesh, system).expect("discretisation")
    };
    let mut all = vec![
        ("metres", Discretisation::of(scene.in_metres(), at).expect("discretisation"), 1e-6),
        ("mirrored", with(scene.mirrored(), mesh.mirrored()), 1.0),
        ("renumbered", with(scene.clone(), mesh.renumbered()), 1.0),
    ];
    if let Some(swapped) = scene.swapped() {
        all.push(("swapped", Discretisation::of(swapped, at).expect("discretisation"), 1.0));
    }
    all
}

#[test]
fn telling_the_problem_differently_leaves_steps_and_pressures_unchanged() {
    let hertz = contact_vv::oracle::analytic::hertz::Hertz { load: 1000.0, radius: 50.0, modulus: 2e5 };
    let field = contact_vv::scene::StressField(std::sync::Arc::new(move |[x, z]: [f64; 2]| hertz.stress(x, z)));
    let scenes = [
        Cylinder::default().scene(),
        Cylinder { model: CylinderModel::HalfLoadedAbove, ..Cylinder::default() }.scene(),
        TruncatedHertz::default().scene_under(field),
        PinRod::default().scene(),
        PinPlate::default().scene(),
        PressFit::default().scene(),
        OwnWeight::default().scene(),
        Bars::default().scene(),
    ];
    for scene in scenes {
        let formulation = Formulation::new(Element::Line, Iteration::Kinematic);
        let wanted = solved(&discretised(scene.clone(), 6, Order::Quadratic), &formulation);
        let peak = pressures(&wanted).into_iter().fold(0.0, f64::max);
        for (name, variant, unit) in variants(&scene, 6) {
            let other = solved(&variant, &formulation);
            let found: Vec<f64> = pressures(&other).iter().map(|p| p * unit).collect();
            // Springs of κ = 2e3 magnify the round-off of the approach.
            assert!(distance(&found, &pressures(&wanted)) <= 1e-8 * peak, "{}, {name}", scene.name);
            assert_eq!(other.work, wanted.work, "{}, {name}", scene.name);
        }
    }
}

#[test]
fn thickness_scales_areas_and_leaves_pressures_of_a_given_load_per_thickness() {
    let thin = PinRod { force: 2000.0, thickness: 1.0, ..PinRod::default() };
    let thick = PinRod { force: 5000.0, thickness: 2.5, ..PinRod::default() };
    let [a, b] = [thin, thick]
        .map(|numbers| solved(&discretised(numbers.scene(), 6, Order::Linear), &Formulation::verification()));
    let peak = pressures(&a).into_iter().fold(0.0, f64::max);
    assert!(distance(&pressures(&a), &pressures(&b)) <= 1e-7 * peak);
    assert_relative_eq!(b.points[3].weight, 2.5 * a.points[3].weight, max_relative = 1e-13);
}

#[test]
fn spring_stiffness_is_kappa_times_modulus_over_length_times_pattern_and_layer() {
    let discretisation = discretised(Patch::default().scene(), 2, Order::Quadratic);
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

    let cylinder = discretised(Cylinder::default().scene(), 4, Order::Quadratic);
    let layer = Formulation::new(Element::Layer, Iteration::Varying);
    let points = cylinder.points(&layer);
    let problem = cylinder.problem(&layer, &points);
    for (k, point) in problem.initial.iter().zip(&points) {
        assert_relative_eq!(*k, problem.scale.stiffness * point.relative_stiffness, max_relative = 1e-13);
    }
    assert!(problem.initial[0] > problem.initial[points.len() - 1]);
}

#[test]
fn nine_formulations_are_three_elements_by_three_algorithms_by_name() {
    let names: Vec<String> = Formulation::nine().iter().map(Formulation::name).collect();
    let mut unique = names.clone();
    unique.sort();
    unique.dedup();
    assert_eq!(unique.len(), 9);
    for element in ["line", "layer", "node"] {
        for algorithm in ["varying", "constant", "kinematic"] {
            assert!(names.contains(&format!("{element}.{algorithm}")), "{element}.{algorithm}");
        }
    }
    let mut other = Formulation::new(Element::Node, Iteration::Constant);
    other.rule = StiffnessRule::Literal;
    assert_eq!(other.name(), "node.constant.literal");
    assert_eq!(Formulation::verification().name(), "node.kinematic");
    assert_relative_eq!(Formulation::verification().settings.tolerance, 1e-8);
}

#[test]
fn default_rules_are_secant_correction_and_switching() {
    let defaults = Iteration::ALL.map(|algorithm| Formulation::new(Element::Line, algorithm).rule);
    assert_eq!(defaults, [StiffnessRule::Secant, StiffnessRule::Correction, StiffnessRule::Switching]);
}

#[test]
fn paper_shows_springs_with_both_stiffness_iterations_and_nodes_with_kinematic_load() {
    let shown: Vec<String> =
        Formulation::nine().iter().filter(|f| f.is_in_the_paper()).map(Formulation::name).collect();
    let mut sorted = shown;
    sorted.sort();
    assert_eq!(sorted, ["layer.constant", "layer.varying", "line.constant", "line.varying", "node.kinematic"]);
}

#[test]
fn shear_stress_is_looked_for_below_the_contact_and_found_where_hertz_has_it() {
    let case = TruncatedHertz::default().case();
    let [a, p0] = [case.scene.reference.length, case.scene.reference.pressure];
    for order in ORDERS {
        let discretisation = discretised(case.scene.clone(), 12, order);
        let run = Run::of(&discretisation, &Formulation::verification()).expect("solved");
        let fields = discretisation.recover(&run.solution).expect("fields");
        let shear =
            discretisation.shear_below(&fields.displacement, run.measures(), [0, 0]).expect("below").expect("inside");
        // Johnson 1985, §4.2: 0.300 p₀ at 0.786 a; stresses recovered at nodes bend the curve that is flat there.
        assert_relative_eq!(shear.stress, 0.300 * p0, max_relative = 0.03);
        assert_relative_eq!(shear.depth, 0.786 * a, max_relative = 0.2);
        // Looked for at many places of the cells around it, none of them above the surface.
        assert!(shear.samples.iter().all(|[depth, _]| *depth >= -1e-6 * a && *depth <= 2.0 * a));
        let around = shear.samples.iter().filter(|[depth, _]| (depth / shear.depth - 1.0).abs() < 0.02).count();
        assert!(around >= 8, "{around} of {}", shear.samples.len());
    }
}

#[test]
fn work_and_answer_do_not_depend_on_the_unit_of_force() {
    let run = |unit: f64| {
        let cylinder = Cylinder::default();
        let scene = Cylinder { young: unit * cylinder.young, ..cylinder }.scene();
        let discretisation = discretised(scene, 6, Order::Quadratic);
        Run::of(&discretisation, &Formulation::verification()).expect("solved")
    };
    let (newton, tiny) = (run(1.0), run(1e-12));
    assert_eq!(tiny.solution.work.iterations, newton.solution.work.iterations);
    assert_eq!(tiny.solution.work.back_substitutions, newton.solution.work.back_substitutions);
    assert_relative_eq!(1e12 * tiny.measures().peak.pressure, newton.measures().peak.pressure, max_relative = 1e-9);
}
