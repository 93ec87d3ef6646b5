//! Blocks on which closed forms hold exactly, pressed by parabolas, waves and punches or by their own load.

use std::f64::consts::PI;
use std::sync::Arc;

use crate::case::library::{FlatPunch, TruncatedHertz};
use crate::measure::Quantity;
use crate::oracle::analytic::hertz::Hertz;
use crate::oracle::analytic::punch;
use crate::oracle::analytic::waves::Waves;
use crate::scene::{
    Body, Component, ContactPair, Face, Grading, Line, Load, Material, Path, Place, PlaneHypothesis, Profile,
    ReferenceValues, Scene, Shape, StressField, Support,
};
use crate::study::random::draw::Draw;
use crate::study::random::half_plane::{largest_shear, sunk};
use crate::study::random::sample::Sample;

/// Part of the height of a block at which a point on its axis is looked at.
const LOOKED_INTO: f64 = 0.3;

/// The sample with how far a point on the axis sinks, given the stresses and the height of the block; the point on the surface
/// above touches and does not move.
pub fn on_axis(sample: Sample, material: Material, stress: impl Fn([f64; 2]) -> [f64; 3], height: f64) -> Sample {
    let depth = LOOKED_INTO * height;
    sample.moved(0, Place::Point([0.0, depth]), Component::Y, sunk(stress, material, depth))
}

/// Westergaard's waves on half a wave of a block, under the mean pressure `p* sin² ψ` that makes contact up to `a`, `ψ = πa/λ`.
pub fn cosine(draw: &mut Draw, material: Material, guess: f64) -> Sample {
    let modulus = material.plane_modulus(PlaneHypothesis::Strain);
    let (wavelength, amplitude) = (draw.decades(0.1, 1000.0), draw.decades(1e-5, 1e-3));
    let amplitude = amplitude * wavelength;
    let [share, height] = [draw.between(0.03, 0.42), wavelength * draw.between(2.0, 3.0)];
    let open = Waves { modulus, amplitude, wavelength, mean: 0.0 };
    let waves = Waves { mean: open.complete() * (PI * share).sin().powi(2), ..open };
    let (peak, half_width) = (waves.pressure(0.0), share * wavelength);
    let rolled = |at: Place| Support { at, component: Component::X, value: 0.0 };
    let side = 0.5 * wavelength;
    let scene = Scene {
        name: "waves".into(),
        plane: PlaneHypothesis::Strain,
        thickness: 1.0,
        bodies: vec![Body {
            density: 1.0,
            name: "block".into(),
            shape: Shape::Rectangle { x: [0.0, side], y: [0.0, height], contact: Face::Bottom },
            material,
            supports: ["left", "right"].map(|name| rolled(Place::Boundary(name.into()))).into(),
            loads: vec![Load::Traction { boundary: "far".into(), traction: [0.0, -waves.mean] }],
        }],
        contacts: vec![ContactPair::new(
            None,
            Path::HORIZONTAL,
            Profile::Cosine { amplitude, wavelength },
            (guess * half_width).min(side),
        )],
        reference: ReferenceValues { length: half_width, pressure: peak, gap: amplitude },
        grading: Grading { unit: half_width, along: 1.5, depth: 1.4, first: 1.0, coarsest: 0.2, end: 1.0 },
    };
    let truths = [
        (Quantity::PeakPressure, peak),
        (Quantity::PeakPlace, 0.0),
        (Quantity::SecondMomentWidth, waves.second_moment()),
        (Quantity::End(0), half_width),
        (Quantity::Resultant, 2.0 * side * waves.mean),
    ];
    // On the mean over x the sides take σ_x = ν' σ_y: ε_y = (1 − ν'²) σ_y / E'.
    let ratio = material.poisson / (1.0 - material.poisson);
    let shortening = waves.mean * height * (1.0 - ratio * ratio) / modulus;
    let approach = waves.sunk() + shortening;
    let sample = Sample::of(scene, truths).moved(0, Place::Boundary("far".into()), Component::Y, -approach);
    sample.with(Quantity::Approach, approach)
}

/// A parabola on a block with Hertz's stresses on its sides.
pub fn hertz(draw: &mut Draw, material: Material, guess: f64) -> Sample {
    let Material { young, poisson } = material;
    let (radius, a_over_r, size) = (draw.decades(0.1, 1000.0), draw.decades(1e-4, 0.1), draw.between(3.0, 14.0));
    let numbers = TruncatedHertz { radius, young, poisson, a_over_r, size, stretch: guess.min(size) };
    let scene = numbers.scene();
    let hertz = Hertz { load: numbers.load(), radius, modulus: scene.contact_modulus() };
    let stress = |[x, depth]: [f64; 2]| hertz.stress(x, depth);
    let sample = on_axis(Sample::of(scene, of_hertz(&hertz)), material, stress, size * numbers.half_width());
    sample.sheared(0, largest_shear(stress, [0.0, numbers.half_width()]))
}

/// A whole block under Hertz's stresses for a contact beside the vertex of the parabola, whose tangent it takes there: a small rotation
/// `c/R` makes `s²/2R` the gap `(s − c)²/2R`.
pub fn rolling(draw: &mut Draw, material: Material, guess: f64) -> Sample {
    let (radius, a_over_r) = (draw.decades(0.1, 1000.0), draw.decades(1e-4, 0.1));
    let (a, modulus) = (radius * a_over_r, material.plane_modulus(PlaneHypothesis::Strain));
    let centre = a * draw.between(-1.5, 1.5);
    let [left, right, height] = [-1.0, 1.0, 1.0].map(|side| side * a * draw.between(6.0, 14.0));
    let hertz = Hertz { load: Hertz::load_for(a, radius, modulus), radius, modulus };
    let field = StressField(Arc::new(move |[x, depth]: [f64; 2]| hertz.stress(x - centre, depth)));
    let loads = ["left", "right", "far"].map(|side| Load::Stress { boundary: side.into(), field: field.clone() });
    let reach = (centre - left).min(right - centre);
    let path = Path::Straight(Line { origin: [0.0, 0.0], both_sides: true });
    let pair = ContactPair::new(None, path, Profile::Parabola { radius }, (guess * a).min(reach));
    let scene = Scene {
        name: "block that rolls".into(),
        plane: PlaneHypothesis::Strain,
        thickness: 1.0,
        bodies: vec![Body {
            density: 1.0,
            name: "block".into(),
            shape: Shape::Rectangle { x: [centre + left, centre + right], y: [0.0, height], contact: Face::Bottom },
            material,
            supports: vec![Support { at: Place::Point([centre + right, height]), component: Component::X, value: 0.0 }],
            loads: loads.into(),
        }],
        contacts: vec![ContactPair { symmetric: false, ..pair }],
        reference: ReferenceValues { length: a, pressure: hertz.peak_pressure(), gap: a * a / (2.0 * radius) },
        grading: Grading { unit: a, along: 1.5, depth: 1.4, first: 1.0, coarsest: 0.2, end: 1.0 },
    };
    Sample::of(
        scene,
        [
            (Quantity::PeakPressure, hertz.peak_pressure()),
            (Quantity::PeakPlace, centre),
            (Quantity::SecondMomentWidth, a),
            (Quantity::Centre, centre),
            (Quantity::Begin(0), centre - a),
            (Quantity::End(0), centre + a),
            (Quantity::Resultant, hertz.load),
            (Quantity::Moment, hertz.load * centre),
        ],
    )
}

/// What Hertz says of a contact.
pub fn of_hertz(hertz: &Hertz) -> [(Quantity, f64); 5] {
    [
        (Quantity::PeakPressure, hertz.peak_pressure()),
        (Quantity::PeakPlace, 0.0),
        (Quantity::SecondMomentWidth, hertz.half_width()),
        (Quantity::End(0), hertz.half_width()),
        (Quantity::Resultant, hertz.load),
    ]
}

/// A block on a rigid plane under a pressure linear in x, which is that of the contact at every height.
pub fn eccentric(draw: &mut Draw, material: Material) -> Sample {
    let (half, mean) = (draw.decades(0.1, 1000.0), material.young * draw.decades(1e-5, 1e-3));
    let (height, slope) = (half * draw.between(0.5, 2.0), mean / half * draw.between(-0.9, 0.9));
    let pressure = move |x: f64| mean + slope * x;
    // ∫p = 2 p̄ L, ∫p s = 2 p' L³/3, ∫p s² = 2 p̄ L³/3.
    let centre = slope * half * half / (3.0 * mean);
    let half_width = 2.0 * (half * half / 3.0 - centre * centre).sqrt();
    let field = StressField(Arc::new(move |[x, _]: [f64; 2]| [0.0, -pressure(x), 0.0]));
    // ε_y = σ_y/E', ε_x = −ν' ε_y and no shear: u_y = −p y/E', u_x = (ν' (p̄ x + p' x²/2) + p' (y² − H²)/2)/E'.
    let (modulus, ratio) =
        (material.plane_modulus(PlaneHypothesis::Strain), material.poisson / (1.0 - material.poisson));
    let far = || Place::Boundary("far".into());
    let path = Path::Straight(Line { origin: [0.0, 0.0], both_sides: true });
    let scene = Scene {
        name: "block under an eccentric load".into(),
        plane: PlaneHypothesis::Strain,
        thickness: 1.0,
        bodies: vec![Body {
            density: 1.0,
            name: "block".into(),
            shape: Shape::Rectangle { x: [-half, half], y: [0.0, height], contact: Face::Bottom },
            material,
            supports: vec![Support { at: Place::Point([0.0, height]), component: Component::X, value: 0.0 }],
            loads: vec![Load::Stress { boundary: "far".into(), field }],
        }],
        contacts: vec![ContactPair { symmetric: false, ..ContactPair::new(None, path, Profile::Uniform(0.0), half) }],
        reference: ReferenceValues { length: half, pressure: mean, gap: half * mean / material.young },
        grading: Grading { unit: half, along: 1.0, depth: 1.0, first: 1.0, coarsest: 1.0, end: 1.0 },
    };
    Sample::of(
        scene,
        [
            (Quantity::PeakPressure, mean + (slope * half).abs()),
            (Quantity::PeakPlace, half.copysign(slope)),
            (Quantity::SecondMomentWidth, half_width),
            (Quantity::Centre, centre),
            (Quantity::Begin(0), -half),
            (Quantity::End(0), half),
            (Quantity::Resultant, 2.0 * mean * half),
            (Quantity::Moment, 2.0 * mean * half * centre),
        ],
    )
    .moved(0, far(), Component::X, ratio * slope * half * half / (6.0 * modulus))
    .moved(0, far(), Component::Y, -mean * height / modulus)
    .with(Quantity::Approach, mean * height / modulus)
}

/// A flat punch on a block with the half-plane's stresses on its sides; its peak has no limit.
pub fn flat_punch(draw: &mut Draw, material: Material) -> Sample {
    let (half_width, size) = (draw.decades(0.01, 100.0), draw.between(4.0, 14.0));
    let modulus = material.plane_modulus(PlaneHypothesis::Strain);
    let load = modulus * half_width * draw.decades(1e-5, 1e-2);
    let solution = punch::FlatPunch { load, half_width };
    let mut scene = FlatPunch { half_width, size, material, load }.scene();
    let field = StressField(Arc::new(move |[x, depth]: [f64; 2]| solution.stress(x, depth)));
    let sides = ["right", "far"].map(|side| Load::Stress { boundary: side.into(), field: field.clone() });
    scene.bodies[0].loads = sides.into();
    let truths = [
        (Quantity::PeakPressure, f64::INFINITY),
        (Quantity::SecondMomentWidth, solution.second_moment()),
        (Quantity::End(0), half_width),
        (Quantity::Resultant, load),
    ];
    let stress = |[x, depth]: [f64; 2]| solution.stress(x, depth);
    on_axis(Sample::of(scene, truths), material, stress, size * half_width)
}
