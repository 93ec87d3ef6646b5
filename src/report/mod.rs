//! The report: `VALIDATION.md`, the pages behind it and their charts, made from the findings of the suite and from
//! nothing else.
//!
//! * [`page`] — the whole of it, or one page; writing, and comparing with what is committed.
//! * [`front`] — the front page.
//! * [`case_page`], [`study_page`] — a page a case, and a study.
//! * [`links`] — of texts that are read elsewhere than at the root, and what every page behind the front page begins
//!   with; [`symbols`] — what letters stand for.
//! * [`matrix`] — the verdict matrix, and verdicts by kind.
//! * [`checks`] — requirement by requirement; [`told`] — what became of checks, in a sentence.
//! * [`pictures`] — the charts by name.
//! * [`statements`] — the paper's statements, judged from the numbers of all studies: the first part of the page on the
//!   paper.
//! * [`record`] — what was judged, counted and stated, as tables; [`diff`] — what moved in them between two commits.

pub mod case_page;
pub mod checks;
pub mod diff;
pub mod front;
pub mod links;
pub mod matrix;
pub mod page;
pub mod pictures;
pub mod record;
pub mod statements;
pub mod study_page;
pub mod symbols;
pub mod told;

pub use crate::study::grouped;
pub use page::{Only, compose, difference, write};
