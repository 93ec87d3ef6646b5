//! Speed against accuracy: what each accuracy costs, in seconds and in counted work. A folder, since what measures seconds, what keeps
//! them and what computes errors and counts again with every report are three things.
//!
//! * `series` — on which meshes truncated Hertz is solved, and whose these are.
//! * `precision` — error against seconds and work, over loads the mesh does not know.
//! * `growth` — one solve at three sizes, stage by stage, against one plain sparse Cholesky solve; all nine formulations over one.
//! * `others` — the same accuracy by codes on meshes of their own; the cylinder by GetFEM and CalculiX on ours.
//! * `statistics` — medians and quantiles.
//! * `record` — what is kept under `snapshots/timings`, measured on demand by the command `timings`.
//! * `run` — errors and counts as they are now, and whether they are still the recorded ones.
//! * `pareto` — what is cheapest for an error; `targets` — what was asked for, and what was measured.
//! * `section` — the page; `work_precision` — its chart.

pub mod growth;
pub mod others;
pub mod pareto;
pub mod precision;
pub mod record;
pub mod run;
pub mod section;
pub mod series;
pub mod statistics;
pub mod targets;
pub mod work_precision;

use crate::drawing::Drawing;
use crate::error::Error;
use crate::study::Found;
use crate::study::about::About;
use record::Record;

pub use run::{Numbers, judge, plan};

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Speed against accuracy",
    asked: "What an accuracy costs, in seconds and in counted work, here and in other codes.",
    limits: "Seconds are those of one machine. Errors and counts are computed again with every report, seconds are not.",
};

/// The page of the committed record.
pub fn section(_: &[Found<Numbers>]) -> Result<String, Error> {
    Ok(section::page(&Record::read()?))
}

/// The chart of the committed record.
pub fn pictures(_: &[Found<Numbers>]) -> Result<Vec<(String, Drawing)>, Error> {
    Ok(vec![("work-precision.svg".into(), work_precision::chart(&Record::read()?))])
}
