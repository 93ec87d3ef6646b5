//! What an iteration solves, system matrix and equilibrium; the loop counts, stops, tells how an iteration ended, and
//! keeps the last state.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact_vv::algorithm::{
    Algorithm, Constant, ContactProblem, Criterion, Iterate, Kinematic, Law, Settings, Springs, StiffnessRule, Target,
    Varying, bound, iterate,
};
use contact_vv::contact::ContactEdge;
use contact_vv::error::Kind;
use contact_vv::solution::{IterationError, Outcome, Work};

use crate::algorithm::{COMPLIANCE, edge, exact, matrix, one, solvers, started, tight, two};
use crate::workbench::{distance, spoiled};

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
    fn next(&mut self, problem: &ContactProblem, _: &mut Springs, _: &mut Work) -> Option<Iterate> {
        let pressure = self.pressures[self.at % self.pressures.len()];
        self.at += 1;
        self.loads.push(problem.load[0]);
        let displacement = vec![self.approach];
        let internal = problem.stiffness.times(&displacement);
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
        assert_eq!(solution.work.iterations, period + 1);
    }
}

#[test]
fn state_that_stands_still_off_the_solution_is_stalled_and_no_cycle() {
    let solution = one(90.0).solve(&mut Playback::of(vec![10.0]), tight(200));
    assert_eq!(solution.outcome, Outcome::Stalled);
    // Three iterations without a change after the first.
    assert_eq!(solution.work.iterations, 4);
    assert_relative_eq!(solution.error().peak, 2.0 / 3.0, max_relative = 1e-9);
    // 1e-8 of a state is round-off: more than a return, less than a change; the error does not fall.
    let creeping = one(90.0).solve(&mut Playback::of(vec![10.0, 10.0 + 1e-7]), tight(200));
    assert_eq!(creeping.outcome, Outcome::Stalled);
    assert_eq!(creeping.work.iterations, 51);
}

#[test]
fn another_criterion_stops_and_what_is_off_then_is_not_converged() {
    let played = |criterion, tolerance, pressures: Vec<f64>, approach| {
        let settings = Settings { criterion, tolerance, max_iterations: 20, ..Settings::default() };
        let solution = one(90.0).solve(&mut Playback { approach, ..Playback::of(pressures) }, settings);
        (solution.outcome, solution.work.iterations)
    };
    // At the gap and without tension the contact conditions hold, whatever the pressure: p* = 30.
    assert_eq!(played(Criterion::Conditions, 1e-9, vec![10.0], 0.1), (Outcome::Stopped, 1));
    assert_eq!(played(Criterion::Conditions, 1e-9, vec![30.0], 0.1), (Outcome::Converged, 1));
    // Of 0.125 a fifth is penetration; of 0.08 a quarter is a gap, across which all of the pressure acts.
    assert_eq!(played(Criterion::Conditions, 0.21, vec![10.0], 0.125).1, 1);
    assert_ne!(played(Criterion::Conditions, 0.19, vec![10.0, 11.0, 12.0], 0.125).0, Outcome::Stopped);
    assert_eq!(played(Criterion::Conditions, 0.26, vec![10.0], 0.08).1, 1);
    assert_ne!(played(Criterion::Conditions, 0.24, vec![10.0, 11.0, 12.0], 0.08).0, Outcome::Stopped);
    // Tension of any size is infinitely more than no pressure.
    assert_ne!(played(Criterion::Conditions, 0.1, vec![-1.0, -2.0, -3.0], 0.1).0, Outcome::Stopped);
    // A change takes two iterations to be seen; the gap is no residual, penetration is.
    assert_eq!(played(Criterion::Displacement, 1e-9, vec![10.0, 20.0], 0.125), (Outcome::Stopped, 2));
    assert_eq!(played(Criterion::Residuals, 1e-9, vec![10.0, 20.0], 0.08), (Outcome::Stopped, 2));
    assert_ne!(played(Criterion::Residuals, 0.19, vec![10.0, 20.0, 15.0, 12.0], 0.125).0, Outcome::Stopped);
    assert_eq!(played(Criterion::State, 1e-9, vec![0.0, 20.0, 15.0], 0.1), (Outcome::Stopped, 3));
    // The iteration error alone does not stop what another criterion shall.
    assert_eq!(played(Criterion::Displacement, 1e-9, vec![30.0, 10.0], 0.1), (Outcome::Stopped, 2));
}

#[test]
fn changes_are_measured_against_the_iterate_before_and_not_across_loads() {
    let settings = Settings { criterion: Criterion::Residuals, tolerance: 1e-12, max_iterations: 40, increments: 2 };
    let solution = two([90.0, 60.0], [0.1, 0.2]).solve(&mut Varying::new(StiffnessRule::Secant), settings);
    for pair in solution.history.windows(2) {
        assert_eq!(pair[1].seen.displacement.is_nan(), pair[0].increment != pair[1].increment);
        assert!(!pair[1].seen.conditions.is_nan());
    }
    assert!(solution.history[0].seen.displacement.is_nan());
    // One spring: u = 90/(300 + 2k) from k = 100, then from k = 180.
    let one = one(90.0).solve(&mut Varying::new(StiffnessRule::Secant), tight(2));
    let [first, second] = [90.0 / 500.0, 90.0 / 660.0];
    assert_relative_eq!(one.history[1].seen.displacement, (first - second) / second, max_relative = 1e-12);
    assert_relative_eq!(one.history[1].seen.residuals, (first - second) / second, max_relative = 1e-12);
    assert_relative_eq!(one.history[0].seen.conditions, (first - 0.1) / first, max_relative = 1e-12);
}

#[test]
fn drifting_states_are_no_cycle() {
    let drift: Vec<f64> = (0..100).map(|i| if i % 2 == 0 { 10.0 } else { 20.0 } + 1e-6 * i as f64).collect();
    assert_eq!(one(90.0).solve(&mut Playback::of(drift), tight(100)).outcome, Outcome::Capped);
}

#[test]
fn divergence_is_a_number_that_is_none_or_a_trend_and_not_one_large_error() {
    for broken in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let solution = one(90.0).solve(&mut Playback::of(vec![20.0, broken]), tight(30));
        assert_eq!((solution.outcome, solution.work.iterations), (Outcome::Diverged, 2), "at {broken}");
    }
    let mut broken = Playback::of(vec![30.0]);
    broken.approach = f64::NAN;
    assert_eq!(one(90.0).solve(&mut broken, tight(3)).outcome, Outcome::Diverged);
    // Doubled at each iteration: 1e3 times the least error after ten, and that for twenty.
    let growing = (0..100).map(|k| 60.0 * 2f64.powi(k)).collect();
    let solution = one(90.0).solve(&mut Playback::of(growing), tight(100));
    assert_eq!(solution.outcome, Outcome::Diverged);
    assert!((25..=35).contains(&solution.work.iterations), "{}", solution.work.iterations);
    // A first iteration a hundred million times off is no trend.
    for far in [3e9, -3e9] {
        let solution = one(90.0).solve(&mut Playback::of(vec![far, 15.0, 30.0]), tight(3));
        assert_eq!((solution.outcome, solution.work.iterations), (Outcome::Converged, 3), "from {far}");
    }
}

#[test]
fn springs_that_are_not_numbers_are_divergence_and_not_an_error() {
    struct Broken;
    impl Algorithm for Broken {
        fn next(&mut self, _: &ContactProblem, springs: &mut Springs, _: &mut Work) -> Option<Iterate> {
            springs.stiffness[0] = f64::NAN;
            None
        }
    }
    let solution = one(90.0).solve(&mut Broken, tight(3));
    assert_eq!(solution.outcome, Outcome::Diverged);
    assert!(solution.points[0].pressure.is_nan() && solution.error().largest().is_nan());
}

#[test]
fn running_out_of_steps_is_exhaustion_with_the_last_state_kept() {
    let solution = one(90.0).solve(&mut Constant::new(StiffnessRule::Correction), tight(2));
    assert_eq!(solution.outcome, Outcome::Capped);
    assert_eq!(solution.history.len(), 2);
    assert_relative_eq!(solution.points[0].pressure, 100.0 * 74.0 / 500.0 + 8.0, max_relative = 1e-13);
    assert!(solution.error().largest() > 1e-9);
}

#[test]
fn convergence_is_the_error_against_the_discrete_solution_within_the_tolerance() {
    // p* = 30.
    for (tolerance, outcome) in [(0.0301, Outcome::Converged), (0.0299, Outcome::Capped)] {
        let settings = Settings { tolerance, increments: 1, max_iterations: 2, ..Settings::default() };
        let solution = one(90.0).solve(&mut Playback::of(vec![20.0, 29.1]), settings);
        assert_eq!(solution.outcome, outcome);
        assert_relative_eq!(solution.error().peak, 0.03, max_relative = 1e-9);
        assert_relative_eq!(solution.error().force, 0.015, max_relative = 1e-9);
        assert_relative_eq!(solution.history[0].error.peak, 1.0 / 3.0, max_relative = 1e-9);
    }
    for (name, mut algorithm) in solvers() {
        let solution = started(&two([200.0, 300.0], [0.1, 0.1]), name).solve(algorithm.as_mut(), tight(50_000));
        assert_eq!(solution.converged(), solution.error().largest() <= 1e-9, "{name}");
        let before = solution.history.iter().rev().skip(1);
        assert!(before.into_iter().all(|iteration| iteration.error.largest() > 1e-9), "{name} went on");
    }
}

#[test]
fn convergence_does_not_depend_on_what_stiffnesses_are_scaled_by() {
    let sample = two([200.0, 300.0], [0.1, 0.1]);
    let counts = [1e-3, 1.0, 1e3].map(|times| {
        let mut problem = sample.problem();
        problem.scale.gap *= times;
        let settings = Settings { tolerance: 1e-3, increments: 1, max_iterations: 2000, ..Settings::default() };
        let solution = iterate(&problem, &mut Constant::new(StiffnessRule::Correction), settings).expect("no error");
        assert!(solution.converged());
        solution.work.iterations
    });
    assert_eq!(counts, [counts[0]; 3]);
}

#[test]
fn error_of_an_iterate_is_told_part_by_part_and_at_the_worst_contact() {
    let mut sample = two([200.0, 300.0], [0.1, 0.1]);
    let wanted = exact(&sample);
    sample.points[1].contact = 1;
    sample.edges.push(ContactEdge { contact: 1, ..edge(1) });
    sample.points[1].shares = vec![(0, 3.0)];
    let problem = ContactProblem { compliance: vec![COMPLIANCE; 2], ..sample.problem() };
    let target = Target::of(&problem, Law::Rigid, &[true; 2]).expect("a solution");
    let right = &target.exact.iterate;
    assert!(distance(&right.pressure, &wanted) <= 1e-9 && target.error(&problem, right).largest() <= 1e-12);
    for (contact, pressure) in wanted.iter().enumerate() {
        let mut iterate = right.clone();
        iterate.pressure[contact] *= 1.02;
        iterate.approach[contact] += 0.003;
        let error = target.error(&problem, &iterate);
        assert_relative_eq!(error.peak, 0.02, max_relative = 1e-9);
        assert_relative_eq!(error.force, 0.01, max_relative = 1e-9);
        let force = problem.points[contact].weight * pressure;
        assert_relative_eq!(error.approach, 0.003 / (COMPLIANCE * force), max_relative = 1e-9);
        assert_abs_diff_eq!(error.width, 0.0, epsilon = 0.0);
        assert_relative_eq!(target.approach(contact), COMPLIANCE * force, max_relative = 1e-9);
    }
}

#[test]
fn nan_anywhere_in_an_iterate_reaches_its_error() {
    let sample = two([200.0, 300.0], [0.1, 0.1]);
    let problem = sample.problem();
    let target = Target::of(&problem, Law::Rigid, &[true; 2]).expect("a solution");
    for at in 0..2 {
        let pressure = spoiled(&target.exact.iterate, |iterate| iterate.pressure[at] = f64::NAN);
        let approach = spoiled(&target.exact.iterate, |iterate| iterate.approach[at] = f64::NAN);
        assert!([pressure, approach].iter().all(|iterate| target.error(&problem, iterate).largest().is_nan()));
    }
    let of = |parts: [f64; 4]| {
        let [peak, force, width, approach] = parts;
        IterationError { peak, force, width, approach }
    };
    for at in 0..4 {
        let mut parts = [1.0; 4];
        parts[at] = 4.0;
        assert_relative_eq!(of(parts).largest(), 4.0);
        assert_relative_eq!(of(parts).worse(of([2.0; 4])).largest(), 4.0);
        parts[at] = f64::NAN;
        assert!(of(parts).largest().is_nan());
        assert!(of(parts).worse(IterationError::NONE).largest().is_nan());
        assert!(IterationError::NONE.worse(of(parts)).largest().is_nan());
    }
}

#[test]
fn error_in_the_energy_norm_is_below_its_bound_with_and_without_tension() {
    for pressures in [[4.0, -3.0], [40.0, 10.0], [-5.0, 90.0], [0.0, 0.0], [60.0, 60.0]] {
        let sample = two([200.0, 300.0], [0.1, 0.1]);
        // In equilibrium: S u = f − Σ A p b.
        let mut load = sample.load.clone();
        for (point, p) in sample.points.iter().zip(pressures) {
            point.add_row(-point.weight * p, &mut load);
        }
        let determinant = 300.0 * 200.0 - 100.0 * 100.0;
        let u = [(200.0 * load[0] + 100.0 * load[1]) / determinant, (100.0 * load[0] + 300.0 * load[1]) / determinant];
        let problem = sample.problem();
        let w = [0, 1].map(|i: usize| sample.points[i].approach(&u));
        let iterate = iterate_of(&problem, u, w, pressures);
        let target = Target::of(&problem, Law::Rigid, &[true; 2]).expect("a solution");
        let energy = bound::of(&problem, &target.exact, &iterate).expect("it presses");
        // By hand: (u − u*)ᵀ S (u − u*) over Σ F* · Σ F*/(E* t).
        let d: Vec<f64> = u.iter().zip(&target.exact.iterate.displacement).map(|(u, v)| u - v).collect();
        let norm = 300.0 * d[0] * d[0] - 200.0 * d[0] * d[1] + 200.0 * d[1] * d[1];
        let force: f64 = sample.points.iter().zip(exact(&sample)).map(|(point, p)| point.weight * p).sum();
        assert_relative_eq!(energy.error, norm / (force * force * COMPLIANCE), max_relative = 1e-8);
        assert!(energy.bound >= energy.error * (1.0 - 1e-9), "{pressures:?}: {energy:?}");
    }
}

#[test]
fn no_spring_left_is_an_error_that_says_what_to_do() {
    let mut sample = one(-12.0);
    sample.stiffness = matrix(&[&[0.0]]);
    let mut kinematic = Kinematic::new(StiffnessRule::Switching, 1e-3);
    let error = iterate(&sample.problem(), &mut kinematic, tight(10)).expect_err("the load pulls the body off");
    let text = error.to_string();
    assert!(error.kind == Kind::NoSpringLeft { iterations: 1 }, "{text}");
    assert!(text.contains("after iteration 1") && error.remedy.contains("raise the initial stiffness"), "{text}");
}

#[test]
fn constant_stiffness_factorises_once_over_all_increments_and_the_others_at_every_step() {
    let settings = Settings { tolerance: 1e-9, increments: 4, max_iterations: 2000, ..Settings::default() };
    let algorithms: [(bool, Box<dyn Algorithm>); 3] = [
        (true, Box::new(Constant::new(StiffnessRule::Correction))),
        (false, Box::new(Varying::new(StiffnessRule::Secant))),
        (false, Box::new(Kinematic::new(StiffnessRule::Switching, 1e-9))),
    ];
    for (once, mut algorithm) in algorithms {
        let solution = one(90.0).solve(algorithm.as_mut(), settings);
        let Work { iterations, factorisations, back_substitutions, .. } = solution.work;
        assert_eq!((solution.outcome, solution.history.len()), (Outcome::Converged, iterations));
        assert_eq!(factorisations, if once { 1 } else { iterations });
        // Once more where an iteration is refined.
        assert!(iterations > 4 && (iterations..=2 * iterations).contains(&back_substitutions));
    }
}

#[test]
fn increments_apply_the_load_in_equal_parts_and_stop_where_one_fails() {
    // Under a quarter of the load the point is open, w* = 0.075; then p* = 7.5, 18.75, 30: hardly any force is off by
    // all of it.
    let settings = Settings { tolerance: 1.0, increments: 4, max_iterations: 100, ..Settings::default() };
    let mut playback = Playback::of(vec![1e-3]);
    let solution = one(90.0).solve(&mut playback, settings);
    assert_eq!(solution.outcome, Outcome::Converged);
    // Each is judged once its pressed points stand still: after two iterations.
    let twice = |each: [f64; 4]| each.into_iter().flat_map(|one| [one, one]).collect::<Vec<_>>();
    assert!(distance(&playback.loads, &twice([22.5, 45.0, 67.5, 90.0])) <= 1e-13);
    assert_eq!(solution.history.iter().map(|s| s.increment).collect::<Vec<_>>(), vec![1, 1, 2, 2, 3, 3, 4, 4]);

    let failing = Settings { tolerance: 1e-9, increments: 4, max_iterations: 5, ..Settings::default() };
    // A quarter of the load is not what the point carries.
    let mut playback = Playback::of((0..9).map(|k| 1.0 + f64::from(k)).collect());
    let solution = one(90.0).solve(&mut playback, failing);
    assert_eq!(solution.outcome, Outcome::Capped);
    assert!(solution.history.iter().all(|s| s.increment == 1));
}

#[test]
fn solution_reports_pressures_gaps_forces_and_edge_means() {
    struct Fixed;
    impl Algorithm for Fixed {
        fn next(&mut self, problem: &ContactProblem, _: &mut Springs, _: &mut Work) -> Option<Iterate> {
            Some(iterate_of(problem, [0.12, 0.2], [0.12, 0.18], [4.0, -3.0]))
        }
    }
    let mut sample = two([50.0, 20.0], [0.1, 0.3]);
    sample.points[0].shares = vec![(0, 0.5), (1, 1.5)];
    sample.points[1].shares = vec![(1, 3.0)];
    sample.edges = vec![edge(0), edge(1)];
    let solution =
        sample.solve(&mut Fixed, Settings { tolerance: 1e-3, increments: 1, max_iterations: 1, ..Settings::default() });

    assert!(distance(&solution.spring_pressures, &[4.0, -3.0]) <= 0.0);
    assert!(distance(&[solution.points[0].pressure, solution.points[1].pressure], &[4.0, 0.0]) <= 0.0);
    assert!(distance(&[solution.points[0].gap, solution.points[1].gap], &[-0.02, 0.12]) <= 1e-15);
    assert!(distance(&solution.contact_force, &[-8.0, 0.0]) <= 1e-15);
    assert!(distance(&solution.displacement, &[0.12, 0.2]) <= 0.0);
    let edges: Vec<[f64; 4]> =
        solution.edges.iter().map(|e| [e.weight, e.pressure, e.position(), e.length()]).collect();
    assert!(distance(&edges[0], &[0.5, 4.0, 0.5, 1.0]) <= 1e-14);
    assert!(distance(&edges[1], &[4.5, (1.5 * 4.0 + 3.0 * 0.0) / 4.5, 1.5, 1.0]) <= 1e-14);
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
fn system_matrix_is_the_condensed_stiffness_plus_weighted_springs() {
    let sample = two([200.0, 300.0], [0.1, 0.1]);
    let (k, b) = ([40.0, 70.0], [1.0, -2.0]);
    let x = sample.problem().factorise(&k, &mut Work::default()).expect("definite").solve(&b);
    // Σ A k bᵀb: 2·40 at (0, 0); 3·70 times (1/4, 3/4)ᵀ(1/4, 3/4).
    let spring = 210.0;
    let a = [300.0 + 80.0 + spring / 16.0, -100.0 + spring * 3.0 / 16.0, 200.0 + spring * 9.0 / 16.0];
    let residual = [a[0] * x[0] + a[1] * x[1] - b[0], a[1] * x[0] + a[2] * x[1] - b[1]];
    assert!(distance(&residual, &[0.0, 0.0]) <= 1e-13);
}

#[test]
fn equilibrium_balances_to_round_off_even_with_stiff_springs() {
    let mut sample = two([200.0, 300.0], [0.1, 0.1]);
    sample.initial = vec![1e8, 1e8];
    let problem = sample.problem();
    let springs = Springs { stiffness: vec![1e8, 1e8], force: vec![3.0, -1.0] };
    let mut work = Work::default();
    let factor = problem.factorise(&springs.stiffness, &mut work).expect("definite");
    let iterate = problem.equilibrium(&factor, &springs, |p| p.gap, &mut work);
    for i in 0..2 {
        let inner: f64 = (0..2).map(|j| sample.stiffness[(i, j)] * iterate.displacement[j]).sum();
        let contact = 2.0 * iterate.pressure[0] * [1.0, 0.0][i] + 3.0 * iterate.pressure[1] * [0.25, 0.75][i];
        // Without the refinement k (w − g) alone loses 1e8 · 0.1 · 1e-16 = 1e-9.
        assert_abs_diff_eq!(sample.load[i] - inner - contact, 0.0, epsilon = 1e-12 * 300.0);
        assert_relative_eq!(iterate.internal[i], inner, max_relative = 1e-14);
    }
    assert_eq!(work.back_substitutions, 2);
    // Springs of 1e8 yield by p/k ≈ 1e-6 mm, which the body resists with some 300 N/mm.
    assert!((iterate.pressure[0] - exact(&sample)[0]).abs() <= 1e-3);
}

#[test]
fn spring_force_of_an_iterate_is_the_carried_force_plus_stiffness_times_strain() {
    let sample = two([200.0, 300.0], [0.05, 0.1]);
    let problem = sample.problem();
    let springs = Springs { stiffness: vec![40.0, 70.0], force: vec![3.0, -1.0] };
    let mut work = Work::default();
    let factor = problem.factorise(&springs.stiffness, &mut work).expect("definite");
    let iterate = problem.equilibrium(&factor, &springs, |p| p.gap, &mut work);
    for i in 0..2 {
        let wanted = springs.force[i] + springs.stiffness[i] * (iterate.approach[i] - sample.points[i].gap);
        assert_relative_eq!(iterate.pressure[i], wanted, max_relative = 1e-11);
    }
    let u = &iterate.displacement;
    assert!(distance(&iterate.approach, &[u[0], 0.25 * u[0] + 0.75 * u[1]]) <= 1e-15);
    let internal = [0, 1].map(|i| sample.stiffness[(i, 0)] * u[0] + sample.stiffness[(i, 1)] * u[1]);
    assert!(distance(&iterate.internal, &internal) <= 1e-12);
    // Soft springs lose nothing that a refinement would return.
    assert_eq!(work.back_substitutions, 1);
}

pub fn iterate_of(problem: &ContactProblem, displacement: [f64; 2], approach: [f64; 2], pressure: [f64; 2]) -> Iterate {
    let internal = problem.stiffness.times(&displacement);
    Iterate { displacement: displacement.to_vec(), approach: approach.to_vec(), pressure: pressure.to_vec(), internal }
}
