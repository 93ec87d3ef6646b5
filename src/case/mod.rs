//! A claim: a scene, the formulations that solve it, and checks that hold the results against independent truth.
//!
//! * [`definition`] — the case.
//! * [`check`] — a quantity, what it is held against, a tolerance and the reason for it.
//! * [`quantity`] — what a check asks for.
//! * [`judged`] — a check with what was found, and the verdict.
//! * [`barred`] — checks beside the error bars of what they judge.
//! * [`notes`] — what must be known of a contact before it is quoted; [`plausible`] — what of a result is hardly meant.
//! * [`solved`] — a case on its mesh, run and judged, with the value of each quantity.
//! * [`universal`] — what every run must satisfy, whatever the case.
//! * [`library`] — the cases of the suite.
//! * [`mod@file`] — cases that users write.

pub mod barred;
pub mod check;
pub mod definition;
pub mod file;
pub mod judged;
pub mod library;
pub mod notes;
pub mod plausible;
pub mod quantity;
pub mod solved;
pub mod universal;

pub use check::{Against, Check, Reference, Relation, Scope};
pub use definition::Case;
pub use judged::{Judged, Verdict, covered};
pub use quantity::Quantity;
pub use solved::Meshed;
