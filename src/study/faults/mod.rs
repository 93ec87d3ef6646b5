//! Fault injection: what turned red when a fault was put into a copy of the tree.
//!
//! * `plan` — one trial, the record.
//! * `run` — the record is read.
//! * `judge` — every fault turned a check against a truth red.
//! * `section` — a row for each fault.

mod judge;
mod plan;
pub mod run;
mod section;

pub use judge::{is_caught, judge};
pub use plan::plan;
pub use run::{Fault, Numbers, Planted};
pub use section::{pictures, section};
