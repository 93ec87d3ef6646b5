//! Blocks on which closed forms hold exactly, pressed by parabolas, waves and punches, by their own load or by the
//! stresses of the half-plane on their sides, so that its contact is theirs; and what these stresses say of the points
//! below a contact: how far they sink, and where the shear stress is largest.

use std::f64::consts::PI;
use std::sync::Arc;

use crate::case::library::{FlatPunch, TruncatedHertz, body, fixed};
use crate::measure::Quantity;
use crate::oracle::analytic::hertz::Hertz;
use crate::oracle::analytic::punch;
use crate::oracle::analytic::waves::Waves;
use crate::oracle::boundary::HalfPlane;
use crate::scene::{
    Action, Body, Component, ContactPair, Face, Grading, Load, Material, Path, Place, PlaneHypothesis, Profile,
    ReferenceValues, Scene, Shape, Support, VectorField,
};
use crate::study::random::family::{Draw, Sample};

/// The surface to both sides of x = 0.
const BOTH_SIDES: Path = Path::Straight { origin: [0.0, 0.0], both_sides: true };
/// Part of the height of a block at which a point on its axis is looked at.
const LOOKED_INTO: f64 = 0.3;

/// The sample with how far a point on the axis sinks, given the stresses and the height of the block; the point on the
/// surface above touches and does not move.
pub fn on_axis(sample: Sample, material: Material, stress: impl Fn([f64; 2]) -> [f64; 3], height: f64) -> Sample {
    let depth = LOOKED_INTO * height;
    sample.moved(0, Place::Point([0.0, depth]), Component::Y, sunk(stress, material, depth))
}

/// Westergaard's waves on half a wave of a block, under the mean pressure `p* sin² ψ` that makes contact up to `a`,
/// `ψ = πa/λ`.
pub fn cosine(draw: &mut Draw, material: Material, guess: f64) -> Sample {
    let modulus = material.plane_modulus(PlaneHypothesis::Strain);
    let (wavelength, amplitude) = (draw.decades(0.1, 1000.0), draw.decades(1e-5, 1e-3));
    let amplitude = amplitude * wavelength;
    let [share, height] = [draw.between(0.03, 0.42), wavelength * draw.between(2.0, 3.0)];
    let open = Waves { modulus, amplitude, wavelength, mean: 0.0 };
    let waves = Waves { mean: open.complete() * (PI * share).sin().powi(2), ..open };
    let (peak, half_width) = (waves.pressure(0.0), share * wavelength);
    let side = 0.5 * wavelength;
    let supports = ["left", "right"].map(|side| fixed(side, Component::X, 0.0)).into();
    let loads = vec![Load::on("far", Action::Uniform([0.0, -waves.mean]))];
    let profile = Profile::Cosine { amplitude, wavelength };
    let scene = scene(
        "waves",
        vec![rectangle(material, [[0.0, side], [0.0, height]], supports, loads)],
        ContactPair::new(None, Path::HORIZONTAL, profile, (guess * half_width).min(side)),
        ReferenceValues { length: half_width, pressure: peak, gap: amplitude },
        GROWING,
    );
    let truths = even([peak, 0.0], waves.second_moment(), half_width, 2.0 * side * waves.mean);
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

/// A whole block under Hertz's stresses for a contact beside the vertex of the parabola, whose tangent it takes there:
/// a small rotation `c/R` makes `s²/2R` the gap `(s − c)²/2R`.
pub fn rolling(draw: &mut Draw, material: Material, guess: f64) -> Sample {
    let (radius, a_over_r) = (draw.decades(0.1, 1000.0), draw.decades(1e-4, 0.1));
    let (a, modulus) = (radius * a_over_r, material.plane_modulus(PlaneHypothesis::Strain));
    let centre = a * draw.between(-1.5, 1.5);
    let [left, right, height] = [-1.0, 1.0, 1.0].map(|side| side * a * draw.between(6.0, 14.0));
    let hertz = Hertz { load: Hertz::load_for(a, radius, modulus), radius, modulus };
    let field = VectorField::of(move |[x, depth]: [f64; 2]| hertz.stress(x - centre, depth));
    let loads = ["left", "right", "far"].map(|side| Load::on(side, Action::Stress(field.clone())));
    let reach = (centre - left).min(right - centre);
    let pair = ContactPair::new(None, BOTH_SIDES, Profile::Parabola { radius }, (guess * a).min(reach));
    let held = Support { at: Place::Point([centre + right, height]), component: Component::X, value: 0.0 };
    let size = [[centre + left, centre + right], [0.0, height]];
    let scene = scene(
        "block that rolls",
        vec![rectangle(material, size, vec![held], loads.into())],
        ContactPair { symmetric: false, ..pair },
        ReferenceValues { length: a, pressure: hertz.peak_pressure(), gap: a * a / (2.0 * radius) },
        GROWING,
    );
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
    even([hertz.peak_pressure(), 0.0], hertz.half_width(), hertz.half_width(), hertz.load)
}

/// What is said of an even contact: peak and its place, second-moment width, end and resultant.
pub fn even([peak, place]: [f64; 2], width: f64, end: f64, load: f64) -> [(Quantity, f64); 5] {
    [
        (Quantity::PeakPressure, peak),
        (Quantity::PeakPlace, place),
        (Quantity::SecondMomentWidth, width),
        (Quantity::End(0), end),
        (Quantity::Resultant, load),
    ]
}

/// Growth of the elements along the surface and into the depth, and the coarsest over the body.
pub const GROWING: [f64; 3] = [1.5, 1.4, 0.2];

/// A scene of plane strain and one contact, whose elements are graded from its reference length on.
pub fn scene(
    name: &str,
    bodies: Vec<Body>,
    pair: ContactPair,
    reference: ReferenceValues,
    [along, depth, coarsest]: [f64; 3],
) -> Scene {
    let grading = Grading { unit: reference.length, along, depth, first: 1.0, coarsest, end: 1.0 };
    let (plane, contacts) = (PlaneHypothesis::Strain, vec![pair]);
    Scene { name: name.into(), plane, thickness: 1.0, bodies, contacts, reference, grading }
}

/// A block with its contact below.
pub fn rectangle(material: Material, [x, y]: [[f64; 2]; 2], supports: Vec<Support>, loads: Vec<Load>) -> Body {
    body("block", Shape::Rectangle { x, y, contact: Face::Bottom }, material, supports, loads)
}

/// A block on a rigid plane under a pressure linear in x, which is that of the contact at every height.
pub fn eccentric(draw: &mut Draw, material: Material) -> Sample {
    let (half, mean) = (draw.decades(0.1, 1000.0), material.young * draw.decades(1e-5, 1e-3));
    let (height, slope) = (half * draw.between(0.5, 2.0), mean / half * draw.between(-0.9, 0.9));
    let pressure = move |x: f64| mean + slope * x;
    // ∫p = 2 p̄ L, ∫p s = 2 p' L³/3, ∫p s² = 2 p̄ L³/3.
    let centre = slope * half * half / (3.0 * mean);
    let half_width = 2.0 * (half * half / 3.0 - centre * centre).sqrt();
    let field = VectorField::of(move |[x, _]: [f64; 2]| [0.0, -pressure(x), 0.0]);
    // ε_y = σ_y/E', ε_x = −ν' ε_y and no shear: u_y = −p y/E', u_x = (ν' (p̄ x + p' x²/2) + p' (y² − H²)/2)/E'.
    let (modulus, ratio) =
        (material.plane_modulus(PlaneHypothesis::Strain), material.poisson / (1.0 - material.poisson));
    let far = || Place::Boundary("far".into());
    let held = Support { at: Place::Point([0.0, height]), component: Component::X, value: 0.0 };
    let loads = vec![Load::on("far", Action::Stress(field))];
    let scene = scene(
        "block under an eccentric load",
        vec![rectangle(material, [[-half, half], [0.0, height]], vec![held], loads)],
        ContactPair { symmetric: false, ..ContactPair::new(None, BOTH_SIDES, Profile::Uniform(0.0), half) },
        ReferenceValues { length: half, pressure: mean, gap: half * mean / material.young },
        [1.0, 1.0, 1.0],
    );
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
    let field = VectorField::of(move |[x, depth]: [f64; 2]| solution.stress(x, depth));
    let sides = ["right", "far"].map(|side| Load::on(side, Action::Stress(field.clone())));
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

/// Parts of the Simpson rule over the depth, graded towards the surface.
const PARTS: usize = 200;
/// Places of the coarse search for the largest shear stress along the contact, and into the depth.
const PLACES: [usize; 2] = [32, 48];
/// Half-widths down to which it is looked for.
const DEPTH: f64 = 2.0;
/// Halvings of the step of the search that follows.
const HALVINGS: usize = 40;

/// `u_z(0, z) − u_z(0, 0) = ∫ (σ_z − ν' σ_x) dz / E'` in plane strain, `E' = E/(1−ν²)`, `ν' = ν/(1−ν)` \[mm\]; the
/// stresses are those at x and the depth z, `[σ_x, σ_z, τ]` \[MPa\].
pub fn sunk(stress: impl Fn([f64; 2]) -> [f64; 3], material: Material, depth: f64) -> f64 {
    let modulus = material.plane_modulus(PlaneHypothesis::Strain);
    let ratio = material.poisson / (1.0 - material.poisson);
    // z = depth · t²; at the surface itself the rule has the weight 0.
    let part = |k: usize| {
        let t = k as f64 / PARTS as f64;
        let [along, into, _] = stress([0.0, depth * t * t]);
        (into - ratio * along) * 2.0 * depth * t
    };
    let weight = |k: usize| match k {
        PARTS => 1.0,
        odd if !odd.is_multiple_of(2) => 4.0,
        _ => 2.0,
    };
    let sum: f64 = (1..=PARTS).map(|k| weight(k) * part(k)).sum();
    sum / (3.0 * PARTS as f64 * modulus)
}

/// Largest in-plane shear stress `½ (σ₁ − σ₂)` below a part of the surface \[MPa\], and its depth \[mm\].
pub fn largest_shear(stress: impl Fn([f64; 2]) -> [f64; 3], [from, to]: [f64; 2]) -> [f64; 2] {
    let length = to - from;
    let value = |[x, z]: [f64; 2]| {
        let [along, into, shear] = stress([from + length * x, length * z]);
        (0.5 * (along - into)).hypot(shear)
    };
    let [across, down] = PLACES;
    let place = |i: usize, j: usize| [i as f64 / across as f64, DEPTH * (j as f64 / down as f64).powi(2)];
    let all = (0..across).flat_map(|i| (1..=down).map(move |j| place(i, j)));
    let (mut at, mut best) = ([f64::NAN; 2], f64::NEG_INFINITY);
    for place in all {
        let found = value(place);
        if found > best {
            (at, best) = (place, found);
        }
    }
    let mut step = 1.0 / across as f64;
    for _ in 0..HALVINGS {
        for [dx, dz] in [[-step, 0.0], [step, 0.0], [0.0, -step], [0.0, step]] {
            let next = [(at[0] + dx).clamp(0.0, 1.0), (at[1] + dz).max(0.0)];
            let found = value(next);
            if found > best {
                (at, best) = (next, found);
            }
        }
        step *= 0.5;
    }
    [best, length * at[1]]
}

/// Elements on the shortest stretch, closed or open: on fewer, no coarser mesh sees it.
const ON_SHORTEST: f64 = 2.0;

/// A contact between a block and a rigid profile, or between two blocks, the upper one first: `whole` blocks lie on
/// both sides of s = 0, others are halves of an even contact; `size` is how far they go to each side, and into the
/// depth, and `guess` the candidate stretch, all over the outermost end of the contact.
pub fn sample(contact: HalfPlane, materials: &[Material], whole: bool, size: [f64; 2], guess: f64) -> Sample {
    let outermost = contact.stretches.iter().flatten().fold(0.0, |far: f64, end| far.max(end.abs()));
    let [side, height] = size.map(|size| size * outermost);
    let [peak, place] = contact.peak();
    let load = contact.load();
    let [centre, width] = contact.centre_and_width();
    let contact = Arc::new(contact);
    let (path, left) = if whole { (BOTH_SIDES, -side) } else { (Path::HORIZONTAL, 0.0) };
    let bodies = materials.iter().enumerate();
    let bodies = bodies.map(|(k, material)| block(&contact, *material, k == 0, [left, side, height])).collect();
    let pair = ContactPair::new(
        (materials.len() > 1).then_some(1),
        path,
        contact.profile.clone(),
        (guess * outermost).min(side),
    );
    let finite = if peak.is_finite() { peak } else { load / outermost };
    let scene = scene(
        "block of a half-plane",
        bodies,
        ContactPair { symmetric: !whole, ..pair },
        ReferenceValues { length: outermost, pressure: finite, gap: load / contact.modulus },
        GROWING,
    );
    let mut sample = Sample::of(
        scene,
        [
            (Quantity::PeakPressure, peak),
            (Quantity::PeakPlace, if whole { place } else { place.abs() }),
            (Quantity::SecondMomentWidth, width),
            (Quantity::Resultant, load),
        ],
    );
    if whole {
        sample = sample.with(Quantity::Centre, centre).with(Quantity::Moment, load * centre);
    }
    let modelled: Vec<[f64; 2]> = contact.stretches.iter().copied().filter(|[_, end]| whole || *end > 0.0).collect();
    if let ([[begin, _], ..], [.., [_, end]]) = (&modelled[..], &modelled[..])
        && (whole || *begin > 0.0)
    {
        sample = sample.with(Quantity::HalfWidth, 0.5 * (end - begin));
    }
    for (k, [begin, end]) in modelled.iter().enumerate() {
        if whole || *begin > 0.0 {
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
        let shear = largest_shear(stress, [if whole { from } else { from.max(0.0) }, outermost_end(&contact)]);
        sample = sample.sheared(0, shear);
        if materials.len() > 1 {
            sample = sample.sheared(1, shear);
        }
    }
    let several = contact.stretches.len() > if whole { 1 } else { 2 };
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
    let field = VectorField::of(move |[x, y]: [f64; 2]| {
        let [along, into, shear] = contact.stress(x, up * y);
        [along, into, up * shear]
    });
    let whole = left < 0.0;
    let sides: &[&'static str] = if whole { &["left", "right", "far"] } else { &["right", "far"] };
    let loads = sides.iter().map(|side| Load::on(*side, Action::Stress(field.clone())));
    let held = |at, component| Support { at, component, value: 0.0 };
    let corner = |x: f64| Place::Point([x, up * height]);
    let along = if whole { corner(right) } else { Place::Boundary("left".into()) };
    let mut supports = vec![held(along, Component::X)];
    if !above {
        supports.push(held(corner(left), Component::Y));
        supports.extend(whole.then(|| held(corner(right), Component::Y)));
    }
    let (name, y, face) =
        if above { ("block", [0.0, height], Face::Bottom) } else { ("lower", [-height, 0.0], Face::Top) };
    body(name, Shape::Rectangle { x: [left, right], y, contact: face }, material, supports, loads.collect())
}
