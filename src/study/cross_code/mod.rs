//! The solver against other finite element codes on the same discrete problem.
//!
//! * `plan` — one trial per problem and code.
//! * `twin` — our discrete problem as it is handed over.
//! * `discrete` — ours beside what another code finds: agreement to round-off, a code check.
//! * `answers` — what the other codes answer, frozen or now.
//! * `renewal` — asking the codes now, and freezing what they answer (feature `python`).
//! * `judge` — the tolerances, each with its reason.
//! * `section` — the verdicts.

pub mod answers;
pub mod discrete;
pub mod judge;
mod plan;
#[cfg(feature = "python")]
pub mod renewal;
mod section;
pub mod twin;

use crate::study::about::About;

pub use discrete::Compared as Numbers;
pub use judge::judge;
#[cfg(feature = "python")]
pub use plan::live;
pub use plan::plan;
pub use section::{pictures, section};

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Against other codes: the same problem assembled twice",
    asked: "Whether other codes, given the same mesh, find the same numbers.",
    limits: "Errors of the mesh, of the supports and of the contact rows are common to all; independent codes share none of them.",
};
