//! Gaertner's digitised curves against the pin–rod of their own dimensions; not run while the figures are not at hand.
//!
//! * `plan` — one trial, the folder of the curves.
//! * `run` — the worst deviation of each curve.
//! * `judge` — within the combined uncertainty.
//! * `section` — the title; its checks say the rest.

mod judge;
mod plan;
pub mod run;
mod section;

pub use judge::judge;
pub use plan::plan;
pub use run::{Curve, Deviates, Numbers};
pub use section::{pictures, section};
