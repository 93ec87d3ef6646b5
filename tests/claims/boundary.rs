//! The boundary method, held against every closed form of the half-plane, and against boundary elements elsewhere.

use std::f64::consts::{FRAC_2_PI, PI};
use std::sync::{Arc, LazyLock};

use approx::assert_relative_eq;
use contact_vv::oracle::analytic::Plane;
use contact_vv::oracle::analytic::even_gap::EvenGap;
use contact_vv::oracle::analytic::hertz::Hertz;
use contact_vv::oracle::analytic::punch::FlatPunch;
use contact_vv::oracle::analytic::waves::Waves;
use contact_vv::oracle::boundary::elements::Elements;
use contact_vv::oracle::boundary::{HalfPlane, Ring, Strip};
use contact_vv::scene::{Material, MonotoneCubic, Profile};

const MODULUS: f64 = 2e5;
/// What the boundary method promises.
const PROMISED: f64 = 1e-7;
/// Parts of a half-width at which pressures are compared.
const PARTS: [f64; 6] = [-0.9, -0.3, 0.0, 0.25, 0.7, 0.99];
/// Places beside and below a contact, over the half-width.
const BELOW: [[f64; 2]; 6] = [[4.0, 0.0], [1.5, 0.01], [0.3, 0.02], [0.0, 4.0], [0.7, 0.5], [9.0, 2.0]];

fn closed(profile: Profile, stretches: &[[f64; 2]]) -> HalfPlane {
    HalfPlane { modulus: MODULUS, profile, stretches: stretches.into() }
}

fn even(coefficients: &[f64]) -> Profile {
    Profile::Even { coefficients: coefficients.into() }
}

fn smooth(points: &[[f64; 2]]) -> Profile {
    Profile::Smooth(Arc::new(MonotoneCubic::through(points)))
}

/// A bottom flat up to a place, and round shoulders of a radius beyond.
fn flat(width: f64, radius: f64) -> Profile {
    let beyond = (0..=60).map(|k| 3.0 * f64::from(k) / 60.0).map(|s| [width + s, 0.5 * s * s / radius]);
    smooth(&[vec![[0.0, 0.0], [0.5 * width, 0.0]], beyond.collect()].concat())
}

/// Waves on a parabola.
fn ripples() -> Profile {
    let at = |k: u32| 0.02 * f64::from(k);
    smooth(&(0..=200).map(|k| [at(k), 1e-3 * (at(k).powi(2) + (1.0 - (8.0 * at(k)).cos()))]).collect::<Vec<_>>())
}

/// The profiles without a closed form: flat with shoulders, skew, two humps, two different humps, ripples; each
/// under a load, and what the boundary method finds of it.
fn others() -> &'static [(Profile, f64, HalfPlane)] {
    static OTHERS: LazyLock<Vec<(Profile, f64, HalfPlane)>> = LazyLock::new(|| {
        let pressed = |(profile, load): (Profile, f64)| {
            let load = load * MODULUS;
            let found = HalfPlane::of_load(MODULUS, profile.clone(), load, [-2.9, 2.9]).expect("a contact");
            (profile, load, found)
        };
        drawn().into_iter().map(pressed).collect()
    });
    &OTHERS
}

/// Those profiles, and loads over E*.
fn drawn() -> Vec<(Profile, f64)> {
    let skew = |s: f64| if s > 0.0 { s.powf(2.5) } else { 0.5 * s.powi(4) };
    let uneven = |s: f64| (s * s - 1.0).powi(2) + 0.03 * s;
    let through = |of: &dyn Fn(f64) -> f64| {
        smooth(&(-75..=75).map(|k| 0.04 * f64::from(k)).map(|s| [s, 1e-3 * of(s)]).collect::<Vec<_>>())
    };
    vec![
        (flat(0.8, 50.0), 1e-3),
        (through(&skew), 1e-3),
        (even(&[-2e-3, 1e-3]), 3e-4),
        (through(&uneven), 3e-4),
        (ripples(), 1.5e-3),
        (ripples(), 5e-3),
    ]
}

#[test]
fn boundary_method_is_every_closed_form_of_an_even_gap() {
    let round: Vec<[f64; 2]> = [0.0, 0.25, 0.5].map(|s| [s, 0.01 * s * s]).into();
    let beyond = [0.5 + 1e-9, 1.0, 3.0].map(|s| [s, 0.0025 + 0.01 * (s - 0.5)]);
    let forms = [
        (even(&[0.01]), EvenGap::polynomial(MODULUS, 2.0, [0.01, 0.0, 0.0])),
        (Profile::Parabola { radius: 50.0 }, EvenGap::polynomial(MODULUS, 2.0, [0.01, 0.0, 0.0])),
        (even(&[1e-3, 2e-3, -1e-4]), EvenGap::polynomial(MODULUS, 2.0, [1e-3, 2e-3, -1e-4])),
        (even(&[-1e-3, 2e-3, 1e-4]), EvenGap::polynomial(MODULUS, 2.0, [-1e-3, 2e-3, 1e-4])),
        (even(&[0.0, 1e-3]), EvenGap::polynomial(MODULUS, 2.0, [0.0, 1e-3, 0.0])),
        (even(&[0.0, 0.0, 1e-4]), EvenGap::polynomial(MODULUS, 2.0, [0.0, 0.0, 1e-4])),
        (smooth(&[round, beyond.into()].concat()), EvenGap::rounded_wedge(MODULUS, 2.0, 50.0, 0.5, 40_000)),
    ];
    for (profile, form) in forms {
        let found = closed(profile.clone(), &[[-2.0, 2.0]]);
        let settled = HalfPlane::of_load(MODULUS, profile.clone(), form.load(), [-2.9, 2.9]).expect("a contact");
        let slope_beside = (profile.gap(2.5 + 1e-4) - profile.gap(2.5 - 1e-4)) / 2e-4;
        assert_relative_eq!(settled.stretches[0][0], -2.0, max_relative = PROMISED);
        assert_relative_eq!(settled.stretches[0][1], 2.0, max_relative = PROMISED);
        for found in [found, settled] {
            assert_relative_eq!(found.load(), form.load(), max_relative = PROMISED);
            let [peak, place] = found.peak();
            assert_relative_eq!(peak, form.peak_pressure(), max_relative = PROMISED);
            assert_relative_eq!(place.abs(), 2.0 * form.peak_place().cos(), epsilon = 2e-4);
            let [centre, width] = found.centre_and_width();
            assert_relative_eq!(centre, 0.0, epsilon = PROMISED);
            assert_relative_eq!(width, form.second_moment(), max_relative = PROMISED);
            assert_relative_eq!(found.opening(2.5), form.opening(2.5, slope_beside), max_relative = 1e-6);
            for part in PARTS {
                let form = form.pressure(part.acos());
                assert_relative_eq!(found.pressure(2.0 * part), form, max_relative = 1e-6);
            }
            for place in BELOW {
                let [x, z] = place.map(|part| 2.0 * part);
                for (found, form) in found.stress(x, z).into_iter().zip(form.stress(x, z)) {
                    assert_relative_eq!(found, form, max_relative = 1e-6, epsilon = PROMISED * peak);
                }
            }
        }
    }
}

#[test]
fn a_parabola_pressed_anywhere_is_hertz() {
    let hertz = Hertz { load: 700.0, radius: 50.0, modulus: MODULUS };
    let found = HalfPlane::of_load(MODULUS, Profile::Parabola { radius: 50.0 }, 700.0, [-1.0, 3.0]).expect("a contact");
    let a = hertz.half_width();
    assert_relative_eq!(found.stretches[0][0], -a, max_relative = PROMISED);
    assert_relative_eq!(found.stretches[0][1], a, max_relative = PROMISED);
    assert_relative_eq!(found.peak()[0], hertz.peak_pressure(), max_relative = PROMISED);
    assert!(HalfPlane::of_load(MODULUS, Profile::Parabola { radius: 50.0 }, 700.0, [-0.1, 3.0]).is_none());
}

#[test]
fn a_sharp_wedge_has_the_pressure_of_an_inverse_hyperbolic_cosine() {
    for profile in [Profile::Wedge { slope: 0.01 }, Profile::Table(vec![[0.0, 0.0], [5.0, 0.05]].into())] {
        let found = closed(profile, &[[-2.0, 2.0]]);
        // Johnson, Contact Mechanics, 1985, §5.2.
        assert_relative_eq!(found.load(), MODULUS * 2.0 * 0.01, max_relative = PROMISED);
        for part in [0.01_f64, 0.3, 0.9] {
            let pressure = MODULUS * 0.01 / PI * part.recip().acosh();
            assert_relative_eq!(found.pressure(2.0 * part), pressure, max_relative = PROMISED);
        }
    }
}

#[test]
fn a_flat_bottom_between_ever_smaller_shoulders_becomes_a_punch() {
    let error = |radius: f64| {
        let found = HalfPlane::of_load(MODULUS, flat(0.8, radius), 200.0, [-2.0, 2.0]).expect("a contact");
        let punch = FlatPunch { load: 200.0, half_width: 0.8 };
        (found.pressure(0.0) / punch.pressure(0.0) - 1.0).abs()
    };
    let errors = [50.0, 5.0, 0.5].map(error);
    assert!(errors[0] > 2.0 * errors[1] && errors[1] > 2.0 * errors[2] && errors[2] <= 0.02, "{errors:?}");
}

#[test]
fn waves_are_those_of_the_half_plane_seen_through_the_tangent() {
    // cot(α − β) = 1/(tan α − tan β) but for a term that an even pressure leaves out: with u = tan(πx/λ) a row of
    // contacts has the equation of one contact, whose slope is that of the waves at x(u).
    let waves = Waves { modulus: MODULUS, amplitude: 1e-3, wavelength: 10.0, mean: 20.0 };
    let end = (PI * waves.half_width() / 10.0).tan();
    let steps = 4000;
    let slope = |u: f64| waves.amplitude * 0.2 * PI * (2.0 * u.atan()).sin();
    // The gap whose slope by u it is, by Simpson's rule; the cubic through it is exact to 1e-10.
    let mut points = vec![[0.0, 0.0]];
    for k in 0..steps {
        let [from, to] = [k, k + 1].map(|k| 1.5 * end * f64::from(k) / f64::from(steps));
        let rise = (to - from) / 6.0 * (slope(from) + 4.0 * slope(0.5 * (from + to)) + slope(to));
        points.push([to, points[points.len() - 1][1] + rise]);
    }
    let found = closed(smooth(&points), &[[-end, end]]);
    for part in [0.0, 0.3, 0.7, 0.95] {
        let x = part * waves.half_width();
        assert_relative_eq!(found.pressure((PI * x / 10.0).tan()), waves.pressure(x), max_relative = PROMISED);
    }
}

#[test]
fn boundary_elements_agree_where_no_closed_form_is() {
    let mut stretches = Vec::new();
    for (number, (profile, load, found)) in others().iter().enumerate() {
        let load = *load;
        let of = |elements| Elements::pressed(MODULUS, profile, load, [-2.9, 2.9], elements).expect("a contact");
        let [coarse, fine] = [of(225), of(900)];
        let [peak, _] = found.peak();
        let highest = |of: &Elements| of.pressures.iter().copied().fold(0.0, f64::max);
        let [force, moment, square] = found.resultants();
        assert_relative_eq!(force, load, max_relative = 1e-9);
        // The highest node is not the peak.
        assert_relative_eq!(highest(&fine), peak, max_relative = 1e-3);
        let error = |of: &Elements| {
            let [_, first, second] = of.resultants();
            [(first - moment).abs() / load, (second / square - 1.0).abs()]
        };
        let [before, after] = [error(&coarse), error(&fine)];
        for (before, after) in before.into_iter().zip(after) {
            assert!(after <= 1e-3 && after <= 0.5 * before.max(1e-6), "{number}: {before:e} {after:e}");
        }
        let ends = fine.stretches();
        assert_eq!(ends.len(), found.stretches.len(), "{number}");
        for (one, other) in ends.iter().flatten().zip(found.stretches.iter().flatten()) {
            assert_relative_eq!(one, other, epsilon = 2e-3);
        }
        stretches.push(found.stretches.len());
    }
    assert_eq!(stretches, [1, 1, 2, 2, 3, 5]);
}

#[test]
fn stresses_below_several_stretches_are_those_of_flamant_and_carry_the_load() {
    for (_, _, found) in others() {
        let [force, moment, _] = found.resultants();
        // On a half-circle around all of it, and its moment about s = 0, by the midpoint rule.
        let (radius, parts) = (8.0, 200);
        let (mut carried, mut turned) = (0.0, 0.0);
        for k in 0..parts {
            let (sin, cos) = (PI * (f64::from(k) + 0.5) / f64::from(parts)).sin_cos();
            let [along, into, shear] = found.stress(radius * cos, radius * sin);
            let [tx, tz] = [along * cos + shear * sin, shear * cos + into * sin];
            carried -= tz * radius * PI / f64::from(parts);
            turned -= (tz * radius * cos - tx * radius * sin) * radius * PI / f64::from(parts);
        }
        assert_relative_eq!(carried, force, max_relative = 1e-5);
        assert_relative_eq!(turned, moment, max_relative = 1e-4, epsilon = 1e-5 * force);
        // Just below the middle of a stretch the surface carries its pressure, and as much along it.
        let [begin, end] = found.stretches[0];
        let x = 0.5 * (begin + end);
        let [along, into, shear] = found.stress(x, 1e-7 * (end - begin));
        let pressure = found.pressure(x);
        assert_relative_eq!(along, -pressure, max_relative = 1e-4);
        assert_relative_eq!(into, -pressure, max_relative = 1e-4);
        assert_relative_eq!(shear, 0.0, epsilon = 1e-4 * pressure);
        // The surface follows the profile, so that the slope of the opening is 0 at an end, and as the root beyond.
        let slope = |part: f64| found.opening(end + part * (end - begin));
        assert_relative_eq!(slope(4e-8), 2.0 * slope(1e-8), max_relative = 1e-2);
        assert!(FRAC_2_PI * slope(1e-8) > 0.0);
    }
}

#[test]
fn a_ring_on_a_pin_is_that_of_another_program() {
    // Radii, modulus and ratio of the ring, clearance, the pressure `P cos θ` outside that presses it on, and what is
    // true of it by Michell's series with collocation and an active set: half-angle, half-angle by second moment
    // [degrees] and peak.
    for (radii, [young, poisson], clearance, outside, [half_angle, second_moment, peak]) in [
        (
            [3.943901632747056, 6.3970700630983375],
            [7636.784946142535, 0.07172018745022757],
            6.282504330663554e-05,
            0.00039990729076686476,
            [10.508510438, 10.571089367782703, 0.007020787356076504],
        ),
        (
            [14.216064286844944, 31.27863773060412],
            [36588.50095305531, 0.010500471293460104],
            0.003266957167441116,
            0.09946439741109014,
            [22.385680504, 22.687553734141993, 1.1121708032888118_f64],
        ),
    ] {
        let material = Material { young, poisson };
        let ring = Ring { radii, material, plane: Plane::Strain, pressure: 0.0 };
        let gap = Profile::Pin { radius: radii[0] - clearance, clearance };
        let found = ring.on_pin(&gap, f64::to_radians(half_angle)).expect("a contact");
        assert_relative_eq!(found.load(), PI * outside * radii[1], max_relative = 1e-7);
        assert_relative_eq!(found.second_moment().to_degrees(), second_moment, max_relative = PROMISED);
        assert_relative_eq!(found.peak()[0], peak, max_relative = PROMISED);
    }
}

#[test]
fn rows_are_westergaards_waves_and_deep_layers_hertz() {
    let (modulus, amplitude, wavelength) = (2.1e5, 1e-3, 4.0);
    for half_width in [0.2, 0.9, 1.7] {
        let profile = Profile::Cosine { amplitude, wavelength };
        let found = Strip::Row(wavelength).pressed(modulus, &profile, half_width, 2.0).expect("a contact");
        let waves = Waves { modulus, amplitude, wavelength, mean: found.load() / wavelength };
        assert_relative_eq!(waves.half_width(), half_width, max_relative = PROMISED);
        assert_relative_eq!(waves.pressure(0.0), found.peak()[0], max_relative = PROMISED);
        assert_relative_eq!(waves.second_moment(), found.second_moment(), max_relative = PROMISED);
    }
    let profile = Profile::Parabola { radius: 100.0 };
    let hertz = Hertz { load: Hertz::load_for(1.0, 100.0, modulus), radius: 100.0, modulus };
    for strip in [Strip::Sliding(3e3), Strip::Bonded(3e3, 0.3)] {
        let found = strip.pressed(modulus, &profile, 1.0, 10.0).expect("a contact");
        assert_relative_eq!(found.peak()[0], hertz.peak_pressure(), max_relative = 1e-6);
        assert_relative_eq!(found.load(), hertz.load, max_relative = 1e-6);
    }
}

#[test]
fn a_thin_layer_is_a_row_of_springs() {
    // p = E* (d − s²/2R)/h, but for the last few h before the end of the contact: at ten layers from there nothing is
    // left of it.
    let (modulus, radius, thickness) = (2.1e5, 1e3, 0.1);
    let profile = Profile::Parabola { radius };
    let found = Strip::Sliding(thickness).pressed(modulus, &profile, 1.0, 2.0).expect("a contact");
    assert_relative_eq!(found.peak()[0], modulus * found.approach / thickness, max_relative = 1e-9);
    let beside = found.pressure(0.95) * thickness / modulus - found.approach + 0.95 * 0.95 / (2.0 * radius);
    assert!(beside.abs() > 1e-3 * found.approach, "near its end it is not: {beside}");
}

/// `p = E (1 − ν)/((1 + ν)(1 − 2ν)) d/h`: bonded to its base it cannot widen; what the bending of the profile leaves is
/// less than half a per cent at a twentieth of the half-width.
#[test]
fn a_thin_layer_that_is_bonded_is_a_row_of_stiffer_springs() {
    let (modulus, thickness, half_width) = (2.1e5, 0.05, 1.0);
    for poisson in [0.0, 0.2, 0.3, 0.4] {
        let strip = Strip::Bonded(thickness, poisson);
        let found = strip.pressed(modulus, &Profile::Parabola { radius: 1e3 }, half_width, 2.0).expect("a contact");
        let confined = modulus * (1.0 - poisson) * (1.0 - poisson) / (1.0 - 2.0 * poisson);
        let off = found.peak()[0] * thickness / (confined * found.approach) - 1.0;
        assert!(off.abs() <= 5e-3, "{poisson}: {off}");
    }
}
