//! What an error is about: a part of a scene, a place in a text file, a contact coordinate.

use std::fmt;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

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

/// A place in a text file.
#[derive(Clone, Debug)]
pub struct Located {
    /// The file.
    pub file: PathBuf,
    /// What it holds.
    pub text: String,
    /// The bytes of the place in it.
    pub place: Range<usize>,
}

impl Located {
    /// A place by its bytes, within the text.
    pub fn new((file, text): (&Path, &str), place: Range<usize>) -> Self {
        let [start, stop] = [place.start, place.end].map(|at| at.min(text.len()));
        Self { file: file.into(), text: text.into(), place: start..stop.max(start) }
    }
}

/// File and line, from 1.
impl fmt::Display for Located {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let before = &self.text.as_bytes()[..self.place.start];
        write!(f, "{}:{}", self.file.display(), 1 + before.iter().filter(|byte| **byte == b'\n').count())
    }
}

/// A contact coordinate: a length, printed in mm, or an angle, printed in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Coordinate {
    /// Along a straight path \[mm\].
    Length(f64),
    /// Along an arc \[rad\].
    Angle(f64),
}

impl Coordinate {
    /// The number itself \[mm, or rad on an arc\].
    pub fn value(self) -> f64 {
        match self {
            Self::Length(value) | Self::Angle(value) => value,
        }
    }
}

impl fmt::Display for Coordinate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // Six decimals, without the zeros at their end.
        let rounded = |x: f64| (1e6 * x).round() / 1e6 + 0.0;
        match self {
            Self::Length(length) => write!(f, "{} mm", rounded(*length)),
            Self::Angle(angle) => write!(f, "{}°", rounded(angle.to_degrees())),
        }
    }
}
