//! What the atlas must hold: a twentieth recomputed is what was recorded, and the predictions are right.

use crate::algorithm::StiffnessRule;
use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::measure::larger;
use crate::solve::{Element, Iteration, Settings};
use crate::stability::halving::SOFT;
use crate::study::atlas::agreement::{
    FACTOR, HALVINGS, has_rate, is_attracted, is_long, is_seen, iterations_off, ratio,
};
use crate::study::atlas::chart::Chart;
use crate::study::atlas::plane::Plane;
use crate::study::atlas::record::{RIGHT, Record};
use crate::study::atlas::run::Numbers;
use crate::study::class::Class;
use crate::study::method::Method;

/// The checks of a plane.
pub fn judge(numbers: &Numbers) -> Result<Vec<Judged>, Error> {
    let mut judged = vec![recomputed(numbers)];
    judged.extend(predicted(&numbers.chart));
    judged.extend(halved(&numbers.chart));
    judged.extend(averaged(&numbers.chart));
    judged.push(honest(&numbers.chart));
    Ok(judged)
}

/// A share of nothing is not a number.
fn count(wrong: usize, of: usize) -> f64 {
    if of == 0 { f64::NAN } else { wrong as f64 }
}

fn recomputed(numbers: &Numbers) -> Judged {
    let Numbers { recomputed, moved, .. } = *numbers;
    let quantity =
        Quantity::at("point of a recomputed twentieth that is not what was recorded", format!("of {recomputed}"));
    Check::none(
        quantity,
        "classes near a boundary, iterations, errors and predictions elsewhere; `atlas` renews the record",
    )
    .judge(count(moved, recomputed))
}

/// Three predictions: what fails, what converges, and in how many iterations.
fn predicted(chart: &Chart) -> Vec<Judged> {
    let limit = Settings::default().max_iterations as f64;
    let records = || chart.rows.iter().flatten().filter(|r| has_rate(r) && is_seen(r.method));
    let on_nodes = || records().filter(|r| r.method.element == Element::Node);
    let failing: Vec<&Record> = records().filter(|r| r.predicted_iterations > FACTOR * limit).collect();
    let ending = |r: &&Record| r.predicted_iterations * FACTOR <= limit && is_attracted(r.method);
    let ending: Vec<&Record> = on_nodes().filter(ending).collect();
    let ratios: Vec<f64> = on_nodes().filter(|r| is_long(r)).map(ratio).collect();
    // Planes with nodes and one increment hold something of each kind: nothing of it is a fault.
    let expected = [Plane::Stretch, Plane::Mesh, Plane::Cylinder, Plane::PinRod].contains(&chart.plane);
    let asked = |of: usize, judged: Judged| (expected || of > 0).then_some(judged);
    [
        asked(failing.len(), never_converge(&failing)),
        asked(ending.len(), always_converge(&ending)),
        asked(ratios.len(), in_iterations(&ratios)),
    ]
    .into_iter()
    .flatten()
    .collect()
}

fn never_converge(failing: &[&Record]) -> Judged {
    let quantity = Quantity::at(
        "run that converges where the condensed matrices predict failure",
        format!("of {} predicted to fail", failing.len()),
    );
    let because = format!(
        "spectral radius above 1, or more than {FACTOR} times the limit of iterations; `secant` with constant stiffness is reported"
    );
    let converged = failing.iter().filter(|r| r.class == Class::Converged).count();
    Check::none(quantity, because).judge(count(converged, failing.len()))
}

fn always_converge(ending: &[&Record]) -> Judged {
    let quantity = Quantity::at(
        "run on nodes that fails where it is predicted to converge",
        format!("of {} predicted to converge", ending.len()),
    );
    let because = format!(
        "less than the limit of iterations over {FACTOR}; varying stiffness with correction is attracted from nearby only"
    );
    let failed = ending.iter().filter(|r| r.class != Class::Converged).count();
    Check::none(quantity, because).judge(count(failed, ending.len()))
}

fn in_iterations(ratios: &[f64]) -> Judged {
    Check::at_most(
        Quantity::at(
            "largest factor between predicted and measured iterations on nodes",
            format!("{} points", ratios.len()),
        ),
        Reference::own("factor accepted", FACTOR),
        "constant stiffness linearised on the final active set, or its gaps worked off; varying stiffness by its points near the edge, each alone: on fine meshes their neighbours help",
    )
    .judge(worst(ratios))
}

/// Kinematic load on nodes against the halving law, on the Hertz scenes; soft starts not where their threshold was taken.
fn halved(chart: &Chart) -> Option<Judged> {
    let (which, least) = match chart.plane {
        Plane::Cylinder => ("any start", 0.0),
        Plane::Stretch | Plane::Mesh => ("starts that are not soft", SOFT),
        _ => return None,
    };
    let switching = chart.of_method(Method::usual(Element::Node, Iteration::Kinematic)).flatten();
    let off: Vec<f64> = switching.filter(|r| r.stiffness >= least).map(iterations_off).collect();
    let check = Check::at_most(
        Quantity::at("largest number of iterations off the halving law on nodes under kinematic load", which),
        Reference::own("halving of L² − a²", HALVINGS),
        "the law counts halvings; the last one may end anywhere within a node spacing",
    );
    Some(check.judge(worst(&off)))
}

/// Constant stiffness with correction, by itself: whatever the scene and the start, it neither diverges nor cycles.
fn averaged(chart: &Chart) -> Option<Judged> {
    let plain = |r: &&Record| {
        let Method { algorithm, rule, .. } = r.method;
        (algorithm, rule) == (Iteration::Constant, StiffnessRule::Correction) && !r.method.is_accelerated()
    };
    let own: Vec<&Record> = chart.rows.iter().flatten().filter(plain).collect();
    let wrong = own.iter().filter(|r| [Class::Diverged, Class::Cycling].contains(&r.class)).count();
    let quantity =
        Quantity::at("run of constant stiffness with correction that diverges or cycles", format!("of {}", own.len()));
    let because =
        "predicted before any contact is solved: an averaged map comes no farther from its limit at any iteration";
    (!own.is_empty()).then(|| Check::none(quantity, because).judge(wrong as f64))
}

/// No run shall be called converged with a peak or a width that is not that of its discrete problem.
fn honest(chart: &Chart) -> Judged {
    let converged = chart.rows.iter().flatten().filter(|r| r.class == Class::Converged);
    let errors: Vec<f64> = converged.map(|r| r.error).collect();
    Check::at_most(
        Quantity::at(
            "largest error of p₀ and a of a converged run against its discrete problem",
            format!("{} converged runs", errors.len()),
        ),
        Reference::own("active set", RIGHT),
        "three times the tolerance: it bounds norms of pressure, width and approach, not these two numbers",
    )
    .judge(worst(&errors))
}

/// The largest; NaN where any is or there is none.
fn worst(values: &[f64]) -> f64 {
    values.iter().copied().reduce(larger).unwrap_or(f64::NAN)
}
