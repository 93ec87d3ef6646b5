//! `[units]`: names of units, and numbers in them.

use serde::Deserialize;
use toml::Spanned;

use crate::case::file::Source;
use crate::case::file::values::Name;
use crate::error::Error;

/// `[units]`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct UnitsTable {
    /// Of lengths: m, cm, mm, um, in.
    pub length: Option<Name>,
    /// Of forces: N, kN, MN.
    pub force: Option<Name>,
    /// Of stresses and moduli: Pa, kPa, MPa, GPa.
    pub stress: Option<Name>,
}

/// Factors to mm, N and MPa.
#[derive(Clone, Copy, Debug)]
pub struct Units {
    /// Millimetres in one unit of length.
    pub length: f64,
    /// Newtons in one unit of force.
    pub force: f64,
    /// Megapascals in one unit of stress.
    pub stress: f64,
}

/// Units of length \[mm\].
const LENGTHS: [(&str, f64); 5] = [("m", 1e3), ("cm", 10.0), ("mm", 1.0), ("um", 1e-3), ("in", 25.4)];
/// Units of force \[N\].
const FORCES: [(&str, f64); 3] = [("N", 1.0), ("kN", 1e3), ("MN", 1e6)];
/// Units of stress \[MPa\].
const STRESSES: [(&str, f64); 4] = [("Pa", 1e-6), ("kPa", 1e-3), ("MPa", 1.0), ("GPa", 1e3)];

impl Units {
    /// Units by their names; mm, N and MPa where none is given.
    pub fn of(source: Source, table: Option<&UnitsTable>) -> Result<Self, Error> {
        let factor = |what: &str, name: Option<&Spanned<String>>, known: &[(&str, f64)]| match name {
            Some(name) => source.choice(what, name, known),
            None => Ok(1.0),
        };
        let named = |of: fn(&UnitsTable) -> &Option<Spanned<String>>| table.and_then(|table| of(table).as_ref());
        Ok(Self {
            length: factor("unit of length", named(|table| &table.length), &LENGTHS)?,
            force: factor("unit of force", named(|table| &table.force), &FORCES)?,
            stress: factor("unit of stress", named(|table| &table.stress), &STRESSES)?,
        })
    }
}
