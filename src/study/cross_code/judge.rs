//! How near another code must come, and why.

use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::oracle::ReferenceKind;
use crate::oracle::cross_code::Code;
use crate::study::answers::reproduced;
use crate::study::cross_code::discrete::{Compared, Difference, Part};

/// Assembly differs by the order of sums only.
const ASSEMBLED: f64 = 1e-11;
/// Two direct solvers on a system of condition 1e6 and more.
const SOLVED: f64 = 1e-8;

/// The checks.
pub fn judge(compared: &Compared) -> Result<Vec<Judged>, Error> {
    let live = compared.reproduced.iter().map(|live| reproduced(compared.code.name(), live));
    Ok(live.chain(compared.differences.iter().map(|one| assembled_alike(compared.code, one))).collect())
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
