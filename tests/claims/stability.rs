//! Predictions from the condensed matrices, held against iterations written out here.

use approx::assert_relative_eq;
use contact_vv::algorithm::{Algorithm, Constant, ContactProblem, Springs, StiffnessRule, Varying};
use contact_vv::case::library::TruncatedHertz;
use contact_vv::case::{Verdict, library};
use contact_vv::contact::ContactPoint;
use contact_vv::mesh::{Order, Resolution};
use contact_vv::oracle::analytic::revolution::indentation::Indentation;
use contact_vv::solution::Work;
use contact_vv::solve::{Discretisation, Element, Formulation, Iteration};
use contact_vv::stability::{Limit, halving, rate};
use contact_vv::study::Study;
use contact_vv::study::stability::Numbers;
use contact_vv::study::stability::rates::{Before, Rate};

fn discretisation() -> Discretisation {
    let scene = library::find("truncated-hertz", None).expect("a scene of the library").scene;
    Discretisation::of(scene, Resolution { elements: 4, refinement: 0, order: Order::Linear })
        .expect("a solvable scene")
}

#[test]
fn rates_of_a_problem_without_springs_are_none() {
    let discretisation = discretisation();
    let formulation = Formulation::new(Element::Node, Iteration::Constant);
    let points: Vec<ContactPoint> = discretisation.points(&formulation);
    let problem = discretisation.problem(&formulation, &points);
    let none = vec![0.0; points.len()];
    assert!(rate::fixed_target(&problem, &none, &none).is_none());
    assert!(rate::secant(&problem, &none, &none, 0.0).is_none());
}

#[test]
fn halving_takes_two_steps_where_the_candidates_end_at_the_edge_and_one_more_by_each_doubling() {
    for stiffness in [1e6, 2e3, 1.0, 0.1] {
        assert_eq!(halving::iterations(1.0, 1.0, 0.1, stiffness), 2);
    }
    // (4 − 1)/(2 · 1/16) = 24, between 2⁴ and 2⁵; halving the spacing adds one, and a soft start another.
    assert_eq!(halving::iterations(2.0, 1.0, 1.0 / 16.0, 1e6), 6);
    assert_eq!(halving::iterations(2.0, 1.0, 1.0 / 32.0, 1e6), 7);
    assert_eq!(halving::iterations(2.0, 1.0, 1.0 / 16.0, halving::SOFT), 6);
    assert_eq!(halving::iterations(2.0, 1.0, 1.0 / 16.0, 0.99 * halving::SOFT), 7);
}

#[test]
fn contact_kept_on_a_sphere_is_its_own_less_a_flat_punch() {
    let (a, curvature) = (1.0, vec![[0.01, 2.0]]);
    let of = |radius| Indentation::smooth(2e5, radius, curvature.clone());
    // One shrinking from each reach on, with a spacing a little more or less than what is then left.
    let mut reach: f64 = 1.9;
    for _ in 0..6 {
        let spacing = 1.01 * (((2.0 * reach.powi(3) + 1.0) / (3.0 * reach)) - 1.0) / 2.0;
        assert_eq!(halving::of_revolution(reach, a, spacing, 1e6), 2);
        assert_eq!(halving::of_revolution(reach, a, spacing / 1.03, 1e6), 3);
        assert_eq!(halving::of_revolution(reach, a, spacing / 1.03, 0.99 * halving::SOFT), 4);
        let kept = of(reach);
        let pulled = Indentation::flat(2e5, reach, kept.load() - of(a).load());
        let pressing = (1.0 + 2.0 * spacing / 1.01).sqrt();
        assert_relative_eq!(kept.pressure(pressing), pulled.pressure(pressing), max_relative = 1e-9);
        reach = pressing;
    }
}

#[test]
fn slowest_open_point_sets_the_rate_of_secant_until_what_is_left_of_its_gap_is_nothing() {
    let discretisation = between_nodes();
    let formulation = Formulation::new(Element::Node, Iteration::Varying);
    let points: Vec<ContactPoint> = discretisation.points(&formulation);
    let problem = discretisation.problem(&formulation, &points);
    let limit = Limit::of(&problem).expect("a contact");
    let rate = |slack| rate::secant(&problem, &limit.target(&problem), &limit.approach, slack).expect("springs hold");
    let open = || (0..points.len()).filter(|&i| !limit.closed[i]);
    let slowest = open().map(|i| limit.approach[i] / points[i].gap).fold(0.0, f64::max);
    assert_relative_eq!(rate(0.0), slowest, max_relative = 1e-9);
    let widest = open().map(|i| points[i].gap - limit.approach[i]).fold(0.0, f64::max);
    assert!(rate(widest) < 0.99 * slowest, "{} of {slowest}", rate(widest));
}

#[test]
fn hertz_rate_outside_the_contact_is_one_at_its_edge_and_falls_by_the_three_halves_of_the_distance() {
    assert_eq!(rate::outside_hertz(1.0), 1.0);
    // (ξ √(ξ² − 1) − arcosh ξ)/ξ² at ξ = 2: (2 √3 − ln(2 + √3))/4.
    let left = (2.0 * 3f64.sqrt() - (2.0 + 3f64.sqrt()).ln()) / 4.0;
    assert_relative_eq!(rate::outside_hertz(2.0), 1.0 - left, max_relative = 1e-14);
    // Next to the edge the gap opens by 4 √2/3 δ^{3/2}.
    let d: f64 = 1e-4;
    assert_relative_eq!(1.0 - rate::outside_hertz(1.0 + d), 4.0 * 2f64.sqrt() / 3.0 * d.powf(1.5), max_relative = 1e-3);
}

#[test]
fn no_active_set_lets_constant_stiffness_with_correction_leave_its_limit() {
    let discretisation = discretisation();
    for element in Element::ALL {
        for stiffness in [1e-2, 1.0, 1e3] {
            let formulation = Formulation { stiffness, ..Formulation::new(element, Iteration::Constant) };
            let points: Vec<ContactPoint> = discretisation.points(&formulation);
            let problem = discretisation.problem(&formulation, &points);
            for pattern in 0..8_usize {
                let closed: Vec<bool> = (0..points.len()).map(|i| (i * (pattern + 1)) % 8 < pattern).collect();
                let rate = rate::correction(&problem, &closed).expect("springs hold the cylinder");
                assert!(rate <= 1.0 + 1e-9, "{element:?} {stiffness}: {rate}");
            }
        }
    }
}

/// What is judged of a trial, spoiled.
fn fails(numbers: Numbers) -> bool {
    numbers.judge().expect("judged").iter().any(|judged| judged.verdict == Verdict::Fail)
}

#[test]
fn no_prediction_of_a_rate_takes_the_place_of_another() {
    let start = |linearised: f64, measured: f64| Rate {
        stiffness: 1.0,
        predicted: 0.96,
        linearised: Some(linearised),
        measured: Some(measured),
    };
    let judged = |start: Rate| Numbers::Rates(vec![start; 3]).judge().expect("judged").len();
    // The slowest mode alone: both predictions are judged. Not alone: the linear iteration is.
    assert_eq!(judged(start(0.96, 0.96)), 6);
    assert_eq!(judged(start(0.95, 0.95)), 3);
    assert!(!fails(Numbers::Rates(vec![start(0.96, 0.96); 3])));
    assert!(!fails(Numbers::Rates(vec![start(0.95, 0.95); 3])));
    assert!(fails(Numbers::Rates(vec![start(0.95, 0.96); 3])));
    assert!(fails(Numbers::Rates(vec![start(0.96, 0.95); 3])));
    assert!(fails(Numbers::Rates(vec![start(0.96, f64::NAN); 3])));
}

#[test]
fn hertz_rate_turns_red_where_the_measured_one_is_not_within_its_factor_or_not_there() {
    let start = |measured| Before { stretch: 1.9, elements: 8, place: 1.01, predicted: 0.99, measured };
    let right = [0.985, 0.993, 0.99].map(Some).map(start);
    assert!(!fails(Numbers::Before(right.to_vec())));
    assert!(!fails(Numbers::Before([&right[..], &[start(None)]].concat())));
    for measured in [Some(0.979), Some(0.996), Some(f64::NAN)] {
        assert!(fails(Numbers::Before([&right[..], &[start(measured)]].concat())), "{measured:?}");
    }
    assert!(fails(Numbers::Before(Vec::new())));
}

#[test]
fn a_rate_that_is_not_the_predicted_one_turns_red() {
    let start = |predicted, measured| Rate { stiffness: 1.0, predicted, linearised: None, measured: Some(measured) };
    let verdict = |predicted, measured| start(predicted, measured).against("spectral radius", predicted).verdict;
    assert_eq!(verdict(0.98, 0.98), Verdict::Pass);
    assert_eq!(verdict(0.98, 0.9795), Verdict::Pass);
    for (predicted, measured) in
        [(0.98, 0.97), (0.98, 0.99), (0.98, f64::NAN), (f64::NAN, 0.98), (0.98, 1.0), (1.0, 0.98)]
    {
        assert_eq!(verdict(predicted, measured), Verdict::Fail, "{predicted}, {measured}");
    }
}

/// Truncated Hertz without a node on the contact edge.
fn between_nodes() -> Discretisation {
    let scene = TruncatedHertz { stretch: 1.9, ..Default::default() }.scene();
    Discretisation::of(scene, Resolution { elements: 4, refinement: 0, order: Order::Quadratic }).expect("a scene")
}

/// Spectral radius of the derivative of one real step, by central differences around the limit.
///
/// `state` makes the springs of a state; `read` takes the state from the springs after the iteration.
fn derivative(
    limit: &[f64],
    mut step: impl FnMut(&mut Springs),
    state: impl Fn(&[f64]) -> Springs,
    read: impl Fn(&Springs) -> Vec<f64>,
) -> f64 {
    let n = limit.len();
    let mut matrix = nalgebra::DMatrix::<f64>::zeros(n, n);
    let largest = limit.iter().map(|x| x.abs()).fold(0.0, f64::max);
    for j in 0..n {
        let nudge = 1e-6 * limit[j].abs().max(1e-3 * largest);
        let after = [1.0, -1.0].map(|sign| {
            let mut moved = limit.to_vec();
            moved[j] += sign * nudge;
            let mut springs = state(&moved);
            step(&mut springs);
            read(&springs)
        });
        for i in 0..n {
            matrix[(i, j)] = (after[0][i] - after[1][i]) / (2.0 * nudge);
        }
    }
    matrix.complex_eigenvalues().iter().map(|value| value.norm()).fold(0.0, f64::max)
}

/// Carried forces of constant stiffness at the limit, `r = p − k₀ w`.
fn carried(problem: &ContactProblem, limit: &Limit) -> Vec<f64> {
    let each = limit.pressure.iter().zip(&problem.initial).zip(&limit.approach);
    each.zip(&limit.closed).map(|(((p, k), w), closed)| if *closed { p - k * w } else { -k * w }).collect()
}

#[test]
fn predicted_rates_are_the_derivatives_of_the_iterations() {
    use Iteration::{Constant as Fixed, Varying as Changing};
    use StiffnessRule::{Correction, Secant};
    let discretisation = between_nodes();
    // Line elements have no point with g = 0, where the secant rule has no derivative.
    for (algorithm, rule, element, stiffnesses) in [
        (Fixed, Correction, Element::Node, &[0.3, 5.0][..]),
        (Fixed, Correction, Element::Line, &[0.3, 5.0]),
        (Fixed, Secant, Element::Layer, &[0.3, 5.0]),
        (Fixed, Secant, Element::Line, &[0.3, 5.0]),
        (Changing, Correction, Element::Line, &[0.5, 2.0, 8.0, 50.0]),
        (Changing, Correction, Element::Layer, &[0.5, 2.0, 8.0, 50.0]),
    ] {
        for &stiffness in stiffnesses {
            let formulation = Formulation { rule, stiffness, ..Formulation::new(element, algorithm) };
            let points: Vec<ContactPoint> = discretisation.points(&formulation);
            let problem = discretisation.problem(&formulation, &points);
            let limit = Limit::of(&problem).expect("a limit");
            let none = vec![0.0; points.len()];
            // Springs of a state, and the state that they leave: forces of constant stiffness, or the stiffnesses
            // themselves, of which those of open points stop at once.
            let springs_of = |state: &[f64]| match algorithm {
                Fixed => Springs { stiffness: problem.initial.clone(), force: state.to_vec() },
                _ => Springs { stiffness: state.to_vec(), force: none.clone() },
            };
            let state_of = |springs: &Springs| match algorithm {
                Fixed => springs.force.clone(),
                _ => springs
                    .stiffness
                    .iter()
                    .zip(&limit.closed)
                    .map(|(k, closed)| if *closed { *k } else { 0.0 })
                    .collect(),
            };
            let step = |springs: &mut Springs| {
                let mut one: Box<dyn Algorithm> = match algorithm {
                    Fixed => Box::new(Constant::new(rule)),
                    _ => Box::new(Varying::new(rule)),
                };
                one.next(&problem, springs, &mut Work::default()).expect("springs hold");
            };
            let (at, predicted) = match (algorithm, rule) {
                (Fixed, Correction) => (carried(&problem, &limit), rate::correction(&problem, &limit.closed)),
                (Fixed, _) => (carried(&problem, &limit), rate::secant_force(&problem, &limit)),
                _ => (limit.target(&problem), rate::varying_correction(&problem, &limit)),
            };
            let measured = derivative(&at, step, springs_of, state_of);
            assert_relative_eq!(predicted.expect("a rate"), measured, max_relative = 2e-3);
        }
    }
}

#[test]
fn the_limit_is_the_contact_that_kinematic_load_finds() {
    let discretisation = between_nodes();
    let solution = discretisation.solve(&Formulation::verification()).expect("solved");
    let points: Vec<ContactPoint> = discretisation.points(&Formulation::verification());
    let problem = discretisation.problem(&Formulation::verification(), &points);
    let limit = Limit::of(&problem).expect("a limit");
    let pressed: Vec<bool> = solution.points.iter().map(|point| point.pressure > 0.0).collect();
    assert_eq!(limit.closed, pressed);
    for ((p, state), point) in limit.pressure.iter().zip(&solution.points).zip(&points) {
        assert_relative_eq!(p.max(0.0), state.pressure, epsilon = 1e-5 * solution.points[0].pressure);
        assert!(point.position <= limit.edge(&problem) || state.pressure <= 0.0);
    }
    for ((k, p), w) in limit.target(&problem).iter().zip(&limit.pressure).zip(&limit.approach) {
        if *k > 0.0 && *w > 1e-6 * problem.scale.gap {
            assert_relative_eq!(k * w, *p, max_relative = 1e-12);
        }
    }
}
