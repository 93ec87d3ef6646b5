//! How near another code must come, and why.

use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::oracle::ReferenceKind;
use crate::oracle::cross_code::Code;
use crate::study::cross_code::Numbers;
use crate::study::cross_code::answers::Reproduced;
use crate::study::cross_code::benchmark::{STATIONS, Scene};
use crate::study::cross_code::differences::worst_difference;
use crate::study::cross_code::discrete::{self, Difference, Part};
use crate::study::cross_code::physical::{self, Found, Measured};

/// Assembly differs by the order of sums only.
const ASSEMBLED: f64 = 1e-11;
/// Two direct solvers on a system of condition 1e6 and more.
const SOLVED: f64 = 1e-8;
/// Relative difference from the frozen answer that a live one may have.
const REPRODUCED: f64 = 1e-6;

/// The checks.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    Ok(match numbers {
        Numbers::Discrete(compared) => discrete(compared),
        Numbers::Physical(compared) => physical(compared),
    })
}

fn discrete(compared: &discrete::Compared) -> Vec<Judged> {
    let live = compared.reproduced.iter().map(|live| reproduced(compared.code, live));
    live.chain(compared.differences.iter().map(|one| assembled_alike(compared.code, one))).collect()
}

/// A live answer is what was frozen; the versions that changed since are named.
pub fn reproduced(code: Code, live: &Reproduced) -> Judged {
    let frozen = Reference { name: "frozen results".into(), kind: ReferenceKind::CrossCode, value: 0.0, uncertainty: None };
    let because = format!("solvers and libraries differ in round-off; {}", live.versions);
    let quantity = Quantity::at("largest relative change of a live answer", code.name());
    Check::error(quantity, frozen, REPRODUCED, because).judge(live.change)
}

/// Another code assembles, and finds, the same on our mesh.
pub fn assembled_alike(code: Code, difference: &Difference) -> Judged {
    let (name, tolerance, because) = match difference.part {
        Part::Stiffness => ("difference of the stiffness on the same mesh", ASSEMBLED, "the order of sums only"),
        Part::Loads => ("difference of the loads on the same mesh", ASSEMBLED, "the order of sums only"),
        Part::Contact => (
            "difference of the contact by penalty line elements on the same mesh",
            SOLVED,
            "two direct solvers, condensed and not",
        ),
    };
    let quantity = Quantity::at(name, difference.by.clone());
    Check::error(quantity, theirs(code.name(), 0.0), tolerance, because).judge(difference.error)
}

fn theirs(name: impl ToString, value: f64) -> Reference {
    Reference { name: name.to_string(), kind: ReferenceKind::CrossCode, value, uncertainty: None }
}

fn physical(compared: &physical::Compared) -> Vec<Judged> {
    let of_code = compared.others.iter().flat_map(|other| {
        let live = other.reproduced.iter().map(|live| reproduced(other.code, live));
        live.chain(other.found.iter().flat_map(|found| agreement(compared.scene, &compared.ours, found)))
    });
    of_code.chain([one_mesh(compared)]).collect()
}

/// scikit-fem and dolfinx share meshes, loads, contact rows and measures: on them they must agree to round-off.
fn one_mesh(compared: &physical::Compared) -> Judged {
    let numbers = |found: &Found| vec![vec![found.peak.value], vec![found.half_width.value], found.profile.clone()];
    let found: Vec<&Found> = compared.others.iter().filter_map(|other| other.found.first()).collect();
    let difference = match found[..] {
        [a, b] => worst_difference(&numbers(a), &numbers(b)),
        _ => f64::NAN,
    };
    Check::error(
        Quantity::at("difference of scikit-fem on the same mesh", "peak, width and profile"),
        theirs(Code::Dolfinx, 0.0),
        1e-8,
        "only stiffness, edge functions and linear solver differ",
    )
    .judge(difference)
}

/// Agreement demanded of peak and half-width, and of the profile.
fn demanded(scene: Scene) -> [f64; 2] {
    match scene {
        // Hertz: the square-root edge of the profile is where meshes differ.
        Scene::Cylinder | Scene::WiderCylinder | Scene::TruncatedHertz => [1e-3, 1.5e-2],
        Scene::PinRod | Scene::PinPlate => [5e-3, 5e-3],
    }
}

/// The agreement demanded of peak, width, profile and resultant.
pub fn agreement(scene: Scene, ours: &Found, found: &Found) -> [Judged; 4] {
    let [measured, profile] = demanded(scene);
    let width = if scene.is_arc() { "2 √(∫pθ²/∫p) [rad]" } else { "a [mm]" };
    let near = |name: &'static str, at: &str, a: Measured, b: Measured| {
        let combined = 100.0 * a.uncertainty.hypot(b.uncertainty) / b.value.abs();
        let because = format!("demanded at the finest meshes; combined uncertainty {combined:.3} %");
        let theirs = Reference { uncertainty: Some(b.uncertainty), ..theirs(found.by, b.value) };
        let judged = Check::near(Quantity::at(name, at), theirs, measured, because).judge(a.value);
        Judged { uncertainty: Some(a.uncertainty), ..judged }
    };
    [
        near("peak pressure", "[MPa]", ours.peak, found.peak),
        near("second-moment width", width, ours.half_width, found.half_width),
        Check::error(
            Quantity::at("difference of the profile", format!("L2(p) over {STATIONS} stretches")),
            theirs(found.by, 0.0),
            profile,
            "means over the same stretches; the square-root edge lies within one of them",
        )
        .judge(l2(&ours.profile, &found.profile)),
        Check::near("resultant [N]", theirs(found.by, found.resultant), 1e-6, "equilibrium on either mesh")
            .judge(ours.resultant),
    ]
}

/// `√( Σ (p − q)² / Σ q² )`; NaN where the lengths differ.
fn l2(p: &[f64], q: &[f64]) -> f64 {
    if p.len() != q.len() {
        return f64::NAN;
    }
    let error: f64 = p.iter().zip(q).map(|(p, q)| (p - q).powi(2)).sum();
    (error / q.iter().map(|q| q * q).sum::<f64>()).sqrt()
}
