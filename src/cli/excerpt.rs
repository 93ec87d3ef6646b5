//! An error in a text file as a terminal shows it.

use miette::{Diagnostic, NamedSource, SourceSpan};

use crate::error::{Error, Place};

/// An error in a text file with the lines around it.
#[derive(Debug, thiserror::Error, Diagnostic)]
#[error("{message}")]
pub struct Excerpt {
    message: String,
    #[help]
    remedy: String,
    #[source_code]
    text: NamedSource<String>,
    #[label]
    place: SourceSpan,
}

impl Excerpt {
    /// The excerpt of an error; none where it is not in a text file.
    pub fn of(error: &Error) -> Option<Self> {
        let Place::Line(located) = &error.place else { return None };
        Some(Self {
            message: error.message.clone(),
            remedy: error.remedy.clone(),
            text: NamedSource::new(located.file.display().to_string(), located.text.clone()),
            place: located.place.clone().into(),
        })
    }
}
