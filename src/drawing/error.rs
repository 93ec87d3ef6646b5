//! A figure that cannot be drawn.

/// What cannot be drawn, why, and what to do.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("figure `{figure}`: {reason}; {remedy}")]
pub struct Error {
    /// Title of the figure.
    pub figure: String,
    /// What is wrong with it.
    pub reason: String,
    /// What to do.
    pub remedy: String,
}

impl Error {
    /// Of a figure, for a reason.
    pub(crate) fn of(figure: &str, reason: impl Into<String>, remedy: &str) -> Self {
        Self { figure: figure.into(), reason: reason.into(), remedy: remedy.into() }
    }
}
