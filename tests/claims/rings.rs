//! Contacts of bodies of revolution that are rings: off the axis, along it, and on arcs; and blocks that carry the
//! tractions of a half-space.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use approx::assert_relative_eq;
use contact_vv::algorithm::Iteration;
use contact_vv::case::Case;
use contact_vv::case::library::Indented;
use contact_vv::contact::Element;
use contact_vv::error::Error;
use contact_vv::measure::Quantity;
use contact_vv::mesh::{Order, Resolution};
use contact_vv::oracle::analytic::hertz::Hertz;
use contact_vv::oracle::analytic::revolution::half_space::Potential;
use contact_vv::oracle::analytic::revolution::indentation::Indentation;
use contact_vv::oracle::analytic::revolution::sphere::Sphere;
use contact_vv::scene::{
    Component, Displaced, Face, Grading, Material, MonotoneCubic, Path as Way, Place, PlaneHypothesis, Profile,
    ReferenceValues, Scene, Shape,
};
use contact_vv::solve::{Discretisation, Formulation, Run};

use crate::balance::scene;
use crate::scene_file;
use crate::workbench::{held, meshed, stressed, told, turned};

const ORDERS: [Order; 4] = [Order::Linear, Order::Quadratic, Order::Quartic, Order::Octic];

fn across(origin: [f64; 2]) -> Way {
    Way::Straight { origin, both_sides: true }
}

/// A ring on a flat, and a sleeve around a rigid shaft, whose contact is a line along the axis; with the areas of their
/// contacts.
fn pressed() -> [(&'static str, Scene, f64); 2] {
    let (about_y, about_x) = (PlaneHypothesis::Axisymmetric, PlaneHypothesis::AxisymmetricAboutX);
    let ring = Shape::Rectangle { x: [2.0, 5.0], y: [0.0, 2.0], contact: Face::Bottom };
    let sleeve = Shape::Rectangle { x: [-1.5, 1.5], y: [2.0, 4.0], contact: Face::Bottom };
    let all = [-7.0, -7.0, 0.0];
    let mut around = turned(about_x, sleeve, across([0.0, 2.0]), 1.5, all, &["right", "far"]);
    around.bodies[0].supports = vec![held("left", Component::X, 0.0)];
    // Under the same pressure from all sides its bore narrows by p (1 − 2ν) r/E.
    around.contacts[0].profile = Profile::Uniform(7.0 * 0.4 * 2.0 / 1000.0);
    [
        ("ring", turned(about_y, ring, across([3.5, 0.0]), 1.5, all, &["left", "right", "far"]), PI * (25.0 - 4.0)),
        ("sleeve", around, TAU * 2.0 * 3.0),
    ]
}

#[test]
fn uniform_pressures_on_rings_are_exact() {
    for (order, element) in ORDERS.into_iter().flat_map(|order| Element::ALL.map(|element| (order, element))) {
        for (name, scene, area) in pressed() {
            let case = format!("{name}, {order:?}, {element:?}");
            let discretisation = meshed(scene, 4, order);
            let formulation = Formulation::new(element, Iteration::Kinematic).tolerance(1e-11);
            let run = Run::of(&discretisation, &formulation).expect("solved");

            for point in &run.solution.points {
                assert!((point.pressure / 7.0 - 1.0).abs() <= 1e-9, "{case}: {point:?}");
            }
            let weights: f64 = run.solution.points.iter().map(|point| point.weight).sum();
            assert_relative_eq!(weights, area, max_relative = 1e-12);
            assert_relative_eq!(run.transmitted(), 7.0 * area, max_relative = 1e-9);
            assert!(run.imbalance() <= 1e-9, "{case}");
            let measures = run.measures();
            assert_relative_eq!(measures.peak.pressure, 7.0, max_relative = 1e-9);
            assert_relative_eq!(measures.half_width(), 1.5, max_relative = 1e-9);
            // Areas over the circumference where their points lie.
            assert_relative_eq!(measures.half_width_nodes, 1.5, max_relative = 3e-2);
            let fields = discretisation.recover(&run.solution).expect("recovered");
            for (stress, hoop) in fields.stress.iter().zip(discretisation.stress_across(&fields)) {
                for (found, wanted) in stress.iter().chain([&hoop]).zip([-7.0, -7.0, 0.0, -7.0]) {
                    assert!((found - wanted).abs() <= 1e-7, "{case}: {stress:?} {hoop}");
                }
            }
        }
    }
}

/// What a case finds.
fn solved(case: &Case) -> Run {
    let (_, run) = case.solve().unwrap_or_else(|error| panic!("{error}"));
    assert!(run.solution.converged(), "{}", run.solution.outcome);
    run
}

#[test]
fn a_ring_on_a_shaft_of_its_length_is_lames() {
    let case = scene("ring-on-shaft", &[]);
    let (run, value) = (solved(&case), told(&case, &Quantity::PeakPressure));
    for point in &run.solution.points {
        assert_relative_eq!(point.pressure, value, max_relative = 1e-5);
    }
    assert_relative_eq!(run.transmitted(), value * TAU * 40.0 * 20.0, max_relative = 1e-5);

    // What the plane scene of the same rings says.
    let swapped = scene(
        "ring-on-shaft",
        &[
            ["name = \"ring\"\nyoung = 210e3\npoisson = 0.3", "name = \"ring\"\nyoung = 70e3\npoisson = 0.33"],
            ["name = \"shaft\"\nyoung = 70e3\npoisson = 0.33", "name = \"shaft\"\nyoung = 210e3\npoisson = 0.3"],
        ],
    );
    let [turned, plane] = [swapped, scene_file::case("press-fit")].map(|case| solved(&case));
    assert_relative_eq!(turned.measures().peak.pressure, plane.measures().peak.pressure, max_relative = 1e-3);
}

#[test]
fn a_ball_in_a_narrow_shell_is_lames() {
    let case = scene("ball-in-shell", &[]);
    let (run, value) = (solved(&case), told(&case, &Quantity::PeakPressure));
    for point in &run.solution.points {
        assert!((point.pressure / value - 1.0).abs() <= 1e-5, "{point:?} {value}");
    }
    // The half's force along the axis is that on its circle.
    assert_relative_eq!(run.transmitted(), value * PI * 900.0, max_relative = 1e-5);
    assert!(run.imbalance() <= 1e-6);
}

/// Inner and outer radius of a ring of pressure \[mm\], and its largest pressure over that at the mean square of both.
const B: f64 = 3.0;
const A: f64 = 5.0;
/// Largest pressure \[MPa\].
const PEAK: f64 = 1000.0;

/// `p = 4P (r² − b²)(a² − r²)/(a² − b²)²` from b to a.
fn pressure(r: f64) -> f64 {
    let apart = (r * r - B * B) * (A * A - r * r);
    4.0 * PEAK * apart.max(0.0) / (A * A - B * B).powi(2)
}

/// Flat punches of all radii t ≤ a make it: `p = ∫ᵣᵃ h(t) dt/√(t² − r²)`, `h = −(2/π) d/dt ∫ₜᵃ r p dr/√(r² − t²)`
/// (Abel).
///
/// With `v = r² − t²` the integral is that of `(v + t² − b²)(a² − t² − v)/2√v`, from `max(0, b² − t²)` to `a² − t²`.
fn punches(t: f64) -> f64 {
    let [low, high] = [(B * B - t * t).max(0.0), A * A - t * t];
    let at_a = high.sqrt() * (A * A + 2.0 * B * B - 3.0 * t * t - high / 3.0);
    let at_b = low.sqrt() * (2.0 * A * A + B * B - 3.0 * t * t - low / 3.0);
    -8.0 * PEAK * t * (at_a - at_b) / (PI * (A * A - B * B).powi(2))
}

/// Sum over the punches, by the midpoint rule in an angle: at the ends of every part, and at a radius, there may be a
/// root.
fn over_punches<T>(radius: f64, mut sum: T, mut add: impl FnMut(T, f64, f64) -> T) -> T {
    let mut ends = vec![0.0, B, A];
    ends.extend((radius > 0.0 && radius < A).then_some(radius));
    ends.sort_by(f64::total_cmp);
    ends.dedup();
    for part in ends.windows(2) {
        let [middle, half] = [0.5 * (part[0] + part[1]), 0.5 * (part[1] - part[0])];
        for k in 0..200 {
            let angle = PI * (f64::from(k) + 0.5) / 200.0;
            let t = middle - half * angle.cos();
            sum = add(sum, t, punches(t) * half * angle.sin() * PI / 200.0);
        }
    }
    sum
}

fn below(r: f64, z: f64) -> Potential {
    // Whose own edge lies elsewhere: there a potential is no number.
    let none = Potential::flat(100.0 * A, r, z).times(0.0);
    over_punches(r, none, |sum, t, weight| sum.with(Potential::flat(t, r, z).times(weight)))
}

/// `∫ p f dA` over the ring.
fn over_ring(f: impl Fn(f64) -> f64) -> f64 {
    let at = |k: i32| B + (A - B) * (f64::from(k) + 0.5) / 4000.0;
    (0..4000).map(at).map(|r| pressure(r) * f(r) * TAU * r * (A - B) / 4000.0).sum()
}

#[test]
fn punches_make_a_ring_of_pressure() {
    // The load of a punch of pressure 1/√(t² − r²) is 2πt.
    let load = over_punches(0.0, 0.0, |sum, t, weight| sum + TAU * t * weight);
    assert_relative_eq!(load, over_ring(|_| 1.0), max_relative = 1e-4);
    assert_relative_eq!(load, TAU / 3.0 * PEAK * (A * A - B * B), max_relative = 1e-4);
    // ∫ h dt/√(t² − r²) with u² = t² − r².
    for r in [2.0, 3.6, 4.4_f64] {
        let most = (A * A - r * r).sqrt();
        let at = |k: i32| (r * r + (most * (f64::from(k) + 0.5) / 2e4).powi(2)).sqrt();
        let sum = (0..20_000).map(at).map(|t| punches(t) / t * most / 2e4).sum::<f64>();
        assert!((sum - pressure(r)).abs() <= 1e-4 * PEAK, "{r}: {sum} {}", pressure(r));
    }
}

/// A block on a rigid profile that a ring of it fits when it carries that pressure, with the stresses of the half-space
/// on its other sides. Inside and outside the ring the profile lies lower.
fn on_a_ring() -> Scene {
    let [middle, stretch, side] = [0.5 * (A + B), 3.0, 40.0];
    let sunk = |r: f64| below(r, 0.0).displacement(Material::STEEL)[1];
    let largest = (0..200).map(|k| sunk(B + (A - B) * f64::from(k) / 200.0)).fold(0.0, f64::max);
    // Nowhere an interference, by what the places between leave.
    let gap = |r: f64| 1e-5 + largest - sunk(r) + 1e-3 * ((B - r).max(0.0) + (r - A).max(0.0)).powi(2);
    // Somewhat beyond the last candidates, which rounding may move.
    let places = (-602..=602).map(|k| stretch * f64::from(k) / 600.0);
    let points: Vec<[f64; 2]> = places.map(|s| [s, gap(middle + s)]).collect();
    let shape = Shape::Rectangle { x: [0.0, side], y: [0.0, side], contact: Face::Bottom };
    let mut scene = turned(PlaneHypothesis::Axisymmetric, shape, across([middle, 0.0]), stretch, [0.0; 3], &[]);
    let body = &mut scene.bodies[0];
    body.material = Material::STEEL;
    body.loads = stressed(&["right", "far"], |[r, depth]| below(r, depth).stress(0.3).in_plane()).collect();
    scene.contacts[0].profile = Profile::Smooth(Arc::new(MonotoneCubic::through(&points)));
    scene.reference = ReferenceValues { length: 1.0, pressure: PEAK, gap: 1e-2 };
    scene.grading = Grading { unit: 1.0, along: 1.5, depth: 1.4, first: 1.0, coarsest: 0.2, end: 1.0 };
    scene
}

#[test]
fn a_ring_of_contact_is_its_closed_form() -> Result<(), Error> {
    let discretisation = meshed(on_a_ring(), 16, Order::Quadratic);
    let (load, middle) = (over_ring(|_| 1.0), 0.5 * (A + B));
    let centre = over_ring(|r| r - middle) / load;
    let second = 2.0 * (over_ring(|r| (r - middle - centre).powi(2)) / load).sqrt();
    let highest = (0.5 * (A * A + B * B)).sqrt() - middle;
    let mut others = Vec::new();
    for formulation in Formulation::compared() {
        let run = Run::of(&discretisation, &formulation)?;
        let name = formulation.name();
        if !run.solution.converged() {
            others.push(format!("{name} {:?} {:?} {:e}", run.solution.outcome, run.solution.error(), run.imbalance()));
            continue;
        }
        // The tolerance of all nine; kinematic load leaves 2e-5, the quadrature of the tractions.
        assert_relative_eq!(run.transmitted(), load, max_relative = 1e-3);
        let measures = run.measures();
        for (what, found, wanted, within) in [
            ("peak", measures.peak.pressure, PEAK, 5e-3 * PEAK),
            ("place", measures.peak.position, highest, 0.05),
            ("begin", measures.begin(), -1.0, 0.05),
            ("end", measures.edge(), 1.0, 0.05),
            ("centre", measures.centre, centre, 1e-3),
            ("second moment", measures.second_moment_width, second, 2e-3),
        ] {
            assert!((found - wanted).abs() <= within, "{name}, {what}: {found} for {wanted}");
        }
    }
    assert!(others.is_empty(), "{others:?}");
    Ok(())
}

/// A torus pressed on to a rigid shaft of radius R by a pressure all around, and its line load \[N/mm\]: far from the
/// axis it is a cylinder.
#[test]
fn a_seal_on_a_wide_shaft_is_as_good_as_a_cylinder() {
    let hertz = Hertz { load: 1000.0, radius: 5.0, modulus: 210e3 / 0.91 };
    let off = [1000.0, 4000.0].map(|radius| {
        let centre = format!("[0, {}], radius", radius + 5.0);
        let run = solved(&scene("seal", &[["[0, 1005], radius", &centre], ["[0, 1000]", &format!("[0, {radius}]")]]));
        // All of the pressure on the horizontal cut, both halves; hoop stresses carry the rest.
        let force = run.transmitted() / (TAU * radius) / 1000.0;
        let peak = run.measures().peak.pressure / hertz.peak_pressure();
        [force, peak]
    });
    assert!((off[1][0] - 1.0).abs() <= 5e-3 && (off[1][1] - 1.0).abs() <= 5e-3, "{off:?}");
}

/// Radius of the contacts \[mm\].
const CONTACT: f64 = 2.5;
/// Height and radius of the blocks over it.
const SIZE: f64 = 8.0;

/// Profiles by their powers, and what they are in a scene.
fn profiles() -> [(&'static str, Vec<[f64; 2]>, Profile); 5] {
    let even = |coefficients: &[f64]| Profile::Even { coefficients: coefficients.into() };
    [
        ("paraboloid", vec![[0.01, 2.0]], Profile::Parabola { radius: 50.0 }),
        ("circle", Indentation::circle(50.0, 20), Profile::Circle { radius: 50.0 }),
        ("r² + r⁴", vec![[0.005, 2.0], [4e-4, 4.0]], even(&[0.005, 4e-4])),
        ("r^2.7", vec![[4e-3, 2.7]], Profile::Powers { terms: [[4e-3, 2.7]].into() }),
        ("cone", vec![[0.02, 1.0]], Profile::Wedge { slope: 0.02 }),
    ]
}

#[test]
fn truncated_blocks_of_revolution_are_their_closed_forms() -> Result<(), Error> {
    for (name, powers, profile) in profiles() {
        let indented = Indented::to(CONTACT, powers, profile);
        let (contact, side) = (&indented.contact, SIZE * CONTACT);
        let sunk = |r: f64| contact.potential(r, side).displacement(Material::STEEL)[1];
        let mean = (0..40).map(|k| (f64::from(k) + 0.5) / 40.0 * side).map(|r| TAU * r * side / 40.0 * sunk(r));
        let sunk = mean.sum::<f64>() / (0.5 * TAU * side * side);
        let resolution = Resolution { elements: 16, refinement: 0, order: Order::Quadratic };
        let discretisation = Discretisation::of(indented.scene(), resolution)?;
        let run = Run::of(&discretisation, &Formulation::verification())?;

        assert!(run.solution.converged(), "{name}");
        let measures = run.measures();
        // The far face comes nearer by less than the half-space's infinity does.
        let far = Displaced { body: 0, at: Place::Boundary("far".into()), component: Component::Y };
        let approach = -discretisation.number(&run, 0, &Quantity::Displacement(far))?;
        // 8-node cells, 16 on the radius.
        let numbers = [
            ("load", run.transmitted(), contact.load(), 1e-9),
            ("radius", measures.second_moment_width, contact.second_moment_radius(), 5e-4),
            ("peak", measures.peak.pressure, contact.peak_pressure(), 5e-4),
            ("approach", approach, contact.approach() - sunk, 1e-4),
        ];
        for (what, value, reference, tolerance) in numbers {
            let error = (value / reference - 1.0).abs();
            // Below the tip of a cone the pressure is without limit.
            assert!(reference == f64::INFINITY || error <= tolerance, "{name}, {what}: {value} against {reference}");
        }
    }
    Ok(())
}

#[test]
fn stresses_on_the_axis_below_a_solved_sphere_are_hubers() -> Result<(), Error> {
    let paraboloid = Profile::Parabola { radius: 50.0 };
    let indented = Indented::to(CONTACT, vec![[0.01, 2.0]], paraboloid);
    let contact = &indented.contact;
    let sphere = Sphere { load: contact.load(), radius: 50.0, modulus: contact.modulus };
    let resolution = Resolution { elements: 8, refinement: 0, order: Order::Sextic };
    let discretisation = Discretisation::of(indented.scene(), resolution)?;
    let run = Run::of(&discretisation, &Formulation::verification())?;
    let fields = discretisation.recover(&run.solution)?;
    let hoop = discretisation.stress_across(&fields);
    let mut seen = 0;
    for ((point, stress), hoop) in discretisation.mesh.points.iter().zip(&fields.stress).zip(hoop) {
        let [r, depth] = *point;
        // Closer to the surface stresses at nodes feel the end of the contact, and farther away they are small.
        if r > 0.0 || !(0.2 * CONTACT..3.0 * CONTACT).contains(&depth) {
            continue;
        }
        seen += 1;
        let [axial, radial] = sphere.on_axis(depth, Material::STEEL.poisson);
        for (found, wanted) in [(stress[1], axial), (stress[0], radial), (hoop, radial), (stress[2], 0.0)] {
            let error = (found - wanted).abs() / sphere.peak_pressure();
            assert!(error <= 2e-3, "{depth}: {found} for {wanted}, {error:e}");
        }
    }
    assert!(seen > 20, "{seen} nodes");
    Ok(())
}

#[test]
fn powers_of_a_scene_file_are_their_transform() {
    let case = scene("power", &[]);
    let a = told(&case, &Quantity::HalfWidth);
    // δ = w(a) = a ∫ g'(a sin φ) dφ and F = 2E* ∫ (δ − w) dt, by the midpoint rule.
    let slope = |r: f64| 0.01 * 2.5 * r.powf(1.5) + 0.002 * 1.5 * r.sqrt();
    let w = |t: f64| {
        let at = |k: i32| (std::f64::consts::FRAC_PI_2 * (f64::from(k) + 0.5) / 400.0).sin();
        t * (0..400).map(|k| slope(t * at(k))).sum::<f64>() * std::f64::consts::FRAC_PI_2 / 400.0
    };
    let modulus = 210e3 / 0.91;
    let under = (0..2000).map(|k| w(a) - w(a * (f64::from(k) + 0.5) / 2000.0)).sum::<f64>() * a / 2000.0;
    assert!((2.0 * modulus * under / 500.0 - 1.0).abs() <= 1e-4, "{under}");
    assert!((told(&case, &Quantity::Approach) / w(a) - 1.0).abs() <= 1e-4);

    // In metres the same: c has the unit of length^(1 − n).
    let c = |c: f64, n: f64| c * 1e-3_f64.powf(1.0 - n);
    let terms = format!("[[{:e}, 2.5], [{:e}, 1.5]]", c(0.01, 2.5), c(0.002, 1.5));
    let metres = scene(
        "power",
        &[
            ["[[0.01, 2.5], [0.002, 1.5]]", &terms],
            ["plane = ", "units = { length = \"m\" }\nplane = "],
            ["[0, 20]", "[0, 0.02]"],
            ["stretch = 2", "stretch = 0.002"],
            ["per = 1", "per = 0.001"],
        ],
    );
    assert!((told(&metres, &Quantity::HalfWidth) / a - 1.0).abs() <= 1e-9);
    assert!((metres.scene.contacts[0].gap(1.3) / case.scene.contacts[0].gap(1.3) - 1.0).abs() <= 1e-12);
}
