//! What an error is about.

use std::fmt;
use std::path::PathBuf;
use std::sync::Arc;

use super::Located;

/// What an error is about: data for whoever knows where that stands in a file, words for everyone else.
#[derive(Clone, Debug)]
pub enum Place {
    /// Nothing in particular.
    Nowhere,
    /// A scene, an option, a figure.
    Named(String),
    /// A body of a scene.
    Body {
        /// Its index.
        body: usize,
        /// Its name, with that of the scene; without spare capacity, since every result carries room for an error.
        name: Box<str>,
    },
    /// A load of a body.
    Load {
        /// Index of the body; short, since every result carries room for an error.
        body: u32,
        /// Index of the load in the body.
        load: u32,
        /// Name of the body, with that of the scene.
        name: Box<str>,
    },
    /// A contact of a scene.
    Contact {
        /// Its index.
        contact: usize,
        /// What of it.
        part: Part,
        /// Its name, or those of its bodies.
        name: Box<str>,
    },
    /// How a scene is solved: the scene, and the formulation where it is known.
    Solve(String),
    /// Initial stiffness of the springs between these bodies.
    Stiffness(String),
    /// A file or a folder.
    File(PathBuf),
    /// A place in a text file.
    Line(Arc<Located>),
}

/// What of a contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Part {
    /// Its first body.
    First,
    /// Its second body.
    Second,
    /// Its candidate stretch.
    Stretch,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Nowhere => Ok(()),
            Self::Named(name) | Self::Solve(name) | Self::Stiffness(name) => write!(f, "{name}"),
            Self::Body { name, .. } | Self::Load { name, .. } | Self::Contact { name, .. } => write!(f, "{name}"),
            Self::File(path) => write!(f, "`{}`", path.display()),
            Self::Line(located) => write!(f, "{located}"),
        }
    }
}

impl From<&Place> for Place {
    fn from(place: &Place) -> Self {
        place.clone()
    }
}

impl From<&str> for Place {
    fn from(name: &str) -> Self {
        Self::Named(name.into())
    }
}

impl From<Located> for Place {
    fn from(located: Located) -> Self {
        Self::Line(Arc::new(located))
    }
}
