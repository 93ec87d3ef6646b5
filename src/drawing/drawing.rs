//! A finished figure, or why it cannot be drawn.

/// The SVG text of a figure, the same bytes for the same shapes; or what is told where it is written.
pub type Drawing = Result<String, Error>;

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

/// Whether a text is a drawing of this program.
pub fn is_drawing(text: &str) -> bool {
    text.starts_with("<svg font-family=\"sans-serif\" font-size=") && text.trim_end().ends_with("</svg>")
}
