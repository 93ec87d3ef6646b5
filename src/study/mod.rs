//! What is found out over many solves.
//!
//! * [`drawn`] — colours and dashes of formulations.
//! * [`trial`] — one piece of a study that can run alone, and what it found.
//! * [`refinement`], [`sweep`], [`family`], [`gaertner`] — studies over meshes, stiffnesses and dimensions.
//! * [`cross_code`] — the solver against scikit-fem and dolfinx.
//! * [`limits`] — limits of validity.
//! * [`faults`] — the record of planted faults.
//! * [`accuracy`] — the cheapest mesh for an accuracy asked.
//! * [`converged`] — what is called converged.
//! * [`met`] — whether an accuracy called met is met.
//! * [`records`] — files of recorded surveys.
//! * [`class`](mod@class), [`method`], [`pairing`] — how a run ended and what was run, as they are recorded.
//! * [`handed_over`] — our discretisation as plain numbers, for other codes.
//! * [`atlas`] — where each method converges, and where it was predicted to.
//! * [`stability`] — predicted rates and steps against measured ones.
//! * [`cures`] — acceleration of constant stiffness, nested starts of kinematic load.
//! * [`timings`] — what each accuracy costs.
//! * [`pictures`] — fields and iteration paths that are shown, not judged.

pub mod class;
pub mod cross_code;
pub mod family;
pub mod gaertner;
pub mod handed_over;
pub mod method;
pub mod pairing;
pub mod pictures;
pub mod records;
pub mod refinement;

pub mod drawn;
mod rooms;
pub mod trial;

use crate::case::Judged;
use crate::error::Error;
use rooms::rooms;

pub use trial::{Finding, Found, Planned, Trial};

rooms! {
    /// The cases of the suite.
    Cases in cases,
    /// Initial stiffness and rules.
    Sweep in sweep,
    /// Studies that have no room of their own yet.
    Unsorted in unsorted,
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
