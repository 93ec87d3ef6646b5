//! How a run ended: by the outcome of its iteration, or by the error that broke it off.

use crate::error::{Error, Kind};
use crate::named::named_enum;
use crate::solution::Outcome;
use crate::solve::Run;

named_enum! {
    /// How a run ended, in the words of records and legends, from good to bad.
    pub enum Ended {
        /// Within the limit of iterations.
        Converged = "converged",
        /// Stopped by its criterion, above the tolerance.
        Stopped = "stopped",
        /// Not converged when the cap of iterations was reached.
        Capped = "capped",
        /// Nothing changes any more, and the error is above the tolerance.
        Stalled = "stalled",
        /// Returned to an earlier state.
        Cycling = "cycling",
        /// The error grows without end, or is no number.
        Diverged = "diverged",
        /// No spring left to hold a body, or springs too soft to: the named error.
        Unsupported = "unsupported",
        /// Converged with contact beyond the candidates: the named error.
        Beyond = "beyond",
    }
}

impl Ended {
    /// How a run ended, and after how many iterations; the error where that is of the input, and not of an iteration.
    pub fn of(run: &Result<Run, Error>) -> Result<(Self, usize), Error> {
        let error = match run {
            Ok(run) => return Ok((run.solution.outcome.into(), run.solution.work.iterations)),
            Err(error) => error,
        };
        match error.kind {
            Kind::NoSpringLeft { iterations } => Ok((Self::Unsupported, iterations)),
            Kind::SpringsTooSoft => Ok((Self::Unsupported, 0)),
            Kind::ContactBeyondCandidates { .. } => Ok((Self::Beyond, 0)),
            _ => Err(error.clone()),
        }
    }
}

impl From<Outcome> for Ended {
    fn from(outcome: Outcome) -> Self {
        match outcome {
            Outcome::Converged => Self::Converged,
            Outcome::Stopped => Self::Stopped,
            Outcome::Capped => Self::Capped,
            Outcome::Cycling { .. } => Self::Cycling,
            Outcome::Diverged => Self::Diverged,
            Outcome::Stalled => Self::Stalled,
        }
    }
}
