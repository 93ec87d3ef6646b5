//! Blocks that carry the stresses of the half-plane on their sides, so that its contact is theirs.

use std::sync::Arc;

use crate::measure::Quantity;
use crate::oracle::boundary::HalfPlane;
use crate::scene::{
    Body, Component, ContactPair, Face, Grading, Line, Load, Material, Path, Place, PlaneHypothesis, ReferenceValues,
    Scene, Shape, StressField, Support,
};
use crate::study::random::blocks::on_axis;
use crate::study::random::half_plane::largest_shear;
use crate::study::random::sample::Sample;

/// Elements on the shortest stretch, closed or open: on fewer, no coarser mesh sees it.
const ON_SHORTEST: f64 = 2.0;

/// How a contact is cut out of the half-plane.
#[derive(Clone, Copy, Debug)]
pub struct Cut {
    /// Whether the blocks lie on both sides of s = 0; else they are halves of an even contact.
    pub whole: bool,
    /// How far they go to each side, and into the depth, over the outermost end of the contact.
    pub size: [f64; 2],
    /// Guess of the candidate stretch over the outermost end.
    pub guess: f64,
}

/// A contact between a block and a rigid profile, or between two blocks, the upper one first.
pub fn sample(contact: HalfPlane, materials: &[Material], cut: Cut) -> Sample {
    let outermost = contact.stretches.iter().flatten().fold(0.0, |far: f64, end| far.max(end.abs()));
    let [side, height] = cut.size.map(|size| size * outermost);
    let [peak, place] = contact.peak();
    let load = contact.load();
    let [centre, width] = contact.centre_and_width();
    let contact = Arc::new(contact);
    let (path, left) = if cut.whole {
        (Path::Straight(Line { origin: [0.0, 0.0], both_sides: true }), -side)
    } else {
        (Path::HORIZONTAL, 0.0)
    };
    let bodies = materials.iter().enumerate();
    let bodies = bodies.map(|(k, material)| block(&contact, *material, k == 0, [left, side, height])).collect();
    let pair = ContactPair::new(
        (materials.len() > 1).then_some(1),
        path,
        contact.profile.clone(),
        (cut.guess * outermost).min(side),
    );
    let finite = if peak.is_finite() { peak } else { load / outermost };
    let scene = Scene {
        name: "block of a half-plane".into(),
        plane: PlaneHypothesis::Strain,
        thickness: 1.0,
        bodies,
        contacts: vec![ContactPair { symmetric: !cut.whole, ..pair }],
        reference: ReferenceValues { length: outermost, pressure: finite, gap: load / contact.modulus },
        grading: Grading { unit: outermost, along: 1.5, depth: 1.4, first: 1.0, coarsest: 0.2, end: 1.0 },
    };
    let mut sample = Sample::of(
        scene,
        [
            (Quantity::PeakPressure, peak),
            (Quantity::PeakPlace, if cut.whole { place } else { place.abs() }),
            (Quantity::SecondMomentWidth, width),
            (Quantity::Resultant, load),
        ],
    );
    if cut.whole {
        sample = sample.with(Quantity::Centre, centre).with(Quantity::Moment, load * centre);
    }
    let modelled: Vec<[f64; 2]> =
        contact.stretches.iter().copied().filter(|[_, end]| cut.whole || *end > 0.0).collect();
    if let ([[begin, _], ..], [.., [_, end]]) = (&modelled[..], &modelled[..])
        && (cut.whole || *begin > 0.0)
    {
        sample = sample.with(Quantity::HalfWidth, 0.5 * (end - begin));
    }
    for (k, [begin, end]) in modelled.iter().enumerate() {
        if cut.whole || *begin > 0.0 {
            sample = sample.with(Quantity::Begin(k), *begin);
        }
        sample = sample.with(Quantity::End(k), *end);
    }
    let stress = |[x, depth]: [f64; 2]| contact.stress(x, depth);
    let touches = contact.stretches.iter().any(|[begin, end]| *begin < 0.0 && 0.0 < *end);
    if materials.len() == 1 && touches && contact.profile.gap(0.0).abs() <= f64::EPSILON {
        sample = on_axis(sample, materials[0], stress, height);
    }
    if peak.is_finite() {
        let from = contact.stretches[0][0];
        let shear = largest_shear(stress, [if cut.whole { from } else { from.max(0.0) }, outermost_end(&contact)]);
        sample = sample.sheared(0, shear);
        if materials.len() > 1 {
            sample = sample.sheared(1, shear);
        }
    }
    let several = contact.stretches.len() > if cut.whole { 1 } else { 2 };
    let half = 0.5 * (outermost_end(&contact) - contact.stretches[0][0]);
    if several { sample.seen_by(ON_SHORTEST * half / contact.shortest()) } else { sample }
}

fn outermost_end(contact: &HalfPlane) -> f64 {
    contact.stretches.last().map_or(f64::NAN, |last| last[1])
}

/// The block above the surface, or the one below it; what holds it carries no force.
fn block(contact: &Arc<HalfPlane>, material: Material, above: bool, [left, right, height]: [f64; 3]) -> Body {
    let contact = contact.clone();
    let up = if above { 1.0 } else { -1.0 };
    let field = StressField(Arc::new(move |[x, y]: [f64; 2]| {
        let [along, into, shear] = contact.stress(x, up * y);
        [along, into, up * shear]
    }));
    let whole = left < 0.0;
    let sides: &[&'static str] = if whole { &["left", "right", "far"] } else { &["right", "far"] };
    let loads = sides.iter().map(|side| Load::Stress { boundary: (*side).into(), field: field.clone() });
    let fixed = |at, component| Support { at, component, value: 0.0 };
    let corner = |x: f64| Place::Point([x, up * height]);
    let along = if whole { corner(right) } else { Place::Boundary("left".into()) };
    let mut supports = vec![fixed(along, Component::X)];
    if !above {
        supports.push(fixed(corner(left), Component::Y));
        supports.extend(whole.then(|| fixed(corner(right), Component::Y)));
    }
    let (name, y, face) =
        if above { ("block", [0.0, height], Face::Bottom) } else { ("lower", [-height, 0.0], Face::Top) };
    Body {
        density: 1.0,
        name: name.into(),
        shape: Shape::Rectangle { x: [left, right], y, contact: face },
        material,
        supports,
        loads: loads.collect(),
    }
}
