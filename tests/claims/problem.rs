//! What an iteration solves: system matrix and equilibrium.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact_vv::algorithm::{ContactProblem, Iterate, Springs};
use contact_vv::solution::Work;

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
    let internal = problem.stiffness.times(&displacement);
    Iterate { displacement: displacement.to_vec(), approach: approach.to_vec(), pressure: pressure.to_vec(), internal }
}
