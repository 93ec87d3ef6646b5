//! The scene: constants, gaps, paths and reference values.

use std::f64::consts::{FRAC_PI_2, PI};

use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact_vv::case::library::Patch;
use contact_vv::scene::{Action, Along, Circle, Load, Material, Path, PlaneHypothesis, Profile, SidePart};

use crate::workbench::{STEEL, block};

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

#[test]
fn mirror_image_turns_parts_of_arcs_and_moments_round() {
    let part = Some(SidePart { along: Along::Angle { centre: [1.0, 50.0] }, from: 0.2, to: 0.7 });
    let load = Load::OnSide { boundary: "right".into(), part, action: Action::Moment(3.0) };
    let mirrored = block([20.0, 10.0], vec![], vec![load]).mirrored();
    let Load::OnSide { part: Some(part), action: Action::Moment(moment), .. } = &mirrored.bodies[0].loads[0] else {
        panic!("{:?}", mirrored.bodies[0].loads)
    };
    let Along::Angle { centre } = part.along else { panic!("{part:?}") };
    assert_eq!((part.from, part.to, *moment, centre), (-0.7, -0.2, -3.0, [-1.0, 50.0]));
}
