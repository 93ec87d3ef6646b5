//! A claim: a problem, the formulations that solve it, and checks that hold the results against independent truth.
//!
//! * [`check`] — requirement, quantity, oracle, tolerance with its reason, verdict.
//! * [`problem`] — the problems of the suite by name: scene, default mesh and oracle.
//! * [`universal`] — what every converged run must satisfy, whatever the problem.
//! * [`exact`], [`hertz`], [`pin`] — the cases.
//! * [`file`] — a user's own scene, with its checks.
//! * [`library`] — the scenes of the suite.

pub mod check;
pub mod exact;
pub mod file;
pub mod hertz;
pub mod library;
pub mod pin;
pub mod problem;
pub mod universal;

pub use check::{Check, Reference, Verdict};
pub use file::SceneFile;
pub use problem::Problem;
