//! What used to be called converged and was wrong is refused or noted; what is right is not.

use contact_vv::case::library::{Cylinder, Patch};
use contact_vv::case::notes::RESOLVED;
use contact_vv::case::{library, notes};
use contact_vv::error::{Error, Kind};
use contact_vv::mesh::{Mesh, Order, Resolution};
use contact_vv::scene::Scene;
use contact_vv::solve::{Discretisation, Element, Formulation, Iteration, Run};
use contact_vv::stability::conditioning;

use crate::workbench::{distance, meshed, resolution};

fn run(scene: Scene, elements: usize, order: Order, formulation: &Formulation) -> Result<Run, Error> {
    Run::of(&Discretisation::of(scene, resolution(elements, 0, order))?, formulation)
}

fn cylinder(stretch: f64) -> Scene {
    Cylinder { stretch, ..Cylinder::default() }.scene()
}

#[test]
fn contact_beyond_the_candidates_is_refused_by_every_formulation_with_place_depth_and_remedy() {
    for formulation in Formulation::nine() {
        let result = run(cylinder(0.7), 8, Order::Quadratic, &formulation);
        let Err(error) = result else {
            // Not converging claims nothing.
            assert!(result.is_ok_and(|run| !run.solution.converged()), "{}", formulation.name());
            continue;
        };
        let Kind::ContactBeyondCandidates { end, deepest: Some((position, penetration)) } = error.kind else {
            panic!("{}: {error}", formulation.name())
        };
        let a = Cylinder::default().half_width();
        let [end, position] = [end, position].map(|at| at.value());
        assert!((end / (0.7 * a) - 1.0).abs() < 1e-9);
        assert!(position > 0.7 * a && position < 1.3 * a, "{}: {position}", formulation.name());
        assert!(penetration > 1e-3 * a * a / 100.0 && penetration < 1e-2 * a, "{penetration}");
        let text = error.to_string();
        for part in ["`cylinder`", "1.75", "penetrate by", "widen the candidate stretch"] {
            assert!(text.contains(part), "`{part}` is missing in: {text}");
        }
    }
}

#[test]
fn contact_on_too_few_points_is_noted_and_contact_on_enough_is_not() {
    let verification = Formulation::verification();
    let coarse = run(Cylinder::default().scene(), 1, Order::Linear, &verification).expect("solvable");
    assert!(coarse.solution.converged() && coarse.measures().active < RESOLVED[0]);
    let note = notes::of(&coarse, 0).join("; ");
    assert!(note.contains(&format!("rests on {} of", coarse.measures().active)), "{note}");
    let fine = run(Cylinder::default().scene(), 8, Order::Quadratic, &verification).expect("solvable");
    assert!(fine.measures().active >= RESOLVED[0] && notes::of(&fine, 0).is_empty(), "{:?}", notes::of(&fine, 0));
    // A patch of two edges rests on all it has.
    let patch = run(Patch::default().scene(), 2, Order::Linear, &verification).expect("solvable");
    assert!(patch.measures().active < RESOLVED[0] && notes::of(&patch, 0).is_empty(), "{:?}", notes::of(&patch, 0));
}

#[test]
fn influence_of_gaps_is_reciprocal_and_does_not_depend_on_the_unit_of_length() {
    let of = |scene: Scene| {
        let discretisation = meshed(scene, 6, Order::Quadratic);
        let formulation = Formulation::new(Element::Node, Iteration::Kinematic);
        let points = discretisation.points(&formulation);
        let pressures: Vec<f64> =
            discretisation.solve(&formulation).expect("solved").points.iter().map(|point| point.pressure).collect();
        let found = conditioning::influence(&discretisation.problem(&formulation, &points), &pressures);
        let weights: Vec<f64> = points.iter().map(|point| point.weight).collect();
        (found.expect("contact holds the bodies"), weights)
    };
    let (millimetres, weights) = of(cylinder(2.0));
    let (metres, _) = of(cylinder(2.0).in_metres());
    assert!(millimetres.len() >= 4 && millimetres.len() == metres.len());
    for (k, (own, same)) in millimetres.iter().zip(&metres).enumerate() {
        let (i, itself) = own.of_gaps[k];
        assert!(itself < 0.0, "point {i} loses pressure where its gap widens: {itself}");
        for (l, ((j, m), (_, in_metres))) in own.of_gaps.iter().zip(&same.of_gaps).enumerate() {
            // Springs of 1e5 times the diagonal cost as many digits.
            let near = |a: f64, b: f64| (a - b).abs() <= 1e-7 * itself.abs();
            assert!(near(*m, in_metres * 1e-9), "{i}, {j}: {m} MPa/mm and {in_metres} Pa/m");
            let back = millimetres[l].of_gaps[k].1 * weights[*j] / weights[i];
            assert!(near(*m, back), "{i}, {j}: {m} and {back}");
        }
    }
}

#[test]
fn shaken_mesh_moves_inner_nodes_only_and_keeps_edges_straight() {
    for order in [Order::Linear, Order::Quadratic] {
        let scene = Patch::default().scene();
        let mesh = Mesh::of(&scene, resolution(4, 0, order)).expect("a mesh");
        let shaken = mesh.shaken(0.3);
        let outer: Vec<usize> =
            mesh.bodies.iter().flat_map(|b| b.boundaries.values().flatten().flatten().copied()).collect();
        let moved: Vec<usize> = (0..mesh.points.len()).filter(|&n| mesh.points[n] != shaken.points[n]).collect();
        assert!(!moved.is_empty() && moved.iter().all(|node| !outer.contains(node)));
        let side = scene.contact().stretch / 4.0;
        for &node in &moved {
            let (p, q) = (mesh.points[node], shaken.points[node]);
            assert!((p[0] - q[0]).hypot(p[1] - q[1]) <= 0.3 * side * (1.0 + 1e-9), "{node}");
        }
        for nodes in (0..shaken.cells()).map(|cell| shaken.cell(cell)) {
            for k in 0..nodes.len().saturating_sub(4) {
                let [p, q, mid] = [nodes[k], nodes[(k + 1) % 4], nodes[4 + k]].map(|node| shaken.points[node]);
                assert!(distance(&mid, &[0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])]) < 1e-12);
            }
        }
    }
}

#[test]
fn pin_cut_short_beyond_which_elements_are_too_large_to_see_it_is_refused() {
    for (name, cut) in [("pin-plate", 48.0_f64), ("pin-rod", 50.0)] {
        let known = library::find(name, None).expect("known");
        for growth in [1.2_f64, 1.7, 2.5, 4.0] {
            for elements in [4, 8, 16] {
                let mut scene = known.scene.clone();
                scene.contacts[0].stretch = cut.to_radians();
                (scene.grading.along, scene.grading.depth) = (growth, growth.min(3.5));
                scene.grading.coarsest = 1.0;
                let resolution = Resolution { elements, ..known.resolution };
                let discretisation = Discretisation::of(scene, resolution).expect("meshed");
                let error = discretisation.solve(&Formulation::verification()).expect_err("cut short");
                let text = error.to_string();
                assert!(text.contains("widen the candidate stretch"), "{name}, {growth}, {elements}: {text}");
            }
        }
    }
}
