//! What a step solves and how it is judged: system matrix, equilibrium, residuals.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact_vv::algorithm::{ContactProblem, Iterate, Springs};
use contact_vv::solution::{Residuals, Work};

use crate::algorithm::{exact, two};
use crate::workbench::distance;

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

pub fn iterate_of(problem: &ContactProblem, displacement: [f64; 2], approach: [f64; 2], pressure: [f64; 2]) -> Iterate {
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
