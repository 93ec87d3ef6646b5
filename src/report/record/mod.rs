//! The record: what was judged, counted and stated, as tables that two commits can be compared by.
//!
//! Rows are sorted by their keys; numbers have four significant digits, and what is round-off is 0, so that every machine writes the
//! same bytes.
//!
//! * [`check`] — a row per check.
//! * [`run`] — a row per run of a case: how it ended and what work it took.
//! * [`statement`] — a row per statement of the paper.
//! * [`rounding`] — how numbers are written.

pub mod check;
pub mod rounding;
pub mod run;
pub mod statement;

use std::path::Path;

use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::error::Error;
use crate::report::statements;
use crate::study::Finding;

pub use check::{CheckRow, Mark, rows};
pub use run::RunRow;
pub use statement::StatementRow;

/// The record of checks.
pub const CHECKS: &str = "snapshots/checks.csv";
/// The record of runs.
pub const RUNS: &str = "snapshots/runs.csv";
/// The record of statements.
pub const STATEMENTS: &str = "snapshots/statements.csv";

/// The record as files: their paths below the project folder, and their texts.
pub fn files(findings: &[Finding]) -> Result<Vec<(String, String)>, Error> {
    let statements: Vec<StatementRow> = statements::judge(findings).iter().map(StatementRow::of).collect();
    Ok(vec![
        (CHECKS.into(), text(CHECKS, &rows(findings))?),
        (RUNS.into(), text(RUNS, &run::rows(findings))?),
        (STATEMENTS.into(), text(STATEMENTS, &statements)?),
    ])
}

/// Rows as a table, a line each below the names of the columns.
pub fn text<T: Serialize>(file: &str, rows: &[T]) -> Result<String, Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in rows {
        writer.serialize(row).map_err(|error| Error::unwritable(Path::new(file), error))?;
    }
    let bytes = writer.into_inner().map_err(|error| Error::unwritable(Path::new(file), error))?;
    String::from_utf8(bytes).map_err(|error| Error::unwritable(Path::new(file), error))
}

/// Rows of a table; what is wrong with it where it cannot be read.
pub fn parsed<T: DeserializeOwned>(text: &str) -> Result<Vec<T>, String> {
    csv::Reader::from_reader(text.as_bytes()).deserialize().collect::<Result<_, _>>().map_err(|error| error.to_string())
}
