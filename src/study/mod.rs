//! What is found out over many solves: studies as rooms, and what they share.
//!
//! * [`trial`] — one piece of a study that can run alone, and what it found.
//! * `rooms` — what a room must have, and how the page meets all of them.
//! * [`drawn`] — colours and dashes of formulations, and curves.
//! * [`class`](mod@class), [`method`], [`pairing`] — how a run ended and what was run, as they are recorded.
//! * [`records`] — files of recorded surveys.
//! * [`handed_over`] — our discretisation as plain numbers, for other codes.

pub mod class;
pub mod drawn;
pub mod handed_over;
pub mod method;
pub mod pairing;
pub mod records;
mod rooms;
pub mod trial;

use crate::case::Judged;
use crate::error::Error;
use rooms::rooms;

pub use trial::{Finding, Found, Planned, Trial};

rooms! {
    /// The cases of the suite.
    Cases in cases,
    /// Observed orders, model error, uncertainty of the pin–rod.
    Refinement in refinement,
    /// The half cylinder against the quarter.
    Quarter in quarter,
    /// The dimensionless family of the pin–rod.
    Family in family,
    /// Gaertner's curves.
    Gaertner in gaertner,
    /// Fields and iteration paths.
    Fields in fields,
    /// Other codes.
    CrossCode in cross_code,
    /// Initial stiffness and rules.
    Sweep in sweep,
    /// Speed against accuracy.
    Timings in timings,
    /// What is called converged.
    Converged in converged,
    /// An accuracy asked for instead of a mesh.
    Accuracy in accuracy,
    /// What is called met.
    Met in met,
    /// Where methods fail: the recorded survey.
    Atlas in atlas,
    /// Where methods fail: predicted rates and steps.
    Stability in stability,
    /// Cures of what fails or is slow.
    Cures in cures,
    /// Limits of validity.
    Limits in limits,
    /// Fault injection.
    Faults in faults,
}

/// The trials of all rooms, in the order of the page.
pub fn trials() -> Vec<Trial> {
    Room::ALL.iter().flat_map(|room| room.plan()).collect()
}
