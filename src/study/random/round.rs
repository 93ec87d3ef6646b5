//! Cylinders, pins and rings; layers and rows under rigid profiles, half of a contact each; and bodies of revolution:
//! blocks that carry the tractions of the half-space that they press, and spheres.

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, PI};

use crate::case::library::{Cylinder, CylinderModel, Indented, PinPlate, PressFit, body, fixed};
use crate::measure::Quantity;
use crate::oracle::analytic::Plane;
use crate::oracle::analytic::hertz::Hertz;
use crate::oracle::analytic::persson::PinInHole;
use crate::oracle::analytic::revolution::indentation::Indentation;
use crate::oracle::analytic::revolution::sphere::Sphere;
use crate::oracle::boundary::strip::OnStrip;
use crate::oracle::boundary::{Ring, Strip};
use crate::scene::{
    Action, Circle, Component, ContactPair, Face, Load, Material, Path, Place, PlaneHypothesis, Profile,
    ReferenceValues, Scene, Sector, Shape, Support, VectorField,
};
use crate::study::random::blocks::{GROWING, even, of_hertz, rectangle, scene};
use crate::study::random::family::{Draw, Sample};
use crate::study::random::gaps::{even_gap, size};

/// Elements across a ring: one has no coarser neighbour.
const ACROSS: f64 = 2.0;
/// Largest half-width of cylinders and spheres over the radius of the smaller one.
pub const WIDEST: f64 = 0.005;
/// What Hertz's closed form of two spheres leaves out at most, over the half-width over that radius.
pub const OF_SPHERES: f64 = 0.2;
/// Radius of the plate's rim, and clearance, over the radius of the pin.
const PLATE: [f64; 2] = [1000.0, 1e-6];

/// A cylinder on a plane, as a quarter or as a half.
pub fn cylinder(draw: &mut Draw, Material { young, poisson }: Material, guess: f64) -> Sample {
    let (radius, a_over_r) = (draw.decades(0.1, 1000.0), draw.decades(0.001, 0.005));
    let model = match draw.between(0.0, 3.0) {
        third if third < 1.0 => CylinderModel::Quarter,
        third if third < 2.0 => CylinderModel::Half,
        _ => CylinderModel::HalfLoadedAbove,
    };
    let numbers = Cylinder { radius, young, poisson, a_over_r, stretch: guess, model };
    let scene = numbers.scene();
    let hertz = Hertz { load: numbers.load(), radius, modulus: scene.contact_modulus() };
    Sample::of(scene, of_hertz(&hertz))
}

/// Persson's pin, pressed to a half-angle of 15 to 80 degrees.
pub fn pin(draw: &mut Draw, material: Material, guess: f64) -> Sample {
    let (pin_radius, half_angle) = (draw.decades(0.1, 1000.0), draw.between(15.0, 80.0).to_radians());
    let [rim_radius, clearance] = PLATE.map(|part| part * pin_radius);
    let load = PinInHole::load_for(half_angle, clearance, material.young);
    let numbers = PinPlate {
        pin_radius,
        clearance,
        rim_radius,
        thickness: 1.0,
        material,
        force: load,
        stretch: (guess * half_angle).min(FRAC_PI_2),
        unit: pin_radius,
    };
    let solution = PinInHole {
        radius: pin_radius,
        clearance,
        load,
        modulus: material.young,
        poisson: material.poisson,
        plane: Plane::Stress,
    };
    let truths = even([solution.peak_pressure(), 0.0], solution.second_moment(), half_angle, load);
    Sample::of(numbers.scene(), truths)
}

/// An elastic cylinder on another one; the gap is the parabola of both, as Hertz has it.
pub fn cylinders(draw: &mut Draw, upper: Material, guess: f64) -> Sample {
    let (mut scene, [half_width, radius, above]) = discs(draw, upper, guess);
    let modulus = scene.contact_modulus();
    let hertz = Hertz { load: Hertz::load_for(half_width, radius, modulus), radius, modulus };
    scene.bodies[0].loads = vec![Load::on("cut", Action::Uniform([0.0, -hertz.load / (2.0 * above)]))];
    scene.reference = ReferenceValues::hertz(half_width, hertz.load, radius);
    Sample::of(scene, of_hertz(&hertz))
}

/// Two quarters of discs without a load: half-width of the contact that they are drawn for, relative radius and that of
/// the upper one.
pub fn discs(draw: &mut Draw, upper: Material, guess: f64) -> (Scene, [f64; 3]) {
    let lower = Material { young: upper.young * draw.decades(0.1, 10.0), poisson: draw.between(0.0, 0.45) };
    let (above, below) = (draw.decades(0.1, 1000.0), draw.decades(0.3, 3.0));
    let [above, below] = [above, above * below];
    let half_width = above.min(below) * draw.decades(0.001, WIDEST);
    let radius = 1.0 / (1.0 / above + 1.0 / below);
    let disc = |name: &str, centre: f64, radius, contact, material| {
        let shape = Shape::Disc { centre: [0.0, centre], radius, sector: Sector::Quarter, contact };
        body(name, shape, material, vec![fixed("axis", Component::X, 0.0)], vec![])
    };
    let mut bodies =
        vec![disc("upper", above, above, Face::Bottom, upper), disc("lower", -below, below, Face::Top, lower)];
    bodies[1].supports.push(fixed("cut", Component::Y, 0.0));
    let scene = scene(
        "two discs",
        bodies,
        ContactPair::new(Some(1), Path::HORIZONTAL, Profile::Parabola { radius }, guess * half_width),
        ReferenceValues::hertz(half_width, 1.0, radius),
        [1.7, 1.6, 0.3],
    );
    (scene, [half_width, radius, above])
}

/// Two rings of any thickness and materials; the cuts of each carry what the fit makes them.
pub fn press_fit(draw: &mut Draw, inside: Material) -> Sample {
    let outside = Material { young: inside.young * draw.decades(0.1, 10.0), poisson: draw.between(0.0, 0.45) };
    let interface = draw.decades(0.1, 1000.0);
    let plane = if draw.between(0.0, 2.0) < 1.0 { PlaneHypothesis::Stress } else { PlaneHypothesis::Strain };
    let numbers = PressFit {
        inner: interface * draw.between(0.3, 0.8),
        interface,
        outer: interface * draw.between(1.3, 3.0),
        interference: interface * draw.decades(1e-5, 1e-3),
        materials: [inside, outside],
        plane,
    };
    let lame = numbers.closed_form();
    let [inner, outer] = lame.fitted();
    let thinner = (interface - numbers.inner).min(numbers.outer - interface);
    let pressure = lame.pressure();
    let middle = 0.5 * (interface + numbers.outer);
    // At 45° of the outer ring; ∫ sin θ over a quarter of a circle is 2/π of it.
    let within = FRAC_1_SQRT_2 * middle;
    // p b on each cut, by equilibrium of a quarter; one support tells it for all four.
    let on_cut = pressure * interface;
    // Uniform: ∫p = pε, ∫p θ² = pε³/3 over the quarter; along the load line 2 ∫p b cos θ dθ = 2 p b.
    Sample::of(
        numbers.scene(),
        [
            (Quantity::PeakPressure, pressure),
            (Quantity::SecondMomentWidth, 2.0 * FRAC_PI_2 / 3f64.sqrt()),
            (Quantity::End(0), FRAC_PI_2),
            (Quantity::Resultant, 2.0 * on_cut),
        ],
    )
    .with(Quantity::Reaction { body: 0, support: 0 }, on_cut)
    .moved(0, Place::Boundary("inner".into()), Component::X, inner.displacement(numbers.inner) / FRAC_PI_2)
    .moved(1, Place::Boundary("outer".into()), Component::Y, -outer.displacement(numbers.outer) / FRAC_PI_2)
    .moved(1, Place::Point([within, -within]), Component::X, FRAC_1_SQRT_2 * outer.displacement(middle))
    .seen_by(ACROSS * FRAC_PI_2 * interface / thinner)
}

/// Half of a ring on a rigid pin, pressed on it by `P cos θ` on all of its outside, of which πbP is the resultant.
pub fn ring(draw: &mut Draw, material: Material, guess: f64) -> Sample {
    let (inner, plane) = (draw.decades(0.1, 1000.0), PlaneHypothesis::Strain);
    let outer = inner * draw.between(1.3, 3.0);
    let clearance = inner * draw.decades(1e-5, 1e-3);
    let profile = Profile::Pin { radius: inner - clearance, clearance };
    let elastic = Ring { radii: [inner, outer], material, plane, pressure: 0.0 };
    let contact = loop {
        let half_angle = draw.between(8.0, 80.0).to_radians();
        if let Some(contact) = elastic.on_pin(&profile, half_angle) {
            break contact;
        }
    };
    let (half_angle, load, [peak, place]) = (contact.half_angle, contact.load(), contact.peak());
    let along = load / (PI * outer);
    // The cosine of the angle from the downward vertical is −y/r, and presses inwards.
    let pressed = move |[x, y]: [f64; 2]| [x, y].map(|part| along * y * part / (x * x + y * y));
    let circle = |radius| Circle { centre: [0.0, 0.0], radius };
    let stretch = (guess * half_angle).min(FRAC_PI_2);
    let shape = Shape::Ring {
        pole: [0.0, 0.0],
        inner: circle(inner),
        outer: circle(outer),
        sweep: PI,
        both_sides: false,
        contact: Face::Bottom,
    };
    let supports = ["start", "end"].map(|side| fixed(side, Component::X, 0.0)).into();
    let loads = vec![Load::on("outer", Action::Field(VectorField::of(pressed)))];
    let scene = scene(
        "ring on a pin",
        vec![body("ring", shape, material, supports, loads)],
        ContactPair { above: false, ..ContactPair::new(None, Path::Arc(circle(inner)), profile, stretch) },
        ReferenceValues { length: inner * half_angle, pressure: peak, gap: clearance },
        GROWING,
    );
    let truths = even([peak, place], contact.second_moment(), half_angle, load);
    Sample::of(scene, truths)
}

/// Half-width over the thickness of a layer.
const OVER_THICKNESS: [f64; 2] = [0.2, 3.0];
/// Largest Poisson's ratio of a bonded layer: beyond, it is the incompressible material that is looked at.
const BONDED: f64 = 0.4;
/// Thicknesses of a layer beyond its contact: at its end e^(−2.1 · 8) of what the contact moves is left.
const BEYOND: f64 = 8.0;
/// Half-width over the period of a row, and heights of its block over that.
const OVER_PERIOD: [f64; 2] = [0.04, 0.42];
const HEIGHTS: [f64; 2] = [2.0, 3.0];

/// An even gap with its half-width.
fn gap(draw: &mut Draw) -> (f64, Profile) {
    let [a, slope] = size(draw);
    (a, even_gap([a, slope], [draw.between(0.0, 1.0), draw.between(-0.3, 1.0), draw.between(-0.3, 1.0)]))
}

/// A layer, sliding or bonded, pushed on to a profile by its base.
pub fn layer(draw: &mut Draw, material: Material, guess: f64, number: usize) -> Sample {
    let is_bonded = number % 2 == 1;
    let material = if is_bonded { Material { poisson: material.poisson.min(BONDED), ..material } } else { material };
    let modulus = material.plane_modulus(PlaneHypothesis::Strain);
    loop {
        let (a, profile) = gap(draw);
        let thickness = a / draw.decades(OVER_THICKNESS[0], OVER_THICKNESS[1]);
        let strip = if is_bonded { Strip::Bonded(thickness, material.poisson) } else { Strip::Sliding(thickness) };
        let end = a + BEYOND * thickness;
        if let Some(contact) = strip.pressed(modulus, &profile, a, end) {
            let mut supports = vec![fixed("far", Component::Y, -contact.approach)];
            supports.extend(is_bonded.then(|| fixed("far", Component::X, 0.0)));
            return sample("layer", (material, profile, guess), &contact, [end, thickness], supports, vec![]);
        }
    }
}

/// Half a period of a row of contacts, pressed by its mean pressure.
pub fn row(draw: &mut Draw, material: Material, guess: f64) -> Sample {
    let modulus = material.plane_modulus(PlaneHypothesis::Strain);
    loop {
        let (a, profile) = gap(draw);
        let period = a / draw.between(OVER_PERIOD[0], OVER_PERIOD[1]);
        let height = period * draw.between(HEIGHTS[0], HEIGHTS[1]);
        if let Some(contact) = Strip::Row(period).pressed(modulus, &profile, a, 0.5 * period) {
            let right = fixed("right", Component::X, 0.0);
            let mean = Load::on("far", Action::Uniform([0.0, -contact.load() / period]));
            let size = [0.5 * period, height];
            return sample("row", (material, profile, guess), &contact, size, vec![right], vec![mean]);
        }
    }
}

/// One half of a block, with its support on the symmetry line.
fn sample(
    name: &str,
    (material, profile, guess): (Material, Profile, f64),
    contact: &OnStrip,
    [side, height]: [f64; 2],
    mut supports: Vec<Support>,
    loads: Vec<Load>,
) -> Sample {
    let (a, load, [peak, place]) = (contact.half_width, contact.load(), contact.peak());
    supports.push(fixed("left", Component::X, 0.0));
    let scene = scene(
        name,
        vec![rectangle(material, [[0.0, side], [0.0, height]], supports, loads)],
        ContactPair::new(None, Path::HORIZONTAL, profile.clone(), (guess * a).min(side)),
        ReferenceValues { length: a, pressure: peak, gap: profile.gap(a) },
        GROWING,
    );
    Sample::of(scene, even([peak, place], contact.second_moment(), a, load))
}

/// Powers of the radius.
const POWERS: [f64; 2] = [1.5, 30.0];

/// What Hertz says of a sphere.
fn of_sphere(sphere: &Sphere) -> [(Quantity, f64); 5] {
    let a = sphere.contact_radius();
    even([sphere.peak_pressure(), 0.0], a, a, sphere.load)
}

/// A block pressed by `Σ c rⁿ` to a contact of a radius \[mm\].
fn indented(material: Material, a: f64, powers: Vec<[f64; 2]>, profile: Profile, guess: f64) -> Indented {
    let modulus = material.plane_modulus(PlaneHypothesis::Axisymmetric);
    let contact = Indentation::smooth(modulus, a, powers);
    Indented { contact, profile, material, drawn: a, stretch: guess }
}

/// A paraboloid on a block with Hertz's stresses on its other sides.
pub fn sphere(draw: &mut Draw, material: Material, guess: f64) -> Sample {
    let (radius, a_over_r) = (draw.decades(0.1, 1000.0), draw.decades(1e-4, 0.1));
    let a = a_over_r * radius;
    let block = indented(material, a, vec![[0.5 / radius, 2.0]], Profile::Parabola { radius }, guess);
    let hertz = Sphere { load: block.contact.load(), radius, modulus: block.contact.modulus };
    let [depth, stress] = hertz.largest_shear(material.poisson);
    Sample::of(block.scene(), of_sphere(&hertz)).sheared(0, [stress, depth])
}

/// A power of the radius on a block.
pub fn power(draw: &mut Draw, material: Material, guess: f64) -> Sample {
    let (a, slope, n) = (draw.decades(0.01, 100.0), draw.decades(1e-4, 1e-2), draw.decades(POWERS[0], POWERS[1]));
    let term = [slope * a.powf(1.0 - n) / n, n];
    let block = indented(material, a, vec![term], Profile::Powers { terms: [term].into() }, guess);
    let truths = [
        (Quantity::PeakPressure, block.contact.peak_pressure()),
        (Quantity::SecondMomentWidth, block.contact.second_moment_radius()),
        (Quantity::End(0), a),
        (Quantity::Resultant, block.contact.load()),
    ];
    Sample::of(block.scene(), truths)
}

/// An elastic sphere on another one; the gap is the paraboloid of both, as Hertz has it.
pub fn spheres(draw: &mut Draw, upper: Material, guess: f64) -> Sample {
    let (mut scene, [a, radius, above]) = discs(draw, upper, guess);
    scene.plane = PlaneHypothesis::Axisymmetric;
    scene.contacts[0].symmetric = false;
    let modulus = scene.contact_modulus();
    let hertz = Sphere { load: Sphere::load_for(a, radius, modulus), radius, modulus };
    let traction = [0.0, -hertz.load / (PI * above * above)];
    scene.bodies[0].loads = vec![Load::on("cut", Action::Uniform(traction))];
    scene.reference = ReferenceValues::hertz_sphere(a, hertz.load, radius);
    Sample::of(scene, of_sphere(&hertz))
}
