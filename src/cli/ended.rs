//! How a command ended, as its exit code tells.

use std::process::ExitCode;

use crate::solve::Run;

/// The end of a command, from good to bad; wrong input is an [`Error`](crate::error::Error) and exits with 2.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Ended {
    /// All is well: 0.
    Well,
    /// A check failed: 1.
    CheckFailed,
    /// A run did not converge, or holds no contact: 3.
    NotConverged,
}

/// Exit code of wrong input, which is also that of a mistyped command.
pub const WRONG_INPUT: u8 = 2;

impl Ended {
    /// Well, or with a failed check.
    pub fn checked(passed: bool) -> Self {
        if passed { Self::Well } else { Self::CheckFailed }
    }

    /// How a run ended that is judged so by its checks.
    pub fn of(run: &Run, checks: Self) -> Self {
        let no_contact = run.contacts.iter().all(|contact| contact.open == Some(true));
        if run.solution.converged() && !no_contact { checks } else { Self::NotConverged }
    }
}

impl From<Ended> for ExitCode {
    fn from(ended: Ended) -> Self {
        match ended {
            Ended::Well => Self::SUCCESS,
            Ended::CheckFailed => Self::from(1),
            Ended::NotConverged => Self::from(3),
        }
    }
}
