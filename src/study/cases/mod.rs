//! The cases of the suite, each solved by its formulations.
//!
//! * `plan` — built-in cases and scene files; formulations of a case share one mesh.
//! * `run` — a run with its judged checks.
//! * `section` — the chapters on the paper's two examples and on exact solutions.
//! * `picture` — pressure of all nine against the reference.

mod picture;
mod picture_band;
mod plan;
mod run;
mod scene;
mod section;

pub use picture::pictures;
pub use plan::plan;
pub use run::{Numbers, judge};
pub use section::section;
