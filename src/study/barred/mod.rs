//! Whether the error bars of the suite's own checks hold.
//!
//! * `plan` — nothing is run: what is looked at is what all other trials found.
//! * `run` — the checks that have a bar, and those whose error is beyond it.
//! * `judge` — how many may be.
//! * `section` — all of them.

pub mod judge;
mod plan;
pub mod run;
mod section;

pub use judge::judge;
pub use plan::plan;
pub use run::Numbers;
pub use section::{pictures, section};
