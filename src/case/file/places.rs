//! Where things stand in a file, for mistakes that show only when the scene is meshed or solved.

use std::ops::Range;
use std::path::PathBuf;

use toml::Spanned;

use crate::case::file::tables::ContactTable;
use crate::error::{Error, Located};

/// Places of the bodies and of the contacts in a file.
#[derive(Clone, Debug)]
pub struct Places {
    /// The file.
    pub(super) file: PathBuf,
    /// Its text.
    pub(super) text: String,
    /// Names of the bodies with their places.
    pub(super) bodies: Vec<(String, Range<usize>)>,
    /// The contacts.
    pub(super) contacts: Vec<PlacesOfContact>,
    /// How it is to be solved; the contacts where the file does not say.
    pub(super) solve: Range<usize>,
    /// Initial stiffness of the springs; how it is to be solved where the file does not say.
    pub(super) stiffness: Range<usize>,
}

/// Places of one contact in a file.
#[derive(Clone, Debug)]
pub(super) struct PlacesOfContact {
    first: Range<usize>,
    second: Option<Range<usize>>,
    stretch: Range<usize>,
}

impl PlacesOfContact {
    pub(super) fn of(table: &ContactTable) -> Self {
        let second = table.second.as_ref().map(Spanned::span);
        Self { first: table.first.span(), second, stretch: table.stretch.span() }
    }
}

impl Places {
    /// The error with its line, where it is one of a body or of the contact.
    pub fn locate(&self, error: Error) -> Error {
        let Some(place) = self.of(&error) else { return error };
        let text = error.to_string();
        let (message, remedy) = text.rsplit_once("; ").unwrap_or((&text, "see tests/scenes/README.md"));
        Error::Located(Box::new(Located::new((&self.file, &self.text), place, message, remedy)))
    }

    fn of(&self, error: &Error) -> Option<Range<usize>> {
        match error {
            Error::DegenerateCell { body, .. }
            | Error::LooseMesh { body, .. }
            | Error::HeldRigidFace { body, .. }
            | Error::FreeMotion { body, .. }
            | Error::SingularStiffness { body, .. }
            | Error::ObliqueSupport { body, .. } => self.body(|name| name == body),
            Error::Unknown { place, .. } | Error::Value { place, .. } => {
                let body = self.body(|name| place.ends_with(&format!(", body `{name}`")));
                body.or_else(|| place.contains(" with ").then(|| self.solve.clone()))
            }
            Error::Combination { .. } => Some(self.solve.clone()),
            Error::SpringsTooSoft { .. } => Some(self.stiffness.clone()),
            Error::NoSpringLeft { .. } | Error::NothingPresses { .. } => {
                self.contacts.first().map(|at| at.first.clone())
            }
            Error::NotFacing { contact, .. } => self.contacts.get(*contact).and_then(|at| at.second.clone()),
            Error::EmptyStretch { contact, .. }
            | Error::SharedCandidate { contact, .. }
            | Error::ContactBeyondCandidates { contact, .. }
            | Error::ContactCutShort { contact, .. } => self.contacts.get(*contact).map(|at| at.stretch.clone()),
            _ => None,
        }
    }

    fn body(&self, is_it: impl Fn(&str) -> bool) -> Option<Range<usize>> {
        self.bodies.iter().find(|(name, _)| is_it(name)).map(|(_, place)| place.clone())
    }
}
