//! Tables for other programs: the load–approach curve, as CSV or JSON, and the pressure profile.

use std::path::Path;

use serde::Serialize;

use crate::error::Error;
use crate::measure::display_factor;
use crate::report::record;
use crate::scene::{ContactPair, Scene};
use crate::solve::curve::{CurveContact, CurvePoint};
use crate::solve::{Discretisation, Run};

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
    let pairs = &discretisation.scene.contacts;
    let contacts = curve.iter().flat_map(|point| pairs.iter().zip(&point.contacts).map(move |two| (point, two)));
    let rows: Vec<Row> = contacts.map(|(point, (pair, contact))| Row::of(point, pair, contact)).collect();
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

/// Columns of the position, and whether that is along a straight path.
const POSITIONS: [(&str, bool); 2] = [("position [mm]", true), ("position [deg]", false)];
/// Columns behind the position.
const HEAD: [&str; 4] = ["pressure [MPa]", "gap [mm]", "area [mm2]", "contact"];

/// Position, pressure, gap, area and contact of every contact point: positions along straight paths in mm, on arcs in
/// degrees; where a scene has contacts of both kinds, each kind has a column.
pub fn profile(scene: &Scene, run: &Run, path: &Path) -> Result<String, Error> {
    let has = |is_straight| scene.contacts.iter().any(|pair| pair.path.is_straight() == is_straight);
    let kinds: Vec<(&str, bool)> = POSITIONS.into_iter().filter(|(_, is_straight)| has(*is_straight)).collect();
    let mut rows: Vec<Vec<String>> =
        vec![kinds.iter().map(|(title, _)| *title).chain(HEAD).map(String::from).collect()];
    for (index, pair) in scene.contacts.iter().enumerate() {
        for point in run.solution.points_of(index) {
            let position = (display_factor(&pair.path) * point.position).to_string();
            // Nothing where it is of the other kind.
            let cell =
                |is_straight| if pair.path.is_straight() == is_straight { position.clone() } else { String::new() };
            let positions = kinds.iter().map(|(_, is_straight)| cell(*is_straight));
            let numbers = [point.pressure, point.gap, point.weight].map(|number| number.to_string());
            rows.push(positions.chain(numbers).chain([pair.name.clone()]).collect());
        }
    }
    record::text(path, &rows)
}

/// Whether a text is such a table, every row as long as the head.
pub fn is_profile(text: &str) -> bool {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let is_head = reader.headers().is_ok_and(|head| {
        let is_position = |title: &&str| POSITIONS.iter().any(|(known, _)| known == title);
        let (positions, rest) = head.iter().partition::<Vec<_>, _>(is_position);
        !positions.is_empty() && rest == HEAD
    });
    is_head && reader.records().all(|row| row.is_ok())
}
