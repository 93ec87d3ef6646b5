//! The loop: it counts, stops, tells how an iteration ended, and keeps the last state.

use approx::assert_relative_eq;
use contact_vv::algorithm::{
    Algorithm, Constant, ContactProblem, Iterate, Kinematic, Settings, Springs, StiffnessRule, Varying, iterate,
};
use contact_vv::error::Error;
use contact_vv::solution::{Outcome, Work};

use crate::algorithm::{exact, matrix, one, solvers, started, tight, two};
use crate::problem::iterate_of;
use crate::workbench::distance;

/// An algorithm that plays back given pressures of one point, at the gap, with the springs left alone.
struct Playback {
    pressures: Vec<f64>,
    approach: f64,
    at: usize,
    loads: Vec<f64>,
}

impl Playback {
    fn of(pressures: Vec<f64>) -> Self {
        Self { pressures, approach: 0.1, at: 0, loads: Vec::new() }
    }
}

impl Algorithm for Playback {
    fn step(&mut self, problem: &ContactProblem, load: &[f64], _: &mut Springs, _: &mut Work) -> Option<Iterate> {
        let pressure = self.pressures[self.at % self.pressures.len()];
        self.at += 1;
        self.loads.push(load[0]);
        let displacement = vec![self.approach];
        let internal = problem.internal_force(&displacement);
        Some(Iterate { approach: displacement.clone(), displacement, pressure: vec![pressure], internal })
    }
}

#[test]
fn states_that_return_are_a_cycle_with_its_period() {
    for (pressures, period) in
        [(vec![10.0, 20.0], 2), (vec![10.0, 20.0, 15.0], 3), (vec![1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0], 7)]
    {
        let solution = one(90.0).solve(&mut Playback::of(pressures), tight(200));
        assert_eq!(solution.outcome, Outcome::Cycling { period });
        // Found as soon as the first state returns.
        assert_eq!(solution.work.steps, period + 1);
    }
}

#[test]
fn state_that_stands_still_is_no_cycle() {
    let solution = one(90.0).solve(&mut Playback::of(vec![10.0]), tight(17));
    assert_eq!(solution.outcome, Outcome::Exhausted);
    assert_eq!(solution.work.steps, 17);
    // 1e-8 of p_ref is less than a step, and more than a return.
    let creeping = one(90.0).solve(&mut Playback::of(vec![10.0, 10.0 + 1e-7]), tight(17));
    assert_eq!(creeping.outcome, Outcome::Exhausted);
}

#[test]
fn drifting_states_are_no_cycle() {
    let drift: Vec<f64> = (0..100).map(|i| if i % 2 == 0 { 10.0 } else { 20.0 } + 1e-6 * i as f64).collect();
    assert_eq!(one(90.0).solve(&mut Playback::of(drift), tight(100)).outcome, Outcome::Exhausted);
}

#[test]
fn residual_that_is_not_a_number_or_beyond_a_million_is_divergence() {
    // A tension of 1.1e7 is 1.1e6 p_ref, one of 0.9e7 is not yet divergence.
    for (pressure, outcome) in [
        (f64::NAN, Outcome::Diverged),
        (f64::INFINITY, Outcome::Diverged),
        (f64::NEG_INFINITY, Outcome::Diverged),
        (-1.1e7, Outcome::Diverged),
        (-0.9e7, Outcome::Exhausted),
    ] {
        let solution = one(90.0).solve(&mut Playback::of(vec![pressure]), tight(3));
        assert_eq!(solution.outcome, outcome, "at {pressure}");
        assert!(!solution.converged());
    }
    let mut broken = Playback::of(vec![30.0]);
    broken.approach = f64::NAN;
    assert_eq!(one(90.0).solve(&mut broken, tight(3)).outcome, Outcome::Diverged);
}

#[test]
fn springs_that_are_not_numbers_are_divergence_and_not_an_error() {
    struct Broken;
    impl Algorithm for Broken {
        fn step(&mut self, _: &ContactProblem, _: &[f64], springs: &mut Springs, _: &mut Work) -> Option<Iterate> {
            springs.stiffness[0] = f64::NAN;
            None
        }
    }
    let solution = one(90.0).solve(&mut Broken, tight(3));
    assert_eq!(solution.outcome, Outcome::Diverged);
    assert!(solution.points[0].pressure.is_nan() && solution.residual().is_nan());
}

#[test]
fn running_out_of_steps_is_exhaustion_with_the_last_state_kept() {
    let solution = one(90.0).solve(&mut Constant::new(StiffnessRule::Correction), tight(2));
    assert_eq!(solution.outcome, Outcome::Exhausted);
    assert_eq!(solution.history.len(), 2);
    assert_relative_eq!(solution.points[0].pressure, 100.0 * 74.0 / 500.0 + 8.0, max_relative = 1e-13);
    assert!(solution.residual() > 1e-9);
}

#[test]
fn convergence_is_residuals_within_the_tolerance() {
    // p = 30 − x at w = g leaves 2x out of balance, over ‖f‖₁ = 90 (Σ A p⁺ = 60 − 2x is smaller).
    let balance = 2.0 * 0.9 / 90.0;
    for (tolerance, outcome) in [(1.001 * balance, Outcome::Converged), (0.999 * balance, Outcome::Exhausted)] {
        let settings = Settings { tolerance, increments: 1, max_steps: 1 };
        let solution = one(90.0).solve(&mut Playback::of(vec![29.1]), settings);
        assert_eq!(solution.outcome, outcome);
        assert_relative_eq!(solution.residual(), balance, max_relative = 1e-10);
    }
    for (name, mut algorithm) in solvers() {
        let solution = started(&two([200.0, 300.0], [0.1, 0.1]), name).solve(algorithm.as_mut(), tight(50_000));
        assert_eq!(solution.converged(), solution.residual() <= 1e-9, "{name}");
        let before = solution.history.len().saturating_sub(2);
        assert!(
            solution.history[..=before].iter().rev().skip(1).all(|s| s.residuals.largest() > 1e-9),
            "{name} went on"
        );
    }
}

#[test]
fn no_spring_left_is_an_error_that_says_what_to_do() {
    let mut sample = one(-12.0);
    sample.stiffness = matrix(&[&[0.0]]);
    let mut kinematic = Kinematic::new(StiffnessRule::Switching, 1e-3);
    let error = iterate(&sample.problem(), &mut kinematic, tight(10)).expect_err("the load pulls the body off");
    let text = error.to_string();
    assert!(matches!(error, Error::NoSpringLeft { steps: 1, .. }), "{text}");
    assert!(text.contains("after 1 steps") && text.contains("raise the initial stiffness"), "{text}");
}

#[test]
fn constant_stiffness_factorises_once_over_all_increments() {
    let settings = Settings { tolerance: 1e-9, increments: 4, max_steps: 2000 };
    let solution = one(90.0).solve(&mut Constant::new(StiffnessRule::Correction), settings);
    assert_eq!(solution.outcome, Outcome::Converged);
    assert!(solution.work.steps > 4);
    assert_eq!(solution.work.factorisations, 1);
    // Once more where a step is refined.
    let steps = solution.work.steps;
    assert!((steps..=2 * steps).contains(&solution.work.back_substitutions));
}

#[test]
fn varying_stiffness_and_kinematic_load_factorise_at_every_step() {
    let settings = Settings { tolerance: 1e-9, increments: 4, max_steps: 2000 };
    let algorithms: [Box<dyn Algorithm>; 2] =
        [Box::new(Varying::new(StiffnessRule::Secant)), Box::new(Kinematic::new(StiffnessRule::Switching, 1e-9))];
    for mut algorithm in algorithms {
        let solution = one(90.0).solve(algorithm.as_mut(), settings);
        assert_eq!(solution.outcome, Outcome::Converged);
        assert_eq!(solution.work.factorisations, solution.work.steps);
        let steps = solution.work.steps;
        assert!((steps..=2 * steps).contains(&solution.work.back_substitutions));
        assert_eq!(solution.history.len(), solution.work.steps);
    }
}

#[test]
fn increments_apply_the_load_in_equal_parts_and_stop_where_one_fails() {
    let settings = Settings { tolerance: 1.0, increments: 4, max_steps: 100 };
    // In balance at w = g under the full load; half a load is missing at most, which the tolerance of 1 accepts.
    let mut playback = Playback::of(vec![0.0]);
    let solution = one(90.0).solve(&mut playback, settings);
    assert_eq!(solution.outcome, Outcome::Converged);
    assert!(distance(&playback.loads, &[22.5, 45.0, 67.5, 90.0]) <= 1e-13);
    assert_eq!(solution.history.iter().map(|s| s.increment).collect::<Vec<_>>(), vec![1, 2, 3, 4]);

    let failing = Settings { tolerance: 1e-9, increments: 4, max_steps: 5 };
    let mut playback = Playback::of(vec![0.0]);
    let solution = one(90.0).solve(&mut playback, failing);
    assert_eq!(solution.outcome, Outcome::Exhausted);
    assert!(solution.history.iter().all(|s| s.increment == 1));
}

#[test]
fn increments_lead_to_the_solution_of_the_whole_load() {
    let sample = two([200.0, 300.0], [0.02, 0.3]);
    let wanted = exact(&sample);
    for (name, mut algorithm) in solvers() {
        let settings = Settings { tolerance: 1e-9, increments: 5, max_steps: 100_000 };
        let solution = started(&sample, name).solve(algorithm.as_mut(), settings);
        let found: Vec<f64> = solution.points.iter().map(|p| p.pressure).collect();
        assert!(solution.converged() && distance(&found, &wanted) <= 1e-6, "{name}: {found:?}");
        assert_eq!(solution.history.last().map(|s| s.increment), Some(5), "{name}");
    }
}

#[test]
fn solution_reports_pressures_gaps_forces_and_edge_means() {
    struct Fixed;
    impl Algorithm for Fixed {
        fn step(&mut self, problem: &ContactProblem, _: &[f64], _: &mut Springs, _: &mut Work) -> Option<Iterate> {
            Some(iterate_of(problem, [0.12, 0.2], [0.12, 0.18], [4.0, -3.0]))
        }
    }
    let mut sample = two([50.0, 20.0], [0.1, 0.3]);
    sample.points[0].shares = vec![(0, 0.5), (1, 1.5)];
    sample.points[1].shares = vec![(1, 3.0)];
    let solution = sample.solve(&mut Fixed, Settings { tolerance: 1e-3, increments: 1, max_steps: 1 });

    assert!(distance(&solution.spring_pressures, &[4.0, -3.0]) <= 0.0);
    assert!(distance(&[solution.points[0].pressure, solution.points[1].pressure], &[4.0, 0.0]) <= 0.0);
    assert!(distance(&[solution.points[0].gap, solution.points[1].gap], &[-0.02, 0.12]) <= 1e-15);
    assert!(distance(&solution.contact_force, &[-8.0, 0.0]) <= 1e-15);
    assert!(distance(&solution.displacement, &[0.12, 0.2]) <= 0.0);
    let edges: Vec<[f64; 4]> = solution.edges.iter().map(|e| [e.weight, e.pressure, e.gap, e.position]).collect();
    assert!(distance(&edges[0], &[0.5, 4.0, -0.02, 0.1]) <= 1e-14);
    let mean = |a: f64, b: f64| (1.5 * a + 3.0 * b) / 4.5;
    assert!(distance(&edges[1], &[4.5, mean(4.0, 0.0), mean(-0.02, 0.12), mean(0.1, 0.3)]) <= 1e-14);
    assert_eq!(solution.history[0].active, 1);
    let [approach, pressure, stiffness] = solution.history[0].first_point;
    assert!(distance(&[approach, pressure, stiffness], &[0.12, 4.0, sample.initial[0]]) <= 0.0);
}

#[test]
fn contact_force_acts_on_all_freedoms_of_a_row() {
    let sample = two([200.0, 300.0], [0.1, 0.1]);
    let solution = sample.solve(&mut Kinematic::new(StiffnessRule::Switching, 1e-9), tight(100));
    let p: Vec<f64> = solution.points.iter().map(|p| p.pressure).collect();
    let wanted = [-2.0 * p[0] - 0.25 * 3.0 * p[1], -0.75 * 3.0 * p[1]];
    assert!(distance(&solution.contact_force, &wanted) <= 1e-12 * 300.0);
}

#[test]
fn outcomes_are_told_in_words() {
    let words = [Outcome::Converged, Outcome::Cycling { period: 3 }, Outcome::Diverged, Outcome::Exhausted];
    assert_eq!(words.map(|o| o.to_string()), ["converged", "cycling (period 3)", "diverged", "exhausted"]);
}
