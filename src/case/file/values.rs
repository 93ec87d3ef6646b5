//! Values of a file with their places.

use std::fmt;
use std::marker::PhantomData;
use std::ops::Deref;

use serde::de::value::MapAccessDeserializer;
use serde::de::{MapAccess, Visitor};
use serde::{Deserialize, Deserializer};
use toml::Spanned;

/// A number and its place.
pub type Number = Spanned<f64>;
/// A name and its place.
pub type Name = Spanned<String>;
/// Entries and the place of their list; how many they must be is told where they are read.
pub type List<T> = Spanned<Vec<T>>;
/// Two numbers and their places.
pub type Pair = List<Number>;

/// A table by its keys. A struct alone would be read from a list too, by position, and drop what is left over.
#[derive(Clone, Debug, Default)]
pub struct Keyed<T>(pub T);

impl<T> Deref for Keyed<T> {
    type Target = T;

    fn deref(&self) -> &T {
        &self.0
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Keyed<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Keys<T>(PhantomData<T>);
        impl<'de, T: Deserialize<'de>> Visitor<'de> for Keys<T> {
            type Value = Keyed<T>;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("a table with its keys, as in { key = value }")
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Self::Value, A::Error> {
                T::deserialize(MapAccessDeserializer::new(map)).map(Keyed)
            }
        }
        deserializer.deserialize_map(Keys(PhantomData))
    }
}
