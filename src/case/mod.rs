//! A claim: a problem, the formulations that solve it, and checks that hold the results against independent truth.
//!
//! * [`check`] — a quantity, what it is held against, a tolerance and the reason for it.
//! * [`quantity`] — what a check asks for.
//! * [`judged`] — a check with what was found, and the verdict.
//! * [`problem`] — the problems of the suite by name: scene, default mesh and oracle.
//! * [`universal`] — what every converged run must satisfy, whatever the problem.
//! * [`exact`], [`hertz`], [`pin`] — the cases.
//! * [`file`] — a user's own scene, with its checks.
//! * [`library`] — the scenes of the suite.

pub mod check;
pub mod exact;
pub mod file;
pub mod hertz;
pub mod judged;
pub mod library;
pub mod pin;
pub mod problem;
pub mod quantity;
mod stated;
pub mod universal;

pub use check::{Against, Check, Reference, Relation, Scope};
pub use file::SceneFile;
pub use judged::{Judged, Verdict};
pub use problem::Problem;
pub use quantity::Quantity;
