//! What of a result is hardly meant: strains of order one, bodies of very different size, moduli in another unit.

use std::f64::consts::PI;

use crate::measure::whole;
use crate::mesh::Mesh;
use crate::scene::{ContactPair, Scene, Shape};
use crate::solve::run::Contact;
use crate::solve::{Discretisation, Run};

/// Peak pressure over the contact modulus above which strains are not small: half-width over radius of a cylinder is
/// then 0.2.
const STRAINED: f64 = 0.1;
/// Displacement over the size of a body from which on it is not small.
const SQUEEZED: f64 = 0.1;
/// Interference over the size of a body from which on it is not small.
const DEEP: f64 = 0.1;
/// Size of a body over that of the one it touches from which on one of them may be in another unit.
const APART: f64 = 1e3;
/// Young's moduli below which they may be in GPa, and above which in Pa: no solid has 10⁸ MPa \[MPa\].
const YOUNG: [f64; 2] = [1e3, 1e8];
/// Peak pressure over the contact modulus below which a modulus may be in Pa.
const UNSTRAINED: f64 = 1e-7;
/// Digits that rounding explains.
const ROUNDING: f64 = 1e-9;

/// What is hardly meant of each contact of a run, converged or not.
pub fn doubts(discretisation: &Discretisation, run: &Run) -> Vec<Vec<String>> {
    let Discretisation { scene, mesh, .. } = discretisation;
    let displacement = discretisation.displacement_under(run.share(), &run.solution);
    let bodies: Vec<Body> = (0..scene.bodies.len()).map(|body| Body::of(mesh, body, &displacement)).collect();
    let mut deepest = vec![0.0_f64; scene.contacts.len()];
    for point in discretisation.points(&run.formulation) {
        deepest[point.contact] = deepest[point.contact].max(-point.gap);
    }
    let of = |(index, contact): (usize, &Contact)| {
        let pair = &scene.contacts[index];
        // What is said of a body is said with its first contact.
        let own =
            pair.bodies().filter(|body| scene.contacts_of(*body).next().is_some_and(|first| std::ptr::eq(first, pair)));
        let of_bodies = own.flat_map(|body| [moved(scene, &bodies, body), turned(scene, body)]);
        let of_pair = [strained(scene, pair, contact), apart(scene, &bodies, pair)];
        let deep = pair.bodies().map(|body| interference(scene, &bodies, body, deepest[index])).find(Option::is_some);
        of_pair.into_iter().chain(deep).chain(of_bodies).flatten().collect()
    };
    run.contacts.iter().enumerate().map(of).collect()
}

/// Sizes of a meshed body \[mm\].
struct Body {
    /// The smaller and the larger of its extents along x and y.
    smallest: f64,
    largest: f64,
    /// Its largest displacement.
    moved: f64,
}

impl Body {
    fn of(mesh: &Mesh, body: usize, displacement: &[[f64; 2]]) -> Self {
        let nodes = mesh.bodies[body].nodes.clone();
        let extents = [0, 1].map(|k| {
            let along = || nodes.clone().map(|node| mesh.points[node][k]);
            along().fold(f64::NEG_INFINITY, f64::max) - along().fold(f64::INFINITY, f64::min)
        });
        let moved = nodes.map(|node| displacement[node][0].hypot(displacement[node][1])).fold(0.0, f64::max);
        Self { smallest: extents[0].min(extents[1]), largest: extents[0].max(extents[1]), moved }
    }
}

/// A peak pressure of the order of the modulus, or so far below it that the modulus must be wrong.
fn strained(scene: &Scene, pair: &ContactPair, contact: &Contact) -> Option<String> {
    let (measures, modulus) = (&contact.measures, scene.modulus_of(pair));
    // A peak without a limit says nothing of the strains around it.
    let width: f64 = measures.stretches.iter().map(|one| one.end - one.begin).sum();
    let (what, pressure) = match contact.unbounded {
        None => ("peak", measures.peak.pressure),
        Some(_) => ("mean", mean(scene, pair, contact.transmitted, width)),
    };
    let strain = pressure / modulus;
    let told = |unit: &str, is_odd: &dyn Fn(f64) -> bool| {
        let odd = pair.bodies().map(|body| &scene.bodies[body]).find(|body| is_odd(body.material.young));
        odd.map(|body| format!("is `young` of `{}`, {} MPa, in {unit}?", body.name, shown(body.material.young)))
    };
    if strain > STRAINED && strain.is_finite() {
        let question = told("GPa", &|young| young < YOUNG[0]).unwrap_or_else(|| "is `young` in MPa?".into());
        return Some(format!(
            "the {what} pressure is {} of the contact modulus, {} MPa: strains are not small, as is assumed; \
            {question}",
            shown(strain),
            shown(modulus)
        ));
    }
    let unstrained = strain > 0.0 && strain < UNSTRAINED;
    let question = if unstrained { told("Pa", &|young| young > YOUNG[1]) } else { None };
    question.map(|question| format!("the {what} pressure is only {} of the contact modulus: {question}", shown(strain)))
}

/// Mean pressure of a contact that transmits a force, both halves, over a width, or around the axis over a circle
/// \[MPa\].
fn mean(scene: &Scene, pair: &ContactPair, transmitted: f64, width: f64) -> f64 {
    if pair.path.is_around_axis(scene.plane) {
        return transmitted.abs() / (PI * (width * pair.path.metric()).powi(2));
    }
    transmitted.abs() / (whole(pair) * scene.depth(pair.path.point(0.0)) * width * pair.path.metric())
}

/// Two bodies of which one may be in another unit.
fn apart(scene: &Scene, bodies: &[Body], pair: &ContactPair) -> Option<String> {
    let second = pair.second?;
    let [first, second] = [pair.first, second].map(|body| (&scene.bodies[body].name, bodies[body].largest));
    let (large, small) = if first.1 > second.1 { (first, second) } else { (second, first) };
    let times = large.1 / small.1;
    (times >= APART * (1.0 - ROUNDING)).then(|| {
        format!(
            "`{}` is {} mm large and `{}` {} mm, {times:.0} times less: is one of them in another unit?",
            large.0,
            shown(large.1),
            small.0,
            shown(small.1)
        )
    })
}

/// An interference that is deep for a body.
fn interference(scene: &Scene, bodies: &[Body], body: usize, deepest: f64) -> Option<String> {
    let part = deepest / bodies[body].smallest;
    (part > DEEP).then(|| {
        format!(
            "the bodies begin {} mm within one another, {:.0} % of the size of `{}`: strains are not small, as is \
            assumed",
            shown(deepest),
            100.0 * part,
            scene.bodies[body].name
        )
    })
}

/// A displacement that is large for a body.
fn moved(scene: &Scene, bodies: &[Body], body: usize) -> Option<String> {
    let (Body { moved, .. }, size) = (&bodies[body], bodies[body].largest);
    (*moved > SQUEEZED * size && moved.is_finite()).then(|| {
        format!(
            "`{}` moves by up to {} mm, {:.0} % of its size: displacements are not small, as is assumed; are `young` \
            and the loads meant so?",
            scene.bodies[body].name,
            shown(*moved),
            100.0 * moved / size
        )
    })
}

/// Cells of a given mesh that were clockwise.
fn turned(scene: &Scene, body: usize) -> Option<String> {
    let body = &scene.bodies[body];
    let Shape::Given(mesh) = &body.shape else { return None };
    let (turned, all) = (mesh.turned, mesh.cells.len());
    (turned > 0)
        .then(|| format!("{turned} of {all} cells of the mesh of `{}` were clockwise, and have been turned", body.name))
}

/// A number to three digits.
fn shown(value: f64) -> String {
    let size = value.abs();
    if (1e-2..1e5).contains(&size) {
        let digits = (2 - size.log10().floor() as i32).max(0) as usize;
        format!("{value:.digits$}")
    } else {
        format!("{value:.2e}")
    }
}
