//! What was measured at each point, as it is kept under `snapshots/atlas`.

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::checkout::root;
use crate::error::Error;
use crate::study::atlas::plane::Plane;
use crate::study::atlas::row::Row;
use crate::study::class::Class;
use crate::study::method::Method;
use crate::study::records;

/// Error of p₀ and a that a run within the default tolerance may have.
pub const RIGHT: f64 = 3e-3;

/// What renews the records.
pub const RENEW: &str = "run `cargo run --release -- atlas` and review the diff of snapshots/atlas";

/// Where the records are.
pub const FOLDER: &str = "snapshots/atlas";

/// One point.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Record {
    /// What was run.
    pub method: Method,
    /// The plane's other number.
    pub ordinate: f64,
    /// Initial stiffness κ₀.
    pub stiffness: f64,
    /// How it ended.
    pub class: Class,
    /// Iterations made; zero where an error keeps them.
    pub iterations: usize,
    /// Iteration error after the last iteration.
    pub iteration_error: f64,
    /// Factor by which the iteration error shrank at each of the latter half of the iterations; NaN where these are fewer than five.
    pub rate: f64,
    /// Larger error of p₀ and a against the solution of the same discrete problem.
    pub error: f64,
    /// Larger error of p₀ and a that the springs of a penalty make; 0 without one.
    pub penalty: f64,
    /// Spectral radius predicted; NaN where none is.
    pub predicted_rate: f64,
    /// Iterations predicted; NaN where none are, infinite where it shall not converge.
    pub predicted_iterations: f64,
}

impl Record {
    /// Whether the run stopped where it shall: a penalty may stop far from there.
    pub fn is_right(&self) -> bool {
        self.class == Class::Converged && self.error + self.penalty <= RIGHT
    }

    /// Whether the record is of this point.
    pub fn is_at(&self, row: &Row, stiffness: f64) -> bool {
        self.method == row.method && same(self.ordinate, row.ordinate) && same(self.stiffness, stiffness)
    }
}

/// Equal but for the digits a text file leaves out.
pub fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-3 * a.abs().max(b.abs())
}

/// Columns of a record.
const HEAD: [&str; 11] = [
    "formulation",
    "ordinate",
    "stiffness",
    "class",
    "iterations",
    "iteration_error",
    "rate",
    "error",
    "penalty",
    "predicted_rate",
    "predicted_iterations",
];

/// The points of a file.
pub fn points(file: &Path) -> Result<Vec<Record>, Error> {
    records::read(file, &records::named(HEAD), RENEW)
}

/// Writes points to a file.
pub fn write(file: &Path, points: &[Record]) -> Result<(), Error> {
    records::write(file, &records::named(HEAD), points)
}

/// The folder of the records.
pub fn folder() -> PathBuf {
    root().join(FOLDER)
}

/// The record of a plane; refused where it does not hold exactly the points of the plan.
pub fn read(plane: Plane) -> Result<Vec<Record>, Error> {
    read_from(&folder(), plane)
}

/// The same from another folder.
pub fn read_from(folder: &Path, plane: Plane) -> Result<Vec<Record>, Error> {
    let path = folder.join(plane.name()).with_extension("csv");
    let records = points(&path)?;
    let stiffnesses = plane.stiffnesses();
    let planned: Vec<(Row, f64)> =
        plane.rows().into_iter().flat_map(|row| stiffnesses.iter().map(move |&stiffness| (row, stiffness))).collect();
    let complete = planned.len() == records.len()
        && planned.iter().zip(&records).all(|((row, stiffness), record)| record.is_at(row, *stiffness));
    if !complete {
        let found = format!("{} points that are not the {} of the plan", records.len(), planned.len());
        return Err(Error::refused(&path, "points", found, RENEW));
    }
    Ok(records)
}
