//! Pictures of runs.
//!
//! * [`compare`] — formulations side by side, error against iterations.
//! * [`solve`] — shape, pressure and iteration error on one sheet.
//! * [`deformed`] — the deformed bodies with their stress.

pub mod compare;
pub mod deformed;
pub mod solve;
