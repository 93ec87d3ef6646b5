//! How a run ended: by the outcome of its iteration, or by the error that broke it off.

use serde::{Deserialize, Serialize};

use crate::error::{Error, Kind};
use crate::solution::Outcome;
use crate::solve::Run;

/// How a run ended, in the words of records and legends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Ended {
    /// Within the limit of iterations.
    Converged,
    /// Stopped by its criterion, above the tolerance.
    Stopped,
    /// Not converged when the cap of iterations was reached.
    Capped,
    /// Nothing changes any more, and the error is above the tolerance.
    Stalled,
    /// Returned to an earlier state.
    Cycling,
    /// The error grows without end, or is no number.
    Diverged,
    /// No spring left to hold a body, or springs too soft to: the named error.
    Unsupported,
    /// Converged with contact beyond the candidates: the named error.
    Beyond,
}

impl Ended {
    /// All, from good to bad.
    pub const ALL: [Self; 8] = [
        Self::Converged,
        Self::Stopped,
        Self::Capped,
        Self::Stalled,
        Self::Cycling,
        Self::Diverged,
        Self::Unsupported,
        Self::Beyond,
    ];

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

    /// Name in records and legends.
    pub fn name(self) -> &'static str {
        match self {
            Self::Converged => "converged",
            Self::Stopped => "stopped",
            Self::Capped => "capped",
            Self::Cycling => "cycling",
            Self::Diverged => "diverged",
            Self::Stalled => "stalled",
            Self::Unsupported => "unsupported",
            Self::Beyond => "beyond",
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
