//! Our curve shall agree with a digitised one within the combined uncertainty.

use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::oracle::ReferenceKind;
use crate::study::digitised::run::{Curve, Numbers};
use crate::uncertainty::COVERAGE;

/// The checks.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    Ok(match numbers {
        Numbers::Absent { source, why } => {
            let reference = reference(source, ReferenceKind::Measured);
            vec![check("every curve", reference, None).not_run(ReferenceKind::Measured, source, why.clone())]
        }
        Numbers::Present(curves) => curves.iter().map(of).collect(),
    })
}

fn of(curve: &Curve) -> Judged {
    let source = reference(&curve.source, curve.kind);
    check(&curve.file, source, curve.model_form.as_deref()).judge(curve.worst)
}

fn reference(source: &str, kind: ReferenceKind) -> Reference {
    Reference { name: source.into(), kind, value: 0.0, uncertainty: None }
}

fn check(curve: &str, source: Reference, model_form: Option<&str>) -> Check {
    let friction = model_form.unwrap_or("no friction in the source");
    Check::error(
        Quantity::at("largest deviation in combined standard uncertainties", curve),
        source,
        COVERAGE,
        format!("u_val = digitising ⊕ measurement ⊕ our mesh, each standard; coverage {COVERAGE}; {friction}"),
    )
}
