//! What was asked of the speed, and what was measured.

use crate::error::Error;
use crate::markdown::significant;
use crate::mesh::Order;
use crate::solve::{Element, Iteration};
use crate::study::pairing::Pairing;
use crate::study::timings::code::Code;
use crate::study::timings::digits;
use crate::study::timings::growth::{Growth, LARGE};
use crate::study::timings::others::{OtherPoint, Peer};
use crate::study::timings::precision::{self, Family, Laps, Point, TOLERANCE};
use crate::study::timings::record::{Beside, Record};
use crate::study::timings::statistics::exponent;

/// One row.
#[derive(Clone, Debug)]
pub struct Target {
    /// What is measured.
    pub what: String,
    /// What was asked for.
    pub asked: String,
    /// What came out, with its spread where it is a ratio of repeated runs.
    pub measured: String,
    /// Whether it is met; none where it could not be measured.
    pub met: Option<bool>,
}

/// Degrees of freedom for which the ratios are asked.
const SIZES: [f64; 3] = [1e4, 1e5, 1e6];
/// Contact solve over plain solve.
const CONTACT: f64 = 1.1;
/// Errors, and what meshes fitted to the contact may take over 8-node ones that have it.
const WITH_DIGITS: [(f64, f64); 2] = [(1e-4, 1.0), (1e-5, 0.25)];
/// An error for which 8-node cells are too many, and what a fitted mesh may take over the plain solve of the smallest size.
const SIXTH: f64 = 1e-6;
const PLAIN_SOLVES: f64 = 30.0;
/// Error of p₀ and a to which codes are compared.
pub const COMPARED: f64 = 1e-3;
/// The formulation that is compared with other codes.
pub const FASTEST: Pairing = Pairing { element: Element::Node, algorithm: Iteration::Kinematic };
/// How often our own solve is measured before and after each code's.
const REPEATS: usize = 10;

/// All rows.
pub fn targets(record: &Record) -> Vec<Target> {
    let growth = &record.measured.growth;
    let near = |dofs: f64| {
        let apart = |n: usize| (n as f64 / dofs).ln().abs();
        growth.iter().min_by(|a, b| apart(a.counts.dofs).total_cmp(&apart(b.counts.dofs)))
    };
    let mut all = Vec::new();
    for one in SIZES.into_iter().filter_map(near) {
        let n = one.counts.dofs;
        all.push(contact(one));
        all.push(at_most(format!("assembly ÷ plain solve, {n} dofs, one thread"), 0.25, one.assembly_ratio[0].median));
        all.push(at_most(format!("the same on all threads, {n} dofs"), 0.25, one.assembly_ratio[1].median));
        all.push(at_most(format!("one more solve ÷ the first, {n} dofs"), 0.02, one.again_ratio.median));
    }
    for nine in &record.measured.nine {
        let mesh = format!("{} dofs, {} retained", nine.counts.dofs, nine.counts.retained);
        for (threads, k) in [("one thread", 0), ("all threads", 1)] {
            let what = format!("all nine formulations ÷ one, {mesh}, {threads}");
            all.push(at_most(what, 2.0, nine.all[k].median));
        }
        let without =
            format!("the same without varying stiffness and its {} iterations, one thread", nine.varying_iterations);
        all.push(at_most(without, 2.0, nine.without_varying[0].median));
    }
    let whole: Vec<[f64; 2]> = (growth.iter())
        .filter(|one| one.counts.dofs as f64 >= LARGE)
        .map(|one| [one.counts.dofs as f64, one.stages.values().map(|stage| stage.median).sum()])
        .collect();
    let ends = whole.first().zip(whole.last()).map_or([f64::NAN; 2], |(first, last)| [first[0], last[0]]);
    let what = format!("exponent of the whole time, {} to {} dofs", ends[0], ends[1]);
    all.push(at_most(what, 1.25, exponent(&whole)));
    all.push(steepness(growth));
    for one in growth.iter().filter(|one| one.counts.dofs as f64 >= 0.7 * SIZES[1]) {
        let what = format!("peak memory ÷ bytes of the factor, {} dofs", one.counts.dofs);
        all.push(match one.memory_ratio {
            Some(ratio) => at_most(what, 2.0, ratio),
            None => absent(what, "≤ 2".into()),
        });
    }
    all.extend(Code::ALL.into_iter().zip([20.0, 10.0, 1.0]).map(|(code, asked)| to_accuracy(record, code, asked)));
    all.extend(Peer::ALL.into_iter().zip([10.0, 50.0]).map(|(code, asked)| peer(record, code, asked)));
    all.extend(WITH_DIGITS.map(|(error, limit)| fitted(record, error, limit)));
    all.push(sixth_digit(record, near(SIZES[0])));
    all.push(at_most("whole report from nothing [s]".into(), 60.0, record.measured.report));
    all
}

/// The contact solve over the plain one, with what three of four runs stay below.
fn contact(one: &Growth) -> Target {
    let what = format!("contact solve ÷ plain solve, {} dofs", one.counts.dofs);
    let quartile = match one.ratio_quartile {
        Some(quartile) => format!("upper quartile {quartile:.3}"),
        None => format!("upper quartile not recorded, at most {:.3}", one.ratio.most),
    };
    let measured = format!("{:.3}, {quartile}", one.ratio.median);
    Target { measured, ..at_most(what, CONTACT, one.ratio.median) }
}

/// The exponent of the contact solve against that of the plain one in the same run.
fn steepness(growth: &[Growth]) -> Target {
    let large = || growth.iter().filter(|one| one.counts.dofs as f64 >= LARGE);
    let power = |seconds: fn(&Growth) -> f64| {
        exponent(&large().map(|one| [one.counts.dofs as f64, seconds(one)]).collect::<Vec<_>>())
    };
    let [least, most] = [large().next(), large().next_back()].map(|one| one.map_or(0, |one| one.counts.dofs));
    let what = format!("exponent of the contact solve, {least} to {most} dofs");
    let [own, plain] = [power(|one| one.contact.median), power(|one| one.plain.median)];
    Target { asked: format!("≤ {plain:.3}, the plain solve's"), ..at_most(what, plain, own) }
}

/// Meshes fitted to the contact against 8-node ones at the same error.
fn fitted(record: &Record, error: f64, limit: f64) -> Target {
    let what = format!("time to {error:e} in p₀ and a under the worst load, truncated Hertz: fitted ÷ 8-node");
    let reached = &record.measured.digits;
    match (digits::fitted(reached, error), digits::quadratic(reached, error)) {
        _ if reached.is_empty() => unrecorded(what, limit),
        (Some(fitted), Some(quadratic)) => {
            let ratio = fitted.seconds.median / quadratic;
            let [own, other] = [fitted.seconds.median, quadratic].map(|seconds| significant(1e3 * seconds, 3));
            Target { measured: format!("{ratio:.3} ({own} ms against {other} ms)"), ..at_most(what, limit, ratio) }
        }
        (Some(_), None) => {
            Target { measured: "no 8-node mesh that was timed".into(), ..at_most(what, limit, f64::NAN) }
        }
        (None, _) => Target { measured: "no fitted mesh that was timed".into(), ..at_most(what, limit, f64::NAN) },
    }
}

/// Six digits in units of a plain solve.
fn sixth_digit(record: &Record, plain: Option<&Growth>) -> Target {
    let dofs = plain.map_or(0, |one| one.counts.dofs);
    let what = format!(
        "time to {SIXTH:e} in p₀ and a under the worst load, truncated Hertz: fitted ÷ plain solve of {dofs} dofs"
    );
    let reached = &record.measured.digits;
    if reached.is_empty() {
        return unrecorded(what, PLAIN_SOLVES);
    }
    let seconds = digits::fitted(reached, SIXTH).map_or(f64::NAN, |one| one.seconds.median);
    at_most(what, PLAIN_SOLVES, seconds / plain.map_or(f64::NAN, |one| one.plain.median))
}

/// Our cheapest mesh within the compared accuracy: node elements with kinematic load on truncated Hertz.
pub fn cheapest(points: &[Point]) -> Option<&Point> {
    let enough =
        |point: &&Point| point.family != Family::Cylinder && point.formulation == FASTEST && point.error() <= COMPARED;
    points.iter().filter(enough).min_by(|a, b| a.seconds.total_cmp(&b.seconds))
}

/// Seconds by stage of that solve as they are now, several times under each load.
pub fn cheapest_laps(points: &[Point]) -> Result<Vec<Laps>, Error> {
    let message = || format!("no mesh of truncated Hertz keeps {} %", 100.0 * COMPARED);
    let none = || Error::at("timings", message(), "measure finer meshes");
    let point = cheapest(points).ok_or_else(none)?;
    let order = if point.cell_nodes == 4 { Order::Linear } else { Order::Quadratic };
    let formulation = FASTEST.formulation().tolerance(TOLERANCE);
    let mut laps = Vec::new();
    for _ in 0..REPEATS {
        laps.extend(precision::laps(point.family, order, point.elements, &formulation)?);
    }
    Ok(laps)
}

/// The cheapest solve of another code within that accuracy.
pub fn theirs(record: &Record, code: Code) -> Option<&OtherPoint> {
    let enough = |point: &&OtherPoint| point.code == code && point.peak.max(point.half_width) <= COMPARED;
    record.measured.others.iter().filter(enough).min_by(|a, b| a.seconds.total_cmp(&b.seconds))
}

fn to_accuracy(record: &Record, code: Code, asked: f64) -> Target {
    let what = format!("time to {} % in p₀ and a, truncated Hertz: {code} ÷ ours", 100.0 * COMPARED);
    let beside = record.measured.beside.iter().find(|beside| beside.code == code);
    match (theirs(record, code), beside, cheapest(&record.points)) {
        (Some(theirs), Some(Beside { seconds: ours, .. }), Some(own)) => {
            let ratio = theirs.seconds / ours.median;
            let measured = format!(
                "{ratio:.1} ({:.1} ms with {} dofs against {:.2} ms with {})",
                1e3 * theirs.seconds,
                theirs.dofs,
                1e3 * ours.median,
                own.dofs
            );
            Target { measured, ..at_least(what, asked, ratio) }
        }
        _ if record.measured.of(code).next().is_some() => {
            let measured = format!("{code} on none of its meshes");
            Target { measured, ..at_least(what, asked, f64::NAN) }
        }
        _ => Target { measured: record.measured.why_not(code), ..absent(what, format!("≥ {asked}")) },
    }
}

fn peer(record: &Record, code: Peer, asked: f64) -> Target {
    let what = format!("contact solve of the same cylinder mesh: {} ÷ ours", code.name());
    let ratios: Vec<f64> = (record.measured.peers.iter())
        .filter(|point| point.code == code)
        .map(|point| point.seconds.median / point.ours.median)
        .collect();
    let told: Vec<String> = ratios.iter().map(|ratio| format!("{ratio:.0}")).collect();
    match ratios.iter().copied().reduce(|a, b| if a.is_nan() || a < b { a } else { b }) {
        Some(least) => {
            Target { measured: format!("{} on {} meshes", told.join(", "), told.len()), ..at_least(what, asked, least) }
        }
        None => absent(what, format!("≥ {asked}")),
    }
}

fn at_most(what: String, limit: f64, value: f64) -> Target {
    Target { what, asked: format!("≤ {limit}"), measured: format!("{value:.3}"), met: Some(value <= limit) }
}

fn at_least(what: String, limit: f64, value: f64) -> Target {
    Target { what, asked: format!("≥ {limit}"), measured: format!("{value:.1}"), met: Some(value >= limit) }
}

fn absent(what: String, asked: String) -> Target {
    Target { what, asked, measured: "not installed where this was measured".into(), met: None }
}

fn unrecorded(what: String, limit: f64) -> Target {
    Target { what, asked: format!("≤ {limit}"), measured: "not part of this record".into(), met: None }
}
