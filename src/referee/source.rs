//! A file that is handed in, and how it is refused: as a whole, by a line of its text, or by the unit that it lacks.

use std::path::Path;

use crate::error::{Error, Located};
use crate::referee::units::Role;

/// A file with its text; none of one that is no text.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a> {
    /// The file.
    pub file: &'a Path,
    /// What stands in it.
    pub text: &'a str,
}

impl Source<'_> {
    /// What is wrong with the file as a whole.
    pub fn refused(&self, message: impl Into<String>, remedy: impl Into<String>) -> Error {
        Error::file(self.file, message, remedy)
    }

    /// What is wrong with a part of its text.
    pub fn at(&self, part: &str, message: impl Into<String>, remedy: impl Into<String>) -> Error {
        let begin = (part.as_ptr() as usize).saturating_sub(self.text.as_ptr() as usize).min(self.text.len());
        Error::at(Located::new((self.file, self.text), begin..begin + part.len()), message, remedy)
    }

    /// What turns numbers of a role into ours, by their unit; `what` has it. None is guessed.
    pub fn factor(&self, role: Role, what: &str, unit: Option<&str>) -> Result<f64, Error> {
        let remedy = || format!("give --unit {}=UNIT, with one of {}", role.name(), role.known_units());
        let unit = unit.ok_or_else(|| self.refused(format!("{what} has no unit"), remedy()))?;
        role.factor(unit).ok_or_else(|| self.refused(format!("the unit `{unit}` of {what} is not known"), remedy()))
    }
}
