//! A place in a text file, and an error there as a terminal shows it.

use std::fmt;
use std::ops::Range;
use std::path::{Path, PathBuf};

use miette::{Diagnostic, NamedSource, SourceSpan};

use super::{Error, Place};

/// A place in a text file.
#[derive(Clone, Debug)]
pub struct Located {
    file: PathBuf,
    text: String,
    /// Its bytes.
    place: Range<usize>,
}

impl Located {
    /// A place by its bytes, within the text.
    pub fn new((file, text): (&Path, &str), place: Range<usize>) -> Self {
        let [start, stop] = [place.start, place.end].map(|at| at.min(text.len()));
        Self { file: file.into(), text: text.into(), place: start..stop.max(start) }
    }
}

/// File and line, from 1.
impl fmt::Display for Located {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let before = &self.text.as_bytes()[..self.place.start];
        write!(f, "{}:{}", self.file.display(), 1 + before.iter().filter(|byte| **byte == b'\n').count())
    }
}

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
