//! Nearly incompressible bodies in plane strain and of revolution: no cell locks, up to ν = 0.4999.
//!
//! In plane stress with `E/(1−ν²)`, `ν/(1−ν)` a body has the same D and the same cells: none locks up to ν = 0.9996.

use std::f64::consts::{FRAC_PI_2, PI};
use std::path::Path;

use contact_vv::accuracy::{self, Asked, Quantity};
use contact_vv::case::Case;
use contact_vv::elasticity::dilatation::ORDINARY;
use contact_vv::elasticity::element::{self, CellStiffness, Tabulated};
use contact_vv::elasticity::{quadrature, stress};
use contact_vv::mesh::{Mesh, Order};
use contact_vv::scene::{Action, Component, Face, LARGEST_POISSON, Load, Material, PlaneHypothesis, VectorField};
use contact_vv::solve::Formulation;
use nalgebra::DVector;

use crate::balance::{solved_on, told_of};
use crate::cells::{RATIOS, distorted, nodes, stiffness};
use crate::workbench::{
    ORDERS, STEEL, block, displaced, distance, distorted_patch, held, held_at, noise, parsed, resolution, ring,
};

const RUBBER: Material = Material { young: 6.0, poisson: LARGEST_POISSON };

const PLANES: [PlaneHypothesis; 2] = [PlaneHypothesis::Strain, PlaneHypothesis::Stress];

/// The same D in plane stress.
fn in_stress(material: Material) -> Material {
    let Material { young, poisson } = material;
    Material { young: young / (1.0 - poisson * poisson), poisson: poisson / (1.0 - poisson) }
}

fn in_strain(order: Order, material: Material) -> CellStiffness {
    CellStiffness::of(order, &material, PlaneHypothesis::Strain, 1.3)
}

#[test]
fn cells_of_ordinary_materials_are_the_plain_ones_and_others_follow_without_a_jump() {
    for order in Order::ALL {
        let points = distorted(order);
        let with = |poisson: f64| Material { poisson, ..STEEL };
        for (plane, ratios) in
            [(PlaneHypothesis::Strain, [-0.5, 0.0, 0.3, 0.3499]), (PlaneHypothesis::Stress, [0.3, 0.4, 0.5, 0.538])]
        {
            for material in ratios.map(with) {
                let one = CellStiffness::new(order, &material.stiffness(plane), 1.3);
                let other = CellStiffness::of(order, &material, plane, 1.3);
                let change = (stiffness(&one, &points) - stiffness(&other, &points)).amax();
                assert!(change <= 0.0, "{order:?}, {plane:?}, ν = {}: {change}", material.poisson);
            }
        }
        for (plane, ordinary) in PLANES.into_iter().zip([ORDINARY, ORDINARY / (1.0 - ORDINARY)]) {
            let cell = |by: f64| CellStiffness::of(order, &with(ordinary + by), plane, 1.3);
            let [below, above] = [-1e-9, 1e-9].map(|by| stiffness(&cell(by), &points));
            assert!((&below - &above).amax() <= 1e-7 * below.amax(), "{order:?} jumps in {plane:?}");
        }
    }
}

#[test]
fn cells_of_order_p_keep_every_dilatation_of_degree_p_less_one() {
    // A skewed cell reproduces complete polynomials of degree p: smoothing leaves their dilatation, and the energy,
    // alone.
    for order in Order::ALL.into_iter().filter(|order| *order != Order::Linear) {
        let p = i32::from(order.number());
        let points: Vec<[f64; 2]> = nodes(order).iter().map(|[x, y]| [x + 0.5 * y + 3.0, 0.2 * x + 0.7 * y]).collect();
        let mut number = noise(3);
        let powers: Vec<[i32; 2]> = (0..=p).flat_map(|sum| (0..=sum).map(move |j| [sum - j, j])).collect();
        let c: Vec<[f64; 2]> = powers.iter().map(|_| [number(), number()]).collect();
        let value = |[x, y]: &[f64; 2], k: usize| -> f64 {
            let term = |([i, j], c): (&[i32; 2], &[f64; 2])| c[k] * (x - 3.0).powi(*i) * y.powi(*j);
            powers.iter().zip(&c).map(term).sum()
        };
        let u = points.iter().flat_map(|point| [value(point, 0), value(point, 1)]);
        let u = DVector::from_iterator(2 * points.len(), u);
        for poisson in RATIOS {
            let material = Material { poisson, ..STEEL };
            let plain = CellStiffness::new(order, &material.stiffness(PlaneHypothesis::Strain), 1.3);
            let energy = |kernel: &CellStiffness| (stiffness(kernel, &points) * &u).dot(&u);
            let (found, wanted) = (energy(&in_strain(order, material)), energy(&plain));
            assert!((found - wanted).abs() <= 1e-10 * wanted, "{order:?}, ν = {poisson}: {found}, not {wanted}");
        }
    }
}

#[test]
fn stresses_are_those_that_the_stiffness_works_with() {
    // uᵀ k u = ∫ ε·σ t dA for any displacement.
    for order in Order::ALL {
        let points = distorted(order);
        for poisson in RATIOS {
            let kernel = in_strain(order, Material { poisson, ..STEEL });
            let mut number = noise(7);
            let u: Vec<[f64; 2]> = points.iter().map(|_| [number(), number()]).collect();
            let all = DVector::from_iterator(2 * u.len(), u.iter().flatten().copied());
            let wanted = (stiffness(&kernel, &points) * &all).dot(&all);

            let rule = quadrature::gauss_square(usize::from(order.number()) + 1);
            let work = |(at, weight): &([f64; 2], f64)| {
                let (gradients, determinant) = element::gradients(&points, *at).expect("convex");
                let stress = kernel.stresses(&points, &u, &[Tabulated::of(points.len(), *at)]).expect("convex")[0];
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
fn uniform_strain_passes_through_bent_cells_of_any_ratio_under_tractions_or_the_stress_field_that_makes_them() {
    for (order, plane) in ORDERS.into_iter().flat_map(|order| PLANES.map(|plane| (order, plane))) {
        let mesh = bent_patch(order);
        let near_one = matches!(plane, PlaneHypothesis::Stress).then_some(0.99);
        for poisson in RATIOS.into_iter().chain(near_one) {
            let material = Material { poisson, ..STEEL };
            let d = material.stiffness(plane);
            let wanted: [f64; 3] = std::array::from_fn(|i| d[i][0] * 1e-3 - d[i][1] * 3e-4 + d[i][2] * 11e-4);
            let ([sx, sy, txy], field) = (wanted, VectorField::of(move |_| wanted));
            let sides = [("right", [sx, txy]), ("left", [-sx, -txy]), ("top", [txy, sy]), ("bottom", [-txy, -sy])];
            let tractions = sides.map(|(side, traction)| Load::on(side, Action::Uniform(traction)));
            let fields = sides.map(|(side, _)| Load::on(side, Action::Stress(field.clone())));
            let supports = vec![
                held_at([0.0, 0.0], Component::X, 0.0),
                held_at([0.0, 0.0], Component::Y, 0.0),
                held_at([1.0, 0.0], Component::Y, linear([1.0, 0.0])[1]),
            ];
            for loads in [tractions.to_vec(), fields.to_vec()] {
                let mut scene = block([1.0, 1.0], supports.clone(), loads);
                (scene.plane, scene.bodies[0].material) = (plane, material);

                let u = displaced(&scene, &mesh);
                let stresses = stress::at_nodes(&scene, &mesh, &u).expect("stress");

                // Round-off grows with λ/μ.
                let digits = 1e-13 * d[0][0] / d[2][2];
                for ((point, found), stress) in mesh.points.iter().zip(&u).zip(&stresses) {
                    let what = format!("{order:?}, {plane:?}, ν = {poisson} at {point:?}");
                    assert!(distance(found, &linear(*point)) <= digits * 1e-3, "{what}: {found:?}");
                    assert!(distance(stress, &wanted) <= digits * sx.abs(), "{what}: {stress:?}, not {wanted:?}");
                }
            }
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
    let supports = vec![held("start", Component::X, 0.0), held("end", Component::Y, 0.0)];
    let pressure = VectorField::of(move |_| [-p, -p, 0.0]);
    let loads = vec![Load::on("contact", Action::Stress(pressure))];
    let mut scene = ring([a, b], Face::Bottom, FRAC_PI_2, supports, loads);
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
    for (order, elements, widening) in
        [(Order::Linear, 16, 5e-3), (Order::Quadratic, 8, 1e-4), (Order::Quartic, 2, 1e-4)]
    {
        let strain = PlaneHypothesis::Strain;
        let steel = ring_errors(STEEL, strain, STEEL, elements, order);
        let rubber = ring_errors(RUBBER, strain, RUBBER, elements, order);
        let twin = ring_errors(in_stress(RUBBER), PlaneHypothesis::Stress, RUBBER, elements, order);

        assert!(steel[0].max(rubber[0]) <= widening, "{order:?}: {steel:?} of steel, {rubber:?} of rubber");
        for (found, usual) in rubber.iter().zip(steel) {
            assert!(*found <= 2.0 * usual, "{order:?}: {rubber:?} of rubber, {steel:?} of steel");
        }
        for (found, usual) in twin.iter().zip(steel) {
            assert!(*found <= 2.0 * usual, "{order:?}: {twin:?} in plane stress, {steel:?} of steel");
        }
    }
}

#[test]
fn cells_in_plane_stress_are_those_of_the_ratio_in_plane_strain_that_has_the_same_stiffness() {
    for order in Order::ALL {
        let points = distorted(order);
        let wanted = stiffness(&in_strain(order, RUBBER), &points);
        let found = stiffness(&CellStiffness::of(order, &in_stress(RUBBER), PlaneHypothesis::Stress, 1.3), &points);
        assert!((&found - &wanted).amax() <= 1e-9 * wanted.amax(), "{order:?}");
    }
}

#[test]
fn blocks_in_plane_stress_with_a_ratio_near_one_follow_hertz_as_those_of_steel_do() {
    // Of the width and height of 12 half-widths: what the size leaves is the same for any ratio in plane stress.
    let pressed = |poisson: f64, order: Order| {
        let text = format!(
            "plane = \"stress\"\nthickness = 1.0\n[[body]]\nname = \"block\"\nyoung = 1000.0\npoisson = {poisson:?}\n\
             shape = {{ rectangle = {{ x = [0, 40], y = [0, 40], contact = \"bottom\" }} }}\n\
             supports = [{{ at = \"left\", component = \"x\" }}]\n\
             loads = [{{ traction = {{ at = \"far\", value = [0, -1] }} }}]\n\
             [contact]\nfirst = \"block\"\ngap = {{ circle = 100 }}\nstretch = 5\n[mesh]\nelements = 16\nper = 2\n"
        );
        let resolution = resolution(16, 0, order);
        let (_, run) = solved_on(parsed(&text).scene, resolution, &Formulation::verification());
        [run.measures().peak.pressure, run.measures().half_width()]
    };
    for (order, tolerance) in [(Order::Linear, 6e-3), (Order::Quadratic, 2e-4)] {
        let steel = pressed(0.3, order);
        for poisson in [0.6, 0.95, 0.99] {
            for (found, usual) in pressed(poisson, order).iter().zip(steel) {
                assert!((found / usual - 1.0).abs() <= tolerance, "{order:?}, ν = {poisson}: {found}, not {usual}");
            }
        }
    }
}

/// A block that is so many half-widths wide and high, pressed by a rigid parabola under which a half-space touches over
/// 1 mm, to 0.1 %: errors of peak and half-width by Hertz's strip or circle, relative, each with its bar.
fn pressed(plane: PlaneHypothesis, poisson: f64, size: f64) -> [[f64; 2]; 2] {
    let (young, radius) = (1000.0, 20.0);
    let modulus = young / (1.0 - poisson * poisson);
    let (load, area, peak) = match plane {
        PlaneHypothesis::Strain => (0.5 * PI * modulus / (4.0 * radius), size, modulus / (2.0 * radius)),
        _ => (4.0 * modulus / (3.0 * radius), PI * size * size, 2.0 * modulus / (PI * radius)),
    };
    let [of_plane, symmetric] = match plane {
        PlaneHypothesis::Strain => ["plane = \"strain\"\nthickness = 1.0", "symmetric = true"],
        _ => ["plane = \"axisymmetric\"", ""],
    };
    let text = format!(
        "{of_plane}\n[[body]]\nname = \"block\"\nyoung = {young:?}\npoisson = {poisson:?}\n\
         shape = {{ rectangle = {{ x = [0, {size}], y = [0, {size}], contact = \"bottom\" }} }}\n\
         supports = [{{ at = \"left\", component = \"x\" }}]\nloads = [{{ traction = {{ at = \"far\", value = [0, \
         {:?}] }} }}]\n\
         [contact]\nfirst = \"block\"\ngap = {{ parabola = {radius:?} }}\nstretch = 1.3\n{symmetric}\n[mesh]\naccuracy \
         = \"0.1 %\"\n",
        0.0 - load / area
    );
    let case = Case::parse(Path::new("rubber.toml"), &text).expect("a case");
    let answer = accuracy::solve(&case.scene, &Formulation::verification(), &Asked::new(1e-3)).expect("solved");
    assert_eq!(answer.unmet, None, "{plane:?}, ν = {poisson}, {size} half-widths");
    let error = |(quantity, truth): (Quantity, f64)| {
        let one = told_of(&answer.estimates, &quantity);
        [(one.value / truth - 1.0).abs(), one.bar.total() / truth]
    };
    [(Quantity::PeakPressure, peak), (Quantity::HalfWidth, 1.0)].map(error)
}

#[test]
fn blocks_of_rubber_of_any_size_follow_hertz_as_those_of_steel_do_and_within_their_bars() {
    // What the block's size leaves is (a/H)² in the plane, (a/H)³ of a body of revolution.
    for (plane, size) in [
        (PlaneHypothesis::Axisymmetric, 100.0),
        (PlaneHypothesis::Axisymmetric, 1000.0),
        (PlaneHypothesis::Axisymmetric, 10_000.0),
        (PlaneHypothesis::Strain, 1000.0),
    ] {
        for poisson in [0.3, 0.45, 0.49, LARGEST_POISSON] {
            for [error, bar] in pressed(plane, poisson, size) {
                let what = format!("{plane:?}, ν = {poisson}, {size} half-widths: {error:.1e}, bar {bar:.1e}");
                assert!(error <= 4e-4 && error <= bar + 2e-6, "{what}");
            }
        }
    }
}
