//! What the user sees of a run: its outcome with its note, or an error with its remedy.

use std::fmt;

use serde::Serialize;

use crate::error::{Error, Kind};
use crate::solution::Outcome;
use crate::solve::Run;

/// How a run ended, as it was reported.
#[derive(Clone, Debug, Serialize)]
pub enum Seen {
    /// With a solution.
    Ended {
        /// How.
        outcome: Outcome,
        /// What must be known before it is quoted.
        notes: Vec<String>,
    },
    /// With an error.
    Refused(Refusal),
}

/// An error as it was reported.
#[derive(Clone, Debug, Serialize)]
pub struct Refusal {
    /// Which error.
    pub why: Why,
    /// What was wrong.
    pub message: String,
    /// What to do.
    pub remedy: String,
}

/// The errors that limits look for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Why {
    /// Every contact spring of a body that contact alone supports is open.
    NoSpringLeft,
    /// No load presses on such a body.
    NothingPresses,
    /// A cell is turned inside out.
    InvertedCell,
    /// The contact reaches the end of the candidate surface.
    BeyondCandidates,
    /// Another.
    Other,
}

impl Seen {
    /// What is seen of a result.
    pub(super) fn of(result: &Result<Run, Error>) -> Self {
        match result {
            Ok(run) => Self::Ended { outcome: run.solution.outcome, notes: run.notes(0) },
            Err(error) => Self::Refused(Refusal::of(error)),
        }
    }

    /// The error, if it is one.
    pub(super) fn refusal(&self) -> Option<&Refusal> {
        match self {
            Self::Refused(refusal) => Some(refusal),
            Self::Ended { .. } => None,
        }
    }

    /// Whether the run was refused for this reason.
    pub(super) fn is_refused(&self, why: Why) -> bool {
        self.refusal().is_some_and(|refusal| refusal.why == why)
    }

    /// Whether the run ended so.
    pub(super) fn is(&self, wanted: Outcome) -> bool {
        matches!(self, Self::Ended { outcome, .. } if *outcome == wanted)
    }

    /// Whether the run ended without a note.
    pub(super) fn is_unnoted(&self) -> bool {
        matches!(self, Self::Ended { notes, .. } if notes.is_empty())
    }
}

impl Refusal {
    fn of(error: &Error) -> Self {
        let why = match error.kind {
            Kind::NoSpringLeft { .. } => Why::NoSpringLeft,
            Kind::NothingPresses => Why::NothingPresses,
            Kind::DegenerateCell => Why::InvertedCell,
            Kind::ContactBeyondCandidates { .. } => Why::BeyondCandidates,
            _ => Why::Other,
        };
        Self { why, message: error.finding(), remedy: error.remedy.clone() }
    }

    /// The error that a result must be; an error that says so where it is none.
    pub(super) fn expected<T>(result: Result<T, Error>, what: &str) -> Result<Self, Error> {
        match result {
            Err(error) => Ok(Self::of(&error)),
            Ok(_) => Err(Error::at("limits", format!("{what} was accepted"), "it shall be refused")),
        }
    }
}

/// Message and remedy of what may not have been refused.
pub(super) fn told(refusal: Option<&Refusal>) -> [String; 2] {
    match refusal {
        Some(refusal) => [refusal.to_string(), refusal.remedy.clone()],
        None => ["no error".into(), "–".into()],
    }
}

impl fmt::Display for Seen {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Ended { outcome, notes } if notes.is_empty() => write!(f, "{outcome}"),
            Self::Ended { outcome, notes } => write!(f, "{outcome}, note: {}", notes.join("; ")),
            Self::Refused(refusal) => write!(f, "{refusal}"),
        }
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "error: {}", self.message)
    }
}
