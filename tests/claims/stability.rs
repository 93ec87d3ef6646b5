//! Predictions from the condensed matrices, held against iterations written out here.

use approx::assert_relative_eq;
use contact_vv::algorithm::{ContactProblem, Springs};
use contact_vv::case::Verdict;
use contact_vv::case::problem::problem;
use contact_vv::case::stability::rate_check;
use contact_vv::contact::ContactPoint;
use contact_vv::formulation::{Discretisation, Element, Formulation, Iteration};
use contact_vv::mesh::{Order, Resolution};
use contact_vv::solution::Work;
use contact_vv::stability::{halving, rate};

fn discretisation() -> Discretisation {
    let scene = problem("truncated-hertz", None).expect("a scene of the library").scene;
    Discretisation::of(scene, Resolution { elements: 4, refinement: 0, order: Order::Linear })
        .expect("a solvable scene")
}

/// Factor by which `(S + K₀) u⁺ = f̂ + (K₀ − K*) u` changes the difference of two neighbouring steps in the end.
fn observed(problem: &ContactProblem, initial: f64, target: f64) -> f64 {
    let n = problem.points.len();
    let factor = problem.factorise(&vec![initial; n], &mut Work::default()).expect("springs hold the body");
    let mut springs = Springs { stiffness: vec![initial; n], force: vec![0.0; n] };
    let mut last = vec![0.0; n];
    let mut change = Vec::new();
    for _ in 0..400 {
        let found = problem.equilibrium(&factor, problem.load, &springs, |_| 0.0, &mut Work::default());
        springs.force = found.approach.iter().map(|w| (target - initial) * w).collect();
        change.push(found.approach.iter().zip(&last).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt());
        last = found.approach;
        let size = change[change.len() - 1] / change[0];
        if !(1e-9..=1e9).contains(&size) {
            break;
        }
    }
    let steps = (change.len() / 3).max(2);
    let (first, end) = (change[change.len() - 1 - steps], change[change.len() - 1]);
    (end / first).powf(1.0 / steps as f64)
}

#[test]
fn fixed_target_converges_exactly_where_both_matrices_are_definite_and_as_fast_as_predicted() {
    let discretisation = discretisation();
    let formulation = Formulation::new(Element::Node, Iteration::Constant);
    let points: Vec<ContactPoint> = discretisation.points(&formulation);
    let problem = discretisation.problem(&formulation, &points);
    let (n, unit) = (points.len(), problem.scale.stiffness);
    let (mut converging, mut diverging) = (0, 0);
    for initial in [0.1, 0.4, 1.0, 3.0] {
        for target in [0.05, 0.1, 0.5, 1.0, 2.5, 10.0] {
            let (k0, k) = (initial * unit, target * unit);
            let predicted = rate::fixed_target(&problem, &vec![k0; n], &vec![k; n]).expect("springs hold the body");
            let definite = rate::holds(&problem, &vec![k; n]) && rate::holds(&problem, &vec![2.0 * k0 - k; n]);
            assert_eq!(predicted < 1.0, definite, "κ₀ = {initial}, κ* = {target}: ρ = {predicted}");
            if definite {
                converging += 1
            } else {
                diverging += 1
            }
            if predicted > 0.05 && predicted < 0.999 {
                let measured = observed(&problem, k0, k);
                assert_relative_eq!(measured.ln(), predicted.ln(), max_relative = 0.05);
            } else if predicted > 1.01 {
                assert!(observed(&problem, k0, k) > 1.0);
            }
        }
    }
    assert!(converging >= 5 && diverging >= 5, "{converging} and {diverging}");
}

#[test]
fn rates_of_a_problem_without_springs_are_none() {
    let discretisation = discretisation();
    let formulation = Formulation::new(Element::Node, Iteration::Constant);
    let points: Vec<ContactPoint> = discretisation.points(&formulation);
    let problem = discretisation.problem(&formulation, &points);
    let none = vec![0.0; points.len()];
    assert!(rate::fixed_target(&problem, &none, &none).is_none());
    assert!(rate::secant(&problem, &none, &none).is_none());
}

#[test]
fn halving_takes_one_step_where_the_candidates_end_at_the_edge_and_one_more_by_each_doubling() {
    assert_eq!(halving::steps(1.0, 1.0, 0.1, 1e6), 1);
    assert_eq!(halving::steps(1.0, 1.0, 0.1, 1.0), 2);
    // (4 − 1)/(2 · 1/16) = 24, between 2⁴ and 2⁵; halving the spacing adds one.
    assert_eq!(halving::steps(2.0, 1.0, 1.0 / 16.0, 1e6), 6);
    assert_eq!(halving::steps(2.0, 1.0, 1.0 / 32.0, 1e6), 7);
}

#[test]
fn a_rate_that_is_not_the_predicted_one_turns_red() {
    let verdict = |predicted, measured| rate_check(1.0, predicted, measured).verdict;
    assert_eq!(verdict(0.98, 0.98), Verdict::Pass);
    assert_eq!(verdict(0.98, 0.9795), Verdict::Pass);
    for (predicted, measured) in
        [(0.98, 0.97), (0.98, 0.99), (0.98, f64::NAN), (f64::NAN, 0.98), (0.98, 1.0), (1.0, 0.98)]
    {
        assert_eq!(verdict(predicted, measured), Verdict::Fail, "{predicted}, {measured}");
    }
}
