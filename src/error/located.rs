//! What is wrong at a place in a text file.

use std::ops::Range;
use std::path::Path;

use miette::{Diagnostic, NamedSource, SourceSpan};

/// A place in a text file, what is wrong there, and what to do.
#[derive(Debug, thiserror::Error, Diagnostic)]
#[error("{message}")]
pub struct Located {
    /// What was found and what was expected.
    message: String,
    /// What to do.
    #[help]
    remedy: String,
    /// Line of the place, from 1.
    line: usize,
    #[source_code]
    text: NamedSource<String>,
    #[label]
    place: SourceSpan,
}

impl Located {
    /// File, line, message and remedy in one line.
    pub fn in_one_line(&self) -> String {
        format!("{}:{}: {}; {}", self.text.name(), self.line, self.message, self.remedy)
    }

    /// A place by its bytes.
    pub fn new(
        (file, text): (&Path, &str),
        place: Range<usize>,
        message: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Self {
        let end = text.len();
        let (start, stop) = (place.start.min(end), place.end.min(end));
        Self {
            message: message.into(),
            remedy: remedy.into(),
            line: 1 + text.as_bytes()[..start].iter().filter(|byte| **byte == b'\n').count(),
            text: NamedSource::new(file.display().to_string(), text.to_owned()),
            place: (start..stop.max(start)).into(),
        }
    }
}
