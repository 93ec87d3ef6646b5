//! What is wrong with a file.

use std::fmt::Display;
use std::path::Path;

use super::{Error, Kind, Place};

impl Error {
    /// Something wrong with a file.
    pub fn file(file: &Path, message: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self::at(Place::File(file.into()), message, remedy)
    }

    /// A file that must be there is not.
    pub fn missing_file(file: &Path, remedy: impl Into<String>) -> Self {
        Self { kind: Kind::MissingFile, ..Self::file(file, "the file is missing", remedy) }
    }

    /// A file is there but cannot be read or parsed.
    pub fn unreadable(file: &Path, cause: impl Display, remedy: impl Into<String>) -> Self {
        Self::file(file, format!("cannot be read: {cause}"), remedy)
    }

    /// A file cannot be written.
    pub fn unwritable(file: &Path, cause: impl Display) -> Self {
        Self::file(file, format!("cannot be written: {cause}"), "check that the folder exists and may be written")
    }

    /// A key or column that must be there is not among those found.
    pub fn missing_key(file: &Path, key: &str, found: &str, remedy: impl Into<String>) -> Self {
        Self::file(file, format!("`{key}` is missing among {found}"), remedy)
    }

    /// A key, column or entry holds what cannot be accepted.
    pub fn refused(file: &Path, key: &str, found: impl Display, remedy: impl Into<String>) -> Self {
        Self::file(file, format!("`{key}` is {found}"), remedy)
    }
}
