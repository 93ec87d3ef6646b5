//! The scene: constants, gaps, paths and reference values.

use std::f64::consts::{FRAC_PI_2, PI};

use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact_vv::case::library::{
    Bars, Cylinder, CylinderModel, FlatPunch, OwnWeight, Patch, PinPlate, PinRod, PressFit,
};
use contact_vv::elasticity::ElasticSystem;
use contact_vv::mesh::{Mesh, Order};
use contact_vv::scene::{Circle, Material, Path, PlaneHypothesis, Profile, Scene};

use crate::workbench::{STEEL, library, resolution};

/// Relative round-off of a handful of operations.
const ROUND_OFF: f64 = 1e-13;

#[test]
fn elasticity_matrix_inverts_hookes_law_in_three_dimensions() {
    let material = Material { young: 70e3, poisson: 0.33 };
    let [sx, sy, txy] = [3.0, -7.0, 2.0];
    for plane in [PlaneHypothesis::Strain, PlaneHypothesis::Stress] {
        let sz = if plane == PlaneHypothesis::Strain { material.poisson * (sx + sy) } else { 0.0 };
        let strain = |s: f64, others: f64| (s - material.poisson * others) / material.young;
        let ez = strain(sz, sx + sy);
        let shear = txy * 2.0 * (1.0 + material.poisson) / material.young;
        let strains = [strain(sx, sy + sz), strain(sy, sx + sz), shear];
        let d = material.stiffness(plane);

        let stress: Vec<f64> = d.iter().map(|row| row.iter().zip(strains).map(|(d, e)| d * e).sum()).collect();

        if plane == PlaneHypothesis::Strain {
            assert_abs_diff_eq!(ez, 0.0, epsilon = 1e-18);
        }
        for (found, wanted) in stress.iter().zip([sx, sy, txy]) {
            assert_relative_eq!(*found, wanted, max_relative = ROUND_OFF);
        }
    }
}

#[test]
fn plane_modulus_is_stress_over_strain_under_uniaxial_stress() {
    let material = Material { young: 70e3, poisson: 0.33 };
    for plane in [PlaneHypothesis::Strain, PlaneHypothesis::Stress] {
        let d = material.stiffness(plane);
        let uniaxial = d[0][0] - d[0][1] * d[1][0] / d[1][1];
        assert_relative_eq!(material.plane_modulus(plane), uniaxial, max_relative = ROUND_OFF);
    }
}

#[test]
fn contact_compliances_add_up_and_a_rigid_side_adds_none() {
    let mut scene = Patch::default().scene();
    scene.bodies[0].material = Material { young: 70e3, poisson: 0.33 };
    let strain = (1.0 - 0.33_f64.powi(2)) / 70e3 + (1.0 - 0.3_f64.powi(2)) / 210e3;

    assert_relative_eq!(1.0 / scene.contact_modulus(), strain, max_relative = ROUND_OFF);
    scene.plane = PlaneHypothesis::Stress;
    assert_relative_eq!(1.0 / scene.contact_modulus(), 1.0 / 70e3 + 1.0 / 210e3, max_relative = ROUND_OFF);
    scene.contacts[0].second = None;
    assert_relative_eq!(scene.contact_modulus(), 70e3, max_relative = ROUND_OFF);
    scene.contacts[0].first = 1;
    assert_relative_eq!(scene.contact_modulus(), STEEL.young, max_relative = ROUND_OFF);
}

#[test]
fn gap_of_the_circle_is_the_height_of_its_lower_arc() {
    let radius = 50.0;
    for x in [0.0, 0.3, 5.0, 20.0] {
        let gap = Profile::Circle { radius }.gap(x);
        assert_abs_diff_eq!(x.hypot(radius - gap), radius, epsilon = 1e-13 * radius);
        assert!(gap >= 0.0 && gap < radius);
    }
}

#[test]
fn parabola_osculates_the_circle_and_keeps_the_gap_quadratic() {
    let (circle, parabola) = (Profile::Circle { radius: 50.0 }, Profile::Parabola { radius: 50.0 });
    // The next term of the circle's series, x⁴/8R³, is relative x²/4R² = 1e-8 at x = 0.01.
    assert_relative_eq!(circle.gap(0.01), parabola.gap(0.01), max_relative = 1.1e-8);
    assert_relative_eq!(parabola.gap(6.0), 4.0 * parabola.gap(3.0), max_relative = ROUND_OFF);
    assert_relative_eq!(Profile::Uniform(-0.02).gap(0.7), -0.02);
}

#[test]
fn gap_of_the_hole_is_the_distance_along_the_pins_radius() {
    for (radius, clearance) in [(10.0, 0.05), (10.0, 3.0), (0.01, 5e-5)] {
        for angle in [0.0_f64, 0.1, 0.7, FRAC_PI_2, 2.5, PI] {
            let gap = Profile::Hole { radius, clearance }.gap(angle);
            // The hole's centre lies the clearance above the pin's, so that both touch at the lowest point.
            let reach = radius + gap;
            let on_hole = (reach * angle.sin()).hypot(-reach * angle.cos() - clearance);
            assert_abs_diff_eq!(on_hole, radius + clearance, epsilon = 1e-14 * (radius + clearance));
        }
    }
}

#[test]
fn ray_from_any_inner_pole_ends_on_the_circle() {
    let circle = Circle { centre: [2.0, -1.0], radius: 5.0 };
    for pole in [[2.0, -1.0], [4.0, 1.0], [-1.0, -2.0]] {
        for k in 0..12 {
            let angle = k as f64 * PI / 6.0;
            let r = circle.along_ray(pole, angle);
            let end = [pole[0] + r * angle.sin(), pole[1] - r * angle.cos()];
            let distance = (end[0] - circle.centre[0]).hypot(end[1] - circle.centre[1]);
            assert!(r > 0.0);
            assert_abs_diff_eq!(distance, circle.radius, epsilon = 1e-14 * 10.0);
        }
    }
}

#[test]
fn contact_coordinate_of_an_arc_is_the_angle_from_the_downward_vertical() {
    let path = Path::Arc(Circle { centre: [1.0, 2.0], radius: 3.0 });
    for angle in [0.0_f64, 0.4, FRAC_PI_2, 2.0, 3.0] {
        let outward = [angle.sin(), -angle.cos()];
        let point = [1.0 + 3.0 * outward[0], 2.0 + 3.0 * outward[1]];
        let mirrored = [1.0 - 3.0 * outward[0], point[1]];
        let direction = path.direction(point);

        assert_abs_diff_eq!(path.coordinate(point), angle, epsilon = 1e-15 * 10.0);
        assert_abs_diff_eq!(path.coordinate(mirrored), angle, epsilon = 1e-15 * 10.0);
        assert_abs_diff_eq!(direction[0], outward[0], epsilon = 1e-15 * 10.0);
        assert_abs_diff_eq!(direction[1], outward[1], epsilon = 1e-15 * 10.0);
        assert_abs_diff_eq!(path.share(angle), -outward[1], epsilon = 1e-15);
        assert_abs_diff_eq!(path.alignment(angle, 0.0), -outward[1], epsilon = 1e-15);
    }
    assert_relative_eq!(path.metric(), 3.0);
    assert_abs_diff_eq!(path.alignment(1.3, 1.1), path.alignment(0.0, 0.2), epsilon = 1e-15);
}

#[test]
fn contact_coordinate_of_a_plane_is_the_distance_from_the_symmetry_line() {
    let path = Path::HORIZONTAL;
    assert_relative_eq!(path.coordinate([-3.0, 7.0]), 3.0);
    assert_eq!(path.direction([5.0, 1.0]), [0.0, -1.0]);
    assert_relative_eq!(path.metric() * path.share(2.0) * path.alignment(1.0, 2.0), 1.0);
}

#[test]
fn reference_values_of_the_cylinder_are_those_of_hertz() {
    let numbers = Cylinder { radius: 40.0, young: 70e3, poisson: 0.2, a_over_r: 0.03, ..Cylinder::default() };
    let scene = numbers.scene();
    let modulus = 70e3 / (1.0 - 0.04);
    // Hertz, line contact with a plane (Johnson 1985, eqs 4.43 to 4.45): p₀ = a E*/2R and P = π a p₀/2.
    let (a, radius) = (1.2, 40.0);
    let peak = a * modulus / (2.0 * radius);

    assert_relative_eq!(scene.reference.length, a, max_relative = ROUND_OFF);
    assert_relative_eq!(scene.reference.pressure, peak, max_relative = ROUND_OFF);
    assert_relative_eq!(numbers.load(), PI * a * peak / 2.0, max_relative = ROUND_OFF);
    assert_relative_eq!(scene.reference.gap, a * a / (2.0 * radius), max_relative = ROUND_OFF);
    assert_relative_eq!(scene.contact().stretch, 2.0 * a, max_relative = ROUND_OFF);
}

/// Vertical load on the modelled part [N].
fn applied(scene: &Scene, body: usize, elements: usize) -> f64 {
    let mesh = Mesh::of(scene, resolution(elements, 0, Order::Quadratic)).expect("mesh");
    ElasticSystem::assemble(scene, &mesh).expect("system").bodies[body].applied_vertical()
}

#[test]
fn modelled_half_carries_half_of_the_stated_load() {
    let cylinder = Cylinder::default();
    let half = Cylinder { model: CylinderModel::HalfLoadedAbove, ..cylinder };
    let rod = PinRod { force: 700.0, ..PinRod::default() };
    let plate = PinPlate { force: 300.0, ..PinPlate::default() };
    let punch = FlatPunch { load: 123.0, ..FlatPunch::default() };
    let weight = OwnWeight { weight: 3e-2, ..OwnWeight::default() };
    let patch = Patch { pressure: 7.0, ..Patch::default() };
    for (what, found, wanted) in [
        ("cylinder", applied(&cylinder.scene(), 0, 4), -0.5 * cylinder.load()),
        ("half cylinder", applied(&half.scene(), 0, 4), -0.5 * half.load()),
        ("pin-rod", applied(&rod.scene(), 1, 6), 350.0),
        ("pin-plate", applied(&plate.scene(), 0, 6), -150.0),
        ("punch", applied(&punch.scene(), 0, 8), -61.5),
        ("own weight", applied(&weight.scene(), 0, 2), -3e-2 * 20.0 * 40.0),
        ("patch", applied(&patch.scene(), 0, 2), -70.0),
    ] {
        // The quadratic arc of the half cylinder spans its exact horizontal length; only round-off is left.
        assert!((found - wanted).abs() <= 1e-11 * wanted.abs(), "{what}: {found} instead of {wanted}");
    }
}

#[test]
fn stiffness_unit_of_the_exact_scenes_is_their_own_scale() {
    // p_ref = E* g_ref/ℓ wherever no gap of its own is given.
    let scenes = [
        Patch::default().scene(),
        Bars::default().scene(),
        OwnWeight::default().scene(),
        PressFit::default().scene(),
        PressFit { plane: PlaneHypothesis::Strain, ..PressFit::default() }.scene(),
        FlatPunch::default().scene(),
    ];
    for scene in scenes {
        let reference = scene.reference;
        let wanted = reference.pressure * reference.length / scene.contact_modulus();
        assert_relative_eq!(reference.gap, wanted, max_relative = ROUND_OFF);
    }
}

#[test]
fn pin_is_measured_by_its_radius_its_load_and_its_clearance() {
    let numbers = PinRod { pin_radius: 8.0, clearance: 0.03, force: 900.0, thickness: 2.0, ..PinRod::default() };
    let reference = numbers.scene().reference;
    assert_relative_eq!(reference.length, 8.0);
    assert_relative_eq!(reference.pressure, 900.0 / (2.0 * 8.0));
    assert_relative_eq!(reference.gap, 0.03);
}

#[test]
fn scene_in_metres_has_the_same_pure_numbers() {
    for (scene, _) in library() {
        let metres = scene.in_metres();
        let pure = |scene: &Scene, unit: f64| {
            let reference = scene.reference;
            let stretch = match scene.contact().path {
                Path::Straight(_) => scene.contact().stretch / reference.length,
                Path::Arc(_) => scene.contact().stretch,
            };
            let at = 0.5 * scene.contact().stretch;
            [
                reference.pressure * reference.length / (scene.contact_modulus() * reference.gap),
                scene.contact().profile.gap(at) / reference.gap,
                stretch,
                scene.grading.unit / reference.length,
                scene.thickness / unit,
                reference.length / unit,
                reference.pressure * unit * unit,
            ]
        };
        let (millimetres, metres) = (pure(&scene, 1.0), pure(&metres, 1e-3));
        for (k, (a, b)) in millimetres.iter().zip(metres).enumerate() {
            assert!((a - b).abs() <= 1e-12 * a.abs(), "{}, number {k}: {a} and {b}", scene.name);
        }
    }
}

#[test]
fn direction_of_an_arc_is_exact_on_its_axes_whatever_its_radius() {
    for radius in [1e-9, 1.0, 1e9] {
        let path = Path::Arc(Circle { centre: [0.0, 0.0], radius });
        for (angle, sine) in [(PI / 6.0, 0.5), (1e-6, 1e-6_f64.sin()), (1e-11, 1e-11)] {
            let [along, across] = [radius * angle.sin(), radius * angle.cos()];
            let [[x, _], [_, y]] = [path.direction([along, -across]), path.direction([across, -along])];
            assert_relative_eq!(x, sine, max_relative = 1e-12);
            assert_relative_eq!(y, -sine, max_relative = 1e-12);
        }
        let rounded = 5e-13 * radius;
        assert_eq!(path.direction([rounded, -radius]), [0.0, -1.0], "{radius}");
        assert_eq!(path.direction([radius, -rounded]), [1.0, 0.0], "{radius}");
    }
}

#[test]
fn gap_reaches_its_last_place_as_rounded_and_no_further() {
    let punch = Profile::Punch { half_width: 3.0 };
    let table = Profile::Table([[0.0, 0.0], [1.0, 0.5], [3.0, 2.5]].into());
    for (profile, last, rounded, beyond) in [(punch, 0.0, 5e-10, 2e-9), (table, 2.5, 5e-13, 2e-12)] {
        assert_eq!(profile.gap(3.0), last);
        assert_eq!(profile.gap(3.0 * (1.0 + rounded)), last);
        assert_eq!(profile.gap(3.0 * (1.0 + beyond)), f64::INFINITY);
    }
}

#[test]
fn kinks_of_a_table_do_not_depend_on_the_unit_of_its_gaps() {
    for unit in [1e-9, 1.0, 1e9] {
        // Straight but for rounding up to 0.7, with a kink there.
        let straight = (0..8).map(|k| [0.1 * f64::from(k), unit * (0.3 * f64::from(k))]);
        let table: Vec<[f64; 2]> = straight.chain([[0.8, unit * 3.0]]).collect();
        let kinks = Profile::Table(table.into()).kinks();
        assert!(kinks.len() == 1 && (kinks[0] - 0.7).abs() < 1e-12, "{unit}: {kinks:?}");
    }
}
