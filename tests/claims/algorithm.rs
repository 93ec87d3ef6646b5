//! The iterations on contact problems of one and two dofs, whose solutions are known by hand.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact_vv::algorithm::{
    Acceleration, Algorithm, Constant, ContactProblem, Iterate, Kinematic, Leeway, Scale, Settings, Spring, Springs,
    StiffnessRule, Varying, iterate, rule,
};
use contact_vv::condensation::stiffness::Stiffness;
use contact_vv::contact::{ContactEdge, ContactPoint};
use contact_vv::solution::{Outcome, Solution, Work};
use faer::Mat;

use crate::workbench::distance;

/// A problem that owns its matrices.
pub struct Sample {
    pub stiffness: Stiffness,
    pub load: Vec<f64>,
    pub points: Vec<ContactPoint>,
    pub edges: Vec<ContactEdge>,
    pub initial: Vec<f64>,
}

pub const SCALE: Scale = Scale { gap: 0.1, stiffness: 100.0 };
/// 1/(E* t): the force of 60 N that closes [`one`] makes an approach of 0.06 mm.
pub const COMPLIANCE: f64 = 1e-3;

impl Sample {
    pub fn problem(&self) -> ContactProblem<'_> {
        ContactProblem {
            stiffness: &self.stiffness,
            load: &self.load,
            points: &self.points,
            edges: &self.edges,
            scale: SCALE,
            compliance: vec![COMPLIANCE],
            initial: self.initial.clone(),
        }
    }

    pub fn solve(&self, algorithm: &mut dyn Algorithm, settings: Settings) -> Solution {
        iterate(&self.problem(), algorithm, settings).expect("no error")
    }
}

pub fn matrix(entries: &[&[f64]]) -> Stiffness {
    Stiffness::Dense(Mat::from_fn(entries.len(), entries.len(), |i, j| entries[i][j]))
}

pub fn point(row: Vec<(usize, f64)>, weight: f64, gap: f64) -> ContactPoint {
    ContactPoint { contact: 0, row, position: gap, weight, gap, relative_stiffness: 1.0, shares: vec![(0, weight)] }
}

pub fn edge(k: usize) -> ContactEdge {
    ContactEdge { contact: 0, ends: [k as f64, k as f64 + 1.0], nodes: 2, axis: None }
}

/// One dof with stiffness 300 N/mm, a point of 2 mm² at the gap 0.1 mm.
pub fn one(load: f64) -> Sample {
    Sample {
        stiffness: matrix(&[&[300.0]]),
        load: vec![load],
        points: vec![point(vec![(0, 1.0)], 2.0, 0.1)],
        edges: vec![edge(0)],
        initial: vec![100.0],
    }
}

/// Two coupled dofs and two points; the second point sees both dofs.
pub fn two(load: [f64; 2], gaps: [f64; 2]) -> Sample {
    Sample {
        stiffness: matrix(&[&[300.0, -100.0], &[-100.0, 200.0]]),
        load: load.to_vec(),
        points: vec![point(vec![(0, 1.0)], 2.0, gaps[0]), point(vec![(0, 0.25), (1, 0.75)], 3.0, gaps[1])],
        edges: vec![edge(0)],
        initial: vec![100.0, 150.0],
    }
}

/// Pressures of the exact solution: the one closed set for which no point penetrates and none pulls.
pub fn exact(sample: &Sample) -> Vec<f64> {
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

pub fn tight(max_iterations: usize) -> Settings {
    Settings { tolerance: 1e-9, increments: 1, max_iterations, ..Settings::default() }
}

/// Every algorithm and rule that iterates to the contact conditions.
pub fn solvers() -> Vec<(&'static str, Box<dyn Algorithm>)> {
    vec![
        ("varying secant", Box::new(Varying::new(StiffnessRule::Secant))),
        ("varying correction", Box::new(Varying::new(StiffnessRule::Correction))),
        ("constant correction", Box::new(Constant::new(StiffnessRule::Correction))),
        ("constant secant", Box::new(Constant::new(StiffnessRule::Secant))),
        ("kinematic", Box::new(Kinematic::new(StiffnessRule::Switching, 1e-9))),
    ]
}

/// The sample with the springs that an algorithm needs: secant on forces diverges below half of k* = p/g, here 2,500.
pub fn started(sample: &Sample, name: &str) -> Sample {
    let initial = if name == "constant secant" { vec![3000.0; 2] } else { sample.initial.clone() };
    let (stiffness, load) = (Stiffness::Dense(sample.stiffness.to_dense()), sample.load.clone());
    Sample { stiffness, load, points: sample.points.clone(), edges: sample.edges.clone(), initial }
}

#[test]
fn one_spring_finds_contact_and_separation_with_every_algorithm() {
    // Closed: w = g and p = (f − s g)/A = (90 − 30)/2. Open: w = f/s.
    for (load, pressure, approach) in [(90.0, 30.0, 0.1), (15.0, 0.0, 0.05), (-12.0, 0.0, -0.04)] {
        for (name, mut algorithm) in solvers() {
            let solution = one(load).solve(algorithm.as_mut(), tight(20_000));
            assert_eq!(solution.outcome, Outcome::Converged, "{name} under {load}");
            // The iteration error is within 1e-9 of p* = 30.
            let point = solution.points[0];
            assert!((point.pressure - pressure).abs() <= 1e-7, "{name}: p = {}", point.pressure);
            assert!((0.1 - point.gap - approach).abs() <= 1e-9, "{name}: h = {}", point.gap);
        }
    }
}

#[test]
fn two_springs_coupled_or_holding_a_body_alone_find_every_closed_set_with_every_algorithm() {
    let coupled = [
        ([200.0, 300.0], [0.1, 0.1], [true, true]),
        ([200.0, -100.0], [0.1, 0.1], [true, false]),
        ([-50.0, 150.0], [0.1, 0.1], [false, true]),
        ([1.0, 1.0], [0.1, 0.1], [false, false]),
        ([200.0, 300.0], [0.02, 0.3], [true, true]),
    ];
    let mut cases = Vec::new();
    for (load, gaps, closed) in coupled {
        let sample = two(load, gaps);
        let wanted = exact(&sample);
        assert_eq!([wanted[0] > 0.0, wanted[1] > 0.0], closed, "{load:?} is not what it is meant to be: {wanted:?}");
        cases.push((sample, wanted));
    }
    // Both closed at one gap: no deformation, so that each carries its own load.
    let held = Sample {
        stiffness: matrix(&[&[100.0, -100.0], &[-100.0, 100.0]]),
        load: vec![20.0, 10.0],
        points: vec![point(vec![(0, 1.0)], 2.0, 0.05), point(vec![(1, 1.0)], 4.0, 0.05)],
        edges: vec![edge(0)],
        initial: vec![100.0; 2],
    };
    cases.push((held, vec![10.0, 2.5]));
    for (sample, wanted) in &cases {
        for (name, mut algorithm) in solvers() {
            let solution = started(sample, name).solve(algorithm.as_mut(), tight(50_000));
            let found: Vec<f64> = solution.points.iter().map(|p| p.pressure).collect();
            assert_eq!(solution.outcome, Outcome::Converged, "{name} under {:?}", sample.load);
            assert!(distance(&found, wanted) <= 1e-6, "{name} under {:?}: {found:?}, not {wanted:?}", sample.load);
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

/// One step from given springs.
pub fn next(algorithm: &mut dyn Algorithm, sample: &Sample, springs: &mut Springs) -> Iterate {
    algorithm.next(&sample.problem(), springs, &mut Work::default()).expect("definite")
}

#[test]
fn a_step_from_given_springs_leaves_those_of_its_equation() {
    use StiffnessRule::{Correction, Literal, Penalty, Secant, Switching};
    let kinematic = |rule| -> Box<dyn Algorithm> { Box::new(Kinematic::new(rule, 1e-3)) };
    let varying = |rule| -> Box<dyn Algorithm> { Box::new(Varying::new(rule)) };
    let constant = |rule| -> Box<dyn Algorithm> { Box::new(Constant::new(rule)) };
    let hard = SCALE.hard();
    // Algorithm, load and stiffness before; stiffness and force of the spring after it.
    for (what, mut algorithm, load, before, stiffness, force) in [
        // Equation (3.2) at u = 90/500 = 0.18, p = 18: secant k w/g = 100·1.8; correction p⁺ = 18 + 100·0.08 = 26 over
        // w.
        ("varying secant", varying(Secant), 90.0, 100.0, 180.0, 0.0),
        ("varying correction", varying(Correction), 90.0, 100.0, 26.0 / 0.18, 0.0),
        // u = 90/1100 = 9/110, by the present stiffness; u = 90/320 = 9/32, by the initial one, which is the larger.
        ("a stiffer spring", varying(Correction), 90.0, 400.0, 400.0 * (2.0 - 0.1 * 110.0 / 9.0), 0.0),
        ("a softer spring", varying(Correction), 90.0, 10.0, 10.0 + 100.0 * (1.0 - 0.1 * 32.0 / 9.0), 0.0),
        // Equation (3.6): p⁺ − p = 26 − 18; by the secant 18·0.8, and read literally k: 100 → 180 and r = 80·0.18.
        ("constant correction", constant(Correction), 90.0, 100.0, 100.0, 8.0),
        ("constant secant", constant(Secant), 90.0, 100.0, 100.0, 14.4),
        ("constant literal", constant(Literal), 90.0, 100.0, 100.0, 14.4),
        // Equation (3.11): p = 100 (0.22 − 0.1) = 12, deeper than 1e-4 of its approach, so that it hardens.
        ("pressed", kinematic(Switching), 90.0, 100.0, hard, 0.0),
        ("pulled", kinematic(Switching), 15.0, 100.0, 0.0, 0.0),
        ("closed", kinematic(Switching), 90.0, 0.0, hard, 0.0),
        ("open", kinematic(Switching), 15.0, 0.0, 0.0, 0.0),
        // Of an approach of 60 N/(E* t) = 0.06 a tenth of the tolerance is 6e-6; penetration 60/(300 + 2k) is 3e-6 at k
        // = 1e7.
        ("hard enough", kinematic(Switching), 90.0, 1e7, 1e7, 0.0),
        ("too soft", kinematic(Switching), 90.0, 3e6, hard, 0.0),
        ("penalty closed", kinematic(Penalty), 90.0, 0.0, 100.0, 0.0),
        ("penalty pulled", kinematic(Penalty), 15.0, 100.0, 0.0, 0.0),
    ] {
        let mut springs = Springs { stiffness: vec![before], force: vec![0.0] };
        next(algorithm.as_mut(), &one(load), &mut springs);
        let found = [springs.stiffness[0], springs.force[0]];
        assert!(distance(&found, &[stiffness, force]) <= 1e-12 * stiffness.max(100.0), "{what}: {found:?}");
    }
}

#[test]
fn bound_limits_the_change_of_a_stiffness_both_ways() {
    // At k = 100: w = 0.18 of a gap of 0.1, factor 1.8; and w = 0.03, factor 0.3.
    for (load, bound, factor) in
        [(90.0, 1.5, 1.5), (90.0, 2.0, 1.8), (15.0, 2.0, 0.5), (15.0, 4.0, 0.3), (15.0, f64::INFINITY, 0.3)]
    {
        let sample = one(load);
        let mut springs = sample.problem().initial_springs();
        let leeway = Leeway { bound, ..Leeway::default() };
        next(&mut Varying::accelerated(StiffnessRule::Secant, leeway, Acceleration::None), &sample, &mut springs);
        assert_relative_eq!(springs.stiffness[0], 100.0 * factor, max_relative = 1e-13);
    }
}

#[test]
fn points_of_an_element_change_by_their_mean_approach_over_their_mean_gap() {
    let mut sample = two([90.0, 60.0], [0.1, 0.3]);
    let per = |spring| {
        Varying::accelerated(StiffnessRule::Secant, Leeway { spring, ..Leeway::default() }, Acceleration::None)
    };
    let factors = |sample: &Sample, spring| -> [f64; 2] {
        let mut springs = sample.problem().initial_springs();
        next(&mut per(spring), sample, &mut springs);
        [0, 1].map(|i| springs.stiffness[i] / sample.initial[i])
    };
    let mut springs = sample.problem().initial_springs();
    let w = next(&mut per(Spring::Point), &sample, &mut springs).approach;
    let own = [w[0] / 0.1, w[1] / 0.3];
    for (found, wanted) in factors(&sample, Spring::Point).into_iter().zip(own) {
        assert_relative_eq!(found, wanted, max_relative = 1e-13);
    }
    let mean = (2.0 * w[0] + 3.0 * w[1]) / (2.0 * 0.1 + 3.0 * 0.3);
    for found in factors(&sample, Spring::Element) {
        assert_relative_eq!(found, mean, max_relative = 1e-13);
    }
    // Of another edge, of another contact, or shared by two edges, each is an element of its own.
    for (contact, shares) in [(0, vec![(1, 3.0)]), (1, vec![(0, 3.0)]), (0, vec![(0, 1.0), (1, 2.0)])] {
        (sample.points[1].contact, sample.points[1].shares) = (contact, shares);
        sample.edges = vec![edge(0), edge(1)];
        let problem = ContactProblem { compliance: vec![COMPLIANCE; 2], ..sample.problem() };
        let mut springs = problem.initial_springs();
        per(Spring::Element).next(&problem, &mut springs, &mut Work::default()).expect("definite");
        assert_relative_eq!(springs.stiffness[0] / sample.initial[0], own[0], max_relative = 1e-13);
    }
}

#[test]
fn second_steps_of_constant_stiffness_are_equation_three_six_and_its_literal_reading() {
    let sample = one(90.0);
    let second = |rule| {
        let (mut constant, mut springs) = (Constant::new(rule), sample.problem().initial_springs());
        next(&mut constant, &sample, &mut springs);
        (next(&mut constant, &sample, &mut springs), springs)
    };
    // (300 + 200) u = 90 − 2·8, p = 100 u + 8.
    let (found, springs) = second(StiffnessRule::Correction);
    assert_relative_eq!(found.displacement[0], 74.0 / 500.0, max_relative = 1e-14);
    assert_relative_eq!(found.pressure[0], 100.0 * 74.0 / 500.0 + 8.0, max_relative = 1e-14);
    assert_relative_eq!(springs.stiffness[0], 100.0);
    let (found, springs) = second(StiffnessRule::Literal);
    let w = (90.0 - 2.0 * 14.4) / 500.0;
    assert_relative_eq!(found.approach[0], w, max_relative = 1e-13);
    // k: 180 → 180 w/g, whose product with w is not the spring's force k₀ w + r.
    assert_relative_eq!(springs.force[0], 14.4 + 180.0 * (w / 0.1 - 1.0) * w, max_relative = 1e-12);
}

#[test]
fn hard_springs_hand_their_force_over_when_they_still_penetrate() {
    let sample = one(90.0);
    let hard = 1e6 * SCALE.stiffness;
    let mut kinematic = Kinematic::new(StiffnessRule::Switching, 1e-9);
    let mut springs = Springs { stiffness: vec![hard], force: vec![0.0] };
    let first = next(&mut kinematic, &sample, &mut springs);
    // 30/1e8 = 3e-7 mm deep, more than 1e-9 of 0.1 mm.
    assert_relative_eq!(springs.force[0], first.pressure[0]);
    assert_relative_eq!(springs.stiffness[0], hard);
    let second = next(&mut kinematic, &sample, &mut springs);
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
fn factors_of_the_rules_are_what_they_are_named_for() {
    use StiffnessRule::{Doubling, Secant, Squared, Step};
    // g_ref = 0.1: a fifth of it is 0.02.
    for (rule, approach, gap, factor) in [
        (Secant, 0.3, 0.1, 3.0),
        (Squared, 0.3, 0.1, 9.0),
        (Squared, -0.3, 0.1, 0.0),
        (Step, 0.13, 0.1, 2.5),
        (Step, 0.09, 0.1, 0.5),
        (Step, 0.07, 0.1, 0.0),
        (Doubling, 0.1001, 0.1, 2.0),
        (Doubling, 0.1, 0.1, 0.5),
    ] {
        assert_abs_diff_eq!(rule::factor(rule, &SCALE, approach, gap), factor, epsilon = 1e-12);
        assert!(rule::factor(rule, &SCALE, f64::NAN, gap).is_nan(), "{rule:?}");
    }
}

#[test]
fn correction_rule_adds_the_penetration_and_never_pulls() {
    assert_relative_eq!(rule::correction(5.0, 10.0, 0.3, 0.1), 7.0, max_relative = 1e-14);
    assert_relative_eq!(rule::correction(5.0, 10.0, 0.1, 0.3), 3.0, max_relative = 1e-14);
    assert_abs_diff_eq!(rule::correction(1.0, 10.0, 0.0, 0.3), 0.0, epsilon = 0.0);
    assert!(rule::correction(f64::NAN, 10.0, 0.0, 0.3).is_nan());
}
