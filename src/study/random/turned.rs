//! Bodies of revolution: blocks that carry the tractions of the half-space that they press, and spheres.

use std::f64::consts::PI;

use crate::case::library::Indented;
use crate::measure::Quantity;
use crate::oracle::analytic::revolution::indentation::Indentation;
use crate::oracle::analytic::revolution::sphere::Sphere;
use crate::scene::{Action, Load, Material, PlaneHypothesis, Profile, ReferenceValues};
use crate::study::random::blocks::even;
use crate::study::random::family::{Draw, Sample};
use crate::study::random::round::discs;

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
