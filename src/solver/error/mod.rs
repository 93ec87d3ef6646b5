//! What was wrong, where, with the numbers and the remedy.
//!
//! * [`place`] — what an error is about.

pub mod place;

use std::fmt::Display;
use std::path::Path;

pub use place::{Coordinate, Located, Part, Place};

/// Wrong input or broken numerics; not converging is an [`Outcome`](crate::solution::Outcome), never an error.
#[derive(Clone, Debug, thiserror::Error)]
#[error("{}; {remedy}", self.finding())]
pub struct Error {
    /// What code tells apart.
    pub kind: Kind,
    /// What it is about.
    pub place: Place,
    /// What was found and what was expected, with the numbers.
    pub message: String,
    /// What to do.
    pub remedy: String,
}

impl Error {
    /// An error of no special kind.
    pub fn at(place: impl Into<Place>, message: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self { kind: Kind::Input, place: place.into(), message: message.into(), remedy: remedy.into() }
    }

    /// A value outside its range, from anything that prints.
    pub fn value(
        place: impl Into<Place>,
        key: &str,
        found: impl ToString,
        expected: impl AsRef<str>,
        remedy: impl Into<String>,
    ) -> Self {
        Self::at(place, format!("`{key}` = {}, but {}", found.to_string(), expected.as_ref()), remedy)
    }

    /// The message behind its place.
    pub fn finding(&self) -> String {
        match &self.place {
            Place::Nowhere => self.message.clone(),
            place => format!("{place}: {}", self.message),
        }
    }

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

/// What an error is, where code does something else about it than to print it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// Wrong input of any other kind.
    Input,
    /// A file that must be there is not.
    MissingFile,
    /// A cell turned inside out or of no area.
    DegenerateCell,
    /// A candidate stretch without an element of the first body.
    EmptyStretch,
    /// No spring is left to fix a body that only contact fixes.
    NoSpringLeft {
        /// Iterations made before.
        iterations: usize,
    },
    /// Initial springs that cannot be distinguished from the round-off of the stiffness they are added to.
    SpringsTooSoft,
    /// Nothing presses a body that only contact fixes.
    NothingPresses,
    /// Contact that reaches the end of the candidate surface.
    ContactBeyondCandidates {
        /// Contact coordinate of the last candidate.
        end: Coordinate,
        /// Contact coordinate of the deepest penetration beyond, and its depth \[mm\]; none where only the pressure,
        /// which rises towards the end, shows it.
        deepest: Option<(Coordinate, f64)>,
    },
    /// A mesh of more dofs than are allowed.
    TooManyDofs {
        /// Those it would have.
        dofs: usize,
    },
}

/// Refuses a value that is not finite and positive.
pub fn positive(place: &Place, key: &str, value: f64) -> Result<(), Error> {
    if value.is_finite() && value > 0.0 {
        return Ok(());
    }
    Err(Error::value(place, key, value, "a finite value above 0 is needed", "give a positive number"))
}

/// Likeness (Jaro, 0 to 1) from which on a name may have been meant; that of the command line's own suggestions.
const ALIKE: f64 = 0.7;

/// The known name most like a mistyped one; none where no name is like it.
pub fn nearest<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let name = name.to_lowercase();
    let alike = known.into_iter().map(|known| (strsim::jaro(&name, &known.to_lowercase()), known));
    alike.filter(|(likeness, _)| *likeness > ALIKE).max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, known)| known)
}

/// `did you mean …? ` before a remedy; nothing where no known name is like it.
pub fn meant<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    nearest(name, known).map_or_else(String::new, |nearest| format!("did you mean `{nearest}`? "))
}
