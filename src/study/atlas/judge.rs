//! What the atlas must hold: a twentieth recomputed is what was recorded, and the predictions are right.

use rayon::prelude::*;

use crate::case::{Judged, Reference};
use crate::error::Error;
use crate::measure::larger;
use crate::solve::Settings;
use crate::study::atlas::chart::Chart;
use crate::study::atlas::plan::{Plane, Row};
use crate::study::atlas::point::{Ground, Site, share_ground};
use crate::study::atlas::record::{self, Class, RIGHT, Record};
use crate::study::atlas::survey::sites;
use crate::study::unsorted::{Finding, Trial};

/// Name of the trials.
pub const ATLAS: &str = "stability atlas";
/// Of the meshes of the full planes every third is entered again, and on it three of twenty points; of the slices every mesh,
/// and one of twenty points.
const FULL: [usize; 2] = [3, 3];
const SLICES: [usize; 2] = [1, 1];
const OF: usize = 20;
/// A recomputed error or prediction may differ by this share: the records hold four digits.
const DIGITS: f64 = 2e-3;
/// Factor within which steps on nodes are predicted, and factor off the limit of steps from which a class is.
pub const FACTOR: f64 = 2.5;
/// Fewer steps than this are over before a rate matters.
const FEW: usize = 20;
/// A rule whose instability sits in the point nearest the centre: where that point's whole gap is below the tolerance, it may
/// swing unseen.
const UNSEEN: &str = "constant.secant";

/// One trial a plane.
pub fn trials() -> Vec<Trial> {
    let each = |plane: Plane| Trial::new(ATLAS, plane.name(), move || judge(plane));
    Plane::ALL.into_iter().map(each).collect()
}

fn judge(plane: Plane) -> Result<Finding, Error> {
    let chart = Chart::of(plane, &record::read(plane)?);
    let mut checks = vec![recomputed(&chart)?];
    checks.extend(predicted(&chart));
    checks.extend(halved(&chart));
    checks.push(honest(&chart));
    Ok(Finding { checks, ..Default::default() })
}

/// The fixed twentieth once more: row and column of each point.
fn recomputed(chart: &Chart) -> Result<Judged, Error> {
    let rows = chart.plane.rows();
    let stiffnesses = chart.plane.stiffnesses();
    let [every, points] = if [Plane::Stretch, Plane::Mesh].contains(&chart.plane) { FULL } else { SLICES };
    let chosen = |row: usize, column: usize| (7 * row + 3 * column) % OF < points;
    let entered = sites(&[chart.plane]).into_iter().step_by(every);
    let entered: Vec<(Row, Vec<Row>)> = entered.map(|grounds| (grounds[0][0], grounds.concat())).collect();
    let moved = entered.par_iter().map(|(first, all)| -> Result<[usize; 2], Error> {
        let (site, mut count) = (Site::of(first)?, [0, 0]);
        let mut ground: Option<(Row, Ground)> = None;
        for row in all {
            if ground.as_ref().is_none_or(|(other, _)| !share_ground(other, row)) {
                ground = Some((*row, Ground::of(&site, row)?));
            }
            let Some((_, ground)) = &ground else { continue };
            let r = rows.iter().position(|other| other == row).unwrap_or(0);
            for (c, &stiffness) in stiffnesses.iter().enumerate().filter(|(c, _)| chosen(r, *c)) {
                let fresh = ground.record(row, stiffness)?;
                count[0] += 1;
                count[1] += usize::from(!is_as_recorded(chart, r, c, &fresh));
            }
        }
        Ok(count)
    });
    let counts: Vec<[usize; 2]> = moved.collect::<Result<_, _>>()?;
    let [points, moved] = [0, 1].map(|k| counts.iter().map(|count| count[k]).sum::<usize>());
    let moved = if points == 0 { f64::NAN } else { moved as f64 };
    Ok(Judged::at_most(
        "A recomputed twentieth of the stability atlas shall be what was recorded",
        format!("points that moved, of {points}"),
        moved,
        Reference::own("snapshots/atlas", 0.0),
        "classes near a boundary, steps, errors and predictions elsewhere; `atlas` renews the record",
    ))
}

/// Whether a fresh point is the recorded one: class and predictions always, what was measured where no boundary is near.
pub fn is_as_recorded(chart: &Chart, row: usize, column: usize, fresh: &Record) -> bool {
    let kept = &chart.rows[row][column];
    let near = |a: f64, b: f64| a.is_finite() && b.is_finite() && (a - b).abs() <= DIGITS * a.abs().max(b.abs());
    let alike = |a: f64, b: f64| (a.is_nan() && b.is_nan()) || a == b || near(a, b);
    let predictions =
        alike(kept.predicted_rate, fresh.predicted_rate) && alike(kept.predicted_steps, fresh.predicted_steps);
    let measured = alike(kept.error, fresh.error)
        && alike(kept.penalty, fresh.penalty)
        && alike(kept.iteration_error, fresh.iteration_error)
        && alike(kept.rate, fresh.rate);
    let exact = kept.class == Class::Converged && !chart.is_near_a_boundary(row, column);
    kept.class == fresh.class && predictions && (!exact || (kept.steps == fresh.steps && measured))
}

/// Whether a record's rule has a prediction of steps by rates.
pub fn is_predicted(record: &Record) -> bool {
    !record.predicted_steps.is_nan() && !record.formulation.contains("kinematic")
}

/// Three predictions: what fails, what converges, and in how many steps.
fn predicted(chart: &Chart) -> Vec<Judged> {
    let limit = Settings::default().max_steps as f64;
    let records = || chart.rows.iter().flatten().filter(|r| is_predicted(r) && !r.formulation.contains(UNSEEN));
    let failing: Vec<&Record> = records().filter(|r| r.predicted_steps > FACTOR * limit).collect();
    let on_nodes = || records().filter(|r| r.formulation.starts_with("node"));
    let ending = |r: &&Record| r.predicted_steps * FACTOR <= limit && !r.formulation.ends_with("varying.correction");
    let ending: Vec<&Record> = on_nodes().filter(ending).collect();
    let ratios: Vec<f64> = on_nodes().filter(|r| is_long(r)).map(ratio).collect();
    // Planes with nodes and one increment hold something of each kind: nothing of it is a fault.
    let expected = [Plane::Stretch, Plane::Mesh, Plane::Cylinder, Plane::PinRod].contains(&chart.plane);
    let count = |wrong: usize, all: usize| if all == 0 { f64::NAN } else { wrong as f64 };
    let mut checks = Vec::new();
    if expected || !failing.is_empty() {
        checks.push(Judged::at_most(
            "Where the condensed matrices predict failure, no run shall converge",
            format!("converged, of {} predicted to fail", failing.len()),
            count(failing.iter().filter(|r| r.class == Class::Converged).count(), failing.len()),
            Reference::own("predicted", 0.0),
            format!("spectral radius above 1, or more than {FACTOR} times the limit of steps; `secant` with constant stiffness is reported"),
        ));
    }
    if expected || !ending.is_empty() {
        checks.push(Judged::at_most(
            "On nodes every run that is predicted to converge shall",
            format!("not converged, of {} predicted to", ending.len()),
            count(ending.iter().filter(|r| r.class != Class::Converged).count(), ending.len()),
            Reference::own("predicted", 0.0),
            format!("less than the limit of steps over {FACTOR}; varying stiffness with correction is attracted from nearby only"),
        ));
    }
    if expected || !ratios.is_empty() {
        checks.push(Judged::at_most(
            format!("On nodes the steps shall be predicted within a factor of {FACTOR}"),
            format!("largest factor between predicted and measured steps, {} points", ratios.len()),
            worst(&ratios),
            Reference::own("factor", FACTOR),
            "constant stiffness linearised on the final contact set, or its gaps worked off; varying stiffness by its points near the edge, each alone: on fine meshes their neighbours help",
        ));
    }
    checks
}

/// A converged run long enough to be judged.
pub fn is_long(record: &Record) -> bool {
    record.class == Class::Converged && record.steps >= FEW && record.predicted_steps.is_finite()
}

/// Measured over predicted steps or the inverse, whichever is above 1.
pub fn ratio(record: &Record) -> f64 {
    let ratio = record.steps as f64 / record.predicted_steps;
    ratio.max(1.0 / ratio)
}

/// Kinematic load on nodes against the halving law, on the Hertz scenes.
fn halved(chart: &Chart) -> Option<Judged> {
    let hertz = [Plane::Stretch, Plane::Mesh, Plane::Cylinder].contains(&chart.plane);
    let switching = chart.of_formulation("node.kinematic.switching").flatten();
    let off: Vec<f64> = switching.map(steps_off).collect();
    hertz.then(|| {
        Judged::at_most(
            "On nodes kinematic load shall take the steps of the halving law at every start",
            "steps off",
            worst(&off),
            Reference::own("halving of L² − a²", 1.0),
            "the law counts halvings; the last one may end anywhere within a node spacing",
        )
    })
}

/// Steps between measured and predicted; NaN where a run did not converge.
pub fn steps_off(record: &Record) -> f64 {
    let steps = if record.class == Class::Converged { record.steps as f64 } else { f64::NAN };
    (steps - record.predicted_steps).abs()
}

/// No run shall be called converged with a peak or a width that is not that of its discrete problem.
fn honest(chart: &Chart) -> Judged {
    let converged = chart.rows.iter().flatten().filter(|r| r.class == Class::Converged);
    let errors: Vec<f64> = converged.map(|r| r.error).collect();
    Judged::at_most(
        "No run shall be called converged with a peak or a half-width that is not its discrete problem's",
        format!("largest error of p₀ and a, {} converged runs", errors.len()),
        worst(&errors),
        Reference::own("active set", RIGHT),
        "three times the tolerance: it bounds norms of pressure, width and approach, not these two numbers",
    )
}

/// The largest; NaN where any is or there is none.
fn worst(values: &[f64]) -> f64 {
    values.iter().copied().reduce(larger).unwrap_or(f64::NAN)
}
