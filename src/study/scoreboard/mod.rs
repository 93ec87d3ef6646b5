//! The scoreboard: exported cases solved by other codes, each with the contact it documents and with the best of its settings that were
//! tried, and judged from the files that they write.
//!
//! A folder, since asking the codes, keeping what they write and judging it are three things.
//!
//! * `setting` — which codes with which contact.
//! * `board` — what a live run leaves under `oracles/frozen/scoreboard`; `live` — that run.
//! * `run` — which cases; the frozen answers, scored and judged.
//! * `section` — a row a run, and error over seconds.

pub mod board;
pub mod live;
mod run;
mod section;
pub mod setting;

use crate::study::about::About;

pub use run::{CASES, Numbers, Row, Score, Scored, judge, named, numbers, plan, scored};
pub use section::{pictures, section};

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "Scoreboard of contact codes",
    asked: "How far other codes are from the truths of exported cases, with the contact they document and with the best setting tried.",
    limits: "One mesh a case, settings tried by us, seconds of one machine; another user may find better settings. Looked at and not asked: \
             FreeFEM, which leaves contact to an optimiser, MFEM's wheel, which has none, and Elmer and code_aster, which neither Debian 12 nor PyPI holds.",
};
