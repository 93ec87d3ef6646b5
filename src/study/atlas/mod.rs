//! The stability atlas: outcome, steps, rate and error of every element × algorithm × rule over initial stiffness and one
//! other number, each predicted before it is run.
//!
//! * [`plan`] — which points it holds.
//! * [`point`] — one point, predicted and run.
//! * [`record`] — what is kept under `snapshots/atlas`.
//! * [`chart`] — a plane as classes and their boundaries.
//! * [`judge`] — what the records must hold.
//! * [`summary`] — what the records say of each method.
//! * [`survey`] — all of them, resumable.

pub mod chart;
pub mod judge;
pub mod plan;
pub mod point;
pub mod record;
pub mod summary;
pub mod survey;

pub use chart::Chart;
pub use judge::{ATLAS, trials};
pub use plan::{Plane, Row};
pub use record::{Class, Record};
