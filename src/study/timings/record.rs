//! What was measured, as it is kept under `snapshots/timings`; what of it is cheapest for an error: the points that no other beats, and
//! the first within an error that is asked for.

use std::collections::BTreeMap;
use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use crate::checkout::root;
use crate::error::Error;
use crate::oracle::cross_code::frozen::{read_json, write_json};
use crate::study::records;
use crate::study::seconds::{Machine, Spread};
use crate::study::timings::growth::{Growth, Nine};
use crate::study::timings::precision::{Point, Series};

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
    /// All nine formulations over one, mesh by mesh.
    pub nine: Vec<Nine>,
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
const POINTS: [&str; 11] = [
    "series",
    "mesh",
    "formulation",
    "dofs",
    "operations",
    "converged",
    "seconds",
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
pub fn front<'a>(points: &[&'a Point], cost: fn(&Point) -> f64, error: &dyn Fn(&Point) -> f64) -> Vec<&'a Point> {
    let mut sorted: Vec<&Point> =
        points.iter().copied().filter(|point| cost(point).is_finite() && error(point).is_finite()).collect();
    sorted.sort_by(|a, b| cost(a).total_cmp(&cost(b)).then(error(a).total_cmp(&error(b))));
    let mut least = f64::INFINITY;
    sorted.retain(|point| {
        let better = error(point) < least;
        least = least.min(error(point));
        better
    });
    sorted
}

/// The point of least cost within an error.
pub fn cheapest<'a>(
    points: impl IntoIterator<Item = &'a Point>,
    cost: fn(&Point) -> f64,
    error: impl Fn(&Point) -> f64,
    most: f64,
) -> Option<&'a Point> {
    let enough = points.into_iter().filter(|point| error(point) <= most);
    enough.min_by(|a, b| cost(a).total_cmp(&cost(b)))
}
