//! The solver against other finite element codes, in two senses.
//!
//! * `plan` — one trial per discrete problem and code, one per physical problem.
//! * `twin` — our discrete problem as it is handed over.
//! * `discrete` — the same discrete problem: agreement to round-off, a code check.
//! * `physical` — the same physical problem on another mesh, by an assembly twin; `benchmark` — its scenes.
//! * `answers` — where the other codes' answers come from: frozen files, or the codes themselves.
//! * `differences` — how far two answers are apart.
//! * `renewal` — asking the codes now, and freezing what they answer (feature `python`).
//! * `validation` — comparison errors, and what their uncertainties are made of.
//! * `judge` — the tolerances, each with its reason.
//! * `section`, `picture` — every code's numbers, the price of the penalty, the profiles.

pub mod answers;
pub mod benchmark;
pub mod differences;
pub mod discrete;
pub mod judge;
pub mod physical;
pub mod picture;
mod plan;
#[cfg(feature = "python")]
pub mod renewal;
pub mod section;
pub mod twin;
pub mod validation;

use serde::Serialize;

use crate::study::about::About;

pub use answers::Answers;
pub use judge::judge;
pub use picture::pictures;
#[cfg(feature = "python")]
pub use plan::live;
pub use plan::plan;
pub use section::section;

/// What a trial found.
#[derive(Clone, Debug, Serialize)]
pub enum Numbers {
    /// The same discrete problem in one code.
    Discrete(discrete::Compared),
    /// The same physical problem in every code.
    Physical(physical::Compared),
}

impl Numbers {
    /// Whether the codes themselves were asked.
    pub fn is_live(&self) -> bool {
        match self {
            Self::Discrete(compared) => compared.reproduced.is_some(),
            Self::Physical(compared) => compared.others.iter().any(|other| other.reproduced.is_some()),
        }
    }
}

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Against other codes: the same problem assembled twice",
    asked: "Whether other codes, given the same mesh or the same scene, find the same numbers.",
    limits: "The assembly twin shares its meshes, contact and measures between both codes: it counts as one.",
};
