//! Values of a file with their places.

use toml::Spanned;

/// A number and its place.
pub type Number = Spanned<f64>;
/// A name and its place.
pub type Name = Spanned<String>;
/// Entries and the place of their list; how many they must be is told where they are read.
pub type List<T> = Spanned<Vec<T>>;
/// Two numbers and their places.
pub type Pair = List<Number>;
