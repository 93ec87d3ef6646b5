//! Predictions against runs: what counts as predicted, and where the two part.

use crate::algorithm::StiffnessRule;
use crate::solve::{Iteration, Settings};
use crate::study::atlas::chart::Chart;
use crate::study::atlas::record::Record;
use crate::study::class::Class;
use crate::study::method::Method;

/// Factor within which iterations on nodes are predicted, and factor off the limit of iterations from which a class is.
pub const FACTOR: f64 = 2.5;
/// Iterations within which the halving law is met.
pub const HALVINGS: f64 = 1.0;
/// Fewer iterations than this are over before a rate matters.
const FEW: usize = 20;

/// Some of some.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Share {
    /// How many.
    pub count: usize,
    /// Of how many.
    pub of: usize,
}

/// Where the predictions of a method fail.
#[derive(Clone, Copy, Debug)]
pub struct Agreement {
    /// What was run.
    pub method: Method,
    /// Converged, of those predicted to fail.
    pub converged: Share,
    /// Failed, of those predicted to converge.
    pub failed: Share,
    /// Iterations off by more than [`FACTOR`], or under kinematic load by more than [`HALVINGS`].
    pub off: Share,
}

/// Whether a record's prediction of iterations is made of a rate; kinematic load has a law instead.
pub fn has_rate(record: &Record) -> bool {
    !record.predicted_iterations.is_nan() && record.method.algorithm != Iteration::Kinematic
}

/// Whether the error sees a method fail. The instability of constant stiffness with secant sits in the point nearest the
/// centre: where that point's whole gap is below the tolerance, it may swing unseen.
pub fn is_seen(method: Method) -> bool {
    (method.algorithm, method.rule) != (Iteration::Constant, StiffnessRule::Secant)
}

/// Whether a method goes to its limit from afar; varying stiffness with correction is attracted from nearby only.
pub fn is_attracted(method: Method) -> bool {
    (method.algorithm, method.rule) != (Iteration::Varying, StiffnessRule::Correction)
}

/// A converged run long enough to be judged.
pub fn is_long(record: &Record) -> bool {
    record.class == Class::Converged && record.iterations >= FEW && record.predicted_iterations.is_finite()
}

/// Measured over predicted iterations or the inverse, whichever is above 1.
pub fn ratio(record: &Record) -> f64 {
    let ratio = record.iterations as f64 / record.predicted_iterations;
    ratio.max(1.0 / ratio)
}

/// Iterations between measured and predicted; NaN where a run did not converge.
pub fn iterations_off(record: &Record) -> f64 {
    let iterations = if record.class == Class::Converged { record.iterations as f64 } else { f64::NAN };
    (iterations - record.predicted_iterations).abs()
}

/// Every method that has a prediction, over all charts.
pub fn agreements(charts: &[&Chart]) -> Vec<Agreement> {
    Method::all().into_iter().filter_map(|method| agreement(charts, method)).collect()
}

fn agreement(charts: &[&Chart], method: Method) -> Option<Agreement> {
    let limit = Settings::default().max_iterations as f64;
    let all: Vec<&Record> = charts.iter().flat_map(|chart| chart.of_method(method)).flatten().collect();
    let kinematic = method.algorithm == Iteration::Kinematic;
    // A run that does not converge is no number of iterations off: it is counted as failed.
    let is_counted = |r: &Record| if kinematic { !r.predicted_iterations.is_nan() } else { is_long(r) };
    let is_off = |r: &Record| if kinematic { iterations_off(r) > HALVINGS } else { ratio(r) > FACTOR };
    let share = |of: &dyn Fn(&Record) -> bool, counted: &dyn Fn(&Record) -> bool| {
        let of: Vec<&&Record> = all.iter().filter(|r| of(r)).collect();
        Share { count: of.iter().filter(|r| counted(r)).count(), of: of.len() }
    };
    all.iter().any(|r| !r.predicted_iterations.is_nan()).then(|| Agreement {
        method,
        converged: share(&|r| r.predicted_iterations > FACTOR * limit, &|r| r.class == Class::Converged),
        failed: share(&|r| r.predicted_iterations * FACTOR <= limit, &|r| r.class != Class::Converged),
        off: share(&is_counted, &is_off),
    })
}
