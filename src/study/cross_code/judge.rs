//! How near another code must come, and why.

use crate::case::{Check, Judged, Quantity, Reference, covered};
use crate::error::Error;
use crate::measure::larger;
use crate::oracle::ReferenceKind;
use crate::oracle::cross_code::Code;
use crate::study::cross_code::Numbers;
use crate::study::cross_code::answers::Reproduced;
use crate::study::cross_code::benchmark::{STATIONS, Scene};
use crate::study::cross_code::differences::worst_difference;
use crate::study::cross_code::discrete::{self, Difference, Part};
use crate::study::cross_code::physical::{self, ClosedForm, Found};
use crate::study::cross_code::validation::{Number, against, exactly};
use crate::uncertainty::COVERAGE;

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
    let live = compared.reproduced.iter().map(|live| reproduced(compared.code.name(), live));
    live.chain(compared.differences.iter().map(|one| assembled_alike(compared.code, one))).collect()
}

/// A live answer is what was frozen; the versions that changed since are named.
pub fn reproduced(name: &str, live: &Reproduced) -> Judged {
    let frozen =
        Reference { name: "frozen results".into(), kind: ReferenceKind::CrossCode, value: 0.0, uncertainty: None };
    let because = format!("solvers and libraries differ in round-off; {}", live.versions);
    let quantity = Quantity::at("largest relative change of a live answer", name);
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
    let live = compared
        .others
        .iter()
        .flat_map(|other| other.reproduced.iter().map(|live| reproduced(other.code.name(), live)));
    let agreed = compared.counted().flat_map(|found| agreement(compared, found));
    let exact = compared.closed_form.iter().filter(|_| compared.scene.closed_form_is_exact());
    let exact = exact.flat_map(|closed| covered_closed_form(compared, closed));
    live.chain(agreed).chain([one_mesh(compared)]).chain(exact).chain(tight(compared)).collect()
}

/// Where the closed form is that of the scene, our uncertainty alone covers the difference.
fn covered_closed_form(compared: &physical::Compared, closed: &ClosedForm) -> [Judged; 2] {
    Number::ALL.map(|number| {
        let exact = number.of_closed_form(compared.scene, closed);
        let reference = Reference::analytic(&closed.name, exact);
        let comparison = exactly(number.of(compared.scene, &compared.ours), exact);
        covered(&number.name(compared.scene), reference, comparison, "our mesh")
    })
}

/// The most a tolerance may exceed what is found.
pub const TIGHT: f64 = 3.0;

/// Tolerances of a scene are at most three times the largest difference that is found.
pub fn tight(compared: &physical::Compared) -> [Judged; 3] {
    let demanded = demanded(compared.scene);
    let worst = |of: &dyn Fn(&Found) -> f64| compared.counted().map(of).fold(0.0, larger);
    let numbers = Number::ALL.map(|number| {
        worst(&|found| {
            (number.of(compared.scene, &compared.ours).value / number.of(compared.scene, found).value - 1.0).abs()
        })
    });
    let profile = worst(&|found| l2(&compared.ours.profile, &found.profile));
    let all = [
        (Number::Peak.name(compared.scene), demanded.peak, numbers[0]),
        (Number::Width.name(compared.scene), demanded.width, numbers[1]),
        ("profile in L2".into(), demanded.profile, profile),
    ];
    all.map(|(name, tolerance, found)| {
        let quantity = Quantity::at("tolerance over the largest difference of either method", name);
        let because = "a tolerance far above what is found sees nothing";
        Check::error(quantity, Reference::own("what is found", 0.0), TIGHT, because).judge(tolerance / found)
    })
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

/// Relative agreement demanded.
struct Demanded {
    peak: f64,
    width: f64,
    profile: f64,
}

/// At most three times the largest difference found, by scene: [`tight`] holds these against that.
fn demanded(scene: Scene) -> Demanded {
    match scene {
        // Hertz: the square-root edge of the profile, where meshes differ, weighs in widths and profiles.
        Scene::Cylinder | Scene::TruncatedHertz => Demanded { peak: 2.5e-4, width: 6e-4, profile: 1.2e-2 },
        Scene::WiderCylinder => Demanded { peak: 3e-4, width: 8e-4, profile: 1.2e-2 },
        // Springs of the penalty press on edges that do not match: pressures scatter from edge to edge.
        Scene::PinRod => Demanded { peak: 1.5e-3, width: 4e-5, profile: 3e-3 },
        Scene::PinPlate => Demanded { peak: 7e-4, width: 1.2e-4, profile: 3e-3 },
    }
}

/// The agreement demanded of peak and width, that their uncertainties cover what they differ by, and of profile and resultant.
pub fn agreement(compared: &physical::Compared, found: &Found) -> [Judged; 6] {
    let (scene, ours) = (compared.scene, &compared.ours);
    let demanded = demanded(scene);
    let [peak, width] = [(Number::Peak, demanded.peak), (Number::Width, demanded.width)].map(|(number, tolerance)| {
        let (name, mine, other) = (number.name(scene), number.of(scene, ours), number.of(scene, found));
        let reference = || Reference { uncertainty: Some(other.uncertainty), ..theirs(found.by, other.value) };
        let because = format!("at most three times what is found; {COVERAGE} u_val is asked beside it");
        let near = Check::near(Quantity::at(number.noun(), number.unit(scene)), reference(), tolerance, because);
        let near = Judged { uncertainty: Some(mine.uncertainty), ..near.judge(mine.value) };
        let (comparison, sources) = against(compared, found, number);
        [near, covered(&name, reference(), comparison, &sources.names())]
    });
    let profile = Check::error(
        Quantity::at("difference of the profile", format!("L2(p) over {STATIONS} stretches")),
        theirs(found.by, 0.0),
        demanded.profile,
        "means over the same stretches; the square-root edge lies within one of them; at most three times what is found",
    );
    let [near_peak, covered_peak] = peak;
    let [near_width, covered_width] = width;
    [
        near_peak,
        covered_peak,
        near_width,
        covered_width,
        profile.judge(l2(&ours.profile, &found.profile)),
        Check::near("resultant [N]", theirs(found.by, found.resultant), 1e-6, "equilibrium on either mesh")
            .judge(ours.resultant),
    ]
}

/// `√( Σ (p − q)² / Σ q² )`; NaN where the lengths differ.
pub fn l2(p: &[f64], q: &[f64]) -> f64 {
    if p.len() != q.len() {
        return f64::NAN;
    }
    let error: f64 = p.iter().zip(q).map(|(p, q)| (p - q).powi(2)).sum();
    (error / q.iter().map(|q| q * q).sum::<f64>()).sqrt()
}
