//! The iterations on contact problems of one and two freedoms, whose solutions are known by hand.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact_vv::algorithm::{
    Algorithm, Constant, ContactProblem, Iterate, Kinematic, Scale, Settings, Springs, StiffnessRule, Varying, iterate,
    rule,
};
use contact_vv::contact::ContactPoint;
use contact_vv::error::Error;
use contact_vv::solution::{Outcome, Residuals, Solution, Work};
use faer::Mat;

use crate::workbench::distance;

/// A problem that owns its matrices.
struct Sample {
    stiffness: Mat<f64>,
    load: Vec<f64>,
    points: Vec<ContactPoint>,
    initial: Vec<f64>,
}

const SCALE: Scale = Scale { pressure: 10.0, gap: 0.1, stiffness: 100.0 };

impl Sample {
    fn problem(&self) -> ContactProblem<'_> {
        ContactProblem {
            stiffness: &self.stiffness,
            load: &self.load,
            points: &self.points,
            scale: SCALE,
            initial: self.initial.clone(),
        }
    }

    fn solve(&self, algorithm: &mut dyn Algorithm, settings: Settings) -> Solution {
        iterate(&self.problem(), algorithm, settings).expect("no error")
    }
}

fn matrix(entries: &[&[f64]]) -> Mat<f64> {
    Mat::from_fn(entries.len(), entries.len(), |i, j| entries[i][j])
}

fn point(row: Vec<(usize, f64)>, weight: f64, gap: f64) -> ContactPoint {
    ContactPoint { row, position: gap, weight, gap, relative_stiffness: 1.0, shares: vec![(0, weight)] }
}

/// One freedom with stiffness 300 N/mm, a point of 2 mm² at the gap 0.1 mm.
fn one(load: f64) -> Sample {
    Sample {
        stiffness: matrix(&[&[300.0]]),
        load: vec![load],
        points: vec![point(vec![(0, 1.0)], 2.0, 0.1)],
        initial: vec![100.0],
    }
}

/// Two coupled freedoms and two points; the second point sees both freedoms.
fn two(load: [f64; 2], gaps: [f64; 2]) -> Sample {
    Sample {
        stiffness: matrix(&[&[300.0, -100.0], &[-100.0, 200.0]]),
        load: load.to_vec(),
        points: vec![point(vec![(0, 1.0)], 2.0, gaps[0]), point(vec![(0, 0.25), (1, 0.75)], 3.0, gaps[1])],
        initial: vec![100.0, 150.0],
    }
}

/// Pressures of the exact solution: the one closed set for which no point penetrates and none pulls.
fn exact(sample: &Sample) -> Vec<f64> {
    let n = sample.load.len();
    let m = sample.points.len();
    for set in 0..1usize << m {
        let closed: Vec<usize> = (0..m).filter(|i| set >> i & 1 == 1).collect();
        let size = n + closed.len();
        let mut a = nalgebra::DMatrix::zeros(size, size);
        let mut b = nalgebra::DVector::zeros(size);
        for i in 0..n {
            b[i] = sample.load[i];
            (0..n).for_each(|j| a[(i, j)] = sample.stiffness[(i, j)]);
        }
        for (k, &i) in closed.iter().enumerate() {
            for &(f, value) in &sample.points[i].row {
                a[(n + k, f)] = value;
                a[(f, n + k)] = sample.points[i].weight * value;
            }
            b[n + k] = sample.points[i].gap;
        }
        let Some(x) = a.lu().solve(&b) else { continue };
        let approach = |i: usize| -> f64 { sample.points[i].row.iter().map(|&(f, value)| value * x[f]).sum() };
        let mut pressures = vec![0.0; m];
        closed.iter().enumerate().for_each(|(k, &i)| pressures[i] = x[n + k]);
        if (0..m).all(|i| pressures[i] >= 0.0 && approach(i) <= sample.points[i].gap + 1e-12) {
            return pressures;
        }
    }
    panic!("no closed set solves the sample");
}

fn tight(max_steps: usize) -> Settings {
    Settings { tolerance: 1e-9, increments: 1, max_steps }
}

/// Every algorithm and rule that iterates to the contact conditions.
fn solvers() -> Vec<(&'static str, Box<dyn Algorithm>)> {
    vec![
        ("varying secant", Box::new(Varying::new(StiffnessRule::Secant))),
        ("varying correction", Box::new(Varying::new(StiffnessRule::Correction))),
        ("constant correction", Box::new(Constant::new(StiffnessRule::Correction))),
        ("constant secant", Box::new(Constant::new(StiffnessRule::Secant))),
        ("kinematic", Box::new(Kinematic::new(StiffnessRule::Switching, 1e-9))),
    ]
}

/// The sample with the springs that an algorithm needs: secant on forces diverges below half of k* = p/g, here 2,500.
fn started(sample: &Sample, name: &str) -> Sample {
    let initial = if name == "constant secant" { vec![3000.0; 2] } else { sample.initial.clone() };
    Sample { stiffness: sample.stiffness.clone(), load: sample.load.clone(), points: sample.points.clone(), initial }
}

#[test]
fn one_spring_finds_contact_and_separation_with_every_algorithm() {
    // Closed: w = g and p = (f − s g)/A = (90 − 30)/2. Open: w = f/s.
    for (load, pressure, approach) in [(90.0, 30.0, 0.1), (15.0, 0.0, 0.05), (-12.0, 0.0, -0.04)] {
        for (name, mut algorithm) in solvers() {
            let solution = one(load).solve(algorithm.as_mut(), tight(20_000));
            assert_eq!(solution.outcome, Outcome::Converged, "{name} under {load}");
            // The residuals are within 1e-9 of p_ref = 10 and g_ref = 0.1.
            assert!(
                (solution.points[0].pressure - pressure).abs() <= 1e-7,
                "{name}: p = {}",
                solution.points[0].pressure
            );
            assert!((0.1 - solution.points[0].gap - approach).abs() <= 1e-9, "{name}: h = {}", solution.points[0].gap);
        }
    }
}

#[test]
fn two_coupled_springs_find_every_closed_set_with_every_algorithm() {
    let cases = [
        ([200.0, 300.0], [0.1, 0.1], [true, true]),
        ([200.0, -100.0], [0.1, 0.1], [true, false]),
        ([-50.0, 150.0], [0.1, 0.1], [false, true]),
        ([1.0, 1.0], [0.1, 0.1], [false, false]),
        ([200.0, 300.0], [0.02, 0.3], [true, true]),
    ];
    for (load, gaps, closed) in cases {
        let sample = two(load, gaps);
        let wanted = exact(&sample);
        assert_eq!(
            [wanted[0] > 0.0, wanted[1] > 0.0],
            closed,
            "the case {load:?} is not what it is meant to be: {wanted:?}"
        );
        for (name, mut algorithm) in solvers() {
            let solution = started(&sample, name).solve(algorithm.as_mut(), tight(50_000));
            let found: Vec<f64> = solution.points.iter().map(|p| p.pressure).collect();
            assert_eq!(solution.outcome, Outcome::Converged, "{name} under {load:?}");
            assert!(distance(&found, &wanted) <= 1e-6, "{name} under {load:?}: {found:?} instead of {wanted:?}");
        }
    }
}

#[test]
fn penalty_rule_solves_the_problem_of_elastic_springs() {
    // (s + A k) u = f + A k g, p = k (u − g).
    let sample = one(90.0);
    let mut penalty = Kinematic::new(StiffnessRule::Penalty, 1e-9);
    let solution = sample.solve(&mut penalty, tight(10));
    let u = (90.0 + 2.0 * 100.0 * 0.1) / (300.0 + 2.0 * 100.0);
    assert_eq!(solution.outcome, Outcome::Converged);
    assert_relative_eq!(solution.displacement[0], u, max_relative = 1e-14);
    assert_relative_eq!(solution.points[0].pressure, 100.0 * (u - 0.1), max_relative = 1e-12);
    assert!(solution.points[0].gap < 0.0, "elastic springs are penetrated");

    let open = one(15.0).solve(&mut penalty, tight(10));
    assert_eq!(open.outcome, Outcome::Converged);
    assert_abs_diff_eq!(open.displacement[0], 0.05, epsilon = 1e-15);
}

#[test]
fn penalty_springs_keep_their_initial_stiffness_and_reopen_and_close() {
    let sample = one(90.0);
    let problem = sample.problem();
    let mut penalty = Kinematic::new(StiffnessRule::Penalty, 1e-9);
    let mut work = Work::default();
    let mut springs = Springs { stiffness: vec![0.0], force: vec![0.0] };
    penalty.step(&problem, &[90.0], &mut springs, &mut work);
    assert_relative_eq!(springs.stiffness[0], 100.0);
    penalty.step(&problem, &[15.0], &mut springs, &mut work);
    assert_abs_diff_eq!(springs.stiffness[0], 0.0, epsilon = 0.0);
}

#[test]
fn interference_is_resolved_by_kinematic_load_and_by_correction() {
    // w = g = −0.1 and p = (f − s g)/A.
    let mut sample = one(0.0);
    sample.points[0].gap = -0.1;
    let solvers: [Box<dyn Algorithm>; 2] =
        [Box::new(Kinematic::new(StiffnessRule::Switching, 1e-9)), Box::new(Constant::new(StiffnessRule::Correction))];
    for mut algorithm in solvers {
        let solution = sample.solve(algorithm.as_mut(), tight(1000));
        assert_eq!(solution.outcome, Outcome::Converged);
        assert_relative_eq!(solution.points[0].pressure, 15.0, max_relative = 1e-7);
    }
}

#[test]
fn body_held_by_contact_alone_is_carried_by_its_pressures() {
    let sample = Sample {
        stiffness: matrix(&[&[100.0, -100.0], &[-100.0, 100.0]]),
        load: vec![20.0, 10.0],
        points: vec![point(vec![(0, 1.0)], 2.0, 0.05), point(vec![(1, 1.0)], 4.0, 0.05)],
        initial: vec![100.0; 2],
    };
    // Both closed at one gap: no deformation, so that each carries its own load.
    for (name, mut algorithm) in solvers() {
        let solution = sample.solve(algorithm.as_mut(), tight(50_000));
        assert_eq!(solution.outcome, Outcome::Converged, "{name}");
        assert!((solution.points[0].pressure - 10.0).abs() <= 1e-6, "{name}");
        assert!((solution.points[1].pressure - 2.5).abs() <= 1e-6, "{name}");
    }
}

/// One step from given springs.
fn step(algorithm: &mut dyn Algorithm, sample: &Sample, springs: &mut Springs) -> Iterate {
    algorithm.step(&sample.problem(), &sample.load, springs, &mut Work::default()).expect("definite")
}

#[test]
fn first_step_of_varying_stiffness_is_equation_three_two() {
    let sample = one(90.0);
    for (rule, wanted) in [
        // u = 90/500 = 0.18, p = 18: secant k w/g = 100·1.8; correction p⁺ = 18 + 100·0.08 = 26 over w.
        (StiffnessRule::Secant, 180.0),
        (StiffnessRule::Correction, 26.0 / 0.18),
    ] {
        let mut springs = sample.problem().initial_springs();
        let iterate = step(&mut Varying::new(rule), &sample, &mut springs);
        assert_relative_eq!(iterate.displacement[0], 0.18, max_relative = 1e-14);
        assert_relative_eq!(iterate.pressure[0], 18.0, max_relative = 1e-14);
        assert_relative_eq!(springs.stiffness[0], wanted, max_relative = 1e-13);
        assert_abs_diff_eq!(springs.force[0], 0.0, epsilon = 0.0);
    }
}

#[test]
fn correction_of_varying_stiffness_uses_the_larger_of_present_and_initial_stiffness() {
    let sample = one(90.0);
    for (present, kappa) in [(400.0, 400.0), (10.0, 100.0)] {
        let mut springs = Springs { stiffness: vec![present], force: vec![0.0] };
        step(&mut Varying::new(StiffnessRule::Correction), &sample, &mut springs);
        let w = 90.0 / (300.0 + 2.0 * present);
        let wanted = (present * w + kappa * (w - 0.1)) / w;
        assert_relative_eq!(springs.stiffness[0], wanted.max(1e-12 * 100.0), max_relative = 1e-12);
    }
}

#[test]
fn first_steps_of_constant_stiffness_are_equation_three_six() {
    let sample = one(90.0);
    let mut constant = Constant::new(StiffnessRule::Correction);
    let mut springs = sample.problem().initial_springs();
    let first = step(&mut constant, &sample, &mut springs);
    // As above: p⁺ − p = 26 − 18.
    assert_relative_eq!(first.pressure[0], 18.0, max_relative = 1e-14);
    assert_relative_eq!(springs.force[0], 8.0, max_relative = 1e-13);
    let second = step(&mut constant, &sample, &mut springs);
    // (300 + 200) u = 90 − 2·8, p = 100 u + 8.
    assert_relative_eq!(second.displacement[0], 74.0 / 500.0, max_relative = 1e-14);
    assert_relative_eq!(second.pressure[0], 100.0 * 74.0 / 500.0 + 8.0, max_relative = 1e-14);
    assert_relative_eq!(springs.stiffness[0], 100.0);
}

#[test]
fn secant_of_constant_stiffness_scales_the_spring_force_by_the_strain() {
    let sample = one(90.0);
    let mut constant = Constant::new(StiffnessRule::Secant);
    let mut springs = sample.problem().initial_springs();
    step(&mut constant, &sample, &mut springs);
    // p = 18, w/g = 1.8: p⁺ − p = 18·0.8.
    assert_relative_eq!(springs.force[0], 14.4, max_relative = 1e-12);
}

#[test]
fn literal_reading_adds_the_change_of_stored_stiffnesses_times_the_approach() {
    let sample = one(90.0);
    let mut literal = Constant::new(StiffnessRule::Literal);
    let mut springs = sample.problem().initial_springs();
    step(&mut literal, &sample, &mut springs);
    // k: 100 → 180; r = 80·0.18.
    assert_relative_eq!(springs.force[0], 14.4, max_relative = 1e-12);
    let second = step(&mut literal, &sample, &mut springs);
    let w = (90.0 - 2.0 * 14.4) / 500.0;
    assert_relative_eq!(second.approach[0], w, max_relative = 1e-13);
    // k: 180 → 180 w/g, whose product with w is not the spring's force k₀ w + r.
    assert_relative_eq!(springs.force[0], 14.4 + 180.0 * (w / 0.1 - 1.0) * w, max_relative = 1e-12);
}

#[test]
fn literal_reading_does_not_find_the_solution() {
    let solution = two([200.0, -100.0], [0.02, 0.1]).solve(&mut Constant::new(StiffnessRule::Literal), tight(5000));
    assert_ne!(solution.outcome, Outcome::Converged);
}

#[test]
fn first_step_of_kinematic_load_is_equation_three_eleven() {
    let sample = one(90.0);
    let mut springs = sample.problem().initial_springs();
    let iterate = step(&mut Kinematic::new(StiffnessRule::Switching, 1e-3), &sample, &mut springs);
    // (300 + 200) u = 90 + 2·100·0.1; p = 100 (u − 0.1) = 12; deeper than 1e-3 g_ref, so that it hardens.
    assert_relative_eq!(iterate.displacement[0], 0.22, max_relative = 1e-14);
    assert_relative_eq!(iterate.pressure[0], 12.0, max_relative = 1e-12);
    assert_relative_eq!(springs.stiffness[0], 1e6 * 100.0);
}

#[test]
fn kinematic_springs_open_under_tension_close_at_full_hardness_and_stay_otherwise() {
    let kinematic = || Kinematic::new(StiffnessRule::Switching, 1e-3);
    let after = |load: f64, k: f64| {
        let mut springs = Springs { stiffness: vec![k], force: vec![0.0] };
        step(&mut kinematic(), &one(load), &mut springs);
        springs.stiffness[0]
    };
    let hard = 1e6 * SCALE.stiffness;
    assert_abs_diff_eq!(after(15.0, 100.0), 0.0, epsilon = 0.0);
    assert_relative_eq!(after(90.0, 0.0), hard);
    assert_abs_diff_eq!(after(15.0, 0.0), 0.0, epsilon = 0.0);
    // Penetration 60/(300 + 2k): 1e-4 g_ref = 1e-5 at k ≈ 3e6, which is tolerated.
    assert_relative_eq!(after(90.0, 3e6), 3e6);
}

#[test]
fn hard_springs_hand_their_force_over_when_they_still_penetrate() {
    let sample = one(90.0);
    let hard = 1e6 * SCALE.stiffness;
    let mut kinematic = Kinematic::new(StiffnessRule::Switching, 1e-9);
    let mut springs = Springs { stiffness: vec![hard], force: vec![0.0] };
    let first = step(&mut kinematic, &sample, &mut springs);
    // 30/1e8 = 3e-7 mm deep, more than 1e-9 of 0.1 mm.
    assert_relative_eq!(springs.force[0], first.pressure[0]);
    assert_relative_eq!(springs.stiffness[0], hard);
    let second = step(&mut kinematic, &sample, &mut springs);
    // Each pass leaves s/Ak = 1.5e-6 of the error of the one before.
    assert_relative_eq!(second.pressure[0], 30.0, max_relative = 3e-12);
    assert_abs_diff_eq!(second.approach[0], 0.1, epsilon = 1e-12);
}

#[test]
fn secant_rule_multiplies_by_the_strain_within_its_limits() {
    assert_relative_eq!(rule::secant(&SCALE, 7.0, 0.3, 0.1), 21.0, max_relative = 1e-14);
    let (soft, hard) = (1e-12 * 100.0, 1e6 * 100.0);
    assert_relative_eq!(rule::secant(&SCALE, 7.0, -0.3, 0.1), soft);
    assert_relative_eq!(rule::secant(&SCALE, 7.0, 0.3, 1e-30), hard);
    // A gap of zero counts as 1e-9 g_ref.
    assert_relative_eq!(rule::secant(&SCALE, 7.0, 1e-9, 0.0), 7.0 * 1e-9 / 1e-10, max_relative = 1e-12);
    assert!(rule::secant(&SCALE, 7.0, f64::NAN, 0.1).is_nan());
    assert_relative_eq!(SCALE.hard(), hard);
}

#[test]
fn correction_rule_adds_the_penetration_and_never_pulls() {
    assert_relative_eq!(rule::correction(5.0, 10.0, 0.3, 0.1), 7.0, max_relative = 1e-14);
    assert_relative_eq!(rule::correction(5.0, 10.0, 0.1, 0.3), 3.0, max_relative = 1e-14);
    assert_abs_diff_eq!(rule::correction(1.0, 10.0, 0.0, 0.3), 0.0, epsilon = 0.0);
    assert!(rule::correction(f64::NAN, 10.0, 0.0, 0.3).is_nan());
}

#[test]
fn rules_have_the_names_they_are_chosen_by() {
    use StiffnessRule::{Correction, Literal, Penalty, Secant, Switching};
    let names = [Secant, Correction, Literal, Switching, Penalty].map(StiffnessRule::name);
    assert_eq!(names, ["secant", "correction", "literal", "switching", "penalty"]);
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
    let iterate = problem.equilibrium(&factor, &sample.load, &springs, |p| p.gap, &mut work);
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
    let iterate = problem.equilibrium(&factor, &sample.load, &springs, |p| p.gap, &mut work);
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

fn iterate_of(problem: &ContactProblem, displacement: [f64; 2], approach: [f64; 2], pressure: [f64; 2]) -> Iterate {
    let internal = problem.internal_force(&displacement);
    Iterate { displacement: displacement.to_vec(), approach: approach.to_vec(), pressure: pressure.to_vec(), internal }
}

#[test]
fn residuals_are_their_definitions() {
    let sample = two([50.0, 20.0], [0.1, 0.3]);
    let problem = sample.problem();
    // First point 0.02 deep with p = 4; second 0.1 open with p = −3.
    let found = problem.residuals(&[50.0, 20.0], &iterate_of(&problem, [0.12, 0.2], [0.12, 0.2], [4.0, -3.0]), false);
    assert_relative_eq!(found.penetration, 0.02 / 0.1, max_relative = 1e-12);
    assert_relative_eq!(found.tension, 3.0 / 10.0, max_relative = 1e-12);
    assert_abs_diff_eq!(found.complementarity, 0.0, epsilon = 0.0);
    // f − S u − A p⁺ b = [50 − 36 + 20 − 8, 20 + 12 − 40] = [26, −8] over max(Σ A p⁺ = 8, ‖f‖₁ = 70).
    assert_relative_eq!(found.balance, 34.0 / 70.0, max_relative = 1e-12);

    // p = 6 at a point 0.1 open: min(0.6, 1) = 0.6; with p = 20 it is 1.
    let open = |p: f64| problem.residuals(&[50.0, 20.0], &iterate_of(&problem, [0.0; 2], [0.0, 0.2], [0.0, p]), false);
    assert_relative_eq!(open(6.0).complementarity, 0.6, max_relative = 1e-12);
    assert_relative_eq!(open(20.0).complementarity, 1.0, max_relative = 1e-12);
    assert_abs_diff_eq!(open(6.0).penetration + open(6.0).tension, 0.0, epsilon = 0.0);
    // Balance over Σ A p⁺ = 60 where that is the larger: [50 − 15, 20 − 45].
    assert_relative_eq!(open(20.0).balance, 60.0 / 70.0, max_relative = 1e-12);
    assert_relative_eq!(open(40.0).balance, (20.0 + 70.0) / 120.0, max_relative = 1e-12);
}

#[test]
fn elastic_springs_are_not_blamed_for_their_own_penetration() {
    let sample = two([50.0, 20.0], [0.1, 0.3]);
    let problem = sample.problem();
    let residual = |p: f64| {
        problem.residuals(&[50.0, 20.0], &iterate_of(&problem, [0.12, 0.2], [0.12, 0.2], [p, 0.0]), true).penetration
    };
    // k₀ (w − g) = 100·0.02 = 2: what is missing of it counts, over p_ref = 10.
    assert_abs_diff_eq!(residual(2.0), 0.0, epsilon = 1e-12);
    assert_relative_eq!(residual(0.0), 0.2, max_relative = 1e-12);
}

#[test]
fn largest_residual_is_nan_if_any_is() {
    let of = |penetration: f64, tension: f64, complementarity: f64, balance: f64| {
        Residuals { penetration, tension, complementarity, balance }.largest()
    };
    assert_relative_eq!(of(1.0, 2.0, 3.0, 4.0), 4.0);
    assert_relative_eq!(of(4.0, 2.0, 3.0, 1.0), 4.0);
    assert_relative_eq!(of(1.0, 4.0, 3.0, 1.0), 4.0);
    assert_relative_eq!(of(1.0, 2.0, 4.0, 1.0), 4.0);
    let nan = f64::NAN;
    for residual in [of(nan, 0.0, 0.0, 0.0), of(0.0, nan, 0.0, 0.0), of(0.0, 0.0, nan, 0.0), of(0.0, 0.0, 0.0, nan)] {
        assert!(residual.is_nan());
    }
}

#[test]
fn nan_in_any_part_of_an_iterate_reaches_the_residuals() {
    let sample = two([50.0, 20.0], [0.1, 0.3]);
    let problem = sample.problem();
    let nan = f64::NAN;
    for broken in [
        iterate_of(&problem, [nan, 0.0], [0.0; 2], [0.0; 2]),
        iterate_of(&problem, [0.0; 2], [0.0, nan], [0.0; 2]),
        iterate_of(&problem, [0.0; 2], [nan, 0.0], [0.0; 2]),
        iterate_of(&problem, [0.0; 2], [0.0; 2], [nan, 0.0]),
    ] {
        assert!(problem.residuals(&[50.0, 20.0], &broken, false).largest().is_nan());
    }
}

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
