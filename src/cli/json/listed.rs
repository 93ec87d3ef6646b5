//! A case of the library as JSON.

use schemars::JsonSchema;
use serde::Serialize;

use crate::case::library::NAMES;

/// A case of the library.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Listed {
    /// Its name, as `solve` takes it.
    name: &'static str,
    /// What it is.
    title: &'static str,
}

impl Listed {
    /// All of them.
    pub fn all() -> Vec<Self> {
        NAMES.map(|(name, title)| Self { name, title }).into()
    }
}
