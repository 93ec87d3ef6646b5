//! Each link of the chain on the cylinder at three sizes: `cargo bench`.

use contact_vv::algorithm::{Algorithm, Constant, ContactProblem, Kinematic, StiffnessRule, Varying};
use contact_vv::case::library::Cylinder;
use contact_vv::condensation::Plain;
use contact_vv::elasticity::{ElasticSystem, numbered};
use contact_vv::mesh::{Mesh, Order, Resolution};
use contact_vv::scene::Scene;
use contact_vv::solution::Work;
use contact_vv::solve::{Discretisation, Formulation};
use divan::{Bencher, black_box};

/// Times the default mesh is halved: about 2e3, 9e3 and 3e4 dofs.
const SIZES: [u32; 3] = [0, 1, 2];

fn main() {
    divan::main();
}

fn scene() -> Scene {
    Cylinder::default().scene()
}

fn resolution(refinement: u32) -> Resolution {
    Resolution { elements: 8, refinement, order: Order::Quadratic }
}

fn mesh(refinement: u32) -> Mesh {
    Mesh::of(&scene(), resolution(refinement)).expect("mesh")
}

fn system(refinement: u32) -> ElasticSystem {
    ElasticSystem::assemble(&scene(), &mesh(refinement)).expect("system")
}

fn discretised(refinement: u32) -> Discretisation {
    Discretisation::of(scene(), resolution(refinement)).expect("discretised")
}

#[divan::bench(args = SIZES)]
fn meshing(refinement: u32) -> Mesh {
    mesh(black_box(refinement))
}

#[divan::bench(args = SIZES)]
fn ordering(bencher: Bencher, refinement: u32) {
    let (scene, mesh) = (scene(), mesh(refinement));
    bencher.bench(|| numbered(&scene, &mesh).expect("numbered"));
}

#[divan::bench(args = SIZES)]
fn assembly(bencher: Bencher, refinement: u32) {
    let (scene, mesh) = (scene(), mesh(refinement));
    let numbered = || numbered(&scene, &mesh).expect("numbered");
    bencher.with_inputs(numbered).bench_values(|numbering| {
        ElasticSystem::assemble_numbered(&scene, &mesh, numbering, &|_| 1.0).expect("system")
    });
}

#[divan::bench(args = SIZES)]
fn factorisation_and_schur_complement(bencher: Bencher, refinement: u32) {
    let system = system(refinement);
    bencher.bench(|| system.condense().expect("condensed"));
}

#[divan::bench(args = SIZES)]
fn plain_sparse_cholesky(bencher: Bencher, refinement: u32) {
    let plain = Plain::of(&system(refinement).bodies[0]).expect("plain");
    bencher.bench(|| plain.solve().expect("solved"));
}

/// One step from springs all closed.
fn next(bencher: Bencher, refinement: u32, algorithm: impl Fn() -> Box<dyn Algorithm>) {
    let discretisation = discretised(refinement);
    let formulation = Formulation::verification();
    let points = discretisation.points(&formulation);
    let problem: ContactProblem = discretisation.problem(&formulation, &points);
    bencher.bench_local(|| {
        let mut springs = problem.initial_springs();
        algorithm().next(&problem, &mut springs, &mut Work::default()).expect("held")
    });
}

#[divan::bench(args = SIZES)]
fn step_varying(bencher: Bencher, refinement: u32) {
    next(bencher, refinement, || Box::new(Varying::new(StiffnessRule::Secant)));
}

#[divan::bench(args = SIZES)]
fn step_constant(bencher: Bencher, refinement: u32) {
    next(bencher, refinement, || Box::new(Constant::new(StiffnessRule::Correction)));
}

#[divan::bench(args = SIZES)]
fn step_kinematic(bencher: Bencher, refinement: u32) {
    next(bencher, refinement, || Box::new(Kinematic::new(StiffnessRule::Switching, 1e-8)));
}

#[divan::bench(args = SIZES)]
fn recovery(bencher: Bencher, refinement: u32) {
    let discretisation = discretised(refinement);
    let solution = discretisation.solve(&Formulation::verification()).expect("solved");
    bencher.bench(|| discretisation.condensed.recover(1.0, &solution.displacement));
}

#[divan::bench(args = SIZES)]
fn whole_solve(bencher: Bencher, refinement: u32) {
    bencher.bench(|| discretised(refinement).solve(&Formulation::verification()).expect("solved"));
}
