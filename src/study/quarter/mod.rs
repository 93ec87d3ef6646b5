//! The half cylinder against the quarter: the top may be left out while the contact is small.
//!
//! * `plan` — one trial.
//! * `run` — change of peak and half-width by a/R.
//! * `judge` — no more than `judge::LEFT_OUT` at small a/R.
//! * `section` — a row for each a/R.

pub mod judge;
mod plan;
pub mod run;
mod section;

pub use judge::{LEFT_OUT, judge};
pub use plan::plan;
pub use run::{Change, Contact, Numbers};
pub use section::{pictures, section};
