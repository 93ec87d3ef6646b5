//! Scenes, hand-made meshes and dense matrices shared by the claims; nothing here is taken from the code under test.

use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_2;
use std::path::Path;
use std::sync::{Mutex, OnceLock, PoisonError};

use contact_vv::case::library::{
    Bars, Cylinder, CylinderModel, FlatPunch, NAMES, Patch, PinPlate, PinRod, PressFit, TruncatedHertz, find,
    own_weight,
};
use contact_vv::case::{Case, Judged, Verdict};
use contact_vv::elasticity::{BodySystem, ElasticSystem, element, quadrature};
use contact_vv::error::Error;
use contact_vv::mesh::{BodyMesh, Edge, Mesh, Order, Resolution};
use contact_vv::oracle::{Quantity, Reading};
use contact_vv::referee::Truth;
use contact_vv::scene::{
    self, Action, Body, Circle, Component, ContactPair, Face, Grading, Load, Material, Place, PlaneHypothesis, Profile,
    ReferenceValues, Scene, Shape, Support, VectorField,
};
use contact_vv::solve::{Discretisation, Element, Formulation, Iteration};
use nalgebra::{DMatrix, DVector};

use crate::scene_file;

pub const STEEL: Material = Material { young: 210e3, poisson: 0.3 };
pub const ORDERS: [Order; 2] = [Order::Linear, Order::Quadratic];

/// Our answer to a case of the library, or to a scene file, solved once for all claims.
pub fn truth(name: &str) -> &'static Truth {
    static KNOWN: Mutex<BTreeMap<String, &OnceLock<Truth>>> = Mutex::new(BTreeMap::new());
    let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    let one = *known.entry(name.into()).or_insert_with(|| Box::leak(Box::default()));
    drop(known);
    one.get_or_init(|| Truth::of(find(name, None).unwrap_or_else(|_| scene_file::case(name))).expect("solved"))
}

/// Every case of the library and every scene file.
pub fn every_case() -> Vec<Case> {
    let files = scene_file::files().into_iter().map(|(path, text)| Case::parse(&path, &text).expect("a scene file"));
    NAMES.iter().map(|(name, _)| find(name, None).expect("a case")).chain(files).collect()
}

pub fn resolution(elements: usize, refinement: u32, order: Order) -> Resolution {
    Resolution { elements, refinement, order }
}

/// Every scene of the library, with the coarsest resolution that makes sense for it.
pub fn library() -> Vec<(Scene, usize)> {
    let none = VectorField::of(|_| [0.0; 3]);
    vec![
        (Patch::default().scene(), 2),
        (Bars::default().scene(), 2),
        (own_weight::case().scene, 2),
        (PressFit::default().scene(), 4),
        (FlatPunch::default().scene(), 8),
        (Cylinder::default().scene(), 4),
        (Cylinder { model: CylinderModel::HalfLoadedAbove, ..Cylinder::default() }.scene(), 4),
        (Cylinder { a_over_r: 0.005, ..Cylinder::default() }.scene(), 4),
        (Cylinder { a_over_r: 0.2, ..Cylinder::default() }.scene(), 4),
        (TruncatedHertz::default().scene_under(none), 4),
        (PinRod::default().scene(), 6),
        (PinPlate::default().scene(), 6),
        (PinPlate { stretch: 1.0, ..PinPlate::default() }.scene(), 6),
    ]
}

/// A scene of one rectangle `[0, w] × [0, h]` whose lower side may touch a rigid plane.
pub fn block(size: [f64; 2], supports: Vec<Support>, loads: Vec<Load>) -> Scene {
    let shape = Shape::Rectangle { x: [0.0, size[0]], y: [0.0, size[1]], contact: Face::Bottom };
    of_shape(shape, scene::Path::HORIZONTAL, size[0], supports, loads)
}

/// A scene of one body in plane strain, 2.5 mm thick, near a rigid profile.
pub fn of_shape(shape: Shape, path: scene::Path, stretch: f64, supports: Vec<Support>, loads: Vec<Load>) -> Scene {
    let unit = stretch * path.metric();
    Scene {
        name: "sample".into(),
        plane: PlaneHypothesis::Strain,
        thickness: 2.5,
        bodies: vec![Body { name: "body".into(), shape, material: STEEL, density: 1.0, supports, loads }],
        contacts: vec![ContactPair {
            symmetric: false,
            ..ContactPair::new(None, path, Profile::Uniform(0.0), stretch)
        }],
        reference: ReferenceValues { length: 1.0, pressure: 1.0, gap: 1.0 },
        grading: Grading { unit, along: 1.0, depth: 1.0, first: 1.0, coarsest: 1.0, end: 1.0 },
    }
}

/// Sides under the tractions of one field of stress.
pub fn stressed(
    sides: &[&'static str],
    field: impl Fn([f64; 2]) -> [f64; 3] + Send + Sync + 'static,
) -> impl Iterator<Item = Load> {
    let field = VectorField::of(field);
    sides.iter().map(move |side| Load::on(*side, Action::Stress(field.clone())))
}

/// A soft body of revolution on a rigid side, under the traction of a uniform stress on the sides that are named.
pub fn turned(
    plane: PlaneHypothesis,
    shape: Shape,
    path: scene::Path,
    stretch: f64,
    stress: [f64; 3],
    loaded: &[&'static str],
) -> Scene {
    let mut scene = of_shape(shape, path, stretch, vec![], stressed(loaded, move |_| stress).collect());
    (scene.plane, scene.thickness) = (plane, 1.0);
    scene.bodies[0].material.young = 1000.0;
    (scene.reference.gap, scene.grading.unit) = (1e-3, 3.0);
    scene
}

/// A quarter of a ring about the origin near a rigid profile, on its inner side where that is its lower face.
pub fn ring(radii: [f64; 2], contact: Face, stretch: f64, supports: Vec<Support>, loads: Vec<Load>) -> Scene {
    let [inner, outer] = radii.map(|radius| Circle { centre: [0.0, 0.0], radius });
    let own = if contact == Face::Bottom { inner } else { outer };
    let shape = Shape::Ring { pole: [0.0, 0.0], inner, outer, sweep: FRAC_PI_2, both_sides: false, contact };
    of_shape(shape, scene::Path::Arc(own), stretch, supports, loads)
}

pub fn held(boundary: &'static str, component: Component, value: f64) -> Support {
    Support { at: Place::Boundary(boundary.into()), component, value }
}

pub fn held_at(point: [f64; 2], component: Component, value: f64) -> Support {
    Support { at: Place::Point(point), component, value }
}

/// Five distorted cells on the unit square, after MacNeal & Harder (1985); mid-sides bulge for 8-node cells inside.
pub fn distorted_patch(order: Order) -> Mesh {
    let mut points: Vec<[f64; 2]> =
        vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.2, 0.25], [0.75, 0.3], [0.7, 0.65], [0.3, 0.75]];
    let corners = [[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7], [4, 5, 6, 7]];
    let mut mids: BTreeMap<[usize; 2], usize> = BTreeMap::new();
    let mut connectivity = Vec::new();
    for cell in corners {
        connectivity.extend(cell);
        if order == Order::Quadratic {
            for k in 0..4 {
                let (a, b) = (cell[k], cell[(k + 1) % 4]);
                let mid = *mids.entry([a.min(b), a.max(b)]).or_insert_with(|| {
                    points.push([0.5 * (points[a][0] + points[b][0]), 0.5 * (points[a][1] + points[b][1])]);
                    points.len() - 1
                });
                connectivity.push(mid);
            }
        }
    }
    let side = |a: usize, b: usize| -> Vec<Edge> {
        let mut edge = vec![a, b];
        edge.extend(mids.get(&[a.min(b), a.max(b)]));
        vec![edge]
    };
    let boundaries = [("bottom", side(0, 1)), ("right", side(1, 2)), ("top", side(2, 3)), ("left", side(3, 0))];
    let boundaries = boundaries.map(|(name, edges)| (name.into(), edges)).into();
    let body =
        BodyMesh { nodes: 0..points.len(), cells: 0..5, boundaries, lines: Default::default(), candidates: Vec::new() };
    Mesh { order, points, connectivity, bodies: vec![body] }
}

/// Full dense stiffness from the stored lower triangle.
pub fn dense(body: &BodySystem) -> DMatrix<f64> {
    let n = body.dofs.equations;
    let mut matrix = DMatrix::zeros(n, n);
    let stored = body.stiffness.as_ref();
    for column in 0..n {
        for (row, &value) in stored.row_idx_of_col(column).zip(stored.val_of_col(column)) {
            assert!(row >= column, "only the lower triangle is stored");
            matrix[(row, column)] = value;
            matrix[(column, row)] = value;
        }
    }
    matrix
}

/// `K⁻¹ f` by dense LU.
pub fn solved(body: &BodySystem) -> Vec<f64> {
    let solution = dense(body).lu().solve(&DVector::from_vec(body.force.clone()));
    solution.expect("the sample is supported").iter().copied().collect()
}

/// Nodal displacements of a scene of one body that its supports hold.
pub fn displaced(scene: &Scene, mesh: &Mesh) -> Vec<[f64; 2]> {
    let system = ElasticSystem::assemble(scene, mesh).expect("system");
    system.nodal_displacements(1.0, &[solved(&system.bodies[0])])
}

/// The case of a scene file's text.
pub fn parsed(text: &str) -> Case {
    Case::parse(Path::new("scene.toml"), text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// A number that the closed form of a case tells.
pub fn told(case: &Case, quantity: &Quantity) -> f64 {
    match case.oracle().expect("a closed form").read(quantity) {
        Reading::Value { value, .. } => value,
        other => panic!("{quantity:?}: {other:?}"),
    }
}

/// The text of a block of steel on x from `left` to `right` with a load on its far side, whose lower side touches a
/// rigid profile; its contact and what follows as in a file.
pub fn block_text([left, right]: [f64; 2], height: f64, load: &str, contact: &str) -> String {
    let held = if left < 0.0 { format!("[0, {height}]") } else { "\"left\"".into() };
    format!(
        "plane = \"strain\"\nthickness = 1\n[[body]]\nname = \"block\"\nyoung = 210e3\npoisson = 0.3\n\
         shape = {{ rectangle = {{ x = [{left}, {right}], y = [0, {height}], contact = \"bottom\" }} }}\n\
         supports = [{{ at = {held}, component = \"x\" }}]\nloads = [{{ {load} }}]\n[contact]\nfirst = \
         \"block\"\n{contact}\n"
    )
}

/// Node elements under kinematic load, by their default tolerance.
pub fn kinematic() -> Formulation {
    Formulation::new(Element::Node, Iteration::Kinematic)
}

/// A scene on a mesh of so many elements.
pub fn meshed(scene: Scene, elements: usize, order: Order) -> Discretisation {
    Discretisation::of(scene, resolution(elements, 0, order)).expect("meshed")
}

/// Largest absolute difference; NaN if there is one, infinite if the lengths differ.
pub fn distance(a: &[f64], b: &[f64]) -> f64 {
    if a.len() != b.len() {
        return f64::INFINITY;
    }
    let worse = |worst: f64, d: f64| if d.is_nan() || worst.is_nan() { f64::NAN } else { worst.max(d) };
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, worse)
}

/// A copy that is spoiled.
pub fn spoiled<T: Clone>(sound: &T, spoil: impl FnOnce(&mut T)) -> T {
    let mut other = sound.clone();
    spoil(&mut other);
    other
}

/// What is said of something that is refused, which holds some parts.
pub fn refused<T>(told: Result<T, Error>, parts: &[impl AsRef<str>]) -> String {
    let error = told.map(|_| ()).expect_err("refused").to_string();
    parts.iter().map(AsRef::as_ref).for_each(|part| assert!(error.contains(part), "`{part}` is not in {error}"));
    error
}

/// How many checks fail.
pub fn fails(judged: &[Judged]) -> usize {
    judged.iter().filter(|one| one.verdict == Verdict::Fail).count()
}

/// Whether there is a check, and all pass.
pub fn all_pass(checks: &[Judged]) -> bool {
    !checks.is_empty() && checks.iter().all(|check| check.verdict == Verdict::Pass)
}

/// Numbers in −1 … 1 that look random and are always the same (SplitMix64; Steele, Lea & Flood 2014).
pub fn noise(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = state;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        (z ^ (z >> 31)) as f64 / u64::MAX as f64 * 2.0 - 1.0
    }
}

/// Area of a mesh.
pub fn area(mesh: &Mesh) -> f64 {
    let rule = quadrature::gauss_square(mesh.order.intervals() + 2);
    let of_cell = |cell: usize| {
        let points: Vec<[f64; 2]> = mesh.cell(cell).iter().map(|&node| mesh.points[node]).collect();
        let at = |(at, weight): &([f64; 2], f64)| weight * element::gradients(&points, *at).expect("convex").1;
        rule.iter().map(at).sum::<f64>()
    };
    (0..mesh.cells()).map(of_cell).sum()
}

/// Length of a boundary of the first body, in chords.
pub fn length(mesh: &Mesh, scene: &Scene, name: &str) -> f64 {
    let chord = |edge: &Edge| {
        let [from, to] = [edge[0], edge[1]].map(|node| mesh.points[node]);
        (to[0] - from[0]).hypot(to[1] - from[1])
    };
    mesh.boundary(scene, 0, name).expect("side").iter().map(chord).sum()
}
