//! The text of a file.

use std::borrow::Cow;
use std::ops::Range;
use std::path::Path;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::error::{Error, Located};

/// The text in bytes: in UTF-8; in UTF-16, as which Windows marks it; or, where it has letters of neither, in Latin-1.
/// None where they are no text.
///
/// Lines end in CR alone where Excel for the Mac wrote them, and the file in Ctrl-Z where a program of DOS did, which
/// may fill its last block with them.
pub fn text_of(bytes: &[u8]) -> Option<Cow<'_, str>> {
    let words = |of: fn([u8; 2]) -> u16| bytes[2..].as_chunks().0.iter().map(|two| of(*two)).collect::<Vec<u16>>();
    let text: Cow<str> = match bytes {
        [0xFF, 0xFE, ..] => String::from_utf16(&words(u16::from_le_bytes)).ok()?.into(),
        [0xFE, 0xFF, ..] => String::from_utf16(&words(u16::from_be_bytes)).ok()?.into(),
        [0xEF, 0xBB, 0xBF, rest @ ..] | rest => {
            let own = &rest[..rest.iter().rposition(|byte| *byte != 0x1A).map_or(0, |last| last + 1)];
            match std::str::from_utf8(own) {
                Ok(text) => text.into(),
                Err(_) if own.iter().any(|byte| byte.is_ascii_control() && !byte.is_ascii_whitespace()) => return None,
                Err(_) => own.iter().map(|byte| char::from(*byte)).collect::<String>().into(),
            }
        }
    };
    // UTF-16 that Windows has not marked has every second byte 0.
    let text = Some(text).filter(|text| !text.contains('\0'))?;
    Some(if text.contains('\n') { text } else { text.replace('\r', "\n").into() })
}

/// The text of a file, to point into.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a> {
    /// The file.
    pub file: &'a Path,
    /// Its text.
    pub text: &'a str,
}

impl<'a> Source<'a> {
    /// What it holds, every value with its place.
    pub fn parsed(&self) -> Result<Spanned<DeValue<'a>>, toml::de::Error> {
        let table = DeTable::parse(self.text)?;
        Ok(Spanned::new(table.span(), DeValue::Table(table.into_inner())))
    }

    /// Something wrong at a place.
    pub fn refused(&self, place: Range<usize>, message: impl Into<String>, remedy: impl Into<String>) -> Error {
        Error::at(Located::new((self.file, self.text), place), message, remedy)
    }
}
