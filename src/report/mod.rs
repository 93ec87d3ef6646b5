//! The page: `VALIDATION.md` and its charts, made from the findings of the suite and from nothing else.
//!
//! * [`page`] — the order of the sections.
//! * [`matrix`] — the verdict matrix, and verdicts by kind and by study.
//! * [`checks`] — requirement by requirement.
//! * [`decisions`] — misprints, decisions where the paper is silent, what is not covered, references.
//! * [`pictures`] — the charts by name.
//! * [`statements`] — the paper's statements, judged.
//! * [`record`] — what was judged, counted and stated, as tables; [`diff`] — what moved in them between two commits.
//! * [`files`] — writing, and comparing with what is committed.

pub mod checks;
pub mod decisions;
pub mod diff;
pub mod files;
pub mod matrix;
pub mod page;
pub mod pictures;
pub mod record;
pub mod statements;

pub use files::{difference, write};
pub use page::{Page, compose};
