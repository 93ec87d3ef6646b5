//! The form of a scene file: which keys a table has, and what their values are.
//!
//! A file is held against its form before it is read, so that a mistake of form is told first, in the words of serde,
//! which reads the values; whoever reads a value finds it as its form says.

use std::fmt;
use std::ops::Range;

use serde::de::{DeserializeOwned, Deserializer, IgnoredAny, Visitor};
use serde_json::{Map, Value, json};
use toml::Spanned;
use toml::de::{DeTable, DeValue, ValueDeserializer};

/// What to do about a key.
pub(super) const DESCRIBED: &str = "add or correct it; tests/cases/README.md describes every key; see `contact-vv new`";

/// What a value may be.
pub(super) enum Form {
    /// A number.
    Number,
    /// A number of things.
    Count,
    /// A number from 0 to 255.
    Byte,
    /// A name, or words.
    Text,
    /// One of some words, which whoever reads it refuses.
    Word(fn() -> Vec<&'static str>),
    /// True or false.
    Flag,
    /// Entries of one form; how many they must be is told where they are read.
    List(&'static Form),
    /// A table with these keys.
    Table(&'static [Key]),
    /// A table with one of these keys: `{ disc = … }`.
    OneOf(&'static [(&'static str, Form)]),
    /// What has one of these forms, and a rule of its own.
    Own(&'static [Form], fn(&Spanned<DeValue>) -> Result<(), Mistake>),
}

/// A key of a table.
pub(super) struct Key {
    name: &'static str,
    needed: bool,
    form: Form,
    told: &'static str,
}

/// Where a file departs from its form, and how.
pub(super) type Mistake = (Range<usize>, String);

/// A point or a vector.
pub(super) const PAIR: Form = Form::List(&Form::Number);

/// A key that a table must have.
pub(super) const fn must(name: &'static str, form: Form) -> Key {
    Key { name, needed: true, form, told: "" }
}

/// A key that may be left out.
pub(super) const fn may(name: &'static str, form: Form) -> Key {
    Key { name, needed: false, form, told: "" }
}

impl Key {
    /// The same with what an editor tells of it.
    pub(super) const fn told(self, told: &'static str) -> Self {
        Self { told, ..self }
    }

    fn schema(&self) -> Value {
        let mut schema = self.form.schema();
        if !self.told.is_empty() {
            schema["description"] = self.told.into();
        }
        schema
    }
}

/// The names of a list of choices.
pub(super) fn names<T>(known: &[(&'static str, T)]) -> Vec<&'static str> {
    known.iter().map(|(name, _)| *name).collect()
}

impl Form {
    /// Refuses a value of another form.
    pub(super) fn check(&self, value: &Spanned<DeValue>) -> Result<(), Mistake> {
        match (self, value.get_ref()) {
            (Self::Number, _) => is::<f64>(value),
            (Self::Count, _) => is::<usize>(value),
            (Self::Byte, _) => is::<u8>(value),
            (Self::Text | Self::Word(_), _) => is::<String>(value),
            (Self::Flag, _) => is::<bool>(value),
            (Self::List(form), DeValue::Array(entries)) => entries.iter().try_for_each(|entry| form.check(entry)),
            (Self::List(_), _) => is::<Vec<IgnoredAny>>(value),
            (Self::Table(keys), DeValue::Table(table)) => check_keys(keys, table, value.span()),
            (Self::Table(_), _) => Err(unexpected(value, "a table with its keys, as in { key = value }")),
            (Self::OneOf(known), _) => check_choice(known, value),
            (Self::Own(_, check), _) => check(value),
        }
    }

    /// Its JSON Schema, for editors; what a rule of its own refuses is not in it.
    pub(super) fn schema(&self) -> Value {
        match self {
            Self::Number => json!({"type": "number"}),
            Self::Count => json!({"type": "integer", "minimum": 0}),
            Self::Byte => json!({"type": "integer", "minimum": 0, "maximum": u8::MAX}),
            Self::Text => json!({"type": "string"}),
            Self::Word(known) => json!({"type": "string", "enum": known()}),
            Self::Flag => json!({"type": "boolean"}),
            Self::List(form) => json!({"type": "array", "items": form.schema()}),
            Self::Table(keys) => {
                let needed: Vec<&str> = keys.iter().filter(|key| key.needed).map(|key| key.name).collect();
                let properties: Map<_, _> = keys.iter().map(|key| (key.name.to_owned(), key.schema())).collect();
                json!({"type": "object", "properties": properties, "required": needed, "additionalProperties": false})
            }
            Self::OneOf(known) => {
                let properties: Map<_, _> =
                    known.iter().map(|(name, form)| ((*name).to_owned(), form.schema())).collect();
                json!({
                    "type": "object", "properties": properties, "minProperties": 1, "maxProperties": 1,
                    "additionalProperties": false,
                })
            }
            Self::Own(forms, _) => json!({"anyOf": forms.iter().map(Self::schema).collect::<Vec<_>>()}),
        }
    }
}

fn check_keys(keys: &[Key], table: &DeTable, place: Range<usize>) -> Result<(), Mistake> {
    for (name, value) in table {
        let Some(key) = keys.iter().find(|key| key.name == name.get_ref()) else {
            return Err((name.span(), unknown("field", name.get_ref(), keys.iter().map(|key| key.name))));
        };
        key.form.check(value)?;
    }
    match keys.iter().find(|key| key.needed && !table.contains_key(key.name)) {
        Some(key) => Err((place, format!("missing field `{}`", key.name))),
        None => Ok(()),
    }
}

fn check_choice(known: &[(&str, Form)], value: &Spanned<DeValue>) -> Result<(), Mistake> {
    let wrong = |message: &str| Err((value.span(), message.into()));
    let names = || listed(known.iter().map(|(name, _)| *name));
    let form = |name: &str, place: Range<usize>| match known.iter().find(|(other, _)| *other == name) {
        Some((_, form)) => Ok(form),
        None => Err((place, unknown("variant", name, known.iter().map(|(name, _)| *name)))),
    };
    match value.get_ref() {
        DeValue::String(name) => {
            form(name, value.span())?;
            wrong("invalid type: unit variant, expected newtype variant")
        }
        DeValue::Table(table) => {
            let mut entries = table.iter();
            match (entries.next(), entries.next()) {
                (Some((name, value)), None) => form(name.get_ref(), name.span())?.check(value),
                (None, _) => wrong(&format!("one of {} is wanted here, and this is empty", names())),
                (Some(_), Some(_)) => {
                    table.keys().try_for_each(|name| form(name.get_ref(), name.span()).map(|_| ()))?;
                    let own = listed(table.keys().map(|name| name.get_ref().as_ref()));
                    wrong(&format!("one of {own} is wanted here, and not all of them"))
                }
            }
        }
        _ => wrong("wanted string or table"),
    }
}

/// Refuses what serde does not read as such a value.
fn is<T: DeserializeOwned>(value: &Spanned<DeValue>) -> Result<(), Mistake> {
    T::deserialize(ValueDeserializer::from(value.clone())).map(|_| ()).map_err(|error| mistake(value, &error))
}

/// A value of another kind than the one expected.
pub(super) fn unexpected(value: &Spanned<DeValue>, expected: &'static str) -> Mistake {
    struct Nothing(&'static str);
    impl Visitor<'_> for Nothing {
        type Value = Mistake;

        fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
            f.write_str(self.0)
        }
    }
    let refused = ValueDeserializer::from(value.clone()).deserialize_any(Nothing(expected));
    refused.unwrap_or_else(|error| mistake(value, &error))
}

fn mistake(value: &Spanned<DeValue>, error: &toml::de::Error) -> Mistake {
    (error.span().unwrap_or(value.span()), error.message().into())
}

/// Names as a message lists them.
pub(super) fn listed<'a>(names: impl IntoIterator<Item = &'a str>) -> String {
    names.into_iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}

/// A name that is none of those known.
pub(super) fn unknown<'a>(what: &str, name: &str, known: impl Iterator<Item = &'a str>) -> String {
    let known: Vec<&str> = known.collect();
    let expected = match known[..] {
        [one] => format!("`{one}`"),
        [one, other] => format!("`{one}` or `{other}`"),
        _ => format!("one of {}", listed(known)),
    };
    format!("unknown {what} `{name}`, expected {expected}")
}
