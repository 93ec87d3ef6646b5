//! The words of a Gmsh file, one after the other, with their places.

use std::ops::Range;

use crate::case::file::source::Source;
use crate::error::Error;

/// Words of the file with their places.
pub(super) struct Words<'a> {
    /// The file.
    pub source: Source<'a>,
    /// Where the next word is looked for.
    pub at: usize,
}

impl<'a> Words<'a> {
    /// The next word and its place; none at the end.
    pub fn next(&mut self) -> Option<(&'a str, Range<usize>)> {
        let start = self.begin();
        let rest = &self.source.text[start..];
        self.at = start + rest.find(char::is_whitespace).unwrap_or(rest.len());
        let place = start..self.at;
        (!place.is_empty()).then(|| (&self.source.text[place.clone()], place))
    }

    /// Where the next word begins.
    pub fn begin(&mut self) -> usize {
        let rest = &self.source.text[self.at..];
        self.at += rest.find(|c: char| !c.is_whitespace()).unwrap_or(rest.len());
        self.at
    }

    /// Something wrong with what has been read since a place.
    pub fn refused(&self, begin: usize, message: String, remedy: impl Into<String>) -> Error {
        self.source.refused(begin..self.at, message, remedy)
    }

    /// The next word as a number.
    pub fn number<T: std::str::FromStr>(&mut self, what: &str) -> Result<T, Error> {
        let remedy = "save it again as version 4.1, ASCII (Mesh.MshFileVersion = 4.1, Mesh.Binary = 0)";
        let Some((word, place)) = self.next() else {
            let end = self.source.text.len();
            return Err(self.source.refused(end..end, format!("the file ends where {what} should stand"), remedy));
        };
        let refused = |_| self.source.refused(place.clone(), format!("`{}` is not {what}", shown(word)), remedy);
        word.parse().map_err(refused)
    }

    /// A coordinate.
    pub fn coordinate(&mut self, what: &str) -> Result<f64, Error> {
        let begin = self.begin();
        let value: f64 = self.number(what)?;
        if value.is_finite() && value.abs() <= 1e13 {
            return Ok(value);
        }
        Err(self.refused(begin, format!("{what} is {value}"), "repair the mesh"))
    }

    /// The rest of the line.
    pub fn line(&mut self) -> (&'a str, Range<usize>) {
        let rest = &self.source.text[self.at..];
        let end = self.at + rest.find('\n').map_or(rest.len(), |k| k + 1);
        let place = self.at..end;
        self.at = end;
        (&self.source.text[place.clone()], place)
    }

    /// Skips a section.
    pub fn skip(&mut self, name: &str, place: Range<usize>) -> Result<(), Error> {
        let end = format!("$End{}", &name[1..]);
        match self.source.text[self.at..].find(&end) {
            Some(k) => {
                self.at += k + end.len();
                Ok(())
            }
            None => {
                let message = format!("`{}` has no end", shown(name));
                Err(self.source.refused(place, message, "the file is cut: save it again"))
            }
        }
    }
}

/// The beginning of a word that may be anything.
pub(super) fn shown(word: &str) -> String {
    word.chars().take(40).collect()
}
