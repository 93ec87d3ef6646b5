//! Shares of runs that converge.

use crate::study::class::Class;
use crate::study::converged::run::Record;

/// Share of some runs that converge; none of no runs.
pub fn share<'a>(runs: impl Iterator<Item = &'a Record>) -> Option<f64> {
    let (mut all, mut converged) = (0.0, 0.0);
    for record in runs {
        all += 1.0;
        converged += f64::from(u8::from(record.class == Class::Converged));
    }
    (all > 0.0).then(|| converged / all)
}

/// Whether two numbers of the plan are the same one.
pub fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits()
}
