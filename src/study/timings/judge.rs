//! Seconds are believed only while the errors and counts recorded beside them are still the code's own.

use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::oracle::ReferenceKind;
use crate::study::timings::digits::{self, Reached};
use crate::study::timings::growth;
use crate::study::timings::precision::Point;
use crate::study::timings::run::{Numbers, Precision, Recounted, Redone};

/// Recorded errors may differ from recomputed ones by this share: other machines round otherwise, and runs stop at 1e-5.
const DIGITS: f64 = 1e-3;

/// The check of a trial.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    Ok(vec![match numbers {
        Numbers::Precision(precision) => points_as_recorded(precision),
        Numbers::Growth(growth) => counts_as_recorded(growth),
        Numbers::Digits(digits) => digits_as_recorded(digits),
    }])
}

fn points_as_recorded(Precision { recorded, fresh, planned }: &Precision) -> Judged {
    let complete = !fresh.is_empty() && recorded.len() == *planned;
    let quantity = Quantity::at(
        "point whose errors or counts are not those recorded with its seconds",
        format!("of {}", fresh.len()),
    );
    let because = format!(
        "every mesh is computed again; errors within {DIGITS:e}, which the tolerance of the runs leaves; `timings` renews \
         the record"
    );
    Check::at_most(quantity, Reference::own("snapshots/timings", 0.0), because).judge(if complete {
        moved(recorded, fresh) as f64
    } else {
        f64::NAN
    })
}

/// How many points are not the recorded ones, or not recorded; seconds are not compared.
pub fn moved(recorded: &[Point], fresh: &[Point]) -> usize {
    let key = |point: &Point| (point.family, point.cell_nodes, point.elements, point.formulation);
    let kept = |fresh: &Point| recorded.iter().find(|kept| key(kept) == key(fresh));
    fresh.iter().filter(|fresh| !kept(fresh).is_some_and(|kept| is_same(kept, fresh))).count()
}

fn near(a: f64, b: f64) -> bool {
    (a.is_nan() && b.is_nan()) || (a - b).abs() <= DIGITS * a.abs().max(b.abs()) + 1e-9
}

fn is_same(kept: &Point, fresh: &Point) -> bool {
    let pairs = [
        (kept.sparse_operations, fresh.sparse_operations),
        (kept.dense_operations, fresh.dense_operations),
        (kept.iterations, fresh.iterations),
        (kept.peak, fresh.peak),
        (kept.peak_worst, fresh.peak_worst),
        (kept.half_width, fresh.half_width),
        (kept.half_width_worst, fresh.half_width_worst),
        (kept.l2, fresh.l2),
        (kept.l2_worst, fresh.l2_worst),
    ];
    kept.dofs == fresh.dofs && kept.converged == fresh.converged && pairs.into_iter().all(|(a, b)| near(a, b))
}

fn digits_as_recorded(Redone { recorded, fresh }: &Redone) -> Judged {
    let quantity = Quantity::at(
        "mesh whose errors or degrees of freedom are not those recorded with the cost of its digits",
        format!("of {}", fresh.len()),
    );
    let because = format!("the smaller meshes are solved again; errors within {DIGITS:e}; `timings` renews the record");
    let check = Check::at_most(quantity, Reference::own("snapshots/timings", 0.0), because);
    if recorded.is_empty() {
        let why = "no digits are part of this record: `cargo run --release -- timings` renews it";
        let kept = Reference::own("snapshots/timings", 0.0);
        return Judged {
            reference: kept,
            ..check.not_run(ReferenceKind::SelfConsistency, "snapshots/timings", why.into())
        };
    }
    let kept: Vec<_> = Redone::kept(recorded).collect();
    let complete = recorded.len() == digits::MESHES.len() && fresh.len() == kept.len();
    let moved = kept.into_iter().zip(fresh).filter(|(kept, fresh)| !has_same_digits(kept, fresh)).count();
    check.judge(if complete { moved as f64 } else { f64::NAN })
}

fn has_same_digits(kept: &Reached, fresh: &Reached) -> bool {
    let errors = |one: &Reached| [one.peak, one.peak_worst, one.half_width, one.half_width_worst];
    let mut pairs = errors(kept).into_iter().zip(errors(fresh));
    kept.cells == fresh.cells && kept.dofs == fresh.dofs && pairs.all(|(a, b)| near(a, b))
}

fn counts_as_recorded(Recounted { recorded, fresh }: &Recounted) -> Judged {
    let complete = !fresh.is_empty() && recorded.growth.len() == growth::MESHES.len();
    let moved = Recounted::kept(recorded).zip(fresh).filter(|(kept, fresh)| kept != fresh).count();
    let quantity = Quantity::at(
        "mesh whose degrees of freedom, iterations or operations are not those recorded with its seconds",
        format!("of {}", fresh.len()),
    );
    Check::at_most(quantity, Reference::own("snapshots/timings", 0.0), "exact counts; `timings` renews the record")
        .judge(if complete { moved as f64 } else { f64::NAN })
}
