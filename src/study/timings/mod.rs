//! Speed against accuracy: what each accuracy costs, in seconds and in counted work.
//!
//! Seconds are measured on demand by the command `timings` and kept under `snapshots/timings`; errors and counts stand
//! beside them, and are measured again whenever the suite runs.
//!
//! * [`record`] — what is kept, and where.
//! * [`machine`] — processor, compiler and library versions.
//! * [`statistics`] — medians and worst values.
//! * [`growth`] — one solve from 10³ to 10⁶ freedoms, stage by stage, against one plain sparse Cholesky solve.
//! * [`meshes`] — the default meshes, and what coarser ones would change.
//! * [`precision`] — error against seconds and work, over loads the mesh does not know.
//! * [`others`] — the same by scikit-fem and dolfinx; the cylinder by GetFEM and CalculiX.
//! * [`targets`] — what was asked for, and what was measured.
//! * [`judge`] — whether errors and counts are still the recorded ones.

pub mod growth;
pub mod judge;
pub mod machine;
pub mod meshes;
pub mod others;
pub mod precision;
pub mod record;
pub mod statistics;
pub mod targets;

use crate::study::unsorted::Trial;

/// All trials.
pub fn trials() -> Vec<Trial> {
    let mut trials = judge::trials();
    trials.extend(meshes::trials());
    trials
}
