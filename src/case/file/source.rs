//! The text of a file.

use std::ops::Range;
use std::path::Path;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::error::{Error, Located};

/// The text of a file, to point into.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a> {
    /// The file.
    pub file: &'a Path,
    /// Its text.
    pub text: &'a str,
}

impl<'a> Source<'a> {
    /// What it holds, every value with its place.
    pub fn parsed(&self) -> Result<Spanned<DeValue<'a>>, toml::de::Error> {
        let table = DeTable::parse(self.text)?;
        Ok(Spanned::new(table.span(), DeValue::Table(table.into_inner())))
    }

    /// Something wrong at a place.
    pub fn refused(&self, place: Range<usize>, message: impl Into<String>, remedy: impl Into<String>) -> Error {
        Error::at(Located::new((self.file, self.text), place), message, remedy)
    }
}
