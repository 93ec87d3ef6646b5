//! The words and numbers of a Gmsh file, one after the other, with their places.

use std::borrow::Cow;
use std::ops::Range;

use crate::case::file::source::Source;
use crate::error::Error;

/// What to do with a file in which something else stands than there should.
const AGAIN: &str = "save it again as version 4.1, ASCII (Mesh.MshFileVersion = 4.1, Mesh.Binary = 0)";

/// How the numbers of a file are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Coding {
    /// As words.
    Text,
    /// As bytes, from the smallest on.
    Little,
    /// As bytes, from the largest on.
    Big,
}

/// Words of the file with their places.
pub(super) struct Words<'a> {
    /// The file, and its text where it is one.
    pub source: Source<'a>,
    /// What is read: the text, or all bytes of a binary file.
    pub bytes: &'a [u8],
    /// Where the next word is looked for.
    pub at: usize,
    /// How numbers are written.
    pub coding: Coding,
}

impl<'a> Words<'a> {
    /// The next word and its place; none at the end.
    pub fn next(&mut self) -> Option<(Cow<'a, str>, Range<usize>)> {
        let start = self.past_blanks();
        let rest = &self.bytes[start..];
        self.at = start + rest.iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len());
        let place = start..self.at;
        (!place.is_empty()).then(|| (String::from_utf8_lossy(&self.bytes[place.clone()]), place))
    }

    /// Where the next word begins, or the next number of binary data.
    pub fn begin(&mut self) -> usize {
        if self.coding == Coding::Text { self.past_blanks() } else { self.at }
    }

    fn past_blanks(&mut self) -> usize {
        let rest = &self.bytes[self.at..];
        self.at += rest.iter().position(|byte| !byte.is_ascii_whitespace()).unwrap_or(rest.len());
        self.at
    }

    /// Something wrong at a place; in binary files with its byte, as they have no lines.
    pub fn wrong(&self, place: Range<usize>, message: impl Into<String>, remedy: impl Into<String>) -> Error {
        match self.coding {
            Coding::Text => self.source.refused(place, message, remedy),
            _ => Error::file(self.source.file, format!("byte {}: {}", place.start, message.into()), remedy),
        }
    }

    /// Something wrong with what has been read since a place.
    pub fn refused(&self, begin: usize, message: String, remedy: impl Into<String>) -> Error {
        self.wrong(begin..self.at, message, remedy)
    }

    /// The next word as a number.
    pub fn number<T: std::str::FromStr>(&mut self, what: &str) -> Result<T, Error> {
        let Some((word, place)) = self.next() else { return Err(self.ended(what)) };
        let refused = |_| self.wrong(place.clone(), format!("`{}` is not {what}", shown(&word)), AGAIN);
        word.parse().map_err(refused)
    }

    /// A whole number: a word, or four bytes.
    pub fn whole(&mut self, what: &str) -> Result<i64, Error> {
        self.either(what, |bytes| i32::from_le_bytes(bytes).into())
    }

    /// A count, or the number of a node or element: a word, or eight bytes.
    pub fn count(&mut self, what: &str) -> Result<u64, Error> {
        self.either(what, u64::from_le_bytes)
    }

    /// The number of a node or element in version 2: a word, or four bytes.
    pub fn short_tag(&mut self, what: &str) -> Result<u64, Error> {
        self.either(what, |bytes| u32::from_le_bytes(bytes).into())
    }

    /// A real number: a word, or eight bytes.
    pub fn real(&mut self, what: &str) -> Result<f64, Error> {
        self.either(what, f64::from_le_bytes)
    }

    /// The next word, or what some bytes mean, from the smallest on.
    fn either<T: std::str::FromStr, const N: usize>(&mut self, what: &str, of: fn([u8; N]) -> T) -> Result<T, Error> {
        if self.coding == Coding::Text {
            return self.number(what);
        }
        let own = self.bytes.get(self.at..).and_then(|rest| rest.first_chunk::<N>()).copied();
        let mut own = own.ok_or_else(|| self.ended(what))?;
        self.at += N;
        if self.coding == Coding::Big {
            own.reverse();
        }
        Ok(of(own))
    }

    fn ended(&self, what: &str) -> Error {
        let end = self.bytes.len();
        self.wrong(end..end, format!("the file ends where {what} should stand"), AGAIN)
    }

    /// The rest of the line.
    pub fn line(&mut self) -> (Cow<'a, str>, Range<usize>) {
        let rest = &self.bytes[self.at..];
        let place = self.at..self.at + rest.iter().position(|byte| *byte == b'\n').map_or(rest.len(), |k| k + 1);
        self.at = place.end;
        (String::from_utf8_lossy(&self.bytes[place.clone()]), place)
    }

    /// What follows a name or a count begins in the next line where it is binary.
    pub fn begin_data(&mut self) {
        if self.coding != Coding::Text {
            self.line();
        }
    }

    /// The end of a section that was read: nothing stands before it.
    pub fn closed(&mut self, name: &str, place: Range<usize>) -> Result<(), Error> {
        let (begin, end) = (self.at, format!("$End{}", &name[1..]));
        match self.next() {
            Some((word, _)) if word == end => Ok(()),
            Some((word, place)) if !word.starts_with('$') => {
                let message = format!("`{}` stands behind the last row of `{name}`", shown(&word));
                Err(self.wrong(place, message, "the section counts fewer rows than it has: save the mesh again"))
            }
            _ => {
                self.at = begin;
                self.skip(name, place)
            }
        }
    }

    /// Where a section ends.
    pub fn end_of(&self, name: &str) -> Option<usize> {
        let end = format!("$End{}", &name[1..]);
        let found = self.bytes[self.at..].windows(end.len()).position(|window| window == end.as_bytes());
        found.map(|k| self.at + k + end.len())
    }

    /// Skips a section.
    pub fn skip(&mut self, name: &str, place: Range<usize>) -> Result<(), Error> {
        match self.end_of(name) {
            Some(end) => {
                self.at = end;
                Ok(())
            }
            None => {
                let message = format!("`{}` has no end", shown(name));
                Err(self.wrong(place, message, "the file is cut: save it again"))
            }
        }
    }
}

/// The beginning of a word that may be anything.
pub(super) fn shown(word: &str) -> String {
    word.chars().take(40).collect()
}
