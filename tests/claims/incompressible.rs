//! Nearly incompressible bodies in plane strain: neither cell locks, up to ν = 0.4999.
//!
//! In plane stress with `E/(1−ν²)`, `ν/(1−ν)` a body has the same D and plain cells: what locks is shown by that.

use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

use contact_vv::case::library::Patch;
use contact_vv::elasticity::dilatation::ORDINARY;
use contact_vv::elasticity::element::{self, CellStiffness};
use contact_vv::elasticity::{loads, quadrature, reactions, stress};
use contact_vv::mesh::{Mesh, Order};
use contact_vv::scene::{
    Circle, Component, Face, LARGEST_POISSON, Load, Material, Path, PlaneHypothesis, Scene, Shape, StressField,
};
use contact_vv::solve::Discretisation;
use nalgebra::{DMatrix, DVector, SymmetricEigen};

use crate::cells::distorted;
use crate::workbench::{
    ORDERS, STEEL, block, displaced, distance, distorted_patch, held, held_at, noise, of_shape, resolution,
};

const RUBBER: Material = Material { young: 6.0, poisson: LARGEST_POISSON };

/// Poisson's ratios on both sides of the last ordinary one.
const RATIOS: [f64; 3] = [0.3, 0.49, LARGEST_POISSON];

/// The same D in plane stress, where cells are plain.
fn plain(material: Material) -> Material {
    let Material { young, poisson } = material;
    Material { young: young / (1.0 - poisson * poisson), poisson: poisson / (1.0 - poisson) }
}

fn stiffness(kernel: &CellStiffness, points: &[[f64; 2]]) -> DMatrix<f64> {
    let mut k = vec![f64::NAN; kernel.entries()];
    kernel.integrate(points.iter().copied(), &mut k).expect("the sample is convex");
    DMatrix::from_row_slice(2 * points.len(), 2 * points.len(), &k)
}

fn in_strain(order: Order, material: Material) -> CellStiffness {
    CellStiffness::of(order, &material, PlaneHypothesis::Strain, 1.3)
}

#[test]
fn cells_of_ordinary_materials_are_the_plain_ones_and_others_follow_without_a_jump() {
    for order in ORDERS {
        let points = distorted(order.nodes_per_cell());
        let with = |poisson: f64| Material { poisson, ..STEEL };
        for (plane, ratios) in
            [(PlaneHypothesis::Strain, [-0.5, 0.0, 0.3, 0.3499]), (PlaneHypothesis::Stress, [0.3, 0.4, 0.4999, 0.99])]
        {
            for material in ratios.map(with) {
                let one = CellStiffness::new(order, &material.stiffness(plane), 1.3);
                let other = CellStiffness::of(order, &material, plane, 1.3);
                let change = (stiffness(&one, &points) - stiffness(&other, &points)).amax();
                assert!(change <= 0.0, "{order:?}, {plane:?}, ν = {}: {change}", material.poisson);
            }
        }
        let [below, above] = [-1e-9, 1e-9].map(|by| stiffness(&in_strain(order, with(ORDINARY + by)), &points));
        assert!((&below - &above).amax() <= 1e-7 * below.amax(), "{order:?} jumps");
    }
}

#[test]
fn cells_have_exactly_the_rigid_motions_and_as_many_stiff_ones_as_dilatations() {
    for (order, dilatations) in [(Order::Linear, 1), (Order::Quadratic, 3)] {
        for points in [distorted(order.nodes_per_cell()), square(order)] {
            for poisson in RATIOS {
                let material = Material { poisson, ..STEEL };
                let shear = material.stiffness(PlaneHypothesis::Strain)[2][2];
                let k = stiffness(&in_strain(order, material), &points);
                let scale = k.amax();

                assert!((&k - k.transpose()).amax() <= 1e-14 * scale);
                for motion in [|_: [f64; 2]| [1.0, 0.0], |_: [f64; 2]| [0.0, 1.0], |[x, y]: [f64; 2]| [-y, x]] {
                    let u = DVector::from_iterator(2 * points.len(), points.iter().flat_map(|p| motion(*p)));
                    assert!((&k * u).amax() <= 1e-13 * scale, "{order:?}, ν = {poisson}");
                }
                let mut eigenvalues: Vec<f64> = SymmetricEigen::new(k).eigenvalues.iter().copied().collect();
                eigenvalues.sort_by(f64::total_cmp);
                let rigid = eigenvalues[2].abs() <= 1e-13 * scale;
                assert!(rigid && eigenvalues[3] >= 0.05 * shear, "{order:?}, ν = {poisson}: {eigenvalues:?}");
                if poisson >= LARGEST_POISSON {
                    let stiff = eigenvalues.iter().filter(|value| **value > 100.0 * shear).count();
                    assert_eq!(stiff, dilatations, "{order:?}: {eigenvalues:?}");
                }
            }
        }
    }
}

fn square(order: Order) -> Vec<[f64; 2]> {
    contact_vv::elasticity::shape_functions::NODES[..order.nodes_per_cell()].to_vec()
}

#[test]
fn eight_node_cells_keep_every_linear_dilatation() {
    // A skewed cell reproduces complete quadratics, whose dilatation is linear: smoothing leaves it, and the energy, alone.
    let points: Vec<[f64; 2]> =
        square(Order::Quadratic).iter().map(|[x, y]| [x + 0.5 * y + 3.0, 0.2 * x + 0.7 * y]).collect();
    let mut number = noise(3);
    let c: [f64; 12] = std::array::from_fn(|_| number());
    let quadratic =
        |[x, y]: &[f64; 2], c: &[f64]| c[0] + c[1] * x + c[2] * y + c[3] * x * x + c[4] * x * y + c[5] * y * y;
    let u = points.iter().flat_map(|point| [quadratic(point, &c[..6]), quadratic(point, &c[6..])]);
    let u = DVector::from_iterator(16, u);
    for poisson in RATIOS {
        let material = Material { poisson, ..STEEL };
        let plain = CellStiffness::new(Order::Quadratic, &material.stiffness(PlaneHypothesis::Strain), 1.3);
        let energy = |kernel: &CellStiffness| (stiffness(kernel, &points) * &u).dot(&u);
        let (found, wanted) = (energy(&in_strain(Order::Quadratic, material)), energy(&plain));
        assert!((found - wanted).abs() <= 1e-11 * wanted, "ν = {poisson}: {found}, not {wanted}");
    }
}

#[test]
fn stresses_are_those_that_the_stiffness_works_with() {
    // uᵀ k u = ∫ ε·σ t dA for any displacement.
    for order in ORDERS {
        let points = distorted(order.nodes_per_cell());
        for poisson in RATIOS {
            let kernel = in_strain(order, Material { poisson, ..STEEL });
            let mut number = noise(7);
            let u: Vec<[f64; 2]> = points.iter().map(|_| [number(), number()]).collect();
            let all = DVector::from_iterator(2 * u.len(), u.iter().flatten().copied());
            let wanted = (stiffness(&kernel, &points) * &all).dot(&all);

            let rule = quadrature::gauss_square(if order == Order::Linear { 2 } else { 3 });
            let work = |(at, weight): &([f64; 2], f64)| {
                let (gradients, determinant) = element::gradients(&points, *at).expect("convex");
                let stress = kernel.stresses(&points, &u, &[*at]).expect("convex")[0];
                let strains = gradients
                    .iter()
                    .zip(&u)
                    .map(|([x, y], [u, v])| x * u * stress[0] + y * v * stress[1] + (y * u + x * v) * stress[2]);
                1.3 * weight * determinant * strains.sum::<f64>()
            };
            let found: f64 = rule.iter().map(work).sum();

            assert!((found - wanted).abs() <= 1e-11 * wanted, "{order:?}, ν = {poisson}: {found}, not {wanted}");
        }
    }
}

/// A uniform strain with a dilatation.
fn linear([x, y]: [f64; 2]) -> [f64; 2] {
    [1e-3 * x + 2e-4 * y, -3e-4 * y + 9e-4 * x]
}

/// The patch of five distorted cells, the sides inside bent where they can be.
fn bent_patch(order: Order) -> Mesh {
    let mut mesh = distorted_patch(order);
    let mut number = noise(11);
    let inside = |p: &[f64; 2]| p[0].min(p[1].min((1.0 - p[0]).min(1.0 - p[1]))) > 1e-12;
    for point in mesh.points.iter_mut().skip(8).filter(|point| inside(point)) {
        *point = point.map(|x| x + 0.03 * number());
    }
    mesh
}

#[test]
fn uniform_strain_passes_through_bent_cells_of_any_ratio() {
    for order in ORDERS {
        let mesh = bent_patch(order);
        for poisson in RATIOS {
            let material = Material { poisson, ..STEEL };
            let d = material.stiffness(PlaneHypothesis::Strain);
            let wanted: [f64; 3] = std::array::from_fn(|i| d[i][0] * 1e-3 - d[i][1] * 3e-4 + d[i][2] * 11e-4);
            let [sx, sy, txy] = wanted;
            let tractions = [("right", [sx, txy]), ("left", [-sx, -txy]), ("top", [txy, sy]), ("bottom", [-txy, -sy])];
            let loads = tractions.map(|(boundary, traction)| Load::Traction { boundary: boundary.into(), traction });
            let supports = vec![
                held_at([0.0, 0.0], Component::X, 0.0),
                held_at([0.0, 0.0], Component::Y, 0.0),
                held_at([1.0, 0.0], Component::Y, linear([1.0, 0.0])[1]),
            ];
            let mut scene = block([1.0, 1.0], supports, loads.to_vec());
            scene.bodies[0].material = material;

            let u = displaced(&scene, &mesh);
            let stresses = stress::at_nodes(&scene, &mesh, &u).expect("stress");

            // Round-off grows with λ/μ.
            let digits = 1e-13 * d[0][0] / d[2][2];
            for ((point, found), stress) in mesh.points.iter().zip(&u).zip(&stresses) {
                let what = format!("{order:?}, ν = {poisson} at {point:?}");
                assert!(distance(found, &linear(*point)) <= digits * 1e-3, "{what}: {found:?}");
                assert!(distance(stress, &wanted) <= digits * sx.abs(), "{what}: {stress:?}, not {wanted:?}");
            }
        }
    }
}

const LENGTH: f64 = 16.0;
const HALF_HEIGHT: f64 = 1.0;

/// A cantilever `0 ≤ x ≤ L`, `|y − c| ≤ c` clamped at x = 0 under a shear force of 1 N/mm at its end, and the
/// displacement it has in plane strain (Timoshenko & Goodier, Theory of Elasticity, §21, with E/(1−ν²) and ν/(1−ν)).
fn cantilever(material: Material) -> (Scene, impl Fn([f64; 2]) -> [f64; 2]) {
    let (l, c, inertia) = (LENGTH, HALF_HEIGHT, 2.0 * HALF_HEIGHT.powi(3) / 3.0);
    let Material { young: e, poisson: nu } = plain(material);
    let field = StressField(Arc::new(move |[x, y]| {
        let y = y - c;
        [-(l - x) * y / inertia, 0.0, (c * c - y * y) / (2.0 * inertia)]
    }));
    let exact = move |[x, y]: [f64; 2]| {
        let y = y - c;
        let along = -y * ((6.0 * l - 3.0 * x) * x + (2.0 + nu) * (y * y - c * c));
        let across = 3.0 * nu * y * y * (l - x) + (4.0 + 5.0 * nu) * c * c * x + (3.0 * l - x) * x * x;
        [along, across].map(|u| u / (6.0 * e * inertia))
    };
    let loads =
        ["left", "right", "contact", "far"].map(|side| Load::Stress { boundary: side.into(), field: field.clone() });
    let (below, above) = ([0.0, 0.0], [0.0, 2.0 * c]);
    let supports = [(below, Component::X), (below, Component::Y), (above, Component::X)];
    let supports = supports.map(|(at, component)| held_at(at, component, exact(at)[component.index()]));
    let mut scene = block([l, 2.0 * c], supports.to_vec(), loads.to_vec());
    scene.bodies[0].material = material;
    (scene, exact)
}

/// Without contact: all sides are loaded.
fn free_mesh(scene: &Scene, elements: usize, order: Order) -> Mesh {
    let mut mesh = Mesh::of(scene, resolution(elements, 0, order)).expect("mesh");
    mesh.bodies[0].candidates.clear();
    mesh
}

/// Relative error of the end's deflection, with sign.
fn deflection_error(scene: &Scene, exact: impl Fn([f64; 2]) -> [f64; 2], elements: usize, order: Order) -> f64 {
    let mesh = free_mesh(scene, elements, order);
    let end = [LENGTH, 0.0];
    let node = mesh.node_at(scene, 0, end).expect("corner");
    displaced(scene, &mesh)[node][1] / exact(end)[1] - 1.0
}

#[test]
fn cantilever_of_rubber_bends_as_the_beam_does_where_plain_cells_lock() {
    let (scene, exact) = cantilever(RUBBER);
    let mut locked = scene.clone();
    locked.plane = PlaneHypothesis::Stress;
    locked.bodies[0].material = plain(RUBBER);

    // Two, four and eight 4-node cells on the height.
    let four = [16, 32, 64].map(|elements| deflection_error(&scene, &exact, elements, Order::Linear));
    let eight = [8, 16, 32].map(|elements| deflection_error(&scene, &exact, elements, Order::Quadratic));
    let stuck = [16, 32, 64].map(|elements| deflection_error(&locked, &exact, elements, Order::Linear));

    // Second order.
    assert!(four.windows(2).all(|pair| pair[1].abs() <= 0.35 * pair[0].abs()), "4-node: {four:?}");
    assert!(four[2].abs() <= 0.01, "4-node: {four:?}");
    assert!(eight[0].abs() <= 2e-3 && eight[2].abs() <= 1e-4, "8-node: {eight:?}");
    assert!(stuck.iter().all(|error| *error <= -0.9), "plain 4-node cells do not lock: {stuck:?}");
}

#[test]
fn internal_forces_of_rubber_balance_its_loads_node_by_node() {
    let (scene, _) = cantilever(RUBBER);
    for order in ORDERS {
        let mesh = free_mesh(&scene, 16, order);
        let u = displaced(&scene, &mesh);
        let internal = reactions::internal_forces(&scene, &mesh, 0, &u).expect("forces");
        let applied = loads::at_nodes(&scene, &mesh, 0).expect("forces");
        // The supports take nothing: they hold the beam where it would be anyway. 1 N/mm on 2.5 mm, with four digits
        // lost to λ/μ.
        for (point, (one, other)) in mesh.points.iter().zip(internal.iter().zip(&applied)) {
            assert!(distance(one, other) <= 1e-6, "{order:?} at {point:?}: {one:?}, not {other:?}");
        }
    }
}

/// Largest errors of a thick ring under internal pressure: of the radial displacement, relative, and of the mean stress
/// `(σ_x + σ_y)/2` at the nodes over the pressure (Lamé; Timoshenko & Goodier, §28).
fn ring_errors(
    material: Material,
    plane: PlaneHypothesis,
    strain: Material,
    elements: usize,
    order: Order,
) -> [f64; 2] {
    let (a, b, p) = (2.0, 4.0, 0.5);
    let circle = |radius| Circle { centre: [0.0, 0.0], radius };
    let shape = Shape::Ring {
        pole: [0.0, 0.0],
        inner: circle(a),
        outer: circle(b),
        sweep: FRAC_PI_2,
        both_sides: false,
        contact: Face::Bottom,
    };
    let supports = vec![held("start", Component::X, 0.0), held("end", Component::Y, 0.0)];
    let pressure = StressField(Arc::new(move |_| [-p, -p, 0.0]));
    let loads = vec![Load::Stress { boundary: "contact".into(), field: pressure }];
    let mut scene = of_shape(shape, Path::Arc(circle(a)), FRAC_PI_2, supports, loads);
    scene.plane = plane;
    scene.bodies[0].material = material;
    let mesh = Mesh::of(&scene, resolution(elements, 0, order)).expect("mesh");
    let u = displaced(&scene, &mesh);
    let stresses = stress::at_nodes(&scene, &mesh, &u).expect("stress");

    let Material { young, poisson } = strain;
    let share = a * a * p / (b * b - a * a);
    let mut worst = [0.0_f64; 2];
    for ((point, u), stress) in mesh.points.iter().zip(&u).zip(&stresses) {
        let r = point[0].hypot(point[1]);
        let radial = (u[0] * point[0] + u[1] * point[1]) / r;
        let wanted = (1.0 + poisson) / young * share * ((1.0 - 2.0 * poisson) * r + b * b / r);
        let errors = [radial / wanted - 1.0, (0.5 * (stress[0] + stress[1]) - share) / p];
        worst = std::array::from_fn(|k| distance(&[worst[k].max(errors[k].abs()), errors[k]], &[0.0; 2]));
    }
    worst
}

#[test]
fn thick_ring_of_rubber_follows_lame_as_one_of_steel_does() {
    for (order, elements, widening) in [(Order::Linear, 16, 5e-3), (Order::Quadratic, 8, 1e-4)] {
        let strain = PlaneHypothesis::Strain;
        let steel = ring_errors(STEEL, strain, STEEL, elements, order);
        let rubber = ring_errors(RUBBER, strain, RUBBER, elements, order);
        let locked = ring_errors(plain(RUBBER), PlaneHypothesis::Stress, RUBBER, elements, order);

        assert!(rubber[0] <= widening, "{order:?}: {rubber:?}");
        for (found, usual) in rubber.iter().zip(steel) {
            assert!(*found <= 2.0 * usual, "{order:?}: {rubber:?} of rubber, {steel:?} of steel");
        }
        for (found, plain) in rubber.iter().zip(locked) {
            assert!(*found <= 0.01 * plain, "{order:?}: plain cells do not lock: {locked:?}, {rubber:?}");
        }
    }
}

#[test]
fn body_that_keeps_its_volume_is_refused_with_the_largest_ratio_in_plane_strain_only() {
    for plane in [PlaneHypothesis::Strain, PlaneHypothesis::Stress] {
        for poisson in [LARGEST_POISSON, 0.49991, 0.5] {
            let mut scene = Patch::default().scene();
            scene.plane = plane;
            scene.bodies[1].material.poisson = poisson;
            for order in ORDERS {
                let result = Discretisation::of(scene.clone(), resolution(2, 0, order)).map(|_| ());
                let accepted = plane == PlaneHypothesis::Stress || poisson <= LARGEST_POISSON;
                assert_eq!(result.is_ok(), accepted, "{order:?}, {plane:?}, {poisson}");
                if let Err(error) = result {
                    let text = error.to_string();
                    for part in ["body `lower`", &format!("`poisson` = {poisson}"), "at most 0.4999", "use "] {
                        assert!(text.contains(part), "`{part}` is not in {text}");
                    }
                }
            }
        }
    }
}
