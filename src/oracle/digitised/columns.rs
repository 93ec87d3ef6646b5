//! The columns of a digitised curve's CSV file: exactly four, their units in their names; and its points.

use std::f64::consts::PI;
use std::path::Path;

use csv::StringRecord;

use super::keys::listed;
use crate::error::Error;

/// A digitised point; errors are standard uncertainties (one standard deviation).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurvePoint {
    /// Angle from the load line \[rad\], distance from it \[mm\], or force \[N\].
    pub abscissa: f64,
    /// Error of the abscissa, in its unit, above zero.
    pub abscissa_error: f64,
    /// Pressure (positive in compression) or hoop stress (tension positive) \[MPa\], or half-angle of the contact
    /// \[rad\].
    pub ordinate: f64,
    /// Error of the ordinate, in its unit, above zero.
    pub ordinate_error: f64,
}

/// What the abscissa of a curve is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Abscissa {
    /// Angle from the load line, held in radians.
    Angle,
    /// Distance from the load line \[mm\].
    Distance,
    /// Full force on the pin \[N\].
    Force,
}

/// What the ordinate of a curve is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ordinate {
    /// Contact pressure \[MPa\].
    Pressure,
    /// Circumferential stress on the rim of the hole \[MPa\].
    HoopStress,
    /// Angle from the load line at which the contact ends, held in radians.
    HalfAngle,
}

/// A quantity and its unit, as the columns of a CSV file spell them, the factor to the unit held, and what it is.
type Column<T> = (&'static str, &'static str, f64, T);

const ABSCISSAE: [Column<Abscissa>; 4] = [
    ("angle", "deg", PI / 180.0, Abscissa::Angle),
    ("angle", "rad", 1.0, Abscissa::Angle),
    ("x", "mm", 1.0, Abscissa::Distance),
    ("force", "n", 1.0, Abscissa::Force),
];

const ORDINATES: [Column<Ordinate>; 4] = [
    ("pressure", "mpa", 1.0, Ordinate::Pressure),
    ("hoop_stress", "mpa", 1.0, Ordinate::HoopStress),
    ("half_angle", "deg", PI / 180.0, Ordinate::HalfAngle),
    ("half_angle", "rad", 1.0, Ordinate::HalfAngle),
];

/// Names of the column of a quantity, and of that of its error.
fn names<T>((quantity, unit, ..): &Column<T>) -> [String; 2] {
    [format!("{quantity}_{unit}"), format!("{quantity}_error_{unit}")]
}

/// What the columns are, and the points by rising abscissa, at least one.
pub(super) fn read(file: &Path, text: &str) -> Result<(Abscissa, Ordinate, Vec<CurvePoint>), Error> {
    let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(text.as_bytes());
    let header = reader.headers().map_err(|cause| unreadable(file, &cause))?.clone();
    let across = which(file, &header, &ABSCISSAE)?;
    let up = which(file, &header, &ORDINATES)?;
    let ([x, x_error], [y, y_error]) = (names(across), names(up));
    let names = [x, x_error, y, y_error];
    let places = places(file, &header, &names)?;

    let mut points = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|cause| unreadable(file, &cause))?;
        let [x, x_error, y, y_error] = row(file, &record, &names, places)?;
        points.push(CurvePoint {
            abscissa: x * across.2,
            abscissa_error: x_error * across.2,
            ordinate: y * up.2,
            ordinate_error: y_error * up.2,
        });
    }
    if points.is_empty() {
        return Err(Error::refused(file, "rows", "none", "add one row per digitised point"));
    }
    points.sort_by(|one, other| one.abscissa.total_cmp(&other.abscissa));
    Ok((across.3, up.3, points))
}

/// The one quantity and unit of `known` that the header has.
fn which<'k, T>(file: &Path, header: &StringRecord, known: &'k [Column<T>]) -> Result<&'k Column<T>, Error> {
    let name = |column: &Column<T>| names(column)[0].clone();
    known.iter().find(|column| header.iter().any(|known| known == name(column))).ok_or_else(|| {
        let names: Vec<String> = known.iter().map(name).collect();
        missing(file, &names.join(" or "), header, "add the column, its unit in its name")
    })
}

/// Where each named column stands; every name there once, and no other.
fn places(file: &Path, header: &StringRecord, names: &[String; 4]) -> Result<[usize; 4], Error> {
    let mut places = [0; 4];
    for (place, name) in places.iter_mut().zip(names) {
        *place = header
            .iter()
            .position(|column| column == name)
            .ok_or_else(|| missing(file, name, header, "add the column"))?;
    }
    for (place, name) in header.iter().enumerate() {
        if !places.contains(&place) {
            let remedy = format!("keep the four columns {}, each once", listed(names));
            return Err(Error::refused(file, name, "not a known column, or there twice", remedy));
        }
    }
    Ok(places)
}

fn row(file: &Path, record: &StringRecord, names: &[String; 4], places: [usize; 4]) -> Result<[f64; 4], Error> {
    let line = record.position().map_or(0, csv::Position::line);
    let mut row = [0.0; 4];
    for (index, value) in row.iter_mut().enumerate() {
        let entry = record.get(places[index]).unwrap_or_default();
        // The error columns are the second and the fourth; an error of zero would make any deviation infinite.
        let is_error = index % 2 == 1;
        *value = entry.parse().unwrap_or(f64::NAN);
        if !value.is_finite() || (is_error && *value <= 0.0) {
            let wanted = if is_error { "write a finite number above 0" } else { "write a finite number" };
            let key = format!("{} in line {line}", names[index]);
            return Err(Error::refused(file, &key, format!("\"{entry}\""), wanted));
        }
    }
    Ok(row)
}

fn unreadable(file: &Path, cause: &csv::Error) -> Error {
    Error::unreadable(file, cause, "write a header and one row per point, as many entries in each")
}

fn missing(file: &Path, key: &str, header: &StringRecord, remedy: &str) -> Error {
    let found: Vec<String> = header.iter().map(str::to_owned).collect();
    Error::missing_key(file, key, &listed(&found), remedy)
}
