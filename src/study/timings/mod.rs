//! Speed against accuracy: what each accuracy costs, in seconds and in counted work.
//!
//! Seconds are measured on demand by the command `timings` and kept under `snapshots/timings`; errors and counts stand
//! beside them, and are measured again whenever the suite runs.
//!
//! * `plan` — what is run with every report.
//! * `run` — the record, and errors and counts as they are now.
//! * `record` — what is kept, and where.
//! * `machine` — processor, compiler and library versions.
//! * `statistics` — medians and worst values.
//! * `growth` — one solve from 10³ to 10⁶ degrees of freedom, stage by stage, against one plain sparse Cholesky solve.
//! * `precision` — error against seconds and work, over loads the mesh does not know; `answers` — what errors are held against.
//! * `family` — which scenes, on which meshes; `pareto` — what is cheapest for an error.
//! * `digits` — seconds of meshes fitted to the contact, and of 8-node ones with as small an error.
//! * `others` — the same by codes on meshes of their own; the cylinder by GetFEM and CalculiX. `code` — whom, on which meshes.
//! * `targets` — what was asked for, and what was measured.
//! * `judge` — whether errors and counts are still the recorded ones.
//! * `section` — what each accuracy costs.
//! * `growth_section` — how the cost grows, and where the time goes.
//! * `digits_section` — what each error costs, here and elsewhere.
//! * `picture` — all charts; `work_precision`, `precision_detail` — error against seconds and work; `compared` — other codes there.
//! * `growth_picture` — seconds by stage and memory against the degrees of freedom.

pub mod answers;
pub mod code;
pub mod compared;
pub mod digits;
mod digits_section;
pub mod family;
pub mod growth;
mod growth_picture;
mod growth_section;
pub mod judge;
pub mod machine;
pub mod others;
pub mod pareto;
mod picture;
pub mod plan;
pub mod precision;
mod precision_detail;
pub mod record;
pub mod run;
mod section;
pub mod statistics;
pub mod targets;
mod work_precision;

use crate::study::about::About;

pub use judge::judge;
pub use picture::pictures;
pub use plan::plan;
pub use run::Numbers;
pub use section::section;

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Speed against accuracy",
    asked: "What an accuracy costs, in seconds and in counted work, here and in other codes.",
    limits: "Seconds are those of one machine. Errors and counts are computed again with every report, seconds are not.",
};
