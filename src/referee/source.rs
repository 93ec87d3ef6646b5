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

    /// What turns numbers of a role into ours, by the unit that the file says, `written`, or that --unit names; `what`
    /// has it. None is guessed, and where both are there they are one.
    pub fn factor(&self, role: Role, what: &str, written: Option<&str>, named: Option<&str>) -> Result<f64, Error> {
        let give = || format!("give --unit {}=UNIT, with one of {}", role.name(), role.known_units());
        if let Some([message, remedy]) = written.zip(named).and_then(|both| role.contradiction(what, both)) {
            return Err(self.refused(message, remedy));
        }
        let unit = written.or(named).ok_or_else(|| self.refused(format!("{what} has no unit"), give()))?;
        // What --unit says is none in place of what the file says.
        let correct = || format!("write a known one in its place; where it is no unit, {}", give());
        role.factor(unit).ok_or_else(|| self.refused(format!("the unit `{unit}` of {what} is not known"), correct()))
    }
}
