//! The pin–rod shall agree with Gaertner within the combined uncertainty.

use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::oracle::ReferenceKind;
use crate::study::gaertner::run::{Curve, Numbers};
use crate::uncertainty::COVERAGE;

/// The checks.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    Ok(match numbers {
        Numbers::Absent(why) => {
            let source = Reference { name: "Gaertner 1977".into(), kind: ReferenceKind::Measured, value: 0.0, uncertainty: None };
            let name = source.name.clone();
            vec![check("p(θ), σ(θ)", source, None).not_run(ReferenceKind::Measured, &name, why.clone())]
        }
        Numbers::Present(curves) => curves.iter().map(of).collect(),
    })
}

fn of(curve: &Curve) -> Judged {
    let source = Reference { name: curve.source.clone(), kind: curve.kind, value: 0.0, uncertainty: None };
    match &curve.deviates {
        Some(deviates) => check(&curve.file, source, deviates.model_form.as_deref()).judge(deviates.worst),
        None => {
            let why = format!("{}: only pressure against angle is compared so far", curve.file);
            check(&curve.file, source, None).not_run(curve.kind, &curve.source, why)
        }
    }
}

fn check(curve: &str, source: Reference, model_form: Option<&str>) -> Check {
    let friction = model_form.unwrap_or("no friction in the source");
    Check::error(
        Quantity::at("largest deviation of the pin–rod in combined standard uncertainties", curve),
        source,
        COVERAGE,
        format!("u_val = digitising ⊕ measurement ⊕ our mesh, each standard; coverage {COVERAGE}; {friction}"),
    )
}
