//! Error bars on meshes made elsewhere: from those that they were halved from, from cells without the nodes on their sides, or from
//! the mesh halved.

use std::collections::BTreeMap;
use std::sync::Arc;

use contact_vv::accuracy::coarser::coarser;
use contact_vv::case::library::Cylinder;
use contact_vv::mesh::{Mesh, Order, Resolution};
use contact_vv::scene::{GivenMesh, Scene, Shape};
use contact_vv::study::coverage::group::Group;
use contact_vv::study::coverage::run::{Kind, Record, of_setup};
use contact_vv::study::coverage::setup::Setup;
use contact_vv::study::random::{Family, Site};

use crate::outputs::{contact_vv, scene};
use crate::workbench::resolution;

/// Scenes of one body whose closed form is known, of each so many from a number on: from none of them a constant was chosen.
const FAMILIES: [Family; 6] =
    [Family::Hertz, Family::Polynomial, Family::Wedge, Family::Cosine, Family::Cylinder, Family::Rolling];
const SCENES: [usize; 2] = [12, 95_000];
/// How far inner nodes are moved, over the shortest edge at them.
const SHAKEN: f64 = 0.1;
/// Largest error over its bar.
const BEYOND: f64 = 3.0;

/// A scene with a mesh of its own, as if that had been made elsewhere.
fn brought(mut scene: Scene, mesh: &Mesh) -> Scene {
    for body in 0..scene.bodies.len() {
        scene.bodies[body].shape = Shape::Given(Arc::new(mesh.given(body)));
    }
    scene
}

/// Points and cells, whatever their numbers: the middle of each cell by its corners, rounded.
fn middles(mesh: &GivenMesh) -> Vec<[i64; 2]> {
    let size = mesh.points.iter().flatten().fold(0.0_f64, |size, x| size.max(x.abs()));
    let middle = |cell: &Vec<usize>| {
        [0, 1].map(|k| (1e6 * cell[..].iter().map(|&node| mesh.points[node][k]).sum::<f64>() / size).round() as i64)
    };
    let mut all: Vec<[i64; 2]> = mesh.cells.iter().map(middle).collect();
    all.sort_unstable();
    all
}

fn lengths(mesh: &GivenMesh) -> BTreeMap<String, usize> {
    mesh.boundaries.iter().map(|(name, edges)| (name.to_string(), edges.len())).collect()
}

#[test]
fn mesh_that_was_halved_is_found_again_on_straight_and_on_round_sides() {
    let polynomial = Site { family: Family::Polynomial, number: 4 }.sample().expect("a scene").scene;
    for (drawn, elements) in [(polynomial, 3), (Cylinder::default().scene(), 5)] {
        for order in [Order::Linear, Order::Quadratic] {
            let mesh = |refinement| Mesh::of(&drawn, resolution(elements, refinement, order)).expect("meshed").given(0);
            let [coarse, fine, finest] = [0, 1, 2].map(mesh);
            let again = fine.merged().expect("halved");
            assert_eq!(again.cells.len(), coarse.cells.len());
            assert_eq!(again.points.len(), coarse.points.len());
            assert_eq!(lengths(&again), lengths(&coarse));
            let apart = middles(&again).into_iter().zip(middles(&coarse));
            assert!(apart.flat_map(|(a, b)| [a[0] - b[0], a[1] - b[1]]).all(|apart| apart.abs() <= 100), "{order:?}");
            assert_eq!(finest.merged().expect("once").merged().expect("twice").cells.len(), coarse.cells.len());
            let straight = coarse.without_sides();
            assert_eq!(straight.is_some(), order == Order::Quadratic);
            assert!(straight.is_none_or(|straight| straight.cells.iter().all(|cell| cell.len() == 4)));
        }
    }
}

#[test]
fn mesh_that_was_not_halved_is_not_taken_for_one() {
    let points = vec![[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0], [0.0, 1.0], [1.0, 1.0], [2.0, 1.0], [3.0, 1.0]];
    let cells = vec![vec![0, 1, 5, 4], vec![1, 2, 6, 5], vec![2, 3, 7, 6]];
    let row = GivenMesh { points, cells, boundaries: BTreeMap::new(), inner: Default::default() };
    assert!(row.merged().is_none() && row.without_sides().is_none());
    // Two by two cells are one, unless a boundary ends at the middle of a side of it.
    let at = |k: usize| [(k % 3) as f64, (k / 3) as f64];
    let cells = [0, 1, 3, 4].map(|k| vec![k, k + 1, k + 4, k + 3]).to_vec();
    let of = |edges: Vec<Vec<usize>>| GivenMesh {
        points: (0..9).map(at).collect(),
        cells: cells.clone(),
        boundaries: [("contact".into(), edges)].into(),
        inner: Default::default(),
    };
    let one = of(vec![vec![0, 1], vec![1, 2]]).merged().expect("one cell");
    assert_eq!([one.cells.len(), one.points.len(), one.boundaries["contact"].len()], [1, 4, 1]);
    assert!(of(vec![vec![0, 1]]).merged().is_none());
}

/// How a mesh comes to be.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Way {
    /// Halved from one.
    Halved,
    /// With inner nodes moved as well.
    Shaken,
    /// With one column of cells more than could be halved.
    Odd,
}

/// The mesh of a setup as if it had been made elsewhere.
fn handed(setup: Setup, way: Way) -> Setup {
    let Resolution { elements, order, .. } = setup.resolution;
    let (elements, refinement) = match way {
        Way::Odd => (elements, 0),
        _ => (elements.div_ceil(2), 1),
    };
    let mesh = Mesh::of(&setup.scene, Resolution { elements, refinement, order }).expect("meshed");
    // Shaken, a line inside would no longer be straight, and its load another one.
    let straight = mesh.bodies.iter().all(|body| body.lines.is_empty());
    let mesh = if way == Way::Halved || !straight { mesh } else { mesh.shaken(SHAKEN) };
    let scene = brought(setup.scene, &mesh);
    Setup { scene, resolution: Resolution { elements: 1, refinement: 0, order }, ..setup }
}

#[test]
fn true_errors_on_meshes_made_elsewhere_lie_within_their_bars() {
    let [each, from] = SCENES;
    for way in [Way::Halved, Way::Shaken, Way::Odd] {
        let sites =
            FAMILIES.into_iter().flat_map(|family| (from..from + each).map(move |number| Site { family, number }));
        let mut all: Vec<Record> = Vec::new();
        for site in sites {
            let sample = site.sample().expect("a scene");
            let setup = handed(Setup::of(&site, &sample), way);
            // A large mesh of 4-node cells that was not halved has no bar, and says so.
            if !coarser(&setup.scene, setup.resolution).is_empty() {
                all.extend(of_setup(&site, &sample, setup).expect("bars"));
            }
        }
        let mut kinds = 0;
        for kind in Kind::ALL {
            let of = |factor: f64| {
                let spoiled: Vec<Record> =
                    all.iter().map(|record| Record { bar: factor * record.bar, ..record.clone() }).collect();
                Group::of(&spoiled, |record| record.kind == kind).within(1.0)
            };
            let own = Group::of(&all, |record| record.kind == kind);
            if own.records.is_empty() {
                continue;
            }
            kinds += 1;
            assert!(of(1.0) >= 0.95, "{way:?}, {}: {:.3} within", kind.title(), of(1.0));
        }
        assert!(kinds >= 6, "{way:?}: {kinds}");
        let all = Group::of(&all, |_| true);
        assert!(all.within(BEYOND) >= 0.995, "{way:?}: {}", all.within(BEYOND));
    }
}

#[test]
fn mesh_from_gmsh_has_bars_without_being_halved_here() {
    let (sound, json, error) = contact_vv(&["solve", &scene("rings-from-gmsh"), "--json", "-"]);
    assert!(sound, "{error}");
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    let bars = json["error_bars"].as_array().expect("a list");
    let peak = bars.iter().find(|bar| bar["quantity"] == "peak-pressure").expect("a peak");
    assert!(peak["bound"].as_f64().is_some_and(|bound| bound > 0.0), "{peak}");
}
