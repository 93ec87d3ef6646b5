//! The paper leaves open how stiffnesses are changed, what has one, when a run ends and when it is given up. Here every
//! reading of it is tried, and held against its sentences.
//!
//! * `axes` — what is open.
//! * `course` — iterations from every start, and when each criterion would have stopped them: what is recorded.
//! * `courses` — the record, by what it is of.
//! * `reading` — one choice on every axis, and the runs under it.
//! * `sentence` — what the paper says, and whether it holds under a reading.
//! * `evidence` — the numbers that it rests on.
//! * `map` — all sentences under all readings.
//! * `trial` — the best readings on meshes that they were not chosen by.
//! * `plan`, `run`, `judge`, `section`, `picture` — as in every study.

pub mod axes;
pub mod course;
pub mod courses;
pub mod evidence;
pub mod judge;
pub mod map;
mod picture;
mod plan;
pub mod reading;
pub mod run;
mod section;
pub mod sentence;
pub mod trial;

/// Name of the command that surveys it, and of its record.
pub const NAME: &str = "readings";

use crate::study::about::About;

pub use judge::judge;
pub use picture::pictures;
pub use plan::plan;
pub use run::Numbers;
pub use section::section;

/// What its page is called, what it asks, and what it cannot tell.
pub const ABOUT: About = About {
    title: "The paper under every reading",
    asked: "Which of the paper's sentences hold, whatever is read into what it leaves open.",
    limits: "A reading that nobody thought of is not tried.",
};
