//! A random scene of each family, and its peak and half-width by closed form.
//!
//! Sizes, materials, loads and guesses of the candidate stretch are drawn. What the scene is and the closed form is not must
//! stay far below the smallest error asked for, 3e-4: blocks carry the stresses of the half-plane on their sides, and leave
//! nothing out; waves are pressed on blocks at least two waves high, e^(−8π) of which nothing is left; cylinders have
//! a/R ≤ 0.006 and pins clearances of 1e-6 radii in plates of 1000 radii, which leaves 1e-5 (a test measures both).

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

use crate::accuracy::longest::longest;
use crate::case::library::{Cylinder, CylinderModel, PinPlate, TruncatedHertz};
use crate::error::Error;
use crate::mesh::{Mesh, Order, Resolution};
use crate::oracle::analytic::Plane;
use crate::oracle::analytic::even_gap::EvenGap;
use crate::oracle::analytic::hertz::Hertz;
use crate::oracle::analytic::persson::PinInHole;
use crate::oracle::analytic::waves::Waves;
use crate::scene::{
    Body, Component, ContactPair, Face, Grading, Load, Material, MonotoneCubic, Path, Place, PlaneHypothesis, Profile,
    ReferenceValues, Scene, Shape, StressField, Support,
};
use crate::study::met::draw::Draw;
use crate::study::met::sites::{Family, Site};

/// Guess of the candidate stretch over the length of the contact, where the bodies allow it.
pub const GUESS: [f64; 2] = [0.3, 10.0];
/// Terms of the series of a wedge: what is left out is 1e-8 of the peak.
const TERMS: usize = 4000;
/// Points on half of a contact at which a drawn polynomial is looked at.
const LOOKED_AT: usize = 200;
/// Length over which a cubic rounds the corner of a wedge's curvature, over the length of its tip.
const CORNER: f64 = 1e-4;
/// Radius of the plate's rim, and clearance, over the radius of the pin.
const PLATE: [f64; 2] = [1000.0, 1e-6];

/// A scene and the truth about it.
#[derive(Clone, Debug)]
pub struct Sample {
    /// The scene.
    pub scene: Scene,
    /// Of each contact the peak pressure \[MPa\], and the half-width by second moment \[mm, or rad\].
    pub truths: Vec<[f64; 2]>,
}

impl Site {
    /// The scene.
    pub fn sample(&self) -> Result<Sample, Error> {
        let mut draw = Draw::new((1000 * self.family as usize + self.number) as u64);
        self.family.sample(&mut draw, self.number)
    }
}

impl Family {
    /// A scene of the family.
    fn sample(self, draw: &mut Draw, number: usize) -> Result<Sample, Error> {
        let material = Material { young: draw.decades(1e3, 4e5), poisson: draw.between(0.0, 0.45) };
        // The first number of a seed is like that of the next one.
        let guess = draw.decades(GUESS[0], GUESS[1]);
        Ok(match self {
            Self::Polynomial => polynomial(draw, material, guess, number % 2 == 1),
            Self::Wedge => wedge(draw, material, guess),
            Self::Cosine => cosine(draw, material, guess),
            Self::Cylinder => cylinder(draw, material, guess),
            Self::Pin => pin(draw, material, guess),
            Self::Mesh => return meshed(draw, number),
            Self::Pair => return pair(draw, number),
        })
    }
}

/// A block with the half-plane's stresses on its sides, pressed by a profile.
fn block(solution: EvenGap, material: Material, profile: Profile, [size, guess]: [f64; 2]) -> Sample {
    let (a, slope) = (solution.half_width, solution.slopes[0]);
    let Material { young, poisson } = material;
    let numbers = TruncatedHertz { radius: a / slope, young, poisson, a_over_r: slope, size, stretch: guess.min(size) };
    let truth = [solution.peak_pressure(), solution.second_moment()];
    let mut scene = numbers.scene_under(StressField(Arc::new(move |[x, depth]: [f64; 2]| solution.stress(x, depth))));
    scene.contacts[0].profile = profile;
    Sample { scene, truths: vec![truth] }
}

/// `g = c₂ s² + c₄ s⁴ + c₆ s⁶`, drawn until it is pressed all over the contact, and open all over the block beyond it.
fn polynomial(draw: &mut Draw, material: Material, guess: f64, off_centre: bool) -> Sample {
    let modulus = material.plane_modulus(PlaneHypothesis::Strain);
    let (a, slope, size) = (draw.decades(0.01, 100.0), draw.decades(1e-4, 1e-2), draw.between(4.0, 14.0));
    loop {
        let parts = [draw.between(0.0, 1.0), draw.between(-0.5, 1.0), draw.between(-0.5, 1.0)];
        let coefficients = [0, 1, 2].map(|k| slope * parts[k] / (2.0 * (k + 1) as f64 * a.powi(2 * k as i32 + 1)));
        let solution = EvenGap::polynomial(modulus, a, coefficients);
        let steepness = |x: f64| (0..3).map(|k| slope * parts[k] * (x / a).powi(2 * k as i32 + 1)).sum::<f64>();
        let mean = solution.slopes[0];
        let phi = |k: usize| FRAC_PI_2 * (k as f64 + 0.5) / LOOKED_AT as f64;
        let pressed = |k: usize| 2.0 * solution.pressure(phi(k)) / (modulus * phi(k).sin()) > 0.1 * mean;
        let beyond = |k: usize| a * (1.0 + (size - 1.0) * (k as f64 + 1.0) / LOOKED_AT as f64);
        let open = |k: usize| solution.opening(beyond(k), steepness(beyond(k))) > 0.0;
        let hollow = solution.peak_pressure() > 1.01 * solution.pressure(FRAC_PI_2);
        if mean > 0.1 * slope && hollow == off_centre && (0..LOOKED_AT).all(|k| pressed(k) && open(k)) {
            return block(solution, material, Profile::Even { coefficients: coefficients.into() }, [size, guess]);
        }
    }
}

/// `g' = s/R` up to a tenth to eight tenths of the contact, and constant beyond: a cubic through points, which is exact but
/// for the corner of its curvature.
fn wedge(draw: &mut Draw, material: Material, guess: f64) -> Sample {
    let modulus = material.plane_modulus(PlaneHypothesis::Strain);
    let (a, slope, size) = (draw.decades(0.01, 100.0), draw.decades(1e-4, 1e-2), draw.between(4.0, 14.0));
    let round = a * draw.between(0.1, 0.8);
    let radius = round / slope;
    let gap = |s: f64| if s < round { 0.5 * s * s / radius } else { round / radius * (s - 0.5 * round) };
    let places = [0.0, 0.5 * round, round * (1.0 - CORNER), round, round * (1.0 + CORNER), size * a];
    let cubic = MonotoneCubic::through(&places.map(|s| [s, gap(s)]));
    let solution = EvenGap::rounded_wedge(modulus, a, radius, round, TERMS);
    block(solution, material, Profile::Smooth(Arc::new(cubic)), [size, guess])
}

/// Westergaard's waves on half a wave of a block, under the mean pressure `p* sin² ψ` that makes contact up to `a`, `ψ = πa/λ`.
fn cosine(draw: &mut Draw, material: Material, guess: f64) -> Sample {
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
    Sample { scene, truths: vec![[peak, waves.second_moment()]] }
}

/// A cylinder on a plane, as a quarter or as a half.
fn cylinder(draw: &mut Draw, Material { young, poisson }: Material, guess: f64) -> Sample {
    let (radius, a_over_r) = (draw.decades(0.1, 1000.0), draw.decades(0.001, 0.006));
    let model = match draw.between(0.0, 3.0) {
        third if third < 1.0 => CylinderModel::Quarter,
        third if third < 2.0 => CylinderModel::Half,
        _ => CylinderModel::HalfLoadedAbove,
    };
    let numbers = Cylinder { radius, young, poisson, a_over_r, stretch: guess, model };
    let scene = numbers.scene();
    let hertz = Hertz { load: numbers.load(), radius, modulus: scene.contact_modulus() };
    Sample { scene, truths: vec![[hertz.peak_pressure(), hertz.half_width()]] }
}

/// Persson's pin, pressed to a half-angle of 15 to 80 degrees.
fn pin(draw: &mut Draw, material: Material, guess: f64) -> Sample {
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
    Sample { scene: numbers.scene(), truths: vec![[solution.peak_pressure(), solution.second_moment()]] }
}

/// A scene of another family with a mesh given for its body: of 4- or 8-node cells, two to six of them on the half-width, its
/// inner nodes shaken.
fn meshed(draw: &mut Draw, number: usize) -> Result<Sample, Error> {
    let of = [Family::Polynomial, Family::Wedge, Family::Cosine, Family::Cylinder][number % 4];
    let (elements, shake) = (draw.between(2.0, 7.0) as usize, draw.between(0.0, 0.2));
    let order = if draw.between(0.0, 2.0) < 1.0 { Order::Linear } else { Order::Quadratic };
    let Sample { mut scene, truths } = of.sample(draw, number)?;
    let guess = scene.contacts[0].stretch;
    // Its cells have the size of a part of the contact, whatever the guess.
    scene.contacts[0].stretch = (1.5 * scene.grading.unit).min(longest(&scene, scene.contact()));
    let mesh = Mesh::of(&scene, Resolution { elements, refinement: 0, order })?;
    // Shaken, a line inside would no longer be straight, and its load another one.
    let straight = mesh.bodies[0].lines.is_empty();
    let mesh = if straight { mesh.shaken(shake) } else { mesh };
    scene.bodies[0].shape = Shape::Given(Arc::new(mesh.given(0)));
    scene.contacts[0].stretch = guess;
    Ok(Sample { scene, truths })
}

/// Two scenes of other families in one.
fn pair(draw: &mut Draw, number: usize) -> Result<Sample, Error> {
    let families = [Family::Polynomial, Family::Wedge, Family::Cosine, Family::Cylinder];
    let Sample { mut scene, mut truths } = families[number % 4].sample(draw, number)?;
    let other = families[number / 4 % 4].sample(draw, number)?;
    let bodies = scene.bodies.len();
    scene.bodies.extend(other.scene.bodies);
    scene.contacts.extend(other.scene.contacts.into_iter().map(|pair| ContactPair {
        first: pair.first + bodies,
        second: pair.second.map(|second| second + bodies),
        ..pair
    }));
    truths.extend(other.truths);
    Ok(Sample { scene, truths })
}
