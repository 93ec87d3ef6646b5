//! A value of a scene file: what it holds in the units of the scene, and what is wrong with it, told with its place.

use std::ops::Range;

use serde::de::DeserializeOwned;
use toml::Spanned;
use toml::de::{DeValue, ValueDeserializer};

use crate::case::file::form::listed;
use crate::case::file::source::Source;
use crate::case::file::units::Units;
use crate::case::file::unsupported::Unsupported;
use crate::error::{Error, meant};

/// Characters of a list that a message shows.
const LONGEST_SHOWN: usize = 60;
/// Largest magnitude of a number in a file.
const LARGEST: f64 = 1e13;
/// Why a value can be read.
const CHECKED: &str = "the form of the file was checked";

/// A value of a scene file whose form was checked.
#[derive(Clone, Copy)]
pub(super) struct Value<'a> {
    /// The file.
    pub source: Source<'a>,
    /// Its units.
    pub units: Units,
    /// Key, as messages give it; that of its list for an entry.
    pub key: &'a str,
    held: &'a Spanned<DeValue<'a>>,
}

impl<'a> Value<'a> {
    /// All that a file holds.
    pub fn all(source: Source<'a>, held: &'a Spanned<DeValue<'a>>) -> Self {
        Self { source, units: Units::SCENE, key: "", held }
    }

    /// The same, in units.
    pub fn with(self, units: Units) -> Self {
        Self { units, ..self }
    }

    /// The value of a key; none where it is left out.
    pub fn get(self, key: &'a str) -> Option<Self> {
        let held = self.held.get_ref().as_table()?.get(key)?;
        Some(Self { key, held, ..self })
    }

    /// The value of a key that the table must have.
    pub fn at(self, key: &'a str) -> Self {
        self.get(key).expect(CHECKED)
    }

    /// A table of the file; where it is left out the bodies, at which its mistakes are told then: their list has none
    /// of its keys.
    pub fn table(self, key: &'a str) -> Self {
        self.get(key).unwrap_or(self.at("body"))
    }

    /// The first of some keys that is given.
    pub fn first<const N: usize>(self, keys: [&'a str; N]) -> Option<Self> {
        keys.into_iter().find_map(|key| self.get(key))
    }

    /// The value of a key where it is `true`.
    pub fn asked(self, key: &'a str) -> Option<Self> {
        self.get(key).filter(|given| given.read())
    }

    /// The key and the value of a table that has one.
    pub fn only(self) -> (&'a str, Self) {
        self.only_but("")
    }

    /// The only entry of a table, but for one key that may stand beside it.
    pub fn only_but(self, beside: &str) -> (&'a str, Self) {
        let mut entries = self.held.get_ref().as_table().into_iter().flat_map(|table| table.iter());
        let (key, held) = entries.find(|(key, _)| key.get_ref() != beside).expect(CHECKED);
        (key.get_ref(), Self { key: key.get_ref(), held, ..self })
    }

    /// What follows a key that its form does not have.
    pub fn unknown(self) -> ! {
        unreachable!("{CHECKED}, and `{}` is none of its keys", self.key)
    }

    /// The entries of a list.
    pub fn entries(self) -> Vec<Self> {
        let entries = self.held.get_ref().as_array().into_iter().flat_map(|list| list.iter());
        entries.map(|held| Self { held, ..self }).collect()
    }

    /// The entries of the list of a key; none where it is left out.
    pub fn list(self, key: &'a str) -> Vec<Self> {
        self.get(key).map_or_else(Vec::new, Self::entries)
    }

    /// The same under another key.
    pub fn called(self, key: &'a str) -> Self {
        Self { key, ..self }
    }

    /// What it holds.
    pub fn read<T: DeserializeOwned>(self) -> T {
        T::deserialize(ValueDeserializer::from(self.held.clone())).expect(CHECKED)
    }

    /// The number that it is, as it is written.
    pub fn number(self) -> f64 {
        self.read()
    }

    /// The name that it is.
    pub fn text(self) -> &'a str {
        self.word().expect(CHECKED)
    }

    /// The same; none where it is something else.
    pub fn word(self) -> Option<&'a str> {
        self.held.get_ref().as_str()
    }

    /// Where it stands.
    pub fn span(self) -> Range<usize> {
        self.held.span()
    }

    /// Something wrong with it.
    pub fn refused(self, message: impl Into<String>, remedy: impl Into<String>) -> Error {
        self.source.refused(self.span(), message, remedy)
    }

    /// Refuses it where something is wrong.
    pub fn refuse_if(self, is_wrong: bool, message: impl Into<String>, remedy: impl Into<String>) -> Result<(), Error> {
        Self::refuse(is_wrong.then_some(self), message, remedy)
    }

    /// Refuses a value where one is given.
    pub fn refuse(given: Option<Self>, message: impl Into<String>, remedy: impl Into<String>) -> Result<(), Error> {
        given.map_or(Ok(()), |given| Err(given.refused(message, remedy)))
    }

    /// What is wrong with the number that it is, or that was made of it.
    fn unlike(self, found: f64, expected: &str) -> Error {
        self.refused(format!("`{}` is {found}", self.key), format!("give {expected}"))
    }

    /// A number that is finite and passes a test.
    pub fn within(self, expected: &str, holds: impl Fn(f64) -> bool) -> Result<f64, Error> {
        let found = self.number();
        if found.is_finite() && holds(found) { Ok(found) } else { Err(self.unlike(found, expected)) }
    }

    /// A number above zero.
    pub fn positive(self) -> Result<f64, Error> {
        self.above_zero(self.number())
    }

    /// A number made of it, which must lie above zero.
    pub fn above_zero(self, found: f64) -> Result<f64, Error> {
        let [least, most] = [1.0 / LARGEST, LARGEST];
        if found >= least && found <= most {
            return Ok(found);
        }
        Err(self.unlike(found, &format!("a number above 0, from {least:e} to {most:e}")))
    }

    /// A number of things, one of them to the most; what more is to say of that follows.
    pub fn count(self, most: usize, more: &str) -> Result<usize, Error> {
        match self.read() {
            count if (1..=most).contains(&count) => Ok(count),
            count => Err(self.refused(format!("`{}` is {count}", self.key), format!("give 1 to {most}{more}"))),
        }
    }

    /// A length above zero \[mm\].
    pub fn length(self) -> Result<f64, Error> {
        Ok(self.units.length * self.positive()?)
    }

    /// A factor above 1, which may be infinite.
    pub fn factor(self) -> Result<f64, Error> {
        let found = self.number();
        if found > 1.0 { Ok(found) } else { Err(self.unlike(found, "a number above 1, or inf for none")) }
    }

    /// A number of a magnitude that squares and products survive.
    pub fn finite(self) -> Result<f64, Error> {
        self.within(&format!("a finite number below {LARGEST:e}"), |x| x.abs() <= LARGEST)
    }

    /// The entries of a list that must have so many.
    pub fn exactly<const N: usize>(self) -> Result<[Self; N], Error> {
        self.entries().try_into().map_err(|found: Vec<Self>| {
            let written: Vec<&str> = self.source.text.get(self.span()).unwrap_or_default().split_whitespace().collect();
            let shown: String = written.join(" ").chars().take(LONGEST_SHOWN).collect();
            self.refused(format!("`{}` is {shown}", self.key), format!("give {N} entries, not {}", found.len()))
        })
    }

    /// Two finite numbers.
    pub fn pair(self) -> Result<[f64; 2], Error> {
        let [x, y] = self.exactly()?;
        Ok([x.finite()?, y.finite()?])
    }

    /// A point \[mm\].
    pub fn point(self) -> Result<[f64; 2], Error> {
        Ok(self.pair()?.map(|x| self.units.length * x))
    }

    /// One of some names.
    pub fn choice<T: Copy>(self, what: &str, known: &[(&str, T)]) -> Result<T, Error> {
        let name = self.text();
        let found = known.iter().find(|(known, _)| *known == name);
        found.map(|(_, value)| *value).ok_or_else(|| {
            let asked = Unsupported::asked_by(name);
            let instead = asked.map_or_else(String::new, |asked| format!("; {}: {}", asked.holds, asked.instead));
            let meant = meant(name, known.iter().map(|(name, _)| *name));
            let remedy = format!("{meant}known: {}{instead}", listed(known.iter().map(|(name, _)| *name)));
            self.refused(format!("there is no {what} `{name}`"), remedy)
        })
    }
}
