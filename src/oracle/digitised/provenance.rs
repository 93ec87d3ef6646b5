//! Who read which figure, how, and what kind of curve it shows.

use std::collections::BTreeMap;
use std::path::Path;

use toml::Value;

use super::keys::{self, Key, Range, text_of};
use crate::error::Error;

/// Where one curve comes from, by the keys of its table `[[curves]]`: the CSV `file` in the same folder, `figure`,
/// `axis_calibration`, `kind` and `hand`.
pub type CurveProvenance = BTreeMap<String, String>;

const KEYS: [Key; 4] = [
    ("citation", "the publication the points were read from", Range::Text),
    ("digitised_by", "who digitised the figures", Range::Text),
    ("method", "with what, and how often, the figures were read", Range::Text),
    ("curves", "one `[[curves]]` table per CSV file", Range::Entries),
];

const CURVE_KEYS: [Key; 5] = [
    ("file", "the CSV file in the same folder", Range::Text),
    ("figure", "figure, and the curve in it by its legend", Range::Text),
    ("axis_calibration", "the ticks used on both axes, with units as printed", Range::Text),
    ("kind", "what produced the curve", Range::OneOf(&["measured", FEM])),
    ("hand", "whose figure it was read off", Range::OneOf(&["first hand", "read off Egert's figures"])),
];

/// The kind of a curve by finite elements of another author.
pub(super) const FEM: &str = "fem";

/// The curves of `provenance.toml`, each in its own file; every key is required.
///
/// # Errors
/// Names the key that is missing, unknown or out of range.
pub fn read(file: &Path) -> Result<Vec<CurveProvenance>, Error> {
    let text = text_of(file, "say where the curves come from; see the README of the folder")?;
    let table = keys::parse(file, &text)?;
    keys::check(file, "", &table, &KEYS)?;
    let entries = table.get("curves").and_then(Value::as_array).into_iter().flatten().filter_map(Value::as_table);
    let curve = |(index, entry): (usize, &toml::Table)| {
        keys::check(file, &format!("curves[{index}]."), entry, &CURVE_KEYS)?;
        Ok(entry.iter().filter_map(|(key, value)| Some((key.clone(), value.as_str()?.to_owned()))).collect())
    };
    entries.enumerate().map(curve).collect()
}
