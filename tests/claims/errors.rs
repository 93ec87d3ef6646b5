//! Wrong input is refused in words that name the place, the key, the value found and the remedy.

use std::path::Path;

use contact_vv::case::Case;
use contact_vv::case::library::{self, Cylinder, FlatPunch, Patch, PinRod};
use contact_vv::checkout::root;
use contact_vv::elasticity::ElasticSystem;
use contact_vv::error::{Error, Kind};
use contact_vv::mesh::{Mesh, Order, Resolution};
use contact_vv::scene::{Action, Component, Load, Scene, Support, VectorField};
use contact_vv::solve::{Discretisation, Element, Formulation, Iteration, Run};
use contact_vv::stability::conditioning;
use contact_vv::study::{Study, limits};

use crate::workbench::{block, distance, held, held_at, meshed, refused, resolution};

fn coarse(scene: &Scene) -> Result<Mesh, Error> {
    Mesh::of(scene, resolution(2, 0, Order::Linear))
}

#[test]
fn scene_values_that_are_not_positive_and_finite_are_refused() {
    type Spoil = fn(&mut Scene, f64);
    let keys: [(&str, Spoil); 6] = [
        ("thickness", |scene, x| scene.thickness = x),
        ("reference length", |scene, x| scene.reference.length = x),
        ("reference pressure", |scene, x| scene.reference.pressure = x),
        ("reference gap", |scene, x| scene.reference.gap = x),
        ("candidate stretch", |scene, x| scene.contacts[0].stretch = x),
        ("young", |scene, x| scene.bodies[1].material.young = x),
    ];
    for (key, spoil) in keys {
        for value in [0.0, -3.5, f64::NAN, f64::INFINITY] {
            let mut scene = Patch::default().scene();
            spoil(&mut scene, value);
            let body = if key == "young" { "patch, body `lower`" } else { "patch" };
            refused(coarse(&scene), &[body, &format!("`{key}` = {value}"), "above 0", "give a positive number"]);
        }
    }
}

#[test]
fn poisson_ratio_of_one_half_is_refused_in_plane_strain_only() {
    let with = |poisson: f64, plane| {
        let mut scene = Patch::default().scene();
        scene.plane = plane;
        scene.bodies[0].material.poisson = poisson;
        coarse(&scene)
    };
    use contact_vv::scene::PlaneHypothesis::{Strain, Stress};
    for (poisson, plane, limit) in [
        (0.49991, Strain, "at most 0.4999"),
        (0.5, Strain, "at most 0.4999"),
        (-1.0, Strain, "-1"),
        (1.0, Stress, "1"),
        (f64::NAN, Stress, "1"),
    ] {
        refused(
            with(poisson, plane),
            &["body `upper`", &format!("`poisson` = {poisson}"), limit, "use for instance 0.3"],
        );
    }
    for (poisson, plane) in [(0.5, Stress), (0.4999, Strain), (0.0, Strain), (-0.5, Stress)] {
        assert!(with(poisson, plane).is_ok(), "{poisson} in {plane:?}");
    }
}

#[test]
fn resolution_out_of_range_is_refused() {
    let scene = Cylinder::default().scene();
    for (elements, refinement) in [(0, 0), (5000, 0)] {
        let mesh = Mesh::of(&scene, resolution(elements, refinement, Order::Linear));
        refused(mesh, &["cylinder", &format!("`resolution` = {elements}"), "between 1 and 4096", "use 8 to 32"]);
    }
    assert!(Mesh::of(&scene, resolution(1, 7, Order::Linear)).is_err());
}

#[test]
fn supports_and_loads_that_have_no_place_or_meet_the_contact_are_refused_with_what_there_is() {
    let left = || vec![held("left", Component::X, 0.0)];
    let loaded = |load: Load| block([4.0, 3.0], left(), vec![load]);
    let supported = |supports: Vec<Support>| block([4.0, 3.0], supports, vec![]);
    let field = VectorField::of(|_| [0.0; 3]);
    let face = |side: &'static str, component| Load::RigidFace { boundary: side.into(), component, force: 1.0 };
    let mut oblique = PinRod::default().scene();
    oblique.bodies[0].supports.push(held("contact", Component::X, 0.0));
    let roof: &[&str] = &["sample, body `body`", "no boundary `roof`", "contact, far, left, right"];
    let end = "end the candidate stretch before that node";
    let cases: [(Scene, &[&str]); 9] = [
        (supported(vec![held("roof", Component::X, 0.0)]), roof),
        (loaded(Load::on("roof", Action::Uniform([0.0; 2]))), roof),
        (loaded(Load::on("roof", Action::Stress(field))), roof),
        (loaded(face("roof", Component::Y)), roof),
        (
            supported(vec![held_at([1.25, 0.77], Component::X, 0.0)]),
            &["sample, body `body`", "no node at `(1.25, 0.77)`", "corners of the outline"],
        ),
        (
            loaded(Load::Force { at: [4.25, 0.77], force: [1.0, 0.0] }),
            &["sample, body `body`", "no cell around `(4.25, 0.77)`", "corners of the outline"],
        ),
        (
            supported([left(), vec![held("contact", Component::Y, 0.0)]].concat()),
            &["`body`", "`contact`, `y`", "at node", end],
        ),
        (oblique, &["`pin`", "`x`", "at node", end]),
        // The corner belongs to both: its frame follows the contact normal, the face's common dof the x axis.
        (loaded(face("right", Component::X)), &["`body`", "`rigid face`", end]),
    ];
    for (scene, parts) in cases {
        let mesh = Mesh::of(&scene, resolution(2, 0, Order::Linear)).expect("mesh");
        refused(ElasticSystem::assemble(&scene, &mesh), parts);
    }
}

#[test]
fn degenerate_cell_is_refused_with_its_body_and_determinant() {
    let scene = block([4.0, 3.0], vec![held("left", Component::X, 0.0)], vec![Load::BodyForce([0.0, -1.0])]);
    let mut mesh = Mesh::of(&scene, resolution(2, 0, Order::Linear)).expect("mesh");
    mesh.connectivity[4..8].reverse();
    let parts = ["cell 1", "`body`", "Jacobian determinant -", "grading gentler"];
    refused(ElasticSystem::assemble(&scene, &mesh), &parts);
}

fn discretised(scene: Scene) -> Discretisation {
    meshed(scene, 4, Order::Quadratic)
}

#[test]
fn formulation_values_out_of_range_are_refused() {
    type Spoil = fn(&mut Formulation, f64);
    let keys: [(&str, Spoil); 3] = [
        ("stiffness", |formulation, x| formulation.stiffness = x),
        ("tolerance", |formulation, x| formulation.settings.tolerance = x),
        ("layer thickness", |formulation, x| formulation.layer_thickness = x),
    ];
    let patch = discretised(Patch::default().scene());
    let mut none = Formulation::verification();
    none.settings.increments = 0;
    refused(
        patch.solve(&none),
        &["patch with node.kinematic", "`increments` = 0", "at least 1", "use 1 for the whole load"],
    );
    for (key, spoil) in keys {
        for value in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            let mut formulation = Formulation::new(Element::Layer, Iteration::Varying);
            spoil(&mut formulation, value);
            let found = format!("`{key}` = {value}");
            let parts = ["patch with layer.varying", &found, "above 0", "give a positive number"];
            refused(patch.solve(&formulation), &parts);
        }
    }
}

#[test]
fn bodies_pulled_apart_are_named_on_every_mesh() {
    // What is left of the rigid motion's stiffness is round-off of either sign; neither may pass for a support.
    for elements in [1, 2, 4, 8, 12] {
        let mut cylinder = Cylinder::default().scene();
        cylinder.bodies[0].loads = vec![Load::on("cut", Action::Uniform([0.0, 5.0]))];
        let mut punch = FlatPunch::default().scene();
        punch.bodies[0].loads = vec![Load::on("far", Action::Uniform([0.0, 5.0]))];
        for (scene, body) in [(cylinder, "`cylinder`"), (punch, "`block`")] {
            let sample = meshed(scene, elements, Order::Quadratic);
            let error = sample.solve(&Formulation::verification()).map(|_| ()).expect_err("the load lifts the body");
            refused(Err::<(), _>(error.clone()), &[body, "no contact spring is left", "reverse the load"]);
            assert!(error.remedy.starts_with("reverse the load") && !error.message.contains("reverse"), "{error}");
        }
    }
}

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
        refused(Err::<(), _>(error), &["`cylinder`", "1.75", "penetrate by", "widen the candidate stretch"]);
    }
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
fn a_gap_that_falls_beyond_the_candidates_is_named_where_surfaces_meet_there() {
    let text = std::fs::read_to_string(root().join("tests/data/wild/tiny.toml")).expect("a scene");
    let solved = |gap: &str| {
        let text = text.replace("parabola = 1000", gap).replace("oracle = ", "# oracle = ");
        Case::parse(Path::new("tiny.toml"), &text).expect("a case").solve()
    };
    // 5e-4 s² − 1e-5 s⁴ is negative beyond s = √50.
    let falls = solved("powers = [[5e-4, 2], [-1e-5, 4]]");
    refused(falls, &["the gap falls beyond the candidates, to -", "correct it"]);
    let rises = refused(solved("parabola = 10000"), &["widen the candidate stretch"]);
    assert!(!rises.contains("falls"), "{rises}");
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
                refused(discretisation.solve(&Formulation::verification()), &["widen the candidate stretch"]);
            }
        }
    }
}

#[test]
fn body_that_nothing_supports_is_refused_by_all_nine_without_a_load_and_by_six_under_one_that_pulls_it_off() {
    let limit = |name: &str| {
        let planned = limits::Numbers::plan().into_iter().find(|planned| planned.name == name);
        planned.expect("a limit").run().expect("run")
    };
    let no_load = limit("zero load");
    assert!(no_load.onset.starts_with("zero: 9 of 9 formulations refuse the cylinder"), "{}", no_load.onset);
    // Constant stiffness never opens a spring: its three end at the cap.
    let pulled = limit("supported by contact alone").seen;
    assert!(pulled.starts_with("6 of 9: ") && pulled.contains("; 3: "), "{pulled}");
}

#[test]
fn springs_that_are_lost_in_round_off_hold_once_they_are_raised_as_told() {
    let made = meshed(Cylinder::default().scene(), 4, Order::Quadratic);
    let with = |stiffness: f64| {
        let formulation = Formulation { stiffness, ..Formulation::new(Element::Node, Iteration::Varying) };
        Run::of(&made, &formulation).map(|_| ())
    };
    let error = with(1e-12).expect_err("only contact holds the cylinder");
    assert!(error.kind == Kind::SpringsTooSoft, "{error}");
    let told = error.remedy.strip_prefix("raise `stiffness` ").and_then(|rest| rest.split(' ').next());
    let times: f64 = told.and_then(|times| times.parse().ok()).unwrap_or_else(|| panic!("{error}"));
    // A hundred times as stiff as hold: that is for digits.
    assert!(with(1e-12 * times).is_ok() && with(0.0101 * 1e-12 * times).is_ok(), "{error}");
}
