//! Where things stand in a file, for mistakes that show only when the scene is meshed or solved.

use std::ops::Range;
use std::path::PathBuf;

use crate::case::file::source::Source;
use crate::case::file::value::Value;
use crate::case::file::{contact, mesh_file};
use crate::error::{Error, Located, Part, Place};

/// The text of a file, in which a place is looked for when it is asked for.
#[derive(Clone, Debug)]
pub struct Places {
    file: PathBuf,
    /// The meshes that it names.
    meshes: Vec<PathBuf>,
    text: String,
}

impl Places {
    /// Those of a file.
    pub(super) fn of(file: Value) -> Self {
        let shapes = file.list("body").into_iter().map(|body| body.at("shape"));
        let mesh = |shape: Value<'_>| mesh_file::SHAPES.iter().find_map(|name| Some(mesh_file::path(shape.get(name)?)));
        Self { file: file.source.file.into(), meshes: shapes.filter_map(mesh).collect(), text: file.source.text.into() }
    }

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
        match self.find(&error.place) {
            Some(place) => Error { place: Located::new((&self.file, &self.text), place).into(), ..error },
            None => error,
        }
    }

    fn find(&self, place: &Place) -> Option<Range<usize>> {
        let source = Source { file: &self.file, text: &self.text };
        let parsed = source.parsed().ok()?;
        let file = Value::all(source, &parsed);
        let body = |index: usize| file.list("body").get(index).copied();
        let solve = file.get("solve");
        let found = match place {
            Place::Body { body: index, .. } => body(*index)?.at("name"),
            Place::Load { body: index, load, .. } => *body(*index as usize)?.list("loads").get(*load as usize)?,
            Place::Contact { contact, part, .. } => {
                contact::tables(file.at("contact")).get(*contact)?.get(match part {
                    Part::First => "first",
                    Part::Second => "second",
                    Part::Stretch => "stretch",
                })?
            }
            // The contacts where the file does not say how it is solved.
            Place::Solve(_) => solve.unwrap_or(file.at("contact")),
            Place::Stiffness(_) => solve.map_or(file.at("contact"), |solve| solve.get("stiffness").unwrap_or(solve)),
            Place::Nowhere | Place::Named(_) | Place::File(_) | Place::Line(_) => return None,
        };
        Some(found.span())
    }
}
