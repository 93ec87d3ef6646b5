//! Pictures of one run.
//!
//! * [`solve`] — shape, pressure and iteration error on one sheet.
//! * [`deformed`] — the deformed bodies with their stress.

pub mod deformed;
pub mod solve;
