//! Who read which figure, how, and what kind of curve it shows.

use std::path::Path;

use toml::Value;

use super::keys::{self, Key, Range, text_of};
use crate::error::Error;

/// Where the curves of a folder come from.
#[derive(Debug, Clone, PartialEq, Eq, serde::Deserialize, serde::Serialize)]
#[serde(deny_unknown_fields)]
pub struct Provenance {
    /// The publication the points were read from.
    pub citation: String,
    /// Who digitised the figures.
    pub digitised_by: String,
    /// With what, and how often, the figures were read.
    pub method: String,
    /// The curves, each in its own file.
    pub curves: Vec<CurveProvenance>,
}

/// Where one curve comes from.
#[derive(Debug, Clone, PartialEq, Eq, serde::Deserialize, serde::Serialize)]
#[serde(deny_unknown_fields)]
pub struct CurveProvenance {
    /// The CSV file in the same folder.
    pub file: String,
    /// Figure, and the curve in it by its legend.
    pub figure: String,
    /// The ticks used to calibrate both axes, with their units as printed.
    pub axis_calibration: String,
    /// What produced the curve.
    pub kind: Kind,
    /// Whose figure it was read off.
    pub hand: Hand,
}

/// What produced a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Deserialize, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// An experiment.
    Measured,
    /// Finite elements of another author.
    Fem,
}

/// Whose figure a curve was read off.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Deserialize, serde::Serialize)]
pub enum Hand {
    /// The original publication.
    #[serde(rename = "first hand")]
    FirstHand,
    /// The reproduction in the source paper's Figures 14 and 15.
    #[serde(rename = "read off Egert's figures")]
    ReadOffEgert,
}

const KEYS: [Key; 4] = [
    key("citation", "the publication the points were read from", Range::Text),
    key("digitised_by", "who digitised the figures", Range::Text),
    key("method", "with what, and how often, the figures were read", Range::Text),
    key("curves", "one `[[curves]]` table per CSV file", Range::Entries),
];

const CURVE_KEYS: [Key; 5] = [
    key("file", "the CSV file in the same folder", Range::Text),
    key("figure", "figure, and the curve in it by its legend", Range::Text),
    key("axis_calibration", "the ticks used on both axes, with units as printed", Range::Text),
    key("kind", "what produced the curve", Range::OneOf(&["measured", "fem"])),
    key("hand", "whose figure it was read off", Range::OneOf(&["first hand", "read off Egert's figures"])),
];

const fn key(path: &'static str, meaning: &'static str, range: Range) -> Key {
    Key { path, meaning, range }
}

impl Provenance {
    /// Reads `provenance.toml`, every key required.
    ///
    /// # Errors
    /// Names the key that is missing, unknown or out of range.
    pub fn read(file: &Path) -> Result<Self, Error> {
        let text = text_of(file, "say where the curves come from; see the README of the folder")?;
        let table = keys::parse(file, &text)?;
        keys::check(file, "", &table, &KEYS)?;
        let entries = table.get("curves").and_then(Value::as_array).into_iter().flatten();
        for (index, entry) in entries.filter_map(Value::as_table).enumerate() {
            keys::check(file, &format!("curves[{index}]."), entry, &CURVE_KEYS)?;
        }

        table.try_into().map_err(|cause: toml::de::Error| {
            Error::unreadable(file, cause.message(), "follow the example in the README of the folder")
        })
    }
}
