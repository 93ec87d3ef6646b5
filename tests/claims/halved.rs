//! Meshes that are given are halved on their circles, and an accuracy is met with them and with several contacts.

use std::sync::Arc;

use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact_vv::accuracy::{self, Asked};
use contact_vv::case::library::{Cylinder, CylinderModel, TruncatedHertz};
use contact_vv::mesh::{Mesh, Order, Resolution};
use contact_vv::scene::{Curve, GivenMesh, Scene, Shape};
use contact_vv::solve::Formulation;
use contact_vv::study::random::{Family, Site};

use crate::outputs::{contact_vv, json, scene};
use crate::scene_file::text_of;
use crate::workbench::{parsed, resolution};

/// The first body of a scene with the mesh it would have, as if that had been made elsewhere.
fn brought(mut scene: Scene, resolution: Resolution) -> Scene {
    let mesh = Mesh::of(&scene, resolution).expect("meshed").given(0);
    scene.bodies[0].shape = Shape::Given(Arc::new(mesh));
    scene
}

fn given(scene: &Scene) -> &GivenMesh {
    match &scene.bodies[0].shape {
        Shape::Given(mesh) => mesh,
        other => panic!("{other:?}"),
    }
}

fn halved(order: Order, refinement: u32) -> Resolution {
    Resolution { refinement, ..resolution(1, 0, order) }
}

#[test]
fn outline_on_a_circle_is_seen_and_nothing_else_is() {
    for order in [Order::Linear, Order::Quadratic] {
        let cylinder = Cylinder { model: CylinderModel::Half, ..Default::default() };
        let scene = brought(cylinder.scene(), resolution(4, 0, order));
        let mesh = given(&scene);
        let arcs = mesh.arcs();
        for name in ["contact", "top"] {
            // A turn of half a radian or more from chord to chord is a corner.
            let round = mesh.boundaries[name].iter().filter(|edge| arcs.contains_key(&[edge[0], edge[1]])).count();
            assert!(round + 1 >= mesh.boundaries[name].len(), "{order:?}, {name}: {round}");
        }
        for centre in arcs.values() {
            assert_abs_diff_eq!(centre[0], 0.0, epsilon = 1e-6 * cylinder.radius);
            assert_relative_eq!(centre[1], cylinder.radius, max_relative = 1e-6);
        }
        assert!(mesh.boundaries["axis"].iter().all(|edge| !arcs.contains_key(&[edge[0], edge[1]])));
        let curves = mesh.curves("contact").expect("there");
        assert!(curves.iter().filter(|curve| matches!(curve, Curve::Arc { .. })).count() + 1 >= curves.len());
        assert!(mesh.curves("middle").is_none(), "a line inside");
        assert!(mesh.curves("elsewhere").is_none());
    }
    // The corners of a square lie on a circle, and so do those of a flat between two bevels.
    let square = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let bevelled =
        vec![[-2.0, 0.1], [-1.0, 0.0], [1.0, 0.0], [2.0, 0.1], [2.0, 2.0], [1.0, 2.0], [-1.0, 2.0], [-2.0, 2.0]];
    for (points, cells, contact) in [
        (square, vec![vec![0, 1, 2, 3]], vec![vec![0, 1]]),
        (
            bevelled,
            vec![vec![0, 1, 6, 7], vec![1, 2, 5, 6], vec![2, 3, 4, 5]],
            vec![vec![0, 1], vec![1, 2], vec![2, 3]],
        ),
    ] {
        let boundaries = [("contact".into(), contact)].into();
        let (half_told, inner) = Default::default();
        let mesh = GivenMesh { points, cells, boundaries, half_told, inner, turned: 0, rounding: 0.0 };
        assert!(mesh.arcs().is_empty(), "{:?}", mesh.points);
    }
}

#[test]
fn halving_keeps_boundaries_and_lines_and_goes_to_the_circle() {
    let cylinder = Cylinder { model: CylinderModel::Half, ..Default::default() };
    for order in [Order::Linear, Order::Quadratic] {
        let scene = brought(cylinder.scene(), resolution(4, 0, order));
        let coarse = Mesh::of(&scene, halved(order, 0)).expect("meshed");
        for times in 1..=2_u32 {
            let mesh = Mesh::of(&scene, halved(order, times)).expect("meshed");
            assert_eq!(mesh.cells(), coarse.cells() << (2 * times));
            let names = |mesh: &Mesh| -> Vec<(String, usize)> {
                let own = &mesh.bodies[0];
                let all = own.boundaries.iter().chain(&own.lines);
                let mut all: Vec<_> = all.map(|(name, edges)| (name.to_string(), edges.len())).collect();
                all.sort();
                all
            };
            let wanted: Vec<_> = names(&coarse).into_iter().map(|(name, edges)| (name, edges << times)).collect();
            assert_eq!(names(&mesh), wanted);
            let on_circle = |node: &usize| {
                let [x, y] = mesh.points[*node];
                (x.hypot(y - cylinder.radius) / cylinder.radius - 1.0).abs() < 1e-9
            };
            // All but what lies on the one chord that is a corner.
            let nodes: Vec<usize> = mesh.bodies[0].boundaries["contact"].iter().flatten().copied().collect();
            let off = nodes.iter().filter(|node| !on_circle(node)).count();
            let on_chord = mesh.bodies[0].boundaries["contact"][0].len() << times;
            assert!(off <= on_chord, "{order:?}, {times}: {off} of {}", nodes.len());
            let axis = mesh.boundary(&scene, 0, "axis").expect("there");
            assert!(axis.iter().flatten().all(|node| mesh.points[*node][0].abs() < 1e-9));
        }
    }
}

#[test]
fn given_mesh_halved_is_the_drawn_mesh_halved() {
    let site = Site { family: Family::Polynomial, number: 4 };
    let drawn = site.sample().expect("a scene").scene;
    for order in [Order::Linear, Order::Quadratic] {
        let scene = brought(drawn.clone(), resolution(3, 0, order));
        let given = Mesh::of(&scene, halved(order, 2)).expect("meshed");
        let wanted = Mesh::of(&drawn, Resolution { refinement: 2, ..resolution(3, 0, order) }).expect("meshed");
        let sorted = |mesh: &Mesh| {
            let mut points = mesh.points.clone();
            points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
            points
        };
        let size = wanted.points.iter().flatten().fold(0.0_f64, |size, x| size.max(x.abs()));
        assert_eq!(given.points.len(), wanted.points.len());
        // Rounding must not change the order of neighbours.
        let rounded = |mesh: &Mesh| -> Vec<[i64; 2]> {
            let mut all: Vec<_> =
                sorted(mesh).iter().map(|point| point.map(|x| (1e7 * x / size).round() as i64)).collect();
            all.sort_unstable();
            all
        };
        for (a, b) in rounded(&given).iter().zip(&rounded(&wanted)) {
            assert!(a[0].abs_diff(b[0]) <= 1 && a[1].abs_diff(b[1]) <= 1, "{a:?} {b:?}");
        }
    }
}

#[test]
fn scene_files_with_meshes_and_several_contacts_may_ask_for_an_accuracy() {
    let several = text_of("plate-on-two-supports.toml").replace("elements = 16\nper = 0.8", "accuracy = \"1 %\"");
    let file = parsed(&several);
    assert!(file.accuracy.is_some());
    for (name, asked) in [
        ("cylinder-between-blocks", "0.3 %"),
        ("roller-between-plates", "0.3 %"),
        ("three-rings", "0.02 %"),
        ("rings-from-gmsh", "0.1 %"),
    ] {
        let json = json(&["solve", &scene(name), "--accuracy", asked]);
        assert!(json["accuracy"]["met"] == true, "{name}: {json}");
        let quantities = json["accuracy"]["quantities"].as_array().expect("a list");
        assert_eq!(quantities.len(), 2 * json["contacts"].as_array().expect("a list").len());
    }
}

#[test]
fn accuracy_out_of_reach_is_said_not_to_be_met_with_the_best_that_was_found() {
    let (sound, table, _) = contact_vv(&["solve", &scene("three-rings"), "--accuracy", "0.001 %"]);
    assert_eq!(sound, !table.contains("NOT met"), "{table}");
    // 4-node cells whose number is limited.
    let mut asked = Asked::new(1e-5);
    asked.most_cells = 2e4;
    let scene = brought(Cylinder::default().scene(), resolution(4, 0, Order::Linear));
    let answer = accuracy::solve(&scene, &Formulation::verification(), &asked).expect("solved");
    let why = answer.unmet.clone().expect("not met");
    assert!(why.contains("cells") && answer.estimate() > 1e-5, "{why}");
}

#[test]
fn contact_that_stays_open_meets_nothing_and_neighbours_share_no_node() {
    let text = text_of("plate-on-two-supports.toml").replace("elements = 16\nper = 0.8", "accuracy = \"1 %\"");
    let file = parsed(&text);
    let mut near = file.scene;
    let apart = (near.contacts[0].path.origin()[0] - near.contacts[1].path.origin()[0]).abs();
    let reach: f64 = near.contacts.iter().map(|pair| accuracy::longest::longest(&near, pair)).sum();
    assert!(reach < apart, "{reach} of {apart}");
    // Nothing presses.
    near.bodies.iter_mut().for_each(|body| body.loads.clear());
    if let Ok(answer) = accuracy::solve(&near, &Formulation::verification(), &Asked::new(1e-2)) {
        assert!(answer.unmet.is_some());
    }
}

#[test]
fn several_contacts_are_found_from_guesses_ten_times_too_long_or_too_short() {
    let text = text_of("plate-on-two-supports.toml").replace("elements = 16\nper = 0.8", "accuracy = \"3 %\"");
    let widths = ["0.1", "1.0", "20"].map(|guess| {
        let scene = parsed(&text.replace("stretch = 1.0", &format!("stretch = {guess}"))).scene;
        let answer = accuracy::solve(&scene, &Formulation::verification(), &Asked::new(3e-2)).expect("solved");
        assert!(answer.unmet.is_none(), "{guess}: {:?}", answer.unmet);
        assert!(answer.tried.iter().all(|tried| tried.dofs < 20_000), "{guess}: {:?}", answer.tried);
        [0, 1].map(|contact| {
            let (half_width, pair) =
                (answer.run.contacts[contact].measures.half_width(), &answer.scene.contacts[contact]);
            // Candidates go as far beyond what was found on a cheap mesh as that is wide.
            assert!((1.2..2.3).contains(&(pair.stretch / half_width)), "{guess}: {} {half_width}", pair.stretch);
            half_width
        })
    });
    for [left, right] in widths {
        assert_relative_eq!(left, widths[1][0], max_relative = 3e-2);
        assert_relative_eq!(right, widths[1][1], max_relative = 3e-2);
    }
}

#[test]
fn mesh_that_would_have_to_be_halved_too_often_is_answered_with_the_finest() {
    let scene = brought(TruncatedHertz::default().scene(), resolution(1, 0, Order::Linear));
    let answer = accuracy::solve(&scene, &Formulation::verification(), &Asked::new(1e-3)).expect("an answer");
    let why = answer.unmet.clone().expect("not met");
    assert!(why.contains("halved more than 6 times") && answer.estimate() > 1e-3, "{why}");
    assert_eq!(answer.tried.len(), 7, "{:?}", answer.tried);
}
