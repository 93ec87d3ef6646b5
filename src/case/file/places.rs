//! Where things stand in a file, for mistakes that show only when the scene is meshed or solved.

use std::ops::Range;
use std::path::PathBuf;

use toml::Spanned;

use crate::case::file::tables::ContactTable;
use crate::error::{Error, Located, Part, Place};

/// Places of the bodies and of the contacts in a file.
#[derive(Clone, Debug)]
pub struct Places {
    /// The file.
    pub(super) file: PathBuf,
    /// The meshes that it names.
    pub(super) meshes: Vec<PathBuf>,
    /// Its text.
    pub(super) text: String,
    /// The bodies.
    pub(super) bodies: Vec<Range<usize>>,
    /// The loads of each body.
    pub(super) loads: Vec<Vec<Range<usize>>>,
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

    fn part(&self, part: Part) -> Option<Range<usize>> {
        match part {
            Part::First => Some(self.first.clone()),
            Part::Second => self.second.clone(),
            Part::Stretch => Some(self.stretch.clone()),
        }
    }
}

impl Places {
    /// The file itself, and the meshes that it names.
    pub fn read(&self) -> impl Iterator<Item = &PathBuf> {
        std::iter::once(&self.file).chain(&self.meshes)
    }

    /// Text of the file.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The error with its line, where it is one of a body, of a load, of a contact or of how the scene is solved.
    pub fn locate(&self, error: Error) -> Error {
        match self.of(&error.place) {
            Some(place) => Error { place: Located::new((&self.file, &self.text), place).into(), ..error },
            None => error,
        }
    }

    fn of(&self, place: &Place) -> Option<Range<usize>> {
        match place {
            Place::Body { body, .. } => self.bodies.get(*body).cloned(),
            Place::Load { body, load, .. } => self.loads.get(*body as usize)?.get(*load as usize).cloned(),
            Place::Contact { contact, part, .. } => self.contacts.get(*contact)?.part(*part),
            Place::Solve(_) => Some(self.solve.clone()),
            Place::Stiffness(_) => Some(self.stiffness.clone()),
            Place::Nowhere | Place::Named(_) | Place::File(_) | Place::Line(_) => None,
        }
    }
}
