//! What was measured, as it is kept under `snapshots/timings`; what of it is cheapest for an error: the points that no
//! other beats, and the first within an error that is asked for; and what was asked of the speed, and what was
//! measured.

use std::collections::BTreeMap;
use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use crate::checkout::root;
use crate::clock::Stage;
use crate::error::Error;
use crate::oracle::cross_code::frozen::{read_json, write_json};
use crate::solve::{Element, Formulation, Iteration};
use crate::study::records;
use crate::study::seconds::{Machine, Spread};
use crate::study::target::Target;
use crate::study::timings::growth::{Growth, exponent};
use crate::study::timings::precision::{Point, Series, TOLERANCE, half_widths, solved};

/// What renews the records.
pub const RENEW: &str = "run `cargo run --release -- timings` and review the diff of snapshots/timings";
/// Where they are.
pub const FOLDER: &str = "snapshots/timings";

/// Everything but the points of the work–precision charts.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Measured {
    /// On what.
    pub machine: Machine,
    /// Mesh by mesh.
    pub growth: Vec<Growth>,
    /// The sphere, mesh by mesh.
    pub revolved: Vec<Growth>,
    /// Seconds of the whole report.
    pub report: f64,
    /// Our cheapest solve of truncated Hertz within 0.1 %, measured before and after each of the other codes.
    pub beside: Vec<Beside>,
    /// Codes that were not installed: what was missing.
    pub absent: BTreeMap<String, String>,
}

/// A code that answered, and our own solve as it was beside it.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Beside {
    /// The other code.
    pub code: Series,
    /// Its version.
    pub version: String,
    /// Our seconds.
    pub seconds: Spread,
    /// On what both were run.
    pub machine: Machine,
}

/// The whole record.
#[derive(Clone, Debug)]
pub struct Record {
    /// Growth, other codes, machine.
    pub measured: Measured,
    /// Points of the work–precision charts: ours, and those of codes on meshes of their own.
    pub points: Vec<Point>,
}

impl Record {
    /// The points of a series.
    pub fn of(&self, series: Series) -> impl Iterator<Item = &Point> {
        self.points.iter().filter(move |point| point.series == series)
    }

    /// Takes in what a code answered, with our own solve beside it.
    pub fn renew(&mut self, points: Vec<Point>, beside: Beside) {
        self.measured.absent.remove(beside.code.name());
        self.points.retain(|point| point.series != beside.code);
        self.measured.beside.retain(|kept| kept.code != beside.code);
        self.points.extend(points);
        self.measured.beside.push(beside);
    }

    /// The same with the seconds of other codes as our own solve beside them took as long as when our points were
    /// recorded: a machine is half as fast on another day, and what counts is the ratio in one run.
    pub fn in_one_run(mut self) -> Self {
        let own = ours(&self.points).map_or(f64::NAN, |own| own.seconds);
        for Beside { code, seconds, .. } in &self.measured.beside {
            let of_code = self.points.iter_mut().filter(|point| point.series == *code);
            let times = |all: f64| all * own / seconds.median;
            of_code.for_each(|point| {
                point.seconds = times(point.seconds);
                [point.assembly, point.linear] = [point.assembly, point.linear].map(|part| part.map(times));
            });
        }
        self
    }

    /// Reads what is committed.
    pub fn read() -> Result<Self, Error> {
        let [one, two] = files();
        let measured = read_json(&one, RENEW)?;
        Ok(Self { measured, points: records::read(&two, &records::named(POINTS), RENEW)? })
    }

    /// Writes both files.
    pub fn write(&self) -> Result<(), Error> {
        let [one, two] = files();
        records::write(&two, &records::named(POINTS), &self.points)?;
        write_json(&one, &self.measured)
    }
}

/// Columns of the points, the fields of [`Point`].
const POINTS: [&str; 13] = [
    "series",
    "mesh",
    "formulation",
    "dofs",
    "operations",
    "converged",
    "seconds",
    "assembly",
    "linear",
    "peak",
    "peak_worst",
    "half_width",
    "half_width_worst",
];

/// The two files.
fn files() -> [PathBuf; 2] {
    ["measured.json", "precision.csv"].map(|name| root().join(FOLDER).join(name))
}

/// Our points on meshes that do not know where the contact ends, under all of whose loads the runs converge.
pub fn sound(points: &[Point]) -> Vec<&Point> {
    points.iter().filter(|point| point.series.order().is_some() && point.peak_worst.is_finite()).collect()
}

/// The points to which none is both as cheap and as exact, the cheapest first.
pub fn front<'a>(points: &[&'a Point], cost: fn(&Point) -> f64) -> Vec<&'a Point> {
    let known = points.iter().copied().filter(|point| cost(point).is_finite() && point.worst().is_finite());
    let mut sorted: Vec<&Point> = known.collect();
    sorted.sort_by(|a, b| cost(a).total_cmp(&cost(b)).then(a.worst().total_cmp(&b.worst())));
    let mut least = f64::INFINITY;
    sorted.retain(|point| {
        let better = point.worst() < least;
        least = least.min(point.worst());
        better
    });
    sorted
}

/// The fastest point within an error, the median or the worst one.
pub fn cheapest<'a>(
    points: impl IntoIterator<Item = &'a Point>,
    error: fn(&Point) -> f64,
    most: f64,
) -> Option<&'a Point> {
    let enough = points.into_iter().filter(|point| error(point) <= most);
    enough.min_by(|a, b| a.seconds.total_cmp(&b.seconds))
}

/// Contact solve over plain solve.
const CONTACT: f64 = 1.1;
/// Degrees of freedom from which the memory is asked for: below, the process itself takes most of it.
const LARGE: usize = 100_000;
/// An error for which 8-node cells are too many, and what a fitted mesh may take over the plain solve of the smallest
/// size.
const SIXTH: f64 = 1e-6;
const PLAIN_SOLVES: f64 = 30.0;
/// Error of p₀ and a to which codes are compared.
pub const COMPARED: f64 = 1e-3;
/// What is told of a code without numbers.
const NOT_ASKED: &str = "not asked where this was measured";
/// The formulation that is compared with other codes.
fn fastest() -> Formulation {
    Formulation::new(Element::Node, Iteration::Kinematic)
}

/// How often our own solve is measured before and after each code's.
const REPEATS: usize = 10;

/// All rows.
pub fn targets(record: &Record) -> Vec<Target> {
    let growth = &record.measured.growth;
    let mut all = Vec::new();
    for one in growth {
        let n = one.counts.dofs;
        all.push(contact(one, ""));
        all.push(Target::at_most(
            format!("assembly ÷ plain solve, {n} dofs, one thread"),
            0.25,
            one.assembly_ratio[0].median,
        ));
        all.push(Target::at_most(format!("the same on all threads, {n} dofs"), 0.25, one.assembly_ratio[1].median));
        all.push(Target::at_most(format!("one more solve ÷ the first, {n} dofs"), 0.02, one.again_ratio.median));
    }
    all.extend(record.measured.revolved.iter().map(|one| contact(one, "sphere, ")));
    all.extend(steepness(growth));
    for one in growth.iter().filter(|one| one.counts.dofs >= LARGE) {
        let what = format!("peak memory ÷ bytes of the factor, {} dofs", one.counts.dofs);
        let unknown =
            Target { measured: "not told by the system".into(), met: None, ..Target::at_most(what.clone(), 2.0, 0.0) };
        all.push(one.memory_ratio.map_or(unknown, |ratio| Target::at_most(what, 2.0, ratio)));
    }
    all.extend(Series::CODES.into_iter().zip([20.0, 10.0, 1.0]).map(|(code, asked)| to_accuracy(record, code, asked)));
    all.extend(growth.first().map(|one| sixth_digit(record, one)));
    all.push(Target::at_most("whole report from nothing [s]".into(), 60.0, record.measured.report));
    all
}

/// The contact solve over the plain one, with what three of four runs stay below.
fn contact(one: &Growth, of: &str) -> Target {
    let what = format!("contact solve ÷ plain solve, {of}{} dofs", one.counts.dofs);
    let measured = format!("{:.3}, upper quartile {:.3}", one.ratio.median, one.ratio_quartile);
    Target { measured, ..Target::at_most(what, CONTACT, one.ratio.median) }
}

/// Exponents of the whole time and of the contact solve, this against that of the plain solve in the same run.
fn steepness(growth: &[Growth]) -> [Target; 2] {
    let [least, most] = [growth.first(), growth.last()].map(|one| one.map_or(0, |one| one.counts.dofs));
    let what = |of: &str| format!("exponent of the {of}, {least} to {most} dofs");
    let whole = exponent(growth, |one| one.seconds(&Stage::ALL));
    let plain = exponent(growth, |one| one.plain.median);
    let contact = Target::at_most(what("contact solve"), plain, exponent(growth, |one| one.contact.median));
    [
        Target::at_most(what("whole time"), 1.25, whole),
        Target { asked: format!("≤ {plain:.3}, the plain solve's"), ..contact },
    ]
}

/// Six digits in units of a plain solve.
fn sixth_digit(record: &Record, Growth { counts, plain, .. }: &Growth) -> Target {
    let what = format!(
        "time to {SIXTH:e} in p₀ and a under the worst load, truncated Hertz: fitted ÷ plain solve of {} dofs",
        counts.dofs
    );
    let best = cheapest(record.of(Series::Fitted), Point::worst, SIXTH);
    Target::at_most(what, PLAIN_SOLVES, best.map_or(f64::NAN, |point| point.seconds) / plain.median)
}

/// Our cheapest mesh within the compared accuracy: node elements with kinematic load on truncated Hertz.
pub fn ours(points: &[Point]) -> Option<&Point> {
    let own = sound(points).into_iter().filter(|point| point.formulation == Some(fastest().name()));
    cheapest(own, Point::error, COMPARED)
}

/// Seconds of that solve as they are now, several times under each load.
pub fn seconds_of_ours(points: &[Point]) -> Result<Vec<f64>, Error> {
    let message = || format!("no mesh of truncated Hertz keeps {} %", 100.0 * COMPARED);
    let &Point { series, mesh, .. } =
        ours(points).ok_or_else(|| Error::at("timings", message(), "measure finer meshes"))?;
    let formulation = [fastest().tolerance(TOLERANCE)];
    let mut seconds = Vec::new();
    for half_width in [half_widths(mesh); REPEATS].concat() {
        seconds.extend(solved(series, mesh, half_width, &formulation)?.into_iter().map(|(_, seconds)| seconds));
    }
    Ok(seconds)
}

/// Another code's cheapest solve within the compared accuracy over ours, both under the worst of the loads.
fn to_accuracy(record: &Record, code: Series, asked: f64) -> Target {
    let what = format!(
        "time to {} % in p₀ and a under the worst load, truncated Hertz: {} ÷ ours",
        100.0 * COMPARED,
        code.name()
    );
    let theirs = cheapest(record.of(code), Point::worst, COMPARED);
    match (theirs, cheapest(sound(&record.points), Point::worst, COMPARED)) {
        (Some(theirs), Some(own)) => {
            let ratio = theirs.seconds / own.seconds;
            let [longer, shorter] = [theirs, own].map(|point| 1e3 * point.seconds);
            let measured = format!(
                "{ratio:.1} ({longer:.1} ms with {} dofs against {shorter:.2} ms with {})",
                theirs.dofs, own.dofs
            );
            Target { measured, ..Target::at_least(what, asked, ratio) }
        }
        _ if record.of(code).next().is_some() => {
            let measured = format!("{} on none of its meshes", code.name());
            Target { measured, ..Target::at_least(what, asked, f64::NAN) }
        }
        _ => Target { measured: NOT_ASKED.into(), met: None, ..Target::at_least(what, asked, f64::NAN) },
    }
}
