//! What was measured at each point, as it is kept under `snapshots/atlas`, and the chart of a plane that it makes.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::error::Error;
use crate::solve::Ended;
use crate::study::atlas::plane::{Plane, Site};
use crate::study::method::Method;
use crate::study::records;

/// Error of p₀ and a that a run within the default tolerance may have.
pub const RIGHT: f64 = 3e-3;

/// What renews the records.
pub const RENEW: &str = "run `cargo run --release -- atlas` and review the diff of snapshots/atlas";

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
    pub class: Ended,
    /// Iterations made; zero where an error keeps them.
    pub iterations: usize,
    /// Larger error of p₀ and a against the solution of the same discrete problem; NaN where an error keeps them.
    pub error: f64,
    /// Larger error of p₀ and a that the springs of a penalty make; none without one.
    pub penalty: Option<f64>,
    /// Iterations predicted, infinite where it shall not converge; none where none are.
    pub predicted_iterations: Option<f64>,
}

impl Record {
    /// Error of p₀ and a with that of a penalty, which may stop far from the solution.
    pub fn off(&self) -> f64 {
        self.error + self.penalty.unwrap_or_default()
    }

    /// Whether the run stopped where it shall.
    pub fn is_right(&self) -> bool {
        self.class == Ended::Converged && self.off() <= RIGHT
    }
}

/// Equal but for the digits a text file leaves out.
pub fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-3 * a.abs().max(b.abs())
}

/// Columns of a record, its fields.
pub const HEAD: [&str; 8] =
    ["formulation", "ordinate", "stiffness", "class", "iterations", "error", "penalty", "predicted_iterations"];

/// The records of a plane, a line per row of the plan.
#[derive(Clone, Debug)]
pub struct Chart {
    /// The plane.
    pub plane: Plane,
    /// Records by row, then by initial stiffness.
    pub rows: Vec<Vec<Record>>,
}

impl Chart {
    /// The records in the order of the plan.
    pub fn of(plane: Plane, records: &[Record]) -> Self {
        Self { plane, rows: records.chunks(plane.stiffnesses().len()).map(<[Record]>::to_vec).collect() }
    }

    /// The record of a plane; refused where it does not hold exactly the points of the plan.
    pub fn read(plane: Plane) -> Result<Self, Error> {
        Self::read_from(&file(plane), plane)
    }

    /// The same from another file.
    pub fn read_from(path: &Path, plane: Plane) -> Result<Self, Error> {
        let records: Vec<Record> = records::read(path, &records::named(HEAD), RENEW)?;
        let of_row = |(site, method): (Site, Method)| plane.stiffnesses().into_iter().map(move |k| (site, method, k));
        let planned: Vec<(Site, Method, f64)> = plane.rows().into_iter().flat_map(of_row).collect();
        let is_at = |(record, (site, method, k)): (&Record, &(Site, Method, f64))| {
            record.method == *method && same(record.ordinate, site.ordinate) && same(record.stiffness, *k)
        };
        if records.len() != planned.len() || !records.iter().zip(&planned).all(is_at) {
            let found = format!("{} points that are not the {} of the plan", records.len(), planned.len());
            return Err(Error::refused(path, "points", found, RENEW));
        }
        Ok(Self::of(plane, &records))
    }

    /// Rows of a method, by growing ordinate.
    pub fn of_method(&self, method: Method) -> impl Iterator<Item = &[Record]> {
        self.rows.iter().map(Vec::as_slice).filter(move |row| row[0].method == method)
    }

    /// Whether a neighbour in stiffness or in the other number ended in another class.
    pub fn is_near_a_boundary(&self, row: usize, column: usize) -> bool {
        let across = self.plane.methods().len();
        let beside = [column.checked_sub(1), Some(column + 1)].map(|column| Some((row, column?)));
        let above = [row.checked_sub(across), Some(row + across)].map(|row| Some((row?, column)));
        let places = beside.into_iter().chain(above).flatten();
        let mut neighbours = places.filter_map(|(row, column)| self.rows.get(row)?.get(column));
        neighbours.any(|other| other.class != self.rows[row][column].class)
    }

    /// What is frozen: the iterations where all neighbours ended alike, the class alone near a boundary.
    pub fn frozen(&self) -> String {
        let mut text = format!("{}; κ₀ from 1e-6 to 1e6\n", self.plane.label());
        for (r, row) in self.rows.iter().enumerate() {
            let _ = write!(text, "{} {}:", row[0].method, row[0].ordinate);
            for (c, record) in row.iter().enumerate() {
                let _ = match record.class {
                    Ended::Converged if !self.is_near_a_boundary(r, c) => write!(text, " {}", record.iterations),
                    class => write!(text, " {}", class.name()),
                };
            }
            text.push('\n');
        }
        text
    }
}

/// The record of a plane.
pub fn file(plane: Plane) -> PathBuf {
    records::file(&format!("atlas/{}", plane.name()))
}
