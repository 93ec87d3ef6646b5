//! The scoreboard: exported cases solved by other codes, each with the contact it documents and with the best of its settings that were
//! tried, and judged from the files that they write.
//!
//! * `plan` — which cases; `setting` — which codes with which contact.
//! * `board` — what a live run leaves under `oracles/frozen/scoreboard`; `live` — that run.
//! * `run` — the frozen answers, judged.
//! * `judge` — whether they are read, are of the present scripts, and agree with the truths.
//! * `section` — a row a run; `picture` — error over seconds.

pub mod board;
mod judge;
pub mod live;
mod picture;
mod plan;
mod run;
mod section;
pub mod setting;

use crate::study::about::About;

pub use judge::judge;
pub use picture::pictures;
pub use plan::{CASES, named, plan};
pub use run::{Ended, Numbers, Row, Score, numbers, scored};
pub use section::section;

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Scoreboard of contact codes",
    asked: "How far other codes are from the truths of exported cases, with the contact they document and with the best setting tried.",
    limits: "One mesh a case, settings tried by us, seconds of one machine; another user may find better settings. Looked at and not asked: \
             FreeFEM, which leaves contact to an optimiser, MFEM's wheel, which has none, and Elmer and code_aster, which neither Debian 12 nor PyPI holds.",
};
