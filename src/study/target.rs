//! What was asked for as a goal, and what came out: told whether it is met or not, and held by no check.

use crate::markdown::Column;

/// One goal.
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

impl Target {
    /// A number that shall be no larger.
    pub fn at_most(what: String, limit: f64, value: f64) -> Self {
        Self { what, asked: format!("≤ {limit}"), measured: format!("{value:.3}"), met: Some(value <= limit) }
    }

    /// One that shall be no smaller.
    pub fn at_least(what: String, limit: f64, value: f64) -> Self {
        Self { what, asked: format!("≥ {limit}"), measured: format!("{value:.1}"), met: Some(value >= limit) }
    }
}

/// Columns of the table of targets.
pub const COLUMNS: [Column<Target>; 4] = [
    ("what", |target| target.what.clone()),
    ("asked for", |target| target.asked.clone()),
    ("measured", |target| target.measured.clone()),
    ("met", |target| target.met.map_or("–", |met| if met { "yes" } else { "no" }).into()),
];
