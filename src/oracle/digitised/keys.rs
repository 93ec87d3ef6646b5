//! Files that must be there, and required TOML keys, refused by name where they are missing, unknown or out of range.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use toml::{Table, Value};

use crate::error::Error;

/// A key that must be there, what it means, and what it may hold.
pub(super) type Key = (&'static str, &'static str, Range);

/// What a key may hold.
pub(super) enum Range {
    Positive,
    NonNegative,
    Poisson,
    Text,
    OneOf(&'static [&'static str]),
    Entries,
}

impl Range {
    fn admits(&self, value: &Value) -> bool {
        let number = number(value);
        match self {
            Self::Positive => number.is_finite() && number > 0.0,
            Self::NonNegative => number.is_finite() && number >= 0.0,
            Self::Poisson => number > -1.0 && number < 0.5,
            Self::Text => value.as_str().is_some_and(|text| !text.trim().is_empty()),
            Self::OneOf(words) => value.as_str().is_some_and(|text| words.contains(&text)),
            Self::Entries => {
                value.as_array().is_some_and(|entries| !entries.is_empty() && entries.iter().all(Value::is_table))
            }
        }
    }

    fn wanted(&self) -> String {
        match self {
            Self::Positive => "a finite number above 0".to_owned(),
            Self::NonNegative => "a finite number, 0 or above".to_owned(),
            Self::Poisson => "a number above -1 and below 0.5".to_owned(),
            Self::Text => "a text that is not empty".to_owned(),
            Self::OneOf(words) => format!("one of \"{}\"", words.join("\", \"")),
            Self::Entries => "one or more tables".to_owned(),
        }
    }
}

/// The table in a TOML text, syntax checked only.
pub(super) fn parse(file: &Path, text: &str) -> Result<Table, Error> {
    let remedy = "write it as TOML; the README of the folder has an example";
    text.parse().map_err(|cause: toml::de::Error| Error::unreadable(file, cause.message(), remedy))
}

/// Holds a table against its keys: all there, all in range, no other.
///
/// `prefix` is what the reader sees before each key, such as `curves[0].`.
pub(super) fn check(file: &Path, prefix: &str, table: &Table, keys: &[Key]) -> Result<(), Error> {
    for (path, meaning, range) in keys {
        let name = format!("{prefix}{path}");
        let wanted = format!("{meaning}, {}", range.wanted());
        let missing = || Error::missing_key(file, &name, &listed(&leaves("", table)), format!("add it: {wanted}"));
        let value = find(table, path).ok_or_else(missing)?;
        if !range.admits(value) {
            return Err(Error::refused(file, &name, shown(value), format!("write {wanted}")));
        }
    }
    refuse_unknown(file, prefix, table, keys)
}

fn refuse_unknown(file: &Path, prefix: &str, table: &Table, keys: &[Key]) -> Result<(), Error> {
    let present = leaves("", table);
    let Some(unknown) = present.iter().find(|path| keys.iter().all(|(key, ..)| key != path)) else {
        return Ok(());
    };
    let known: Vec<String> = keys.iter().map(|(key, ..)| (*key).to_owned()).collect();
    let remedy = format!("take it out or correct its name; known are {}", listed(&known));
    Err(Error::refused(file, &format!("{prefix}{unknown}"), "not a known key", remedy))
}

/// A number; NaN of what is none. A length of more than 2^53 mm is not written by hand.
fn number(value: &Value) -> f64 {
    value.as_float().or(value.as_integer().map(|number| number as f64)).unwrap_or(f64::NAN)
}

/// The numbers of a table that is held against its keys, each of a number, by these.
pub(super) fn numbers(file: &Path, table: &Table, keys: &[Key]) -> Result<BTreeMap<&'static str, f64>, Error> {
    check(file, "", table, keys)?;
    Ok(keys.iter().filter_map(|(path, ..)| Some((*path, number(find(table, path)?)))).collect())
}

fn find<'t>(table: &'t Table, path: &str) -> Option<&'t Value> {
    match path.split_once('.') {
        Some((head, rest)) => find(table.get(head)?.as_table()?, rest),
        None => table.get(path),
    }
}

fn leaves(prefix: &str, table: &Table) -> Vec<String> {
    table
        .iter()
        .flat_map(|(name, value)| match value {
            Value::Table(inner) => leaves(&format!("{prefix}{name}."), inner),
            _ => vec![format!("{prefix}{name}")],
        })
        .collect()
}

fn shown(value: &Value) -> String {
    match value {
        Value::String(text) => format!("\"{text}\""),
        Value::Integer(number) => number.to_string(),
        Value::Float(number) => number.to_string(),
        other => format!("of type {}", other.type_str()),
    }
}

/// Names in one line, or "nothing".
pub(super) fn listed(names: &[String]) -> String {
    if names.is_empty() { "nothing".to_owned() } else { names.join(", ") }
}

/// The text of a file that must be there.
pub(super) fn text_of(file: &Path, remedy: &str) -> Result<String, Error> {
    fs::read_to_string(file).map_err(|cause| match cause.kind() {
        std::io::ErrorKind::NotFound => Error::missing_file(file, remedy),
        _ => Error::unreadable(file, cause, remedy),
    })
}
