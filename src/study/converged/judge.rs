//! What the record must hold: a twentieth run again is what was recorded, and what is called converged is right.

use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::study::class::Class;
use crate::study::converged::run::{Again, Numbers, ROUND_OFF, Record};

/// Error of a peak or a half-width that a run called converged may have, in tolerances: they are not what is iterated.
const SLACK: f64 = 3.0;
/// A recomputed error may differ by this share: the record holds four digits.
const DIGITS: f64 = 2e-3;

/// The checks.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    Ok(vec![as_recorded(&numbers.recorded, &numbers.again), right(&numbers.recorded)])
}

/// Whether the sites run again are what was recorded.
fn as_recorded(recorded: &[Record], again: &[Again]) -> Judged {
    let (mut runs, mut moved) = (0, 0);
    for Again { scene, stretch, fresh } in again {
        let is_own = |kept: &&Record| kept.scene == *scene && kept.stretch.to_bits() == stretch.to_bits();
        let kept: Vec<&Record> = recorded.iter().filter(is_own).collect();
        runs += fresh.len().max(kept.len());
        moved += fresh.iter().zip(&kept).filter(|(fresh, kept)| !is_as_recorded(kept, fresh)).count();
        moved += fresh.len().abs_diff(kept.len());
    }
    let quantity = Quantity::at("recomputed run that is not the recorded one", format!("of {runs}"));
    let record = Reference::own("snapshots/converged.csv", 0.0);
    Check::at_most(quantity, record, "outcome, iterations and error; `converged` renews the record")
        .judge(if runs == 0 { f64::NAN } else { moved as f64 })
}

/// Whether a fresh run is the recorded one: outcome and iterations always, the error where it is above round-off.
pub fn is_as_recorded(kept: &Record, fresh: &Record) -> bool {
    let key = |record: &Record| (record.formulation, record.load.to_bits(), record.tolerance.to_bits());
    let [a, b] = [kept.error, fresh.error];
    let alike =
        (a.is_nan() && b.is_nan()) || (a - b).abs() <= DIGITS * a.abs().max(b.abs()) + ROUND_OFF * kept.tolerance;
    key(kept) == key(fresh) && kept.class == fresh.class && kept.iterations == fresh.iterations && alike
}

/// Nothing is called converged that is not.
pub fn right(recorded: &[Record]) -> Judged {
    let converged: Vec<&Record> = recorded.iter().filter(|record| record.class == Class::Converged).collect();
    let right = converged.iter().filter(|record| record.error <= SLACK * record.tolerance).count();
    let wrong = converged.len() - right;
    let quantity = Quantity::at(
        format!(
            "run called converged with a peak or a half-width off its discrete solution by more than {SLACK} tolerances"
        ),
        format!("of {} converged, {} runs in all", converged.len(), recorded.len()),
    );
    let because = "relative to that solution, contact by contact";
    Check::at_most(quantity, Reference::own("active set", 0.0), because).judge(if converged.is_empty() {
        f64::NAN
    } else {
        wrong as f64
    })
}
