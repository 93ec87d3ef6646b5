//! The fast ways give what the plain ones give, on meshes and systems that look random.

use contact_vv::algorithm::ContactProblem;
use contact_vv::algorithm::kept::KeptFactor;
use contact_vv::algorithm::settling::Settling;
use contact_vv::case::library::{Cylinder, PinRod};
use contact_vv::condensation::Plain;
use contact_vv::condensation::dense::DenseFactor;
use contact_vv::condensation::trailing::Trailing;
use contact_vv::elasticity::element::CellStiffness;
use contact_vv::elasticity::{ElasticSystem, Freedom, numbered};
use contact_vv::mesh::{Mesh, Order};
use contact_vv::scene::{Action, Component, Load, Scene};
use contact_vv::solution::{Solution, Work};
use contact_vv::solve::{Change, Discretisation, Element, Formulation, Iteration};
use faer::Mat;
use nalgebra::{DMatrix, DVector};

use crate::workbench::{ORDERS, block, dense, distance, held, library, meshed, noise, resolution};

/// Equations up to which a body is added densely.
const DENSE: usize = 1500;

/// Every scene of the library on a mesh that is shaken, mirrored or numbered backwards by turns.
fn samples() -> Vec<(String, Scene, Mesh)> {
    let mut samples = Vec::new();
    let mut number = noise(20);
    for (scene, elements) in library() {
        for order in ORDERS {
            let elements = elements + (1.5 * (number() + 1.0)) as usize;
            let mesh = Mesh::of(&scene, resolution(elements, 0, order)).expect("mesh");
            let name = |how: &str| format!("{}, {how}, {order:?}, {elements} elements", scene.name);
            samples.push((name("shaken"), scene.clone(), mesh.shaken(0.1 * (number() + 1.0))));
            samples.push((name("numbered backwards"), scene.clone(), mesh.renumbered()));
            samples.push((name("mirrored"), scene.mirrored(), mesh.mirrored()));
        }
    }
    samples
}

/// `K` and the forces of prescribed displacements, added cell by cell into a full matrix.
fn added_densely(scene: &Scene, mesh: &Mesh, body: usize, system: &ElasticSystem) -> (DMatrix<f64>, DVector<f64>) {
    let dofs = &system.bodies[body].dofs;
    let kernel = CellStiffness::new(mesh.order, &scene.bodies[body].material.stiffness(scene.plane), scene.thickness);
    let mut matrix = DMatrix::zeros(dofs.equations, dofs.equations);
    let mut force = DVector::zeros(dofs.equations);
    for cell in mesh.bodies[body].cells.clone() {
        let nodes = mesh.cell(cell);
        let mut k = vec![0.0; kernel.entries()];
        kernel.integrate(nodes.iter().map(|&n| mesh.points[n]), &mut k).expect("sound cell");
        dofs.rotate(nodes, &mut k);
        let of_cell: Vec<Freedom> = nodes.iter().flat_map(|&n| dofs.of_node(n)).collect();
        for (i, row) in of_cell.iter().enumerate() {
            let Freedom::Equation(row) = *row else { continue };
            for (j, column) in of_cell.iter().enumerate() {
                match *column {
                    Freedom::Equation(column) => matrix[(row, column)] += k[i * of_cell.len() + j],
                    Freedom::Prescribed(u) => force[row] -= k[i * of_cell.len() + j] * u,
                }
            }
        }
    }
    (matrix, force)
}

#[test]
fn matrix_and_forces_of_prescribed_displacements_are_those_added_densely() {
    let mut pulled = 0;
    for (name, mut scene, mesh) in samples() {
        scene.bodies.iter_mut().for_each(|body| body.loads.retain(is_tie));
        scene.bodies.iter_mut().for_each(|body| body.supports.iter_mut().for_each(|support| support.value = 0.01));
        let system = ElasticSystem::assemble(&scene, &mesh).expect("system");
        for (index, body) in system.bodies.iter().enumerate() {
            if body.dofs.equations > DENSE {
                continue;
            }
            let (matrix, force) = added_densely(&scene, &mesh, index, &system);
            let difference = (dense(body) - &matrix).amax();
            assert!(difference <= 1e-13 * matrix.amax(), "{name}: {difference:e}");
            let free = |list: &[f64]| -> Vec<f64> {
                (0..list.len()).filter(|&e| !is_tied(body, e)).map(|e| list[e]).collect()
            };
            let apart = distance(&free(&body.force), &free(force.as_slice()));
            assert!(apart <= 1e-12 * force.amax().max(1.0), "{name}: {apart:e}");
            pulled += usize::from(force.amax() > 1.0);
        }
    }
    assert!(pulled > 20, "only {pulled} bodies were pulled at all");
}

fn is_tie(load: &Load) -> bool {
    matches!(load, Load::RigidFace { .. })
}

/// Whether several components share an equation; a rigid face carries its own load there.
fn is_tied(body: &contact_vv::elasticity::BodySystem, equation: usize) -> bool {
    body.dofs.components.iter().flatten().filter(|dof| dof.equation() == Some(equation)).count() > 1
}

#[test]
fn every_unknown_has_one_number_and_the_candidates_have_the_last_ones() {
    for (name, scene, mesh) in samples() {
        let system = ElasticSystem::assemble(&scene, &mesh).expect("system");
        for (body, part) in system.bodies.iter().zip(&mesh.bodies) {
            let dofs = &body.dofs;
            let mut numbers = dofs.in_mesh_order();
            numbers.sort_unstable();
            assert!(numbers.iter().copied().eq(0..dofs.equations), "{name}");
            let normals = part.candidates.iter().map(|candidate| dofs.of_node(candidate.node)[0].equation());
            let last = dofs.equations - part.candidates.len()..dofs.equations;
            assert!(normals.eq(last.map(Some)), "{name}");
        }
    }
}

#[test]
fn elimination_and_recovery_solve_what_the_library_solves_by_itself() {
    for (name, scene, mesh) in samples() {
        let system = ElasticSystem::assemble(&scene, &mesh).expect("system");
        let condensed = system.condense().expect("condensed");
        let plain: Vec<Vec<f64>> = (system.bodies.iter())
            .map(|body| Plain::of(body).and_then(|plain| plain.solve()).expect("definite"))
            .collect();
        let retained: Vec<f64> =
            (system.bodies.iter().zip(&plain)).flat_map(|(body, u)| u[body.dofs.retained.clone()].to_vec()).collect();
        for (found, wanted) in condensed.recover(1.0, &retained).iter().zip(&plain) {
            let size = wanted.iter().fold(1e-30, |a: f64, u| a.max(u.abs()));
            assert!(distance(found, wanted) <= 1e-9 * size, "{name}: {:e}", distance(found, wanted) / size);
        }
    }
}

#[test]
fn one_thread_and_two_assemble_the_same_bits() {
    let (scene, _) = &library()[5];
    for order in ORDERS {
        // Large enough to be assembled in halves.
        let mesh = Mesh::of(scene, resolution(10, 2, order)).expect("mesh");
        let [one, two] = [1, 2].map(|threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
            pool.install(|| ElasticSystem::assemble(scene, &mesh).expect("system"))
        });
        assert!(mesh.cells() > 2000, "{}", mesh.cells());
        assert!(distance(one.bodies[0].stiffness.val(), two.bodies[0].stiffness.val()) <= 0.0);
        assert!(distance(&one.bodies[0].force, &two.bodies[0].force) <= 0.0);
    }
}

#[test]
fn halves_of_a_large_body_add_up_to_the_matrix_that_is_added_densely() {
    let supports = vec![held("left", Component::X, 0.01), held("far", Component::Y, -0.02)];
    let scene = block([4.0, 3.0], supports, vec![]);
    let mesh = Mesh::of(&scene, resolution(40, 0, Order::Linear)).expect("mesh");
    assert!(mesh.cells() > 1024, "too small to be halved: {} cells", mesh.cells());
    let numbering = numbered(&scene, &mesh).expect("numbered");
    let system = ElasticSystem::assemble_numbered(&scene, &mesh, numbering, &|_| 1.0).expect("system");
    for index in 0..system.bodies.len() {
        let (wanted, force) = added_densely(&scene, &mesh, index, &system);
        assert!((dense(&system.bodies[index]) - &wanted).amax() <= 1e-13 * wanted.amax());
        assert!(distance(&system.bodies[index].force, force.as_slice()) <= 1e-13 * force.amax() && force.amax() > 0.0);
    }
}

#[test]
fn update_that_leaves_nothing_of_a_pivot_gives_no_factor() {
    let factor = DenseFactor::new(&Mat::from_fn(2, 2, |i, j| if i == j { 1.0 } else { 0.0 })).expect("definite");
    assert!(factor.clone().updated(&[(-1.0, &[(1, 1.0)])]).is_none());
    assert!(factor.clone().updated(&[(-2.0, &[(0, 1.0)])]).is_none());
    assert!(factor.clone().updated(&[(f64::NAN, &[(0, 1.0)])]).is_none());
    assert!(factor.updated(&[(-0.5, &[(0, 1.0)])]).is_some());
}

#[test]
fn factor_of_which_the_last_rows_change_is_none_where_they_make_it_indefinite_or_no_number() {
    let matrix = Mat::from_fn(6, 6, |i, j| if i == j { 4.0 } else { 1.0 });
    let (changing, place) = ([false, false, false, true, true, true], [(3, 1.0), (5, 0.5)]);
    let of = |delta: f64| Trailing::of(&matrix, &changing, [(delta, &place[..])].into_iter());
    let mut sound = of(1.0).expect("definite");
    for spoiled in [-1e3, f64::NAN] {
        assert!(of(spoiled).is_none(), "{spoiled}");
        assert!(!sound.renew([(spoiled, &place[..])].into_iter()), "{spoiled}");
    }
}

#[test]
fn springs_that_come_to_rest_are_eliminated_once_and_solved_as_if_factorised_anew() {
    let discretisation = large();
    for element in Element::ALL {
        let formulation = Formulation::new(element, Iteration::Varying);
        let points = discretisation.points(&formulation);
        let problem: ContactProblem = discretisation.problem(&formulation, &points);
        let (mut springs, mut kept, mut number) = (problem.initial_springs(), Settling::default(), noise(5));
        let mut work = Work::default();
        for step in 0..60 {
            // Those of the far half come to rest one after the other; the others move, and one of the first stirs
            // again.
            let moving = points.len().saturating_sub(step * points.len() / 40).max(points.len() / 4);
            springs.stiffness[..moving].iter_mut().for_each(|k| *k *= 1.0 + 0.3 * number());
            if step % 17 == 16 {
                *springs.stiffness.last_mut().expect("points") *= 0.5;
            }
            let fresh = problem.factorise(&springs.stiffness, &mut Work::default()).expect("held");
            let wanted = problem.equilibrium(&fresh, &springs, |_| 0.0, &mut Work::default());
            let factor = kept.renew(&problem, &springs.stiffness, &mut work).expect("held");
            let found = problem.equilibrium(factor, &springs, |_| 0.0, &mut Work::default());
            let largest = wanted.pressure.iter().fold(0.0, |a: f64, p| a.max(p.abs()));
            let apart = distance(&found.pressure, &wanted.pressure);
            assert!(apart <= 1e-10 * largest, "{element:?}, step {step}: {:e}", apart / largest);
        }
        assert_eq!(work.factorisations, 60);
        let whole = 60.0 * (problem.load.len() as f64).powi(3) / 3.0;
        assert!(work.operations < 0.6 * whole, "{element:?}: {:.2} of {whole:e}", work.operations / whole);
        // The last spring opened: nothing is left to hold the body.
        assert!(kept.renew(&problem, &vec![0.0; points.len()], &mut work).is_none());
    }
}

#[test]
fn several_solutions_are_recovered_at_once_as_one_by_one() {
    for (scene, elements) in [(Cylinder::default().scene(), 6), (PinRod::default().scene(), 8)] {
        let discretisation = meshed(scene, elements, Order::Quadratic);
        let condensed = &discretisation.condensed;
        let mut number = noise(13);
        let retained: Vec<Vec<f64>> = (0..4).map(|_| (0..condensed.retained()).map(|_| number()).collect()).collect();
        let all = condensed.recover_all(1.0, &retained.iter().map(Vec::as_slice).collect::<Vec<_>>());
        for (k, one) in retained.iter().enumerate() {
            for (body, wanted) in all.iter().zip(condensed.recover(1.0, one)) {
                assert!(distance(&body[k], &wanted) <= 0.0, "solution {k}");
            }
        }
    }
}

/// A contact with more than 256 retained dofs, where factors are updated.
fn large() -> Discretisation {
    let scene = Cylinder::default().scene();
    Discretisation::of(scene, resolution(10, 3, Order::Quadratic)).expect("discretised")
}

#[test]
fn springs_that_open_and_close_a_few_at_a_time_are_solved_as_if_factorised_anew() {
    let discretisation = large();
    let formulation = Formulation::verification();
    let points = discretisation.points(&formulation);
    let problem: ContactProblem = discretisation.problem(&formulation, &points);
    let (mut springs, mut kept, mut number) = (problem.initial_springs(), KeptFactor::default(), noise(3));
    let mut work = Work::default();
    for step in 0..12 {
        for _ in 0..=step {
            let at = ((number() + 1.0) / 2.0 * (points.len() - 1) as f64) as usize;
            let k = &mut springs.stiffness[at];
            *k = if *k > 0.0 { 0.0 } else { problem.scale.hard() };
        }
        let fresh = problem.factorise(&springs.stiffness, &mut Work::default()).expect("held");
        let wanted = problem.equilibrium(&fresh, &springs, |p| p.gap, &mut Work::default());
        let factor = kept.renew(&problem, &springs.stiffness, &mut work).expect("held");
        let found = problem.equilibrium(factor, &springs, |p| p.gap, &mut Work::default());
        let largest = wanted.pressure.iter().fold(0.0, |a: f64, p| a.max(p.abs()));
        let apart = distance(&found.pressure, &wanted.pressure);
        assert!(apart <= 1e-7 * largest, "step {step}: {:e}", apart / largest);
    }
    assert!(work.updates > 40 && work.factorisations < 6, "{work:?}");
}

#[test]
fn another_load_and_clearance_are_solved_as_the_changed_scene_is() {
    let formulation = Formulation::verification();
    let pressures = |solution: &Solution| solution.points.iter().map(|point| point.pressure).collect::<Vec<f64>>();
    for (scene, elements) in [(Cylinder::default().scene(), 8), (PinRod::default().scene(), 12)] {
        let discretisation = meshed(scene.clone(), elements, Order::Quadratic);
        let earlier = discretisation.solve(&formulation).expect("solved");
        for (load, clearance) in [(1.0, 0.0), (0.8, 0.0), (1.1, 0.02 * scene.reference.gap)] {
            let change = Change { load, clearance };
            let again = discretisation.solve_from(Some(&earlier), &formulation, change).expect("solved again");
            let mut changed = meshed(under(&scene, load), elements, Order::Quadratic);
            changed.interfaces[0].nodes.iter_mut().for_each(|node| node.gap += clearance);
            let wanted = pressures(&changed.solve(&formulation).expect("solved"));
            let size = wanted.iter().fold(0.0, |a: f64, p| a.max(p.abs()));
            // Hard springs may penetrate by 1e-6 of the reference gap, from either side.
            let apart = distance(&pressures(&again), &wanted) / size;
            assert!(again.converged() && apart <= 1e-5, "{}, {load}, {clearance}: {apart:e}", scene.name);
        }
    }
}

/// A scene whose loads are multiplied before anything is assembled.
fn under(scene: &Scene, factor: f64) -> Scene {
    let mut changed = scene.clone();
    for applied in changed.bodies.iter_mut().flat_map(|body| &mut body.loads) {
        match applied {
            Load::OnSide { action: Action::Uniform(traction), .. } => traction.iter_mut().for_each(|t| *t *= factor),
            Load::RigidFace { force, .. } => *force *= factor,
            other => panic!("{other:?} is not expected here"),
        }
    }
    changed
}

#[test]
fn change_that_is_no_number_or_that_the_formulation_cannot_take_is_refused() {
    let scene = Cylinder::default().scene();
    let discretisation = meshed(scene, 4, Order::Quadratic);
    let solve = |formulation: &Formulation, load, clearance| {
        let earlier = discretisation.solve(formulation).expect("solved");
        let again = discretisation.solve_from(Some(&earlier), formulation, Change { load, clearance });
        again.map(|_| ()).expect_err("refused").to_string()
    };
    let kinematic = Formulation::new(Element::Node, Iteration::Kinematic);
    assert!(solve(&kinematic, f64::NAN, 0.0).contains("load factor"));
    assert!(solve(&kinematic, 1.0, f64::INFINITY).contains("clearance"));
    assert!(solve(&kinematic, 0.0, 0.0).contains("`cylinder`"));
    let varying = Formulation::new(Element::Node, Iteration::Varying);
    assert!(solve(&varying, 1.0, -0.01).contains("interference"));
    // What a formula leaves where the bodies just touch is none.
    let earlier = discretisation.solve(&varying).expect("solved");
    let round_off = Change { load: 1.0, clearance: -1e-18 };
    assert!(discretisation.solve_from(Some(&earlier), &varying, round_off).is_ok());
}
