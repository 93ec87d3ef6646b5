//! The closed forms, held against equilibrium, integration and tables that do not use them.

use std::f64::consts::{FRAC_PI_2, PI};

use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact_vv::oracle::analytic::Plane;
use contact_vv::oracle::analytic::hertz::Hertz;
use contact_vv::oracle::analytic::persson::PinInHole;
use contact_vv::oracle::analytic::punch::FlatPunch;
use contact_vv::oracle::analytic::shell::{PressFit, Shape};
use contact_vv::oracle::analytic::uniform::Uniform;
use contact_vv::oracle::{Oracle, Quantity, Reading, ReferenceKind};
use contact_vv::scene::Material;
use nalgebra::{Matrix4, Vector4};

const HERTZ: Hertz = Hertz { load: 1200.0, radius: 50.0, modulus: 230_769.0 };

const PIN: PinInHole =
    PinInHole { radius: 10.0, clearance: 0.05, load: 2000.0, modulus: 210_000.0, poisson: 0.3, plane: Plane::Stress };

const STEEL: Material = Material { young: 210_000.0, poisson: 0.3 };

const FIT: PressFit = PressFit {
    shape: Shape::FreeCylinder,
    radii: [20.0, 30.0, 50.0],
    interference: 0.02,
    materials: [Material { young: 70_000.0, poisson: 0.33 }, STEEL],
};

const PUNCH: FlatPunch = FlatPunch { load: 300.0, half_width: 2.0 };

/// `∫ f` by the midpoint rule, which converges exponentially once the ends are smooth.
fn integral(from: f64, to: f64, intervals: usize, f: impl Fn(f64) -> f64) -> f64 {
    let h = (to - from) / intervals as f64;
    (0..intervals).map(|i| h * f(from + (i as f64 + 0.5) * h)).sum()
}

/// Principal value of `∫ p(s) / (x − s) ds` over `−a…a`: the slope of a half-plane's surface but for a factor.
fn hilbert(half_width: f64, x: f64, p: impl Fn(f64) -> f64) -> f64 {
    let at_x = p(x);
    let regular = integral(0.0, PI, 20_001, |t| {
        let s = half_width * t.cos();
        (p(s) - at_x) / (x - s) * half_width * t.sin()
    });
    regular + at_x * ((half_width + x) / (half_width - x)).ln()
}

#[test]
fn hertz_pressure_bends_the_half_plane_to_the_parabola() {
    let a = HERTZ.half_width();

    for s in [0.1237, 0.4561, 0.8017] {
        let slope = 2.0 / (PI * HERTZ.modulus) * hilbert(a, s * a, |x| HERTZ.pressure(x));
        assert_relative_eq!(slope, s * a / HERTZ.radius, max_relative = 1e-6);
    }
}

#[test]
fn hertz_pressure_adds_up_to_the_load() {
    let a = HERTZ.half_width();

    let resultant = integral(-FRAC_PI_2, FRAC_PI_2, 100, |t| HERTZ.pressure(a * t.sin()) * a * t.cos());

    assert_relative_eq!(resultant, HERTZ.load, max_relative = 1e-12);
    assert_relative_eq!(HERTZ.pressure(0.0), HERTZ.peak_pressure());
    assert_relative_eq!(Hertz::load_for(a, HERTZ.radius, HERTZ.modulus), HERTZ.load, max_relative = 1e-14);
    assert_abs_diff_eq!(HERTZ.pressure(1.01 * a), 0.0);
}

/// Stresses of Flamant's point loads spread as the semi-ellipse, without the closed form.
fn flamant(x: f64, z: f64) -> [f64; 3] {
    let a = HERTZ.half_width();
    let peak = 2.0 * HERTZ.load / (PI * a);
    let component = |power: i32| {
        -2.0 / PI
            * integral(-FRAC_PI_2, FRAC_PI_2, 4000, |t| {
                let across = x - a * t.sin();
                let r2 = across.powi(2) + z.powi(2);
                peak * a * t.cos().powi(2) * across.powi(power) * z.powi(3 - power) / r2.powi(2)
            })
    };
    [component(2), component(0), component(1)]
}

#[test]
fn stresses_below_hertz_contact_equal_integrated_flamant_loads() {
    let a = HERTZ.half_width();
    for (x, z) in [(0.0, 0.5), (0.5, 0.1), (1.0, 0.2), (-0.7, 0.9), (1.5, 0.05), (-3.0, 2.0), (40.0, 3.0), (5.0, 200.0)]
    {
        let (closed, integrated) = (HERTZ.stress(x * a, z * a), flamant(x * a, z * a));
        for (ours, theirs) in closed.iter().zip(&integrated) {
            let scale = integrated.iter().map(|s| s.abs()).fold(0.0, f64::max);
            assert_abs_diff_eq!(ours / scale, theirs / scale, epsilon = 1e-11);
        }
    }
}

#[test]
fn stresses_on_the_surface_are_the_pressure_and_nothing_else() {
    let (a, p0) = (HERTZ.half_width(), HERTZ.peak_pressure());
    for s in [0.0, 0.2, 0.99, 1.01, 2.0, 100.0] {
        let [across, down, shear] = HERTZ.stress(s * a, 0.0);
        let p = HERTZ.pressure(s * a);
        assert_abs_diff_eq!(across / p0, -p / p0, epsilon = 1e-12);
        assert_abs_diff_eq!(down / p0, -p / p0, epsilon = 1e-12);
        assert_abs_diff_eq!(shear / p0, 0.0, epsilon = 1e-12);
    }
}

#[test]
fn stresses_below_hertz_contact_are_numbers_everywhere_but_at_the_edge() {
    let a = HERTZ.half_width();
    let lengths = [0.0, 1e-300, 1e-12, 0.3, 1.0, 1.0 + 1e-12, 2.0, 1e6];
    for x in lengths {
        for z in lengths {
            let finite = HERTZ.stress(x * a, z * a).iter().all(|s| s.is_finite());
            let at_edge = (x - 1.0).abs() < 1e-15 && z < 1e-100;
            assert!(finite || at_edge, "x = {x} a, z = {z} a: {:?}", HERTZ.stress(x * a, z * a));
        }
    }
    assert!(HERTZ.stress(a, 0.0)[1].is_nan());
}

#[test]
fn pin_in_hole_is_in_equilibrium() {
    for clearance in [0.0, 1e-4, 0.01, 0.05, 1.0] {
        let pin = PinInHole { clearance, ..PIN };
        let edge = pin.half_angle();

        let resultant = integral(-FRAC_PI_2, FRAC_PI_2, 4000, |t| {
            let phi = edge * t.sin();
            pin.pressure(phi) * phi.cos() * pin.radius * edge * t.cos()
        });

        assert_relative_eq!(resultant, PIN.load, max_relative = 1e-10);
    }
}

/// Gap between hole and pin at each angle from the Fourier moments of the pressure, once it closes at `φ = 0`.
///
/// Michell's terms give the opening `(4R/E_p) [p_0/2 + Σ n p_n cos nφ / (n²−1)]`, `n ≥ 2`, with `p_0` the mean;
/// the term `n = 1` is a shift of the pin, which is free.
fn gaps(pin: &PinInHole, angles: &[f64]) -> Vec<f64> {
    let edge = pin.half_angle();
    let intervals = 4000;
    let samples: Vec<(f64, f64)> = (0..intervals)
        .map(|i| {
            let t = -FRAC_PI_2 + (i as f64 + 0.5) * PI / intervals as f64;
            let angle = edge * t.sin();
            (angle, pin.pressure(angle) * edge * t.cos() / intervals as f64)
        })
        .collect();
    let moment = |order: f64| samples.iter().map(|(angle, weight)| weight * (order * angle).cos()).sum::<f64>();
    let moments: Vec<f64> = (0..2000).map(|n| moment(n as f64)).collect();

    let open = |phi: f64| {
        let series = (2..2000).map(|n| {
            let order = n as f64;
            order * moments[n] * (order * phi).cos() / (order.powi(2) - 1.0)
        });
        pin.clearance + 4.0 * pin.radius / pin.modulus * (0.25 * moments[0] + series.sum::<f64>())
    };
    angles.iter().map(|&phi| open(phi) - open(0.0) * phi.cos()).collect()
}

#[test]
fn pin_in_hole_touches_inside_the_contact_and_only_there() {
    for clearance in [0.0, 0.001, 0.01, 0.05] {
        let pin = PinInHole { clearance, ..PIN };
        let edge = pin.half_angle();
        let scale = pin.load / pin.modulus;

        let inside = gaps(&pin, &[0.3, 0.6, 0.9].map(|part| part * edge));
        for gap in inside {
            assert_abs_diff_eq!(gap / scale, 0.0, epsilon = 1e-6);
        }
        for gap in gaps(&pin, &[1.1 * edge, 1.5 * edge]) {
            assert!(gap / scale > 1e-4, "clearance {clearance}: {gap} outside the contact");
        }
    }
}

#[test]
fn pin_load_for_an_angle_makes_that_angle() {
    for degrees in [0.5_f64, 10.0, 45.0, 80.0] {
        let load = PinInHole::load_for(degrees.to_radians(), PIN.clearance, PIN.modulus);
        assert_relative_eq!(PinInHole { load, ..PIN }.half_angle().to_degrees(), degrees, max_relative = 1e-12);
    }
    assert!(PinInHole::load_for(1.5, PIN.clearance, PIN.modulus).is_nan(), "no clearance opens beyond 84.8°");
    assert!(PinInHole::load_for(1.0, 0.0, PIN.modulus).is_nan(), "no clearance, no load for an angle");
}

/// Hoop stresses of hole and pin from the Fourier moments of the pressure and Michell's terms of orders 0 and 1.
fn michell(pin: &PinInHole, phi: f64) -> [f64; 2] {
    let edge = pin.half_angle();
    let moment = |order: f64| {
        integral(-FRAC_PI_2, FRAC_PI_2, 4000, |t| {
            let angle = edge * t.sin();
            pin.pressure(angle) * (order * angle).cos() * edge * t.cos() / PI
        })
    };
    let (mean, first) = (0.5 * moment(0.0), moment(1.0) * phi.cos());
    // In plane strain the plane-stress form holds with ν/(1−ν): (κ−1)/(κ+1) = (1−ν)/2.
    let nu = match pin.plane {
        Plane::Stress => pin.poisson,
        Plane::Strain => pin.poisson / (1.0 - pin.poisson),
        Plane::Axisymmetric | Plane::AxisymmetricAboutX => f64::NAN,
    };
    let rest = pin.pressure(phi) - mean - first;
    let sideways = first * 0.5 * (1.0 - nu);
    [-rest + mean + sideways, -rest - mean - sideways]
}

#[test]
fn pin_and_hole_hoop_stresses_follow_from_the_pressure_by_michells_series() {
    for plane in [Plane::Stress, Plane::Strain] {
        let pin = PinInHole { plane, ..PIN };
        for phi in [0.0, 0.4, 1.0, 2.0, PI] {
            let [hole, rim] = michell(&pin, phi);
            let peak = pin.peak_pressure();
            assert_abs_diff_eq!(pin.hole_hoop_stress(phi) / peak, hole / peak, epsilon = 1e-9);
            assert_abs_diff_eq!(pin.pin_hoop_stress(phi) / peak, rim / peak, epsilon = 1e-9);
        }
    }
}

/// Lamé constant `λ` of the plane problem and `μ`.
fn lame_constants(material: Material, plane: Plane) -> (f64, f64) {
    let Material { young, poisson } = material;
    let mu = young / (2.0 * (1.0 + poisson));
    let lambda = young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
    match plane {
        Plane::Strain => (lambda, mu),
        Plane::Stress => (2.0 * lambda * mu / (lambda + 2.0 * mu), mu),
        Plane::Axisymmetric | Plane::AxisymmetricAboutX => (f64::NAN, mu),
    }
}

/// Interface pressure from `u = Ar + B/r` in each ring, free rims, equal stress and the mismatch `δ`.
fn mismatch_pressure(fit: &PressFit, plane: Plane) -> f64 {
    let [(li, mi), (lo, mo)] = fit.materials.map(|material| lame_constants(material, plane));
    let [a, b, c] = fit.radii;
    let radial = |lambda: f64, mu: f64, r: f64| (2.0 * (lambda + mu), -2.0 * mu / r.powi(2));
    let (ia, ib) = (radial(li, mi, a), radial(li, mi, b));
    let (ob, oc) = (radial(lo, mo, b), radial(lo, mo, c));
    #[rustfmt::skip]
    let equations = Matrix4::new(
        ia.0, ia.1,     0.0,   0.0,
        0.0,  0.0,      oc.0,  oc.1,
        ib.0, ib.1,     -ob.0, -ob.1,
        -b,   -1.0 / b, b,     1.0 / b,
    );
    let constants =
        equations.lu().solve(&Vector4::new(0.0, 0.0, 0.0, fit.interference)).expect("rings of positive width resist");
    -(ob.0 * constants[2] + ob.1 * constants[3])
}

#[test]
fn press_fit_pressure_closes_the_mismatch_of_the_rings() {
    for plane in [Plane::Stress, Plane::Strain] {
        let fit = PressFit { shape: Shape::of_ring(plane), ..FIT };
        assert_relative_eq!(fit.pressure(), mismatch_pressure(&fit, plane), max_relative = 1e-11);
    }
}

#[test]
fn bars_carry_nothing_until_the_gap_is_closed() {
    let at = |displacement: f64| Uniform::bars(1000.0, 5.0, [30.0, 20.0], 0.1, displacement).resultant;

    assert_abs_diff_eq!(at(-1.0), 0.0);
    assert_abs_diff_eq!(at(0.1), 0.0);
    // Springs in series: k = 1/(L1/EA + L2/EA).
    let (first, second) = (30.0 / 5000.0, 20.0 / 5000.0);
    assert_relative_eq!(at(0.3), 0.2 / (first + second), max_relative = 1e-14);
}

#[test]
fn flat_punch_keeps_the_surface_flat_and_carries_its_load() {
    let a = PUNCH.half_width;

    for s in [0.1237, 0.4561, 0.8017] {
        let slope = hilbert(a, s * a, |x| PUNCH.pressure(x));
        assert_abs_diff_eq!(slope / PUNCH.pressure(0.0), 0.0, epsilon = 1e-6);
    }
    let load = integral(-FRAC_PI_2, FRAC_PI_2, 100, |t| PUNCH.pressure(a * t.sin()) * a * t.cos());
    assert_relative_eq!(load, PUNCH.load, max_relative = 1e-12);
}

const QUANTITIES: [Quantity; 6] = [
    Quantity::HalfWidth,
    Quantity::PeakPressure,
    Quantity::Resultant,
    Quantity::Pressure { at: 0.1 },
    Quantity::HoopStress { at: 0.1 },
    Quantity::PinHoopStress { at: 0.1 },
];

fn sound() -> [Box<dyn Oracle>; 7] {
    let bars = Uniform::bars(1000.0, 5.0, [30.0, 20.0], 0.1, 0.3);
    let (patch, block) = (Uniform::patch(7.0, 3.0), Uniform::own_weight(7.7e-5, 100.0, 40.0));
    [Box::new(HERTZ), Box::new(PIN), Box::new(FIT), Box::new(bars), Box::new(PUNCH), Box::new(patch), Box::new(block)]
}

#[test]
fn every_closed_form_names_its_source_and_answers() {
    for oracle in sound() {
        let name = oracle.name().to_owned();
        let source = oracle.source();
        assert_eq!(oracle.kind(), ReferenceKind::Analytic, "{name}");
        let nowhere = oracle.read(&Quantity::Pressure { at: f64::NAN });
        assert!(matches!(&nowhere, Reading::Unavailable(why) if why.contains("at is NaN")), "{name}: {nowhere:?}");
        assert!(!name.is_empty() && !source.citation.is_empty() && !source.note.is_empty(), "{name}");
        let answers = QUANTITIES.map(|quantity| oracle.read(&quantity));
        assert!(answers.iter().all(|answer| !matches!(answer, Reading::Unavailable(_))), "{name}: {answers:?}");
        assert!(answers.iter().any(|answer| matches!(answer, Reading::Value { .. })), "{name}");
    }
}

/// Each closed form with one parameter set to `value`, beside that parameter's name.
fn spoiled(value: f64) -> Vec<(&'static str, Box<dyn Oracle>)> {
    let soft = Material { young: value, ..STEEL };
    let odd = Material { poisson: value, ..STEEL };
    vec![
        ("load", Box::new(Hertz { load: value, ..HERTZ })),
        ("radius", Box::new(Hertz { radius: value, ..HERTZ })),
        ("modulus", Box::new(Hertz { modulus: value, ..HERTZ })),
        ("radius", Box::new(PinInHole { radius: value, ..PIN })),
        ("clearance", Box::new(PinInHole { clearance: value, ..PIN })),
        ("load", Box::new(PinInHole { load: value, ..PIN })),
        ("modulus", Box::new(PinInHole { modulus: value, ..PIN })),
        ("poisson", Box::new(PinInHole { poisson: value, ..PIN })),
        ("bore", Box::new(PressFit { radii: [value, 30.0, 50.0], ..FIT })),
        ("interface", Box::new(PressFit { radii: [20.0, value, 50.0], ..FIT })),
        ("outside", Box::new(PressFit { radii: [20.0, 30.0, value], ..FIT })),
        ("interference", Box::new(PressFit { interference: value, ..FIT })),
        ("inner.young", Box::new(PressFit { materials: [soft, STEEL], ..FIT })),
        ("outer.young", Box::new(PressFit { materials: [STEEL, soft], ..FIT })),
        ("inner.poisson", Box::new(PressFit { materials: [odd, STEEL], ..FIT })),
        ("outer.poisson", Box::new(PressFit { materials: [STEEL, odd], ..FIT })),
        ("young", Box::new(Uniform::bars(value, 5.0, [30.0, 20.0], 0.1, 0.3))),
        ("section", Box::new(Uniform::bars(1000.0, value, [30.0, 20.0], 0.1, 0.3))),
        ("moved_length", Box::new(Uniform::bars(1000.0, 5.0, [value, 20.0], 0.1, 0.3))),
        ("fixed_length", Box::new(Uniform::bars(1000.0, 5.0, [30.0, value], 0.1, 0.3))),
        ("gap", Box::new(Uniform::bars(1000.0, 5.0, [30.0, 20.0], value, 0.3))),
        ("load", Box::new(FlatPunch { load: value, ..PUNCH })),
        ("half_width", Box::new(FlatPunch { half_width: value, ..PUNCH })),
        ("applied", Box::new(Uniform::patch(value, 3.0))),
        ("width", Box::new(Uniform::patch(7.0, value))),
        ("specific_weight", Box::new(Uniform::own_weight(value, 100.0, 40.0))),
        ("height", Box::new(Uniform::own_weight(7.7e-5, value, 40.0))),
        ("width", Box::new(Uniform::own_weight(7.7e-5, 100.0, value))),
    ]
}

#[test]
fn parameters_out_of_range_are_named_and_give_no_number() {
    for value in [f64::NAN, -1.0, f64::INFINITY, f64::NEG_INFINITY] {
        for (parameter, oracle) in spoiled(value) {
            for quantity in QUANTITIES {
                let reading = oracle.read(&quantity);
                let case = format!("{} with {parameter} = {value}, {quantity:?}: {reading:?}", oracle.name());
                match reading {
                    Reading::Silent => {}
                    Reading::Unavailable(why) => {
                        assert!(why.contains(&format!("{parameter} is {value}")), "{case}")
                    }
                    Reading::Value { .. } => panic!("{case}"),
                }
            }
        }
    }
}

#[test]
fn infinite_pressure_at_a_punch_corner_is_not_read() {
    let at = PUNCH.half_width;

    let reading = PUNCH.read(&Quantity::Pressure { at });

    assert!(matches!(&reading, Reading::Unavailable(why) if why.contains("at = 2")), "{reading:?}");
    assert_eq!(PUNCH.read(&Quantity::PeakPressure), Reading::Silent);
}

#[test]
fn stresses_below_a_flat_punch_carry_its_load_and_are_its_pressure_on_the_surface() {
    let punch = FlatPunch { load: 1000.0, half_width: 2.0 };
    for x in [0.0, 0.7, -1.9] {
        let [sx, sz, shear] = punch.stress(x, 0.0);
        assert_relative_eq!(sz, -punch.pressure(x), max_relative = 1e-12);
        assert_relative_eq!(sx, sz, max_relative = 1e-12);
        assert!(shear.abs() <= 1e-12 * sz.abs());
    }
    assert!(punch.stress(3.0, 0.0).iter().all(|stress| stress.abs() <= 1e-9));
    // On a line below, x = z tan t: all of the load, and no shear altogether; far away Flamant's 2P/πz.
    for z in [0.3, 2.0, 50.0] {
        let parts = 20_000;
        let at = |part: usize| PI * ((part as f64 + 0.5) / parts as f64 - 0.5);
        let sum = |k: usize| -> f64 {
            let one = |part: usize| punch.stress(z * at(part).tan(), z)[k] * z / at(part).cos().powi(2);
            (0..parts).map(one).sum::<f64>() * PI / parts as f64
        };
        assert_relative_eq!(sum(1), -1000.0, max_relative = 1e-6);
        assert!(sum(2).abs() <= 1e-6 * 1000.0, "{}", sum(2));
    }
    assert_relative_eq!(punch.stress(0.0, 2000.0)[1], -1000.0 / PI / 1000.0, max_relative = 1e-5);
}
