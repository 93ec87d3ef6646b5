//! How near another code must come, and why.

use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::oracle::ReferenceKind;
use crate::oracle::cross_code::Code;
use crate::study::cross_code::answers::Reproduced;
use crate::study::cross_code::discrete::{Compared, Difference, Part};

/// Assembly differs by the order of sums only.
const ASSEMBLED: f64 = 1e-11;
/// Two direct solvers on a system of condition 1e6 and more.
const SOLVED: f64 = 1e-8;
/// Relative difference from the frozen answer that a live one may have.
const REPRODUCED: f64 = 1e-6;

/// The checks.
pub fn judge(compared: &Compared) -> Result<Vec<Judged>, Error> {
    let live = compared.reproduced.iter().map(|live| reproduced(compared.code.name(), live));
    Ok(live.chain(compared.differences.iter().map(|one| assembled_alike(compared.code, one))).collect())
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
    let theirs = Reference { name: code.name().into(), kind: ReferenceKind::CrossCode, value: 0.0, uncertainty: None };
    Check::error(quantity, theirs, tolerance, because).judge(difference.error)
}
