//! Closed forms of bodies of revolution, each derived a second way.

use std::f64::consts::{FRAC_PI_2, PI, SQRT_2, TAU};

use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact_vv::oracle::analytic::revolution::half_space::{Potential, Stress};
use contact_vv::oracle::analytic::revolution::indentation::Indentation;
use contact_vv::oracle::analytic::revolution::sphere::Sphere;
use contact_vv::oracle::analytic::shell::{PressFit, Shape, Shell};
use contact_vv::oracle::{Oracle, Quantity, Reading};
use contact_vv::scene::Material;

const STEEL: Material = Material { young: 210e3, poisson: 0.3 };
const BRASS: Material = Material { young: 100e3, poisson: 0.35 };

const SPHERE: Sphere = Sphere { load: 9600.0, radius: 50.0, modulus: 230_769.0 };

/// Radius of the contacts.
const A: f64 = 2.5;

/// Relative error of quadratures below an edge: places next to it have half of their digits.
const EDGE: f64 = 1e-7;

/// Every kind of profile, pressed to one radius.
fn profiles() -> [(&'static str, Indentation); 8] {
    let smooth = |powers: &[[f64; 2]]| Indentation::smooth(SPHERE.modulus, A, powers.to_vec());
    [
        ("paraboloid", smooth(&[[0.01, 2.0]])),
        ("cone", smooth(&[[0.05, 1.0]])),
        ("r^1.5", smooth(&[[0.02, 1.5]])),
        ("r^0.6", smooth(&[[0.02, 0.6]])),
        ("r^3.7", smooth(&[[0.002, 3.7]])),
        ("r² − r⁴ + r⁵", smooth(&[[0.01, 2.0], [-4e-4, 4.0], [1e-4, 5.0]])),
        ("flat", Indentation::flat(SPHERE.modulus, A, SPHERE.load)),
        ("paraboloid with an edge", Indentation { beyond: 0.02, ..smooth(&[[0.01, 2.0]]) }),
    ]
}

/// `∫ f` by the double exponential rule; the ends may be singular.
fn integral(from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
    let (half, step) = (0.5 * (to - from), 1.0 / 64.0);
    let terms = (-210..=210).map(|k: i32| {
        let u = step * f64::from(k);
        let v = FRAC_PI_2 * u.sinh();
        // The distance from the nearer end keeps its digits.
        let apart = half * (-v.abs()).exp() / v.cosh();
        let place = if v < 0.0 { from + apart } else { to - apart };
        let weight = half * step * FRAC_PI_2 * u.cosh() / v.cosh().powi(2);
        if place > from && place < to { weight * f(place) } else { 0.0 }
    });
    terms.sum()
}

/// `∫₀ᵃ f p dr` of the pressure of a contact; with `r = a sin θ` it may be infinite at the edge.
fn under(contact: &Indentation, f: impl Fn(f64) -> f64) -> f64 {
    integral(0.0, FRAC_PI_2, |angle| {
        let r = contact.radius * angle.sin();
        if r < contact.radius { contact.pressure(r) * f(r) * contact.radius * angle.cos() } else { 0.0 }
    })
}

/// Complete elliptic integral of the first kind by the arithmetic-geometric mean, given `k'² = 1 − k²`.
fn elliptic(complement: f64) -> f64 {
    // At r = s, where it is infinite, nothing of an integral over s may come from one place.
    let (mut a, mut b) = (1.0, complement.sqrt().max(f64::MIN_POSITIVE));
    for _ in 0..40 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    PI / (2.0 * a)
}

/// Profile of a contact at r.
fn gap(contact: &Indentation, r: f64) -> f64 {
    contact.powers.iter().map(|[c, n]| c * r.powf(*n)).sum()
}

/// Central difference.
fn slope(f: impl Fn(f64) -> f64, x: f64, step: f64) -> f64 {
    // Of fourth order.
    (8.0 * (f(x + step) - f(x - step)) - (f(x + 2.0 * step) - f(x - 2.0 * step))) / (12.0 * step)
}

#[test]
fn approach_of_revolution_is_the_transform_by_quadrature() {
    for (name, contact) in profiles() {
        // With r = t sin φ: w = t ∫ g'(t sin φ) dφ.
        let slope = |r: f64| contact.powers.iter().map(|[c, n]| c * n * r.powf(n - 1.0)).sum::<f64>();
        let transform = |t: f64| t * integral(0.0, FRAC_PI_2, |phi| slope(t * phi.sin()));

        assert_relative_eq!(contact.approach(), contact.beyond + transform(A), max_relative = 1e-9);

        let load = 2.0 * SPHERE.modulus * (A * contact.approach() - integral(0.0, A, transform));
        assert!((contact.load() / load - 1.0).abs() < 1e-9, "{name}");
    }
}

#[test]
fn pressure_of_revolution_adds_up_to_load_and_second_moment() {
    for (name, contact) in profiles() {
        let force = under(&contact, |r| TAU * r);
        let moment = under(&contact, |r| TAU * r.powi(3));

        assert!((force / contact.load() - 1.0).abs() < EDGE, "{name}: {force} {}", contact.load());
        assert!(((2.5 * moment / force).sqrt() / contact.second_moment_radius() - 1.0).abs() < EDGE, "{name}");
        assert_abs_diff_eq!(contact.pressure(1.001 * A), 0.0);
    }
}

#[test]
fn pressure_of_revolution_presses_the_surface_to_the_profile() {
    // Boussinesq over rings: u = (4/πE*) ∫ p s K(k) ds/(r + s), k² = 4rs/(r + s)².
    for (name, contact) in profiles() {
        for r in [0.1 * A, 0.53 * A, 0.95 * A] {
            let ring = |s: f64| s * elliptic(((r - s) / (r + s)).powi(2)) / (r + s);
            let at = |angle: f64| {
                let s = A * angle.sin();
                if s < A { contact.pressure(s) * ring(s) * A * angle.cos() } else { 0.0 }
            };
            let middle = (r / A).asin();
            let sum = integral(0.0, middle, at) + integral(middle, FRAC_PI_2, at);
            let displacement = 4.0 / (PI * SPHERE.modulus) * sum;

            let expected = contact.approach() - gap(&contact, r);
            assert!((displacement / expected - 1.0).abs() < 1e-7, "{name} at {r}: {displacement} {expected}");
        }
    }
}

#[test]
fn smooth_profiles_carry_the_largest_load_at_their_approach() {
    // Pressure that falls to zero at the edge: the load at a given approach is stationary in the radius (Barber 1974).
    for (name, contact) in profiles().into_iter().filter(|(_, contact)| contact.beyond <= 0.0) {
        let load = |radius: f64| {
            let smooth = Indentation { radius, ..contact.clone() };
            let beyond = contact.approach() - smooth.approach();
            Indentation { beyond, ..smooth }.load()
        };

        assert!(slope(load, A, 1e-3).abs() < 1e-6 * contact.load() / A, "{name}");
    }
}

#[test]
fn sphere_is_the_paraboloid_of_its_radius() {
    let a = SPHERE.contact_radius();
    let contact = Indentation::smooth(SPHERE.modulus, a, vec![[0.5 / SPHERE.radius, 2.0]]);

    assert_relative_eq!(contact.load(), SPHERE.load, max_relative = 1e-12);
    assert_relative_eq!(contact.approach(), SPHERE.approach(), max_relative = 1e-12);
    assert_relative_eq!(contact.peak_pressure(), SPHERE.peak_pressure(), max_relative = 1e-12);
    assert_relative_eq!(contact.pressure(0.7 * a), SPHERE.pressure(0.7 * a), max_relative = 1e-12);
    assert_relative_eq!(contact.second_moment_radius(), a, max_relative = 1e-12);
    assert_relative_eq!(Sphere::load_for(a, SPHERE.radius, SPHERE.modulus), SPHERE.load, max_relative = 1e-14);
}

#[test]
fn cone_and_flat_punch_are_those_of_sneddon_and_boussinesq() {
    let [(_, cone), (_, flat)] = [1, 6].map(|k| profiles()[k].clone());
    // F = πE* a² tan β/2, δ = πa tan β/2, p = (E* tan β/2) arcosh(a/r).
    let slope = 0.05;
    assert_relative_eq!(cone.approach(), FRAC_PI_2 * A * slope, max_relative = 1e-13);
    assert_relative_eq!(cone.load(), FRAC_PI_2 * cone.modulus * A * A * slope, max_relative = 1e-13);
    assert_relative_eq!(cone.pressure(1.0), 0.5 * cone.modulus * slope * A.acosh(), max_relative = 1e-13);
    assert_eq!(cone.pressure(0.0), f64::INFINITY);
    assert_relative_eq!(flat.load(), SPHERE.load, max_relative = 1e-14);
    assert_relative_eq!(flat.pressure(0.0), SPHERE.load / (TAU * A * A), max_relative = 1e-14);
    assert_eq!(flat.pressure(A), f64::INFINITY);
}

#[test]
fn circle_of_revolution_is_that_of_segedin() {
    // w = t artanh(t/R): δ = a artanh(a/R), F = E* [(a² + R²) artanh(a/R) − aR].
    let radius = 10.0;
    let contact = Indentation::smooth(SPHERE.modulus, A, Indentation::circle(radius, 20));
    let angle = (A / radius).atanh();

    assert_relative_eq!(gap(&contact, 2.0), radius - (radius * radius - 4.0).sqrt(), max_relative = 1e-13);
    assert_relative_eq!(contact.approach(), A * angle, max_relative = 1e-13);
    let load = contact.modulus * ((A * A + radius * radius) * angle - A * radius);
    assert_relative_eq!(contact.load(), load, max_relative = 1e-12);
}

#[test]
fn load_makes_the_radius_that_makes_the_load() {
    for (name, contact) in profiles().into_iter().filter(|(_, contact)| contact.beyond <= 0.0) {
        let found = Indentation::of_load(contact.load(), contact.modulus, &contact.powers, [1e-3, 5.0]);

        assert!((found.radius / A - 1.0).abs() < 1e-12, "{name}: {}", found.radius);
    }
}

#[test]
fn peak_of_revolution_may_lie_off_the_axis() {
    // r⁴: p ∝ (1 + 2s²) √(1 − s²), largest at s = 1/√2.
    let contact = Indentation::smooth(SPHERE.modulus, A, vec![[1e-3, 4.0]]);
    assert_relative_eq!(contact.peak_pressure(), contact.pressure(A / SQRT_2), max_relative = 1e-13);
    assert!(contact.peak_pressure() > 1.3 * contact.pressure(0.0));

    let between = Indentation::smooth(SPHERE.modulus, A, vec![[1e-2, 1.5]]);
    assert_relative_eq!(between.peak_pressure(), between.pressure(0.0), max_relative = 1e-13);
    assert_relative_eq!(between.pressure(1e-9), between.pressure(0.0), max_relative = 1e-3);
}

#[test]
fn pressures_of_revolution_without_limit_have_no_peak_to_read() {
    for (name, contact) in profiles() {
        let limited = !["cone", "r^0.6", "flat", "paraboloid with an edge"].contains(&name);
        let read = contact.read(&Quantity::PeakPressure);
        assert_eq!(matches!(read, Reading::Value { .. }), limited, "{name}: {read:?}");
        assert!(limited || read == Reading::Silent, "{name}: {read:?}");
    }
}

#[test]
fn closed_forms_of_revolution_refuse_what_is_out_of_range() {
    let contact = |powers| Indentation::smooth(SPHERE.modulus, A, powers);
    for (wrong, contact) in [
        ("radius", Indentation { radius: f64::NAN, ..contact(vec![[0.01, 2.0]]) }),
        ("load", contact(vec![[-0.01, 2.0]])),
        ("power", contact(vec![[0.01, 2.0], [0.01, 0.0]])),
        ("steep power", contact(vec![[0.01, 1e18]])),
        ("coefficient", contact(vec![[f64::NAN, 2.0]])),
        ("beyond", Indentation { beyond: -1e-3, ..contact(vec![[0.01, 2.0]]) }),
    ] {
        for quantity in [Quantity::Resultant, Quantity::Approach, Quantity::Pressure { at: 0.5 }] {
            let read = contact.read(&quantity);
            assert!(matches!(read, Reading::Unavailable(_)), "{wrong}: {read:?}");
        }
    }
    let flat = Sphere { load: -1.0, ..SPHERE };
    assert!(matches!(flat.read(&Quantity::Approach), Reading::Unavailable(why) if why.contains("load")));
    assert_eq!(SPHERE.read(&Quantity::Approach), Reading::Value { value: SPHERE.approach(), uncertainty: 0.0 });
    assert_eq!(SPHERE.read(&Quantity::Centre), Reading::Silent);
}

/// Places in the half-space, near and far.
const PLACES: [[f64; 2]; 5] = [[0.5, 0.3], [0.2, 2.0], [1.7, 0.4], [6.0, 5.0], [1.3, 8.0]];

/// Both closed forms, of a radius, `r` and `z`.
const POTENTIALS: [fn(f64, f64, f64) -> Potential; 2] = [Potential::flat, Potential::hertz];

#[test]
fn stresses_of_revolution_are_in_equilibrium() {
    for (k, potential) in POTENTIALS.into_iter().enumerate() {
        for [r, z] in PLACES {
            let at = |r: f64, z: f64| potential(1.0, r, z).stress(0.3);
            let along = |part: fn(Stress) -> f64| slope(|r| part(at(r, z)), r, 1e-3);
            let down = |part: fn(Stress) -> f64| slope(|z| part(at(r, z)), z, 1e-3);
            let here = at(r, z);
            let radial = along(|s| s.radial) + down(|s| s.shear) + (here.radial - here.hoop) / r;
            let axial = along(|s| s.shear) + down(|s| s.axial) + here.shear / r;

            assert!(radial.abs().max(axial.abs()) < 1e-8, "{k} at {r}, {z}: {radial} {axial}");
        }
    }
}

#[test]
fn stresses_of_revolution_follow_from_displacements_by_hooke() {
    let Material { young, poisson } = STEEL;
    let shear = young / (2.0 * (1.0 + poisson));
    let bulk = 2.0 * shear * poisson / (1.0 - 2.0 * poisson);
    for (k, potential) in POTENTIALS.into_iter().enumerate() {
        for [r, z] in PLACES {
            let at = |r: f64, z: f64| potential(1.0, r, z).displacement(STEEL);
            let along = [0, 1].map(|k| slope(|r| at(r, z)[k], r, 1e-3));
            let down = [0, 1].map(|k| slope(|z| at(r, z)[k], z, 1e-3));
            let hoop = at(r, z)[0] / r;
            let volume = bulk * (along[0] + down[1] + hoop);
            let normal = [along[0], down[1], hoop].map(|strain| volume + 2.0 * shear * strain);
            let stress = potential(1.0, r, z).stress(poisson);

            let given = [stress.radial, stress.axial, stress.hoop, stress.shear];
            let found = [normal[0], normal[1], normal[2], shear * (along[1] + down[0])];
            for (given, found) in given.into_iter().zip(found) {
                assert!((given - found).abs() < 1e-8, "{k} at {r}, {z}: {given} {found}");
            }
        }
    }
}

#[test]
fn surface_below_hertz_carries_its_pressure_alone() {
    let (a, p0, poisson) = (SPHERE.contact_radius(), SPHERE.peak_pressure(), 0.3);
    for s in [0.0, 0.3, 0.6, 0.97] {
        let stress = SPHERE.potential(s * a, 0.0).stress(poisson);
        assert_relative_eq!(stress.axial, -SPHERE.pressure(s * a), max_relative = 1e-12);
        assert_abs_diff_eq!(stress.shear, 0.0);
        let into = SPHERE.potential(s * a, 0.0).displacement(STEEL)[1];
        let modulus = STEEL.young / (1.0 - STEEL.poisson.powi(2));
        let expected = (SPHERE.approach() - (s * a).powi(2) / (2.0 * SPHERE.radius)) * SPHERE.modulus / modulus;
        assert_relative_eq!(into, expected, max_relative = 1e-12);
    }
    // Outside, pure shear in the surface: σ_r = −σ_θ = (1 − 2ν) p₀ a²/3r² (Johnson 1985, eq. 3.44).
    for r in [1.05, 1.6, 8.0] {
        let stress = SPHERE.potential(r * a, 0.0).stress(poisson);
        let expected = (1.0 - 2.0 * poisson) * p0 / (3.0 * r * r);
        assert_relative_eq!(stress.radial, expected, max_relative = 1e-9);
        assert_relative_eq!(stress.hoop, -expected, max_relative = 1e-9);
        assert_abs_diff_eq!(stress.axial, 0.0, epsilon = 1e-12 * p0);
    }
}

#[test]
fn approach_of_two_spheres_is_the_sum_of_what_their_surfaces_give_way() {
    let modulus = 1.0 / [STEEL, BRASS].map(|of| (1.0 - of.poisson.powi(2)) / of.young).iter().sum::<f64>();
    let pair = Sphere { radius: 1.0 / (1.0 / 50.0 + 1.0 / 30.0), modulus, ..SPHERE };
    let sum: f64 = [STEEL, BRASS].iter().map(|of| pair.potential(0.0, 0.0).displacement(*of)[1]).sum();

    assert_relative_eq!(sum, pair.approach(), max_relative = 1e-12);
}

#[test]
fn axis_below_hertz_has_the_stresses_of_the_books() {
    let (a, p0) = (SPHERE.contact_radius(), SPHERE.peak_pressure());
    for s in [0.0, 0.48, 1.0, 7.0] {
        let stress = SPHERE.potential(0.0, s * a).stress(0.3);
        let [axial, radial] = SPHERE.on_axis(s * a, 0.3);
        assert_abs_diff_eq!(stress.axial, axial, epsilon = 1e-12 * p0);
        assert_abs_diff_eq!(stress.radial, radial, epsilon = 1e-12 * p0);
        assert_abs_diff_eq!(stress.hoop, radial, epsilon = 1e-12 * p0);
    }
    // 0.31 p₀ at 0.48 a for ν = 0.3 (Johnson 1985, §3.4): nowhere on a grid is it larger.
    let [depth, largest] = SPHERE.largest_shear(0.3);
    assert_abs_diff_eq!(largest / p0, 0.31, epsilon = 5e-4);
    assert_abs_diff_eq!(depth / a, 0.48, epsilon = 2e-3);
    for [r, z] in (0..900).map(|k| [0.05 * f64::from(k % 30), 0.05 + 0.05 * f64::from(k / 30)]) {
        let here = SPHERE.potential(r * a, z * a).stress(0.3).largest_shear();
        assert!(here <= largest, "{here} at {r}, {z}");
    }
}

#[test]
fn stresses_below_any_profile_are_those_of_the_point_loads_on_it() {
    // On the axis σ_z = −3z³ ∫ p r dr/(r² + z²)^{5/2}, and u_z = (1 + ν)/E ∫ p r dr [2(1 − ν)/ρ + z²/ρ³].
    for (name, contact) in profiles() {
        for z in [0.6, 3.0, 20.0] {
            let below = contact.potential(0.0, z);
            let axial = -3.0 * z.powi(3) * under(&contact, |r| r * r.hypot(z).powi(-5));
            let stress = below.stress(STEEL.poisson).axial;
            assert!((stress / axial - 1.0).abs() < EDGE, "{name} at {z}: {stress} {axial}");

            let flexible = |r: f64| 2.0 * (1.0 - STEEL.poisson) / r.hypot(z) + z * z * r.hypot(z).powi(-3);
            let into = (1.0 + STEEL.poisson) / STEEL.young * under(&contact, |r| r * flexible(r));
            let found = below.displacement(STEEL)[1];
            assert!((found / into - 1.0).abs() < EDGE, "{name} at {z}: {found} {into}");
        }
    }
}

#[test]
fn flat_punches_of_all_radii_make_the_stresses_below_hertz() {
    let a = SPHERE.contact_radius();
    let contact = Indentation::smooth(SPHERE.modulus, a, vec![[0.5 / SPHERE.radius, 2.0]]);
    for [r, z] in PLACES.map(|place| place.map(|part| part * a)) {
        let [one, other] =
            [contact.potential(r, z), SPHERE.potential(r, z)].map(|potential| potential.stress(STEEL.poisson));
        let pairs = one.in_plane().into_iter().chain([one.hoop]).zip(other.in_plane().into_iter().chain([other.hoop]));
        for (one, other) in pairs {
            assert_abs_diff_eq!(one, other, epsilon = 1e-11 * SPHERE.peak_pressure());
        }
    }
}

#[test]
fn tractions_of_a_truncated_block_carry_the_load() {
    // Down on the far face, along on the round side: together the load of every profile.
    let side = 8.0 * A;
    for (name, contact) in profiles() {
        let stress = |r: f64, z: f64| contact.potential(r, z).stress(STEEL.poisson);
        let far = integral(0.0, side, |r| TAU * r * stress(r, side).axial);
        let round = integral(0.0, side, |z| TAU * side * stress(side, z).shear);
        let carried = -far - round;
        assert!((carried / contact.load() - 1.0).abs() < 1e-9, "{name}: {carried} {}", contact.load());
    }
}

/// Shells of every shape, one of them solid.
fn shells() -> Vec<(Shape, Shell)> {
    let shapes = [Shape::Sphere, Shape::FreeCylinder, Shape::FixedCylinder];
    let shell = |shape, radii, pressures| (shape, Shell { shape, radii, pressures, material: STEEL });
    let thick = shapes.map(|shape| shell(shape, [20.0, 50.0], [70.0, 30.0]));
    thick.into_iter().chain(shapes.map(|shape| shell(shape, [0.0, 50.0], [0.0, 30.0]))).collect()
}

#[test]
fn thick_shells_are_in_equilibrium_and_compatible() {
    for (shape, shell) in shells() {
        let around = if shape == Shape::Sphere { 2.0 } else { 1.0 };
        for r in [21.0, 33.0, 49.0] {
            let [radial, hoop, third] = shell.stress(r);
            let residual = slope(|r| shell.stress(r)[0], r, 1e-2) + around * (radial - hoop) / r;
            assert_abs_diff_eq!(residual, 0.0, epsilon = 1e-8);

            // Hooke: the radial strain is the slope of the displacement, which the hoop strain gave.
            let strain = (radial - STEEL.poisson * (hoop + third)) / STEEL.young;
            assert_relative_eq!(slope(|r| shell.displacement(r), r, 1e-2), strain, max_relative = 1e-7);
            let axial = (third - STEEL.poisson * (radial + hoop)) / STEEL.young;
            assert!(shape != Shape::FixedCylinder || axial.abs() < 1e-15, "{axial}");
        }
        let [a, b] = shell.radii;
        let [inside, outside] = shell.pressures;
        assert_relative_eq!(shell.stress(b)[0], -outside, max_relative = 1e-13);
        assert!(a <= 0.0 || (shell.stress(a)[0] + inside).abs() < 1e-12, "{shape:?}");
        assert!(a > 0.0 || shell.stress(0.0)[0] == -outside, "{shape:?}");
        assert_abs_diff_eq!(shell.displacement(0.0).min(0.0), 0.0);
    }
}

#[test]
fn fitted_shells_take_up_their_interference() {
    for shape in [Shape::Sphere, Shape::FreeCylinder, Shape::FixedCylinder] {
        for bore in [0.0, 20.0] {
            let radii = [bore, 30.0, 50.0];
            let [inner, outer] = PressFit { shape, radii, interference: 0.02, materials: [BRASS, STEEL] }.fitted();

            assert_relative_eq!(outer.displacement(30.0) - inner.displacement(30.0), 0.02, max_relative = 1e-13);
            assert_relative_eq!(outer.stress(30.0)[0], inner.stress(30.0)[0], max_relative = 1e-13);
        }
    }
}
