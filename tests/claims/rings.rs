//! Contacts of bodies of revolution that are rings: off the axis, along it, and on arcs.

use std::f64::consts::{PI, TAU};
use std::path::Path;
use std::sync::Arc;

use approx::assert_relative_eq;
use contact_vv::algorithm::Iteration;
use contact_vv::case::Case;
use contact_vv::checkout::root;
use contact_vv::contact::Element;
use contact_vv::error::Error;
use contact_vv::mesh::{Order, Resolution};
use contact_vv::oracle::analytic::hertz::Hertz;
use contact_vv::oracle::analytic::revolution::half_space::Potential;
use contact_vv::oracle::{Quantity, Reading};
use contact_vv::scene::{
    Action, Body, Component, ContactPair, Face, Grading, Load, Material, MonotoneCubic, Path as Way, Place,
    PlaneHypothesis, Profile, ReferenceValues, Scene, Shape, Support, VectorField,
};
use contact_vv::solve::{Discretisation, Formulation, Run};

const ORDERS: [Order; 4] = [Order::Linear, Order::Quadratic, Order::Quartic, Order::Octic];

/// One block on a rigid side, under the traction of a stress on the sides that are named.
fn block(plane: PlaneHypothesis, shape: Shape, path: Way, stretch: f64, loaded: &[&'static str]) -> Scene {
    let stress = VectorField::of(|_| [-7.0, -7.0, 0.0]);
    let load = |name: &&'static str| Load::on(*name, Action::Stress(stress.clone()));
    let body = Body {
        name: "block".into(),
        shape,
        material: Material { young: 1000.0, poisson: 0.3 },
        density: 1.0,
        supports: vec![],
        loads: loaded.iter().map(load).collect(),
    };
    let mut pair = ContactPair::new(None, path, Profile::Uniform(0.0), stretch);
    pair.symmetric = false;
    Scene {
        name: "block".into(),
        plane,
        thickness: 1.0,
        bodies: vec![body],
        contacts: vec![pair],
        reference: ReferenceValues { length: 1.0, pressure: 1.0, gap: 1e-3 },
        grading: Grading { unit: 3.0, along: 1.0, depth: 1.0, first: 1.0, coarsest: 1.0, end: 1.0 },
    }
}

fn across(origin: [f64; 2]) -> Way {
    Way::Straight { origin, both_sides: true }
}

/// A ring on a flat, and a sleeve around a rigid shaft, whose contact is a line along the axis; with the areas of their contacts.
fn pressed() -> [(&'static str, Scene, f64); 2] {
    let (about_y, about_x) = (PlaneHypothesis::Axisymmetric, PlaneHypothesis::AxisymmetricAboutX);
    let ring = Shape::Rectangle { x: [2.0, 5.0], y: [0.0, 2.0], contact: Face::Bottom };
    let sleeve = Shape::Rectangle { x: [-1.5, 1.5], y: [2.0, 4.0], contact: Face::Bottom };
    let mut around = block(about_x, sleeve, across([0.0, 2.0]), 1.5, &["right", "far"]);
    around.bodies[0].supports =
        vec![Support { at: Place::Boundary("left".into()), component: Component::X, value: 0.0 }];
    // Under the same pressure from all sides its bore narrows by p (1 − 2ν) r/E.
    around.contacts[0].profile = Profile::Uniform(7.0 * 0.4 * 2.0 / 1000.0);
    [
        ("ring", block(about_y, ring, across([3.5, 0.0]), 1.5, &["left", "right", "far"]), PI * (25.0 - 4.0)),
        ("sleeve", around, TAU * 2.0 * 3.0),
    ]
}

#[test]
fn uniform_pressures_on_rings_are_exact() {
    for (order, element) in ORDERS.into_iter().flat_map(|order| Element::ALL.map(|element| (order, element))) {
        for (name, scene, area) in pressed() {
            let case = format!("{name}, {order:?}, {element:?}");
            let resolution = Resolution { elements: 4, refinement: 0, order };
            let discretisation = Discretisation::of(scene, resolution).expect("meshed");
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

/// What a scene file finds.
fn solved(text: &str) -> (Case, Run) {
    let case = Case::parse(Path::new("rings.toml"), text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let (_, run) = case.solve().unwrap_or_else(|error| panic!("{error}\n{text}"));
    assert!(run.solution.converged(), "{text}");
    (case, run)
}

/// A steel ring on a hollow shaft of aluminium that is as long; the right half is modelled.
const RING_ON_SHAFT: &str = r#"
title = "ring on a shaft"
plane = "axisymmetric"
axis = "x"

[[body]]
name = "ring"
young = 210e3
poisson = 0.3
shape = { rectangle = { x = [0, 10], y = [40, 70], contact = "bottom" } }
supports = [{ at = "left", component = "x" }]

[[body]]
name = "shaft"
young = 70e3
poisson = 0.33
shape = { rectangle = { x = [0, 10], y = [20, 40], contact = "top" } }
supports = [{ at = "left", component = "x" }]

[contact]
first = "ring"
second = "shaft"
origin = [0, 40]
gap = { uniform = -0.02 }
stretch = 10
oracle = { lame = { radii = [20, 40, 70], interference = 0.02 } }

[mesh]
elements = 4
per = 10
order = 4
growth = { along = 1.0, depth = 1.0 }

[solve]
tolerance = 1e-8

[[check]]
quantity = "pressure"
at = 5
tolerance = 1e-6
because = "rings of free ends and the same length are in plane stress"
"#;

#[test]
fn a_ring_on_a_shaft_of_its_length_is_lames() -> Result<(), Error> {
    let (case, run) = solved(RING_ON_SHAFT);
    let wanted = case.oracles[0].as_ref().expect("Lamé").read(&Quantity::PeakPressure);
    let Reading::Value { value, .. } = wanted else { panic!("a pressure") };
    for point in &run.solution.points {
        assert_relative_eq!(point.pressure, value, max_relative = 1e-5);
    }
    assert_relative_eq!(run.transmitted(), value * TAU * 40.0 * 20.0, max_relative = 1e-5);

    // What the plane scene of the same rings says.
    let plane = Case::read(&root().join("tests/cases/press-fit.toml"))?;
    let swapped = RING_ON_SHAFT
        .replace("name = \"ring\"\nyoung = 210e3\npoisson = 0.3", "name = \"ring\"\nyoung = 70e3\npoisson = 0.33")
        .replace("name = \"shaft\"\nyoung = 70e3\npoisson = 0.33", "name = \"shaft\"\nyoung = 210e3\npoisson = 0.3");
    let (_, turned) = solved(&swapped);
    let (_, plane) = plane.solve()?;
    assert_relative_eq!(turned.measures().peak.pressure, plane.measures().peak.pressure, max_relative = 1e-3);
    Ok(())
}

/// A ball of brass in a shell of steel that is too narrow for it, to a half: both are cut where they are symmetric.
const BALL_IN_SHELL: &str = r#"
title = "ball in a shell"
plane = "axisymmetric"

[[body]]
name = "ball"
young = 100e3
poisson = 0.35
shape = { ring = { centre = [0, 0], inner = 20, outer = 30, sweep = 90, contact = "outer" } }
supports = [{ at = "end", component = "y" }]

[[body]]
name = "shell"
young = 210e3
poisson = 0.3
shape = { ring = { centre = [0, 0], inner = 30, outer = 50, sweep = 90, contact = "inner" } }
supports = [{ at = "end", component = "y" }]

[contact]
first = "ball"
second = "shell"
arc = { centre = [0, 0], radius = 30 }
gap = { uniform = -0.02 }
stretch = 90
oracle = { lame = { radii = [20, 30, 50], interference = 0.02 } }

[mesh]
elements = 4
per = 47.1
order = 6
growth = { along = 1.0, depth = 1.0 }

[solve]
tolerance = 1e-8

[[check]]
quantity = "pressure"
at = 45
tolerance = 1e-6
because = "spheres about one centre"
"#;

#[test]
fn a_ball_in_a_narrow_shell_is_lames() {
    let (case, run) = solved(BALL_IN_SHELL);
    let wanted = case.oracles[0].as_ref().expect("Lamé").read(&Quantity::PeakPressure);
    let Reading::Value { value, .. } = wanted else { panic!("a pressure") };
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

/// Flat punches of all radii t ≤ a make it: `p = ∫ᵣᵃ h(t) dt/√(t² − r²)`, `h = −(2/π) d/dt ∫ₜᵃ r p dr/√(r² − t²)` (Abel).
///
/// With `v = r² − t²` the integral is that of `(v + t² − b²)(a² − t² − v)/2√v`, from `max(0, b² − t²)` to `a² − t²`.
fn punches(t: f64) -> f64 {
    let [low, high] = [(B * B - t * t).max(0.0), A * A - t * t];
    let at_a = high.sqrt() * (A * A + 2.0 * B * B - 3.0 * t * t - high / 3.0);
    let at_b = low.sqrt() * (2.0 * A * A + B * B - 3.0 * t * t - low / 3.0);
    -8.0 * PEAK * t * (at_a - at_b) / (PI * (A * A - B * B).powi(2))
}

/// Sum over the punches, by the midpoint rule in an angle: at the ends of every part, and at a radius, there may be a root.
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

/// A block on a rigid profile that a ring of it fits when it carries that pressure, with the stresses of the half-space on its other
/// sides. Inside and outside the ring the profile lies lower.
fn on_a_ring() -> Scene {
    let [middle, stretch, side] = [0.5 * (A + B), 3.0, 40.0];
    let sunk = |r: f64| below(r, 0.0).displacement(Material::STEEL)[1];
    let largest = (0..200).map(|k| sunk(B + (A - B) * f64::from(k) / 200.0)).fold(0.0, f64::max);
    // Nowhere an interference, by what the places between leave.
    let gap = |r: f64| 1e-5 + largest - sunk(r) + 1e-3 * ((B - r).max(0.0) + (r - A).max(0.0)).powi(2);
    // Somewhat beyond the last candidates, which rounding may move.
    let places = (-602..=602).map(|k| stretch * f64::from(k) / 600.0);
    let points: Vec<[f64; 2]> = places.map(|s| [s, gap(middle + s)]).collect();
    let field = VectorField::of(|[r, depth]: [f64; 2]| below(r, depth).stress(0.3).in_plane());
    let shape = Shape::Rectangle { x: [0.0, side], y: [0.0, side], contact: Face::Bottom };
    let mut scene = block(PlaneHypothesis::Axisymmetric, shape, across([middle, 0.0]), stretch, &[]);
    let body = &mut scene.bodies[0];
    body.material = Material::STEEL;
    body.loads = ["right", "far"].map(|boundary| Load::on(boundary, Action::Stress(field.clone()))).into();
    scene.contacts[0].profile = Profile::Smooth(Arc::new(MonotoneCubic::through(&points)));
    scene.reference = ReferenceValues { length: 1.0, pressure: PEAK, gap: 1e-2 };
    scene.grading = Grading { unit: 1.0, along: 1.5, depth: 1.4, first: 1.0, coarsest: 0.2, end: 1.0 };
    scene
}

#[test]
fn a_ring_of_contact_is_its_closed_form() -> Result<(), Error> {
    let resolution = Resolution { elements: 16, refinement: 0, order: Order::Quadratic };
    let discretisation = Discretisation::of(on_a_ring(), resolution)?;
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

/// A torus pressed on to a rigid shaft of radius R by a pressure all around, and its line load \[N/mm\]: far from the axis it is a cylinder.
#[test]
fn a_seal_on_a_wide_shaft_is_as_good_as_a_cylinder() {
    let text = |radius: f64| {
        format!(
            r#"
title = "seal"
plane = "axisymmetric"
axis = "x"
[[body]]
name = "seal"
young = 210e3
poisson = 0.3
shape = {{ disc = {{ centre = [0, {}], radius = 5 }} }}
supports = [{{ at = "axis", component = "x" }}]
loads = [{{ pressure = {{ at = "cut", law = {{ uniform = 100 }} }} }}]
[contact]
first = "seal"
origin = [0, {radius}]
gap = {{ circle = 5 }}
stretch = 0.3
[mesh]
elements = 12
per = 0.1
"#,
            radius + 5.0
        )
    };
    let hertz = Hertz { load: 1000.0, radius: 5.0, modulus: 210e3 / 0.91 };
    let off = [1000.0, 4000.0].map(|radius| {
        let (_, run) = solved(&text(radius));
        // All of the pressure on the horizontal cut, both halves; hoop stresses carry the rest.
        let force = run.transmitted() / (TAU * radius) / 1000.0;
        let peak = run.measures().peak.pressure / hertz.peak_pressure();
        [force, peak]
    });
    assert!((off[1][0] - 1.0).abs() <= 5e-3 && (off[1][1] - 1.0).abs() <= 5e-3, "{off:?}");
}

/// What is said of a scene in which something is replaced.
fn refused(text: &str, what: &str, by: &str) -> String {
    assert!(text.contains(what), "{what}");
    match Case::parse(Path::new("rings.toml"), &text.replacen(what, by, 1)).and_then(|case| case.solve().map(|_| ())) {
        Ok(()) => String::new(),
        Err(error) => error.to_string(),
    }
}

#[test]
fn rings_that_cannot_be_are_refused() {
    for (text, what, by, said) in [
        (RING_ON_SHAFT, "axis = \"x\"", "axis = \"z\"", "axis"),
        (RING_ON_SHAFT, "plane = \"axisymmetric\"", "plane = \"strain\"\nthickness = 1", "bodies of revolution"),
        (RING_ON_SHAFT, "origin = [0, 40]", "origin = [0, 0]", "lies on the axis"),
        (RING_ON_SHAFT, "radii = [20, 40, 70]", "radii = [10, 40, 70]", "bore"),
        (
            RING_ON_SHAFT,
            "{ lame = { radii = [20, 40, 70], interference = 0.02 } }",
            "{ cone = { load = 1, slope = 1 } }",
            "around the axis",
        ),
        (BALL_IN_SHELL, "arc = { centre = [0, 0]", "arc = { centre = [1, 0]", "ring about x = 0"),
        (BALL_IN_SHELL, "centre = [0, 0], inner = 20", "centre = [0, 1], inner = 20", "does not lie on `arc`"),
    ] {
        let found = refused(text, what, by);
        assert!(found.contains(said), "{by}: {found}");
    }
}
