//! Acceleration of fixed points and nested starts: exact where they must be, guarded, and off by default.

use approx::assert_relative_eq;
use contact_vv::algorithm::acceleration::{Acceleration, Accelerator};
use contact_vv::case::Verdict;
use contact_vv::case::library;
use contact_vv::error::Error;
use contact_vv::mesh::{Order, Resolution};
use contact_vv::solution::{Outcome, Solution};
use contact_vv::solve::{Discretisation, Element, Formulation, Iteration, Start};
use contact_vv::study::cures::{self, Numbers, record};

use crate::workbench::distance;

fn truncated(elements: usize) -> Discretisation {
    let scene = library::find("truncated-hertz", None).expect("a scene of the library").scene;
    Discretisation::of(scene, Resolution { elements, refinement: 0, order: Order::Quadratic }).expect("a scene")
}

fn constant(element: Element, stiffness: f64, acceleration: Acceleration) -> Formulation {
    Formulation { stiffness, acceleration, ..Formulation::new(element, Iteration::Constant) }
}

fn pressures(solution: &Solution) -> Vec<f64> {
    solution.points.iter().map(|p| p.pressure).collect()
}

/// `G(x) − x = b − M x` of a contraction with four different rates, its fixed point (1, −2, 3, 0.5).
fn residual(x: &[f64]) -> Vec<f64> {
    let rates = [0.9, 0.5, 0.2, 0.05];
    let exact = [1.0, -2.0, 3.0, 0.5];
    (0..x.len()).map(|i| rates[i] * (exact[i] - x[i])).collect()
}

/// Evaluations until the residual is below 1e-10; none within 400.
fn evaluations(kind: Acceleration, dofs: usize) -> Option<usize> {
    let mut accelerator = Accelerator::new(kind, vec![1.0; dofs]);
    let mut x = vec![0.0; dofs];
    for count in 1..=400 {
        let f = residual(&x);
        if f.iter().all(|f| f.abs() <= 1e-10) {
            return Some(count);
        }
        x = accelerator.next(&x, &f, &mut 0);
    }
    None
}

#[test]
fn crossed_secant_solves_a_linear_map_of_one_freedom_at_the_third_evaluation() {
    // Two states give the slope; the third is the fixed point.
    assert_eq!(evaluations(Acceleration::CrossedSecant, 1), Some(3));
    assert!(evaluations(Acceleration::None, 1).is_some_and(|n| n > 3));
}

#[test]
fn anderson_solves_a_linear_map_of_four_freedoms_in_few_steps_where_the_plain_one_takes_hundreds() {
    // Full minimisation over n differences ends after n + 1 evaluations; here every other step is a plain one.
    let plain = evaluations(Acceleration::None, 4).expect("a contraction converges");
    let anderson = evaluations(Acceleration::Anderson, 4).expect("so does its acceleration");
    assert!(plain > 300 && anderson <= 2 * 5, "{plain} and {anderson}");
}

#[test]
fn crossed_secant_never_steps_shorter_than_the_plain_iteration() {
    // The residual of a firmly nonexpansive map: Δx·Δf ≤ −‖Δf‖², so the factor on f is at least 1.
    let mut accelerator = Accelerator::new(Acceleration::CrossedSecant, vec![1.0; 4]);
    let mut x = vec![0.0; 4];
    for _ in 0..30 {
        let f = residual(&x);
        let next = accelerator.next(&x, &f, &mut 0);
        for i in 0..4 {
            assert!((next[i] - x[i]) / f[i] >= 1.0 - 1e-9 || f[i].abs() <= 1e-6, "{next:?} after {x:?}");
        }
        x = next;
    }
}

#[test]
fn spoiled_state_is_given_up_for_the_plain_step_before_it() {
    for kind in [Acceleration::CrossedSecant, Acceleration::Anderson] {
        let mut accelerator = Accelerator::new(kind, vec![1.0; 4]);
        let (mut rejected, mut states) = (0, vec![vec![0.0; 4]]);
        for _ in 0..2 {
            let x = &states[states.len() - 1];
            states.push(accelerator.next(x, &residual(x), &mut rejected));
        }
        let last_plain: Vec<f64> = states[1].iter().zip(residual(&states[1])).map(|(x, f)| x + f).collect();
        assert!(distance(&states[2], &last_plain) > 1e-3, "{}: the second step is accelerated", kind.name());
        let spoiled = [1e5; 4];
        assert_eq!(accelerator.next(&states[2], &spoiled, &mut rejected), last_plain, "{}", kind.name());
        assert_eq!(rejected, 1);
        // A residual that is not a number is no smaller than any bound.
        let next = accelerator.next(&last_plain, &residual(&last_plain), &mut rejected);
        accelerator.next(&next, &[f64::NAN; 4], &mut rejected);
        assert_eq!(rejected, 2, "{}", kind.name());
    }
}

#[test]
fn states_that_do_not_change_are_left_to_the_plain_step() {
    for kind in [Acceleration::CrossedSecant, Acceleration::Anderson] {
        let mut accelerator = Accelerator::new(kind, vec![1.0; 2]);
        for _ in 0..4 {
            let next = accelerator.next(&[1.0, 2.0], &[0.5, 0.25], &mut 0);
            assert_eq!(next, [1.5, 2.25], "{}: no difference, no direction", kind.name());
        }
    }
}

#[test]
fn accelerated_fixed_points_are_the_solution_of_kinematic_load() {
    let discretisation = truncated(6);
    let exact = discretisation.solve(&Formulation::verification()).expect("solution");
    for acceleration in [Acceleration::CrossedSecant, Acceleration::Anderson] {
        for stiffness in [0.3, 3.0, 20.0] {
            let formulation = constant(Element::Node, stiffness, acceleration).tolerance(1e-8);
            let found = discretisation.solve(&formulation).expect("solution");
            assert_eq!(found.outcome, Outcome::Converged, "{}, κ₀ = {stiffness}", formulation.name());
            let apart = distance(&pressures(&found), &pressures(&exact)) / discretisation.scene.reference.pressure;
            assert!(apart <= 1e-5, "{}, κ₀ = {stiffness}: {apart}", formulation.name());
        }
    }
}

#[test]
fn acceleration_saves_steps_and_keeps_the_one_factorisation() {
    let discretisation = truncated(6);
    for element in Element::ALL {
        let iterations = |acceleration| {
            let solution = discretisation.solve(&constant(element, 10.0, acceleration)).expect("solution");
            assert!(solution.converged());
            assert_eq!(solution.work.factorisations, 1);
            let iterations = solution.work.iterations;
            assert!((iterations..=2 * iterations).contains(&solution.work.back_substitutions));
            iterations
        };
        let plain = iterations(Acceleration::None);
        for acceleration in [Acceleration::CrossedSecant, Acceleration::Anderson] {
            let accelerated = iterations(acceleration);
            assert!(2 * accelerated < plain, "{}: {accelerated} instead of {plain}", acceleration.name());
        }
    }
}

#[test]
fn load_increments_forget_the_states_of_the_increment_before() {
    let discretisation = truncated(6);
    let exact = discretisation.solve(&Formulation::verification()).expect("solution");
    let mut formulation = constant(Element::Node, 3.0, Acceleration::Anderson).tolerance(1e-8);
    formulation.settings.increments = 3;
    let found = discretisation.solve(&formulation).expect("solution");
    assert!(found.converged());
    assert!(distance(&pressures(&found), &pressures(&exact)) <= 1e-5 * discretisation.scene.reference.pressure);
}

#[test]
fn cures_are_off_unless_asked_for_and_named_where_they_are_on() {
    for formulation in Formulation::nine() {
        assert_eq!((formulation.acceleration, formulation.start), (Acceleration::None, Start::Closed));
        assert!(!formulation.name().contains('+'), "{}", formulation.name());
    }
    assert_eq!(constant(Element::Line, 1.0, Acceleration::CrossedSecant).name(), "line.constant+crossed-secant");
    let nested = Formulation { start: Start::Nested, ..Formulation::new(Element::Node, Iteration::Kinematic) };
    assert_eq!(nested.name(), "node.kinematic+nested");
}

#[test]
fn cures_of_another_algorithm_are_refused_by_name() {
    let discretisation = truncated(4);
    for algorithm in Iteration::ALL {
        let base = Formulation::new(Element::Node, algorithm);
        let with = |acceleration| Formulation { acceleration, ..base.clone() };
        let nested = Formulation { start: Start::Nested, ..base.clone() };
        for (formulation, takes, name) in [
            (with(Acceleration::Anderson), Iteration::Constant, "anderson"),
            (with(Acceleration::Newton), Iteration::Varying, "newton"),
            (nested, Iteration::Kinematic, "nested"),
        ] {
            match discretisation.solve(&formulation) {
                Ok(_) => assert_eq!(algorithm, takes, "{name}"),
                Err(Error { message, remedy, .. }) => {
                    assert_ne!(algorithm, takes, "{name}");
                    assert!(message.contains(name) && message.contains(algorithm.name()), "{message}");
                    assert!(remedy.contains(takes.name()), "{remedy}");
                }
            }
        }
    }
}

#[test]
fn nested_start_takes_three_steps_at_most_and_finds_the_same_contact() {
    for elements in [4, 8, 16] {
        let discretisation = truncated(elements);
        let closed = Formulation::new(Element::Node, Iteration::Kinematic);
        let from_closed = discretisation.solve(&closed).expect("solution");
        let nested = discretisation.solve(&Formulation { start: Start::Nested, ..closed }).expect("solution");
        assert!(nested.converged() && nested.work.iterations <= 3, "{elements}: {} iterations", nested.work.iterations);
        assert!(from_closed.work.iterations > 3 && from_closed.coarser.iterations == 0);
        assert!(nested.coarser.iterations >= nested.coarser.factorisations && nested.coarser.iterations > 0);
        for (a, b) in pressures(&nested).iter().zip(pressures(&from_closed)) {
            assert_relative_eq!(*a, b, epsilon = 1e-3 * discretisation.scene.reference.pressure);
        }
    }
}

#[test]
fn share_below_the_multiple_of_the_plain_one_turns_red() {
    let recorded = record::read(Element::Node).expect("the record");
    let (plain, crossed_secant) = (&recorded[0], recorded[1].clone());
    assert_eq!(cures::times(plain, &crossed_secant).verdict, Verdict::Pass);
    let mut spoiled = crossed_secant;
    spoiled.iterations[1].iter_mut().step_by(2).flatten().for_each(|iterations| *iterations = None);
    assert_eq!(cures::times(plain, &spoiled).verdict, Verdict::Fail);
    assert_eq!(cures::times(plain, plain).verdict, Verdict::Fail);
}

#[test]
fn acceleration_slower_than_none_and_another_rule_that_converges_turn_red() {
    let trials = cures::plan();
    let trial = trials.iter().find(|trial| trial.case == "accelerated rules").expect("a trial of the rules");
    let Numbers::Rules(rules) = trial.run().expect("runs") else { panic!("other numbers than of the rules") };
    let verdicts = |rules: Vec<cures::Rule>| {
        let judged = cures::judge(&Numbers::Rules(rules)).expect("checks");
        judged.into_iter().map(|one| one.verdict).collect::<Vec<_>>()
    };
    assert_eq!(verdicts(rules.clone()), [Verdict::Pass, Verdict::Pass]);
    let mut slower = rules.clone();
    slower[1].ended.swap(0, 2);
    assert_eq!(verdicts(slower), [Verdict::Fail, Verdict::Pass]);
    let mut lost = rules.clone();
    lost[0].ended[1].outcome = Outcome::Capped;
    assert_eq!(verdicts(lost), [Verdict::Fail, Verdict::Pass]);
    let mut found = rules;
    found.last_mut().expect("rules").ended[2].outcome = Outcome::Converged;
    assert_eq!(verdicts(found), [Verdict::Pass, Verdict::Fail]);
}

/// What follows a state of ten times the first residual after so many quiet evaluations: times it was given up, and the
/// plain iteration before it.
fn after_a_jump(quiet: usize) -> (usize, Vec<f64>, Vec<f64>) {
    let mut accelerator = Accelerator::new(Acceleration::CrossedSecant, vec![1.0]);
    let (mut x, mut plain, mut rejected) = (vec![0.0], vec![0.0], 0);
    for k in 0..quiet {
        let f = vec![0.99_f64.powi(k as i32)];
        plain = vec![x[0] + f[0]];
        x = accelerator.next(&x, &f, &mut rejected);
    }
    assert_eq!(rejected, 0, "quiet evaluations are accepted");
    let next = accelerator.next(&x, &[10.0], &mut rejected);
    (rejected, next, plain)
}

#[test]
fn the_safeguard_tightens_with_every_accelerated_step_and_falls_back_to_the_plain_one() {
    assert_eq!(after_a_jump(3).0, 0);
    let (rejected, next, plain) = after_a_jump(60);
    assert_eq!((rejected, next), (1, plain));
}

#[test]
fn a_nested_start_with_increments_is_refused() {
    let mut formulation = Formulation { start: Start::Nested, ..Formulation::new(Element::Node, Iteration::Kinematic) };
    formulation.settings.increments = 2;
    let refused = truncated(2).solve(&formulation).expect_err("refused").to_string();
    assert!(refused.contains("increment") && refused.contains("closed"), "{refused}");
}

#[test]
fn plain_iteration_follows_a_residual_that_rose_and_every_anderson_iteration() {
    let plain = |x: [f64; 2], f: [f64; 2]| vec![x[0] + f[0], x[1] + f[1]];
    for kind in [Acceleration::CrossedSecant, Acceleration::Anderson] {
        let mut accelerator = Accelerator::new(kind, vec![1.0; 2]);
        let mut next = |x: [f64; 2], f: [f64; 2]| accelerator.next(&x, &f, &mut 0) == plain(x, f);
        assert!(next([0.0, 0.0], [1.0, 1.0]), "{kind:?}: one state extrapolates nothing");
        assert!(!next([1.0, 1.0], [0.5, 0.25]), "{kind:?}: two do");
        let rests = kind == Acceleration::Anderson;
        assert_eq!(next([1.5, 1.2], [0.2, 0.1]), rests, "{kind:?}: after an accelerated iteration");
        assert!(next([1.6, 1.3], [0.4, 0.3]), "{kind:?}: the residual rose");
    }
}
