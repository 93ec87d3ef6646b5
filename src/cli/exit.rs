//! How a command ended, as its exit code tells.

use std::process::ExitCode;

use crate::solve::Run;

/// The end of a command, from good to bad; wrong input is an [`Error`](crate::error::Error) and exits with 2.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Exit {
    /// All is well.
    Well = 0,
    /// A check failed.
    CheckFailed = 1,
    /// A run did not converge, or holds no contact.
    NotConverged = 3,
}

/// Exit code of wrong input, which is also that of a mistyped command.
pub const WRONG_INPUT: u8 = 2;

impl Exit {
    /// Well, or with a failed check.
    pub fn checked(passed: bool) -> Self {
        if passed { Self::Well } else { Self::CheckFailed }
    }

    /// How a run ended that is judged so by its checks.
    pub fn of(run: &Run, checks: Self) -> Self {
        if run.solution.converged() && !run.is_open() { checks } else { Self::NotConverged }
    }
}

impl From<Exit> for ExitCode {
    fn from(ended: Exit) -> Self {
        Self::from(ended as u8)
    }
}
