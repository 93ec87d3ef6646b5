//! The dimensions, materials and load of a digitised source.

use std::path::Path;

use super::keys::{self, Key, Range, text_of};
use super::point::{Abscissa, Ordinate};
use crate::error::Error;
use crate::scene::Material;

/// What the source shows, as it gives it: nothing of it may be guessed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum DigitisedScene {
    /// A pin in a connecting rod, by the table `[rod]`.
    Rod(RodScene),
    /// A pin in a large sheet, by the table `[sheet]`.
    Sheet(SheetScene),
}

/// Pin and rod.
#[derive(Debug, Clone, Copy, PartialEq, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RodScene {
    /// Radius of the pin \[mm\].
    pub pin_radius: f64,
    /// Radial clearance between pin and hole \[mm\].
    pub clearance: f64,
    /// Outer radius of the eye \[mm\].
    pub eye_outer_radius: f64,
    /// Full width of the shank \[mm\].
    pub shank_width: f64,
    /// Distance from the centre of the eye to the end of the shank \[mm\].
    pub shank_end: f64,
    /// Thickness of pin and rod \[mm\].
    pub thickness: f64,
    /// Full force on the rod \[N\].
    pub force: f64,
    /// Coefficient of friction in the source.
    pub friction: f64,
    /// Material of the pin.
    pub pin: Material,
    /// Material of the rod.
    pub rod: Material,
}

/// Pin and sheet; the force is the abscissa of its curves.
#[derive(Debug, Clone, Copy, PartialEq, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SheetScene {
    /// Radius of the pin \[mm\].
    pub pin_radius: f64,
    /// Radial clearance between pin and hole \[mm\].
    pub clearance: f64,
    /// Distance from the hole's centre to where the sheet is held \[mm\].
    pub rim_radius: f64,
    /// Thickness of pin and sheet \[mm\].
    pub thickness: f64,
    /// Coefficient of friction in the source.
    pub friction: f64,
    /// Material of the pin.
    pub pin: Material,
    /// Material of the sheet.
    pub sheet: Material,
}

const ROD: [Key; 12] = [
    key("pin_radius", "radius of the pin [mm]", Range::Positive),
    key("clearance", "radial clearance between pin and hole [mm]", Range::NonNegative),
    key("eye_outer_radius", "outer radius of the eye [mm]", Range::Positive),
    key("shank_width", "full width of the shank [mm]", Range::Positive),
    key("shank_end", "distance from the eye's centre to the shank's end [mm]", Range::Positive),
    key("thickness", "thickness of pin and rod [mm]", Range::Positive),
    key("force", "full force on the rod [N]", Range::Positive),
    key("friction", "coefficient of friction in the source", Range::NonNegative),
    key("pin.young", "Young's modulus of the pin [MPa]", Range::Positive),
    key("pin.poisson", "Poisson's ratio of the pin", Range::Poisson),
    key("rod.young", "Young's modulus of the rod [MPa]", Range::Positive),
    key("rod.poisson", "Poisson's ratio of the rod", Range::Poisson),
];

const SHEET: [Key; 9] = [
    key("pin_radius", "radius of the pin [mm]", Range::Positive),
    key("clearance", "radial clearance between pin and hole [mm]", Range::NonNegative),
    key("rim_radius", "distance from the hole's centre to where the sheet is held [mm]", Range::Positive),
    key("thickness", "thickness of pin and sheet [mm]", Range::Positive),
    key("friction", "coefficient of friction in the source", Range::NonNegative),
    key("pin.young", "Young's modulus of the pin [MPa]", Range::Positive),
    key("pin.poisson", "Poisson's ratio of the pin", Range::Poisson),
    key("sheet.young", "Young's modulus of the sheet [MPa]", Range::Positive),
    key("sheet.poisson", "Poisson's ratio of the sheet", Range::Poisson),
];

const fn key(path: &'static str, meaning: &'static str, range: Range) -> Key {
    Key { path, meaning, range }
}

impl DigitisedScene {
    /// Reads `scene.toml`, every key required; with a table `[sheet]` it is a sheet, else a rod.
    ///
    /// # Errors
    /// Names the key that is missing, unknown or out of range.
    pub fn read(file: &Path) -> Result<Self, Error> {
        let text = text_of(file, "write the source's dimensions, materials and load; see the README of the folder")?;
        let table = keys::parse(file, &text)?;
        if table.contains_key("sheet") {
            checked::<SheetScene>(file, table, &SHEET)?.fits_together(file).map(Self::Sheet)
        } else {
            checked::<RodScene>(file, table, &ROD)?.fits_together(file).map(Self::Rod)
        }
    }

    /// Coefficient of friction in the source.
    pub fn friction(&self) -> f64 {
        match self {
            Self::Rod(rod) => rod.friction,
            Self::Sheet(sheet) => sheet.friction,
        }
    }

    /// Whether a curve of these quantities belongs to it: stresses along the arc to a rod, half-angles over the force to a sheet.
    pub(super) fn has_curve(&self, abscissa: Abscissa, ordinate: Ordinate) -> bool {
        let along = matches!(abscissa, Abscissa::Angle | Abscissa::Distance);
        let stress = matches!(ordinate, Ordinate::Pressure | Ordinate::HoopStress);
        match self {
            Self::Rod(_) => along && stress,
            Self::Sheet(_) => !along && !stress,
        }
    }
}

/// A table held against its keys.
fn checked<S: serde::de::DeserializeOwned>(file: &Path, table: toml::Table, keys: &[Key]) -> Result<S, Error> {
    keys::check(file, "", &table, keys)?;
    table.try_into().map_err(|cause: toml::de::Error| {
        Error::unreadable(file, cause.message(), "follow the example in the README of the folder")
    })
}

impl RodScene {
    fn fits_together(self, file: &Path) -> Result<Self, Error> {
        let refused = |key: &str, value: f64, remedy: String| Err(Error::refused(file, key, value, remedy));
        let hole = self.pin_radius + self.clearance;
        if self.eye_outer_radius <= hole {
            let remedy = format!("give an eye outside its hole of radius {hole} mm");
            return refused("eye_outer_radius", self.eye_outer_radius, remedy);
        }
        if self.shank_end <= self.eye_outer_radius {
            let remedy = format!("give a shank that ends outside the eye of radius {} mm", self.eye_outer_radius);
            return refused("shank_end", self.shank_end, remedy);
        }
        Ok(self)
    }
}

impl SheetScene {
    fn fits_together(self, file: &Path) -> Result<Self, Error> {
        let hole = self.pin_radius + self.clearance;
        if self.rim_radius <= hole {
            let remedy = format!("give a rim outside the hole of radius {hole} mm");
            return Err(Error::refused(file, "rim_radius", self.rim_radius, remedy));
        }
        Ok(self)
    }
}
