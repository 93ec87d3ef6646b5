//! Égert's 1999 comparison of contact elements and iterations for frictionless elastic contact in 2D, implemented and
//! verified.
//!
//! The solver is the crate [`signorini`], from a scene to numbers with error bars; its modules are those of this crate
//! too. On it stand
//!
//! * [`oracle`] — independent truth.
//! * [`mod@case`] — claims: problems and checks.
//! * [`referee`] — the answers of other codes, judged.
//! * [`study`] — what is found out over many solves.
//! * [`report`] — the page.
//! * [`cli`] — what the user types.
//!
//! Beside them stand [`checkout`], where the project's files are, the crate [`drawing`], and [`markdown`], how results
//! are drawn and written.

pub use drawing;
use signorini::named;
pub use signorini::{
    accuracy, algorithm, clock, condensation, contact, elasticity, error, measure, mesh, scene, solution, solve,
    stability, uncertainty,
};

pub mod case;
pub mod checkout;
pub mod cli;
pub mod markdown;
pub mod oracle;
pub mod referee;
pub mod report;
pub mod study;
