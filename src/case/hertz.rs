//! Errors of a run against Hertz.

use crate::measure::profile;
use crate::oracle::analytic::hertz::Hertz;
use crate::solve::Run;

/// Relative errors of p₀, of a, and L2(p) over one and a half half-widths; NaN where the run did not converge.
pub fn errors(run: &Run, exact: &Hertz) -> [f64; 3] {
    if !run.solution.converged() {
        return [f64::NAN; 3];
    }
    let away = |value: f64, reference: f64| (value - reference).abs() / reference;
    let measures = run.measures();
    [
        away(measures.peak.pressure, exact.peak_pressure()),
        away(measures.second_moment_width, exact.half_width()),
        profile::relative_l2(&run.solution.points, |x| exact.pressure(x), 1.5 * exact.half_width()),
    ]
}
