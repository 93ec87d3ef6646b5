//! What was wrong, where, with the numbers and the remedy.
//!
//! * [`kind`] — the few kinds that code tells apart.
//! * [`place`] — what an error is about.
//! * [`located`] — a place in a text file.
//! * [`files`] — what is wrong with a file.
//! * [`coordinate`] — a contact coordinate as messages give it.
//! * [`mod@nearest`] — what a mistyped name may have meant.

pub mod coordinate;
pub mod files;
pub mod kind;
pub mod located;
pub mod nearest;
pub mod place;

pub use coordinate::Coordinate;
pub use kind::Kind;
pub use located::Located;
pub use nearest::meant;
pub use place::{Part, Place};

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
}
