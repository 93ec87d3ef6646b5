//! How a run ended, in the words of recorded surveys.

use serde::{Deserialize, Serialize};

use crate::solution::Outcome;

/// How a run ended, as the maps colour it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Class {
    /// Within the limit of iterations.
    Converged,
    /// Stopped by its criterion, above the tolerance.
    Stopped,
    /// Not converged when the cap of iterations was reached.
    Capped,
    /// Returned to an earlier state.
    Cycling,
    /// The error grows without end, or is no number.
    Diverged,
    /// Nothing changes any more, and the error is above the tolerance.
    Stalled,
    /// No spring left to hold a body: the named error.
    Unsupported,
    /// Converged with contact beyond the candidates: the named error.
    Beyond,
}

impl Class {
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

    /// The class of an outcome.
    pub fn of(outcome: Outcome) -> Self {
        match outcome {
            Outcome::Converged => Self::Converged,
            Outcome::Stopped => Self::Stopped,
            Outcome::Capped => Self::Capped,
            Outcome::Cycling { .. } => Self::Cycling,
            Outcome::Diverged => Self::Diverged,
            Outcome::Stalled => Self::Stalled,
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
