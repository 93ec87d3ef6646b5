//! The text of a file: its values checked, and what is wrong told with its place.

use std::ops::Range;
use std::path::Path;

use toml::Spanned;

use crate::case::file::unsupported::Unsupported;
use crate::case::file::values::{List, Pair};
use crate::error::{Error, Located, meant};

/// Characters of a list that a message shows.
const LONGEST_SHOWN: usize = 60;
/// Largest magnitude of a number in a file.
const LARGEST: f64 = 1e13;

/// The text of a file, to point into.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a> {
    /// The file.
    pub file: &'a Path,
    /// Its text.
    pub text: &'a str,
}

impl Source<'_> {
    /// Something wrong at a place.
    pub fn refused(&self, place: Range<usize>, message: impl Into<String>, remedy: impl Into<String>) -> Error {
        Error::at(Located::new((self.file, self.text), place), message, remedy)
    }

    /// A number that is finite and passes a test.
    pub fn number(
        &self,
        key: &str,
        value: &Spanned<f64>,
        expected: &str,
        holds: impl Fn(f64) -> bool,
    ) -> Result<f64, Error> {
        let found = *value.get_ref();
        if found.is_finite() && holds(found) {
            return Ok(found);
        }
        Err(self.refused(value.span(), format!("`{key}` is {found}"), format!("give {expected}")))
    }

    /// A number above zero.
    pub fn positive(&self, key: &str, value: &Spanned<f64>) -> Result<f64, Error> {
        let [least, most] = [1.0 / LARGEST, LARGEST];
        self.number(key, value, &format!("a number above 0, from {least:e} to {most:e}"), |x| x >= least && x <= most)
    }

    /// A factor above 1, which may be infinite.
    pub fn factor(&self, key: &str, value: &Spanned<f64>) -> Result<f64, Error> {
        let found = *value.get_ref();
        if found > 1.0 {
            return Ok(found);
        }
        Err(self.refused(
            value.span(),
            format!("`{key}` is {found}"),
            "give a number above 1, or inf for none".to_string(),
        ))
    }

    /// A number of a magnitude that squares and products survive.
    pub fn finite(&self, key: &str, value: &Spanned<f64>) -> Result<f64, Error> {
        self.number(key, value, &format!("a finite number below {LARGEST:e}"), |x| x.abs() <= LARGEST)
    }

    /// The entries of a list that must have so many.
    pub fn entries<'a, T, const N: usize>(&self, key: &str, list: &'a List<T>) -> Result<&'a [T; N], Error> {
        list.get_ref().as_slice().try_into().map_err(|_| {
            let written: Vec<&str> = self.text.get(list.span()).unwrap_or_default().split_whitespace().collect();
            let shown: String = written.join(" ").chars().take(LONGEST_SHOWN).collect();
            let remedy = format!("give {N} entries, not {}", list.get_ref().len());
            self.refused(list.span(), format!("`{key}` is {shown}"), remedy)
        })
    }

    /// A point or a vector.
    pub fn pair(&self, key: &str, value: &Pair) -> Result<[f64; 2], Error> {
        let [x, y] = self.entries(key, value)?;
        Ok([self.finite(key, x)?, self.finite(key, y)?])
    }

    /// One of some names.
    pub fn choice<T: Copy>(&self, what: &str, name: &Spanned<String>, known: &[(&str, T)]) -> Result<T, Error> {
        let found = known.iter().find(|(known, _)| known == name.get_ref());
        found.map(|(_, value)| *value).ok_or_else(|| {
            let names: Vec<String> = known.iter().map(|(name, _)| format!("`{name}`")).collect();
            let asked = Unsupported::asked_by(name.get_ref());
            let instead = asked.map_or_else(String::new, |asked| format!("; {}: {}", asked.holds, asked.instead));
            let meant = meant(name.get_ref(), known.iter().map(|(name, _)| *name));
            let remedy = format!("{meant}known: {}{instead}", names.join(", "));
            self.refused(name.span(), format!("there is no {what} `{}`", name.get_ref()), remedy)
        })
    }
}
