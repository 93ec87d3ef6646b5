//! The text of the files of a folder.

use std::fs;
use std::path::Path;

use crate::error::Error;

/// The text of a file that must be there.
pub(super) fn text_of(file: &Path, remedy: &str) -> Result<String, Error> {
    fs::read_to_string(file).map_err(|cause| match cause.kind() {
        std::io::ErrorKind::NotFound => Error::missing_file(file, remedy),
        _ => Error::unreadable(file, cause, remedy),
    })
}
