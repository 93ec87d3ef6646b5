//! The load–approach curve for other programs: CSV, or JSON.

use std::path::Path;

use serde::Serialize;

use crate::error::Error;
use crate::measure::display_factor;
use crate::report::record;
use crate::scene::{ContactPair, Scene};
use crate::solve::Discretisation;
use crate::solve::Run;
use crate::solve::curve::{CurveContact, CurvePoint};

/// One contact at one load; half-widths are lengths, or angles on an arc.
#[derive(Serialize)]
struct Row<'a> {
    load_factor: f64,
    outcome: String,
    iterations: usize,
    contact: &'a str,
    resultant_n: f64,
    approach_mm: Option<f64>,
    half_width_mm: Option<f64>,
    half_width_deg: Option<f64>,
    peak_pressure_mpa: Option<f64>,
}

impl<'a> Row<'a> {
    fn of(point: &CurvePoint, pair: &'a ContactPair, contact: &CurveContact) -> Self {
        let (straight, half_width) = (pair.path.is_straight(), display_factor(&pair.path) * contact.half_width);
        Self {
            load_factor: point.share,
            outcome: point.outcome.to_string(),
            iterations: point.iterations,
            contact: &pair.name,
            resultant_n: contact.resultant,
            approach_mm: contact.approach,
            half_width_mm: straight.then_some(half_width),
            half_width_deg: (!straight).then_some(half_width),
            peak_pressure_mpa: contact.peak,
        }
    }
}

/// Refuses a curve of a single increment, and a file name that would not tell its format.
pub fn refuse(path: Option<&Path>, increments: usize) -> Result<(), Error> {
    let Some(path) = path else { return Ok(()) };
    if !is_json(path) && path.extension().is_none_or(|end| end != "csv") {
        let remedy = "end the file name in .csv or .json";
        return Err(Error::value("solve", "--curve", path.display(), "curves are CSV or JSON", remedy));
    }
    if increments < 2 {
        let remedy = "add `--increments 10`, or `increments = 10` in [solve]";
        return Err(Error::value("solve", "--curve", path.display(), "all of the load is applied at once", remedy));
    }
    Ok(())
}

fn is_json(path: &Path) -> bool {
    path.extension().is_some_and(|end| end == "json")
}

/// The curve as text: a row for each contact at each load, the increment that did not converge included.
pub fn text(discretisation: &Discretisation, run: &Run, path: &Path) -> Result<String, Error> {
    let curve = discretisation.curve(run)?;
    let rows: Vec<Row> = curve.iter().flat_map(|point| rows(&discretisation.scene, point)).collect();
    if is_json(path) {
        return Ok(serde_json::to_string_pretty(&rows).expect("numbers, strings and lists can be written as JSON"));
    }
    record::text(path, &rows)
}

/// Whether a text is such a curve.
pub fn is_curve(text: &str) -> bool {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    if reader.headers().is_ok_and(|head| head.get(0) == Some("load_factor")) {
        return reader.records().all(|row| row.is_ok());
    }
    let rows = serde_json::from_str::<Vec<serde_json::Value>>(text);
    rows.is_ok_and(|rows| rows.iter().all(|row| row.get("load_factor").is_some()))
}

fn rows<'a>(scene: &'a Scene, point: &'a CurvePoint) -> impl Iterator<Item = Row<'a>> {
    scene.contacts.iter().zip(&point.contacts).map(move |(pair, contact)| Row::of(point, pair, contact))
}
