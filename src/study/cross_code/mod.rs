//! The solver against other finite element codes, in two senses.
//!
//! * [`discrete`] — the same discrete problem: agreement to round-off, a code check.
//! * [`physical`] — the same physical problem on another mesh: a benchmark; [`benchmark`] — its scenes.
//! * [`shown`] — what the page shows of it.
//! * [`answers`] — where the other codes' answers come from: frozen files, or the codes themselves.
//! * `renewal` — asking the codes now, and freezing what they answer (feature `python`).

pub mod answers;
pub mod benchmark;
pub mod discrete;
pub mod physical;
#[cfg(feature = "python")]
pub mod renewal;
pub mod shown;

use crate::study::unsorted::Trial;

pub use answers::Answers;

/// Name of the discrete trials.
pub const DISCRETE: &str = "same discrete problem";
/// Name of the physical trials.
pub const PHYSICAL: &str = "same physical problem";

/// All trials against frozen or live answers.
pub fn trials(answers: Answers) -> Vec<Trial> {
    let mut trials = discrete::trials(answers);
    trials.extend(physical::trials(answers));
    trials
}

/// The same with the codes themselves asked.
#[cfg(feature = "python")]
pub fn live() -> Vec<crate::study::Trial> {
    trials(Answers::Live)
        .into_iter()
        .map(|trial| trial.of(crate::study::Room::Unsorted, crate::study::Numbers::Unsorted))
        .collect()
}
