//! How near the scripts must come: within the uncertainties of both, and within three times what is found.

use crate::case::{Check, Judged, Quantity, Reference, covered};
use crate::error::Error;
use crate::oracle::ReferenceKind;
use crate::oracle::cross_code::independent::Script;
use crate::study::answers::reproduced;
use crate::study::independent::benchmark::{STATIONS, Scene};
use crate::study::independent::found::Number;
use crate::study::independent::run::{Compared, Other};
use crate::uncertainty::{COVERAGE, Comparison};

/// The checks of a scene.
pub fn judge(compared: &Compared) -> Result<Vec<Judged>, Error> {
    Ok(compared.others.iter().flat_map(|other| of_script(compared, other)).chain([served(compared)]).collect())
}

/// Somebody must have answered.
fn served(compared: &Compared) -> Judged {
    let because = "a scene that no other code solves has no witness";
    Check::at_least("number of independent scripts", Reference::own("at least", 1.0), because)
        .judge(compared.others.len() as f64)
}

/// Ours against a script's, with the uncertainties of both meshes and of its penalty.
pub fn against(compared: &Compared, other: &Other, number: Number) -> Comparison {
    let (ours, theirs) = (number.of(compared.scene, &compared.ours), number.of(compared.scene, &other.found));
    let softened = compared.penalty[number as usize] * number.per_unit(compared.scene);
    let penalty = if other.script.has_penalty() { softened } else { 0.0 };
    Comparison::of(ours.value, theirs.value, [ours.uncertainty, theirs.uncertainty, penalty])
}

fn of_script(compared: &Compared, other: &Other) -> Vec<Judged> {
    let (scene, script) = (compared.scene, other.script);
    let demanded = demanded(scene, script);
    let theirs =
        |value: f64| Reference { name: script.name().into(), kind: ReferenceKind::CrossCode, value, uncertainty: None };
    let because = format!("at most {TIGHT} times what is found; {COVERAGE} u_val is asked beside it");
    let mut judged: Vec<Judged> = other.reproduced.iter().map(|live| reproduced(script.name(), live)).collect();
    let tight = |name: String, tolerance: f64, found: f64| {
        let quantity = Quantity::at("tolerance over the difference found", format!("{name}, {script}"));
        let because = "a tolerance far above what is found sees nothing";
        Check::error(quantity, Reference::own("what is found", 0.0), TIGHT, because).judge(tolerance / found)
    };
    for (number, tolerance) in Number::ALL.into_iter().zip(demanded) {
        let (name, mine, value) =
            (number.name(scene), number.of(scene, &compared.ours), number.of(scene, &other.found));
        let reference = || Reference { uncertainty: Some(value.uncertainty), ..theirs(value.value) };
        let quantity = Quantity::at(number.noun(), number.unit(scene));
        let near = Check::near(quantity, reference(), tolerance, because.clone()).judge(mine.value);
        judged.push(Judged { uncertainty: Some(mine.uncertainty), ..near });
        let sources = if script.has_penalty() { "both meshes ⊕ penalty" } else { "both meshes" };
        judged.push(covered(&name, reference(), against(compared, other, number), sources));
        judged.push(tight(name, tolerance, (mine.value / value.value - 1.0).abs()));
    }
    let difference = l2(&compared.ours.profile, &other.found.profile);
    let quantity = Quantity::at("difference of the profile", format!("L2(p) over {STATIONS} stretches"));
    judged.push(Check::error(quantity, theirs(0.0), demanded[2], because).judge(difference));
    judged.push(tight("profile in L2".into(), demanded[2], difference));
    judged.push(carried(compared, other));
    let resultant =
        Check::near("resultant [N]", theirs(other.found.resultant), RESULTANT, "equilibrium on either mesh");
    judged.push(resultant.judge(compared.ours.resultant));
    judged
}

/// The profile of a script shall carry the force that its contact transmits: areas and pressures belong together.
fn carried(compared: &Compared, other: &Other) -> Judged {
    let same = other.found.profile.len() == compared.carries.len();
    let force: f64 =
        other.found.profile.iter().zip(&compared.carries).map(|(pressure, carries)| pressure * carries).sum();
    let quantity = Quantity::at("force of the profile [N]", other.script.name());
    let reference = Reference::own("resultant of the same script", other.found.resultant);
    let because = "means over stretches, linear between integration points; at most three times what is found";
    Check::near(quantity, reference, CARRIED, because).judge(if same { force } else { f64::NAN })
}

/// `√( Σ (p − q)² / Σ q² )`; NaN where the lengths differ.
fn l2(p: &[f64], q: &[f64]) -> f64 {
    if p.len() != q.len() {
        return f64::NAN;
    }
    let error: f64 = p.iter().zip(q).map(|(p, q)| (p - q).powi(2)).sum();
    (error / q.iter().map(|q| q * q).sum::<f64>()).sqrt()
}

/// The most a tolerance may exceed what is found.
const TIGHT: f64 = 3.0;
/// Difference of the force of a profile to the resultant that is accepted.
const CARRIED: f64 = 4e-4;
/// Difference of resultants that is accepted: equilibrium to the tolerance of their iterations.
const RESULTANT: f64 = 1e-5;

/// Relative agreement of peak, width and profile: at most three times what is found, as the checks beside these hold.
fn demanded(scene: Scene, script: Script) -> [f64; 3] {
    match (script, scene) {
        // Springs soften the cylinders by 1e-4; the square-root edge lies within one stretch of the profile.
        (Script::Ufl, Scene::Cylinder | Scene::WiderCylinder | Scene::TruncatedHertz) => [2.5e-4, 1.7e-4, 1e-2],
        (Script::Facets, Scene::Cylinder | Scene::WiderCylinder | Scene::TruncatedHertz) => [1.8e-4, 1.6e-4, 4.5e-3],
        (Script::Facets, Scene::PinRod) => [9e-5, 1.3e-4, 5e-3],
        (Script::Facets, Scene::PinPlate) => [1.3e-5, 6e-5, 5e-3],
        // Nitsche's method has no springs: only meshes differ.
        (Script::Nitsche, Scene::Cylinder) => [1.8e-5, 4e-5, 6.5e-4],
        (Script::Nitsche, Scene::WiderCylinder) => [4e-5, 4e-5, 1.7e-3],
        (Script::Nitsche, Scene::TruncatedHertz) => [5e-6, 2.7e-5, 7e-4],
        (Script::Nitsche, Scene::PinRod) => [2.4e-4, 6e-5, 9e-4],
        (Script::Nitsche, Scene::PinPlate) => [9e-6, 1.2e-4, 4e-3],
        // Pressures are linear between the nodes of the boundary, and an edge of the contact moves within a node's distance.
        (Script::HalfPlane, Scene::TruncatedHertz) => [5e-6, 5e-5, 1e-3],
        // Edges move within elements: widths wander by 1e-4 from mesh to mesh.
        (Script::Augmented, Scene::PinRod) => [2e-4, 5e-5, 3e-3],
        (Script::Augmented, Scene::PinPlate) => [6e-5, 1.5e-4, 3e-3],
        (Script::Gaps, Scene::PinRod) => [2e-4, 2.5e-4, 3e-3],
        (Script::Gaps, Scene::PinPlate) => [8e-5, 1.5e-5, 3e-3],
        // Not served.
        (Script::Ufl | Script::HalfPlane, Scene::PinRod | Scene::PinPlate)
        | (Script::HalfPlane | Script::Augmented | Script::Gaps, Scene::Cylinder | Scene::WiderCylinder)
        | (Script::Augmented | Script::Gaps, Scene::TruncatedHertz) => [f64::NAN; 3],
    }
}
