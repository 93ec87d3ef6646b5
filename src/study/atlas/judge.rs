//! What the atlas must hold: a twentieth recomputed is what was recorded, the predictions are right, and what the program takes
//! converges.

use std::borrow::Cow;

use crate::algorithm::StiffnessRule;
use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::measure::larger;
use crate::solve::{Element, Ended, Iteration, Settings};
use crate::stability::halving::SOFT;
use crate::study::atlas::plane::Plane;
use crate::study::atlas::record::{Chart, RIGHT, Record};
use crate::study::atlas::run::{Numbers, Saved};
use crate::study::method::Method;

/// Factor within which iterations on nodes are predicted, and factor off the limit of iterations from which a class is.
pub(super) const FACTOR: f64 = 2.5;
/// Iterations within which the halving law is met.
pub(super) const HALVINGS: f64 = 1.0;
/// Fewer iterations than this are over before a rate matters.
const FEW: usize = 20;

/// The checks of a trial.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    Ok(match numbers {
        Numbers::Surveyed { chart, recomputed, moved } => {
            let mut judged = vec![as_recorded(*recomputed, *moved)];
            judged.extend(predicted(chart));
            judged.extend(halved(chart));
            judged.extend(averaged(chart));
            judged.push(honest(chart));
            judged
        }
        Numbers::Saved(scene, saved) => taken(scene.name(), saved),
    })
}

/// Whether a run converged.
fn converged(record: &Record) -> bool {
    record.class == Ended::Converged
}

/// A converged run long enough to be judged by a prediction.
fn is_long(record: &Record) -> bool {
    converged(record) && record.iterations >= FEW && record.predicted_iterations.is_some_and(f64::is_finite)
}

/// Measured over predicted iterations or the inverse, whichever is above 1.
fn ratio(record: &Record) -> f64 {
    let ratio = record.iterations as f64 / record.predicted_iterations.unwrap_or(f64::NAN);
    ratio.max(1.0 / ratio)
}

/// Iterations between measured and predicted; NaN where a run did not converge.
fn iterations_off(record: &Record) -> f64 {
    let iterations = if converged(record) { record.iterations as f64 } else { f64::NAN };
    (iterations - record.predicted_iterations.unwrap_or(f64::NAN)).abs()
}

/// Whether a run is predicted to fail: far more iterations than the limit.
fn shall_fail(record: &Record) -> bool {
    record.predicted_iterations.is_some_and(|predicted| predicted > FACTOR * Settings::default().max_iterations as f64)
}

/// Whether it is predicted to converge: far fewer.
fn shall_converge(record: &Record) -> bool {
    record.predicted_iterations.is_some_and(|predicted| predicted * FACTOR <= Settings::default().max_iterations as f64)
}

/// Of a method how many runs converged of those predicted to fail, failed of those predicted to converge, and took iterations off by more
/// than [`FACTOR`], or under kinematic load by more than [`HALVINGS`], each with of how many; none where nothing is predicted.
pub(super) fn agreement(charts: &[&Chart], method: Method) -> Option<[[usize; 2]; 3]> {
    let all: Vec<&Record> = charts.iter().flat_map(|chart| chart.of_method(method)).flatten().collect();
    let share = |of: fn(&Record) -> bool, counted: fn(&Record) -> bool| {
        let of: Vec<&&Record> = all.iter().filter(|record| of(record)).collect();
        [of.iter().filter(|record| counted(record)).count(), of.len()]
    };
    // A run that does not converge is no number of iterations off: it is counted as failed.
    let off = match method.algorithm {
        Iteration::Kinematic => share(|r| r.predicted_iterations.is_some(), |r| iterations_off(r) > HALVINGS),
        _ => share(is_long, |r| ratio(r) > FACTOR),
    };
    let is_predicted = all.iter().any(|record| record.predicted_iterations.is_some());
    is_predicted.then(|| [share(shall_fail, converged), share(shall_converge, |r| !converged(r)), off])
}

/// The largest; NaN where any is or there is none.
fn worst(values: impl Iterator<Item = f64>) -> f64 {
    values.reduce(larger).unwrap_or(f64::NAN)
}

/// That none of some is wrong; of nothing nothing is known.
fn none(what: &'static str, at: String, because: impl Into<Cow<'static, str>>, wrong: usize, of: usize) -> Judged {
    Check::none(Quantity::at(what, at), because).judge(if of == 0 { f64::NAN } else { wrong as f64 })
}

fn as_recorded(recomputed: usize, moved: usize) -> Judged {
    let what = "point of a recomputed twentieth that is not what was recorded";
    let because = "classes near a boundary, iterations, errors and predictions elsewhere; `atlas` renews the record";
    none(what, format!("of {recomputed}"), because, moved, recomputed)
}

/// Three predictions that are made of a rate: what fails, what converges, and in how many iterations.
fn predicted(chart: &Chart) -> Vec<Judged> {
    let is = |r: &Record, algorithm, rule| (r.method.algorithm, r.method.rule) == (algorithm, rule);
    // The instability of constant stiffness with secant sits in the point nearest the centre: where that point's whole gap is below the
    // tolerance, it may swing unseen by the error. Varying stiffness with correction does not go to its limit from afar.
    let is_unseen = |r: &Record| is(r, Iteration::Constant, StiffnessRule::Secant);
    let is_attracted_nearby = |r: &Record| is(r, Iteration::Varying, StiffnessRule::Correction);
    let records = || {
        let all = chart.rows.iter().flatten();
        all.filter(|r| r.method.algorithm != Iteration::Kinematic && !is_unseen(r))
    };
    let on_nodes = || records().filter(|r| r.method.element == Element::Node);
    let failing: Vec<&Record> = records().filter(|r| shall_fail(r)).collect();
    let ending: Vec<&Record> = on_nodes().filter(|r| shall_converge(r) && !is_attracted_nearby(r)).collect();
    let ratios: Vec<f64> = on_nodes().filter(|r| is_long(r)).map(ratio).collect();
    let never_converge = none(
        "run that converges where the condensed matrices predict failure",
        format!("of {} predicted to fail", failing.len()),
        format!(
            "spectral radius above 1, or more than {FACTOR} times the limit of iterations; `secant` with constant stiffness is reported"
        ),
        failing.iter().filter(|r| converged(r)).count(),
        failing.len(),
    );
    let always_converge = none(
        "run on nodes that fails where it is predicted to converge",
        format!("of {} predicted to converge", ending.len()),
        format!(
            "less than the limit of iterations over {FACTOR}; varying stiffness with correction is attracted from nearby only"
        ),
        ending.iter().filter(|r| !converged(r)).count(),
        ending.len(),
    );
    let in_iterations = Check::at_most(
        Quantity::at(
            "largest factor between predicted and measured iterations on nodes",
            format!("{} points", ratios.len()),
        ),
        Reference::own("factor accepted", FACTOR),
        "constant stiffness linearised on the final active set, or its gaps worked off; varying stiffness by its points near the edge, each alone: on fine meshes their neighbours help",
    );
    let in_iterations = in_iterations.judge(worst(ratios.iter().copied()));
    let all = [(failing.len(), never_converge), (ending.len(), always_converge), (ratios.len(), in_iterations)];
    // Planes with nodes and one increment hold something of each kind: nothing of it is a fault.
    let asked = all.into_iter().filter(|(of, _)| !chart.plane.is_slice() || *of > 0);
    asked.map(|(_, judged)| judged).collect()
}

/// Kinematic load on nodes against the halving law, on the Hertz scenes; soft starts not where their threshold was taken.
fn halved(chart: &Chart) -> Option<Judged> {
    let (which, least) = match chart.plane {
        Plane::Cylinder => ("any start", 0.0),
        Plane::Stretch | Plane::Mesh => ("starts that are not soft", SOFT),
        _ => return None,
    };
    let switching = chart.of_method(Method::usual(Element::Node, Iteration::Kinematic)).flatten();
    let check = Check::at_most(
        Quantity::at("largest number of iterations off the halving law on nodes under kinematic load", which),
        Reference::own("halving of L² − a²", HALVINGS),
        "the law counts halvings; the last one may end anywhere within a node spacing",
    );
    Some(check.judge(worst(switching.filter(|r| r.stiffness >= least).map(iterations_off))))
}

/// Constant stiffness with correction, by itself: whatever the scene and the start, it neither diverges nor cycles.
fn averaged(chart: &Chart) -> Option<Judged> {
    let plain = Element::ALL.map(|element| Method::usual(element, Iteration::Constant));
    let own: Vec<&Record> = chart.rows.iter().flatten().filter(|r| plain.contains(&r.method)).collect();
    let wrong = own.iter().filter(|r| [Ended::Diverged, Ended::Cycling].contains(&r.class)).count();
    let what = "run of constant stiffness with correction that diverges or cycles";
    let because =
        "predicted before any contact is solved: an averaged map comes no farther from its limit at any iteration";
    (!own.is_empty()).then(|| none(what, format!("of {}", own.len()), because, wrong, own.len()))
}

/// No run shall be called converged with a peak or a width that is not that of its discrete problem.
fn honest(chart: &Chart) -> Judged {
    let errors: Vec<f64> = chart.rows.iter().flatten().filter(|r| converged(r)).map(|r| r.error).collect();
    let at = format!("{} converged runs", errors.len());
    Check::at_most(
        Quantity::at("largest error of p₀ and a of a converged run against its discrete problem", at),
        Reference::own("active set", RIGHT),
        "three times the tolerance: it bounds norms of pressure, width and approach, not these two numbers",
    )
    .judge(worst(errors.into_iter()))
}

/// What the program takes is right, and all nine converge.
fn taken(scene: &str, saved: &[Saved]) -> Vec<Judged> {
    let at = format!("{scene}, all nine as the program takes them");
    let right = Check::error(
        Quantity::at("error of p₀ and a of what converges, from any initial stiffness", at),
        Reference::own("the discrete solution", 0.0),
        RIGHT,
        "the iteration error bounds norms of pressure and width; a single number may be off by more, never by this much",
    );
    let converging = Check::none(
        Quantity::at("formulation that does not converge as the program takes it", scene),
        "acceleration, κ₀ and tolerance are chosen so that all nine do",
    );
    let failing = saved.iter().filter(|one| one.iterations[1].is_none()).count();
    vec![right.judge(worst(saved.iter().map(|one| one.error))), converging.judge(failing as f64)]
}
