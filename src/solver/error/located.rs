//! A place in a text file.

use std::fmt;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// A place in a text file.
#[derive(Clone, Debug)]
pub struct Located {
    /// The file.
    pub file: PathBuf,
    /// What it holds.
    pub text: String,
    /// The bytes of the place in it.
    pub place: Range<usize>,
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
