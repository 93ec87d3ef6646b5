//! Layers and rows under rigid profiles: half of a contact each.

use crate::measure::Quantity;
use crate::oracle::boundary::Strip;
use crate::oracle::boundary::strip::OnStrip;
use crate::scene::{
    Body, Component, ContactPair, Face, Grading, Load, Material, Path, Place, PlaneHypothesis, Profile,
    ReferenceValues, Scene, Shape, Support,
};
use crate::study::random::draw::Draw;
use crate::study::random::sample::Sample;

/// Half-width over the thickness of a layer.
const OVER_THICKNESS: [f64; 2] = [0.2, 3.0];
/// Largest Poisson's ratio of a bonded layer: beyond, it is the incompressible material that is looked at.
const BONDED: f64 = 0.4;
/// Thicknesses of a layer beyond its contact: at its end e^(−2.1 · 8) of what the contact moves is left.
const BEYOND: f64 = 8.0;
/// Half-width over the period of a row, and heights of its block over that.
const OVER_PERIOD: [f64; 2] = [0.04, 0.42];
const HEIGHTS: [f64; 2] = [2.0, 3.0];

/// `g = c₂ s² + c₄ s⁴ + c₆ s⁶`, with a half-width.
fn gap(draw: &mut Draw) -> (f64, Profile) {
    let (a, slope) = (draw.decades(0.01, 100.0), draw.decades(1e-4, 1e-2));
    let parts = [draw.between(0.0, 1.0), draw.between(-0.3, 1.0), draw.between(-0.3, 1.0)];
    let coefficients = [0, 1, 2].map(|k| slope * parts[k] / (2.0 * (k + 1) as f64 * a.powi(2 * k as i32 + 1)));
    (a, Profile::Even { coefficients: coefficients.into() })
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
            let base = |component, value| Support { at: Place::Boundary("far".into()), component, value };
            let mut supports = vec![base(Component::Y, -contact.approach)];
            supports.extend(is_bonded.then(|| base(Component::X, 0.0)));
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
            let right = Support { at: Place::Boundary("right".into()), component: Component::X, value: 0.0 };
            let mean = Load::Traction { boundary: "far".into(), traction: [0.0, -contact.load() / period] };
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
    supports.push(Support { at: Place::Boundary("left".into()), component: Component::X, value: 0.0 });
    let scene = Scene {
        name: name.into(),
        plane: PlaneHypothesis::Strain,
        thickness: 1.0,
        bodies: vec![Body {
            density: 1.0,
            name: "block".into(),
            shape: Shape::Rectangle { x: [0.0, side], y: [0.0, height], contact: Face::Bottom },
            material,
            supports,
            loads,
        }],
        contacts: vec![ContactPair::new(None, Path::HORIZONTAL, profile.clone(), (guess * a).min(side))],
        reference: ReferenceValues { length: a, pressure: peak, gap: profile.gap(a) },
        grading: Grading { unit: a, along: 1.5, depth: 1.4, first: 1.0, coarsest: 0.2, end: 1.0 },
    };
    Sample::of(
        scene,
        [
            (Quantity::PeakPressure, peak),
            (Quantity::PeakPlace, place),
            (Quantity::SecondMomentWidth, contact.second_moment()),
            (Quantity::End(0), a),
            (Quantity::Resultant, load),
        ],
    )
}
