//! The dimensions, materials and load of a digitised source.

use std::collections::BTreeMap;
use std::path::Path;

use super::keys::Range::{NonNegative, Poisson, Positive};
use super::keys::{self, Key, text_of};
use super::{Abscissa, Ordinate};
use crate::error::Error;
use crate::scene::Material;

/// What the source shows, as it gives it: nothing of it may be guessed.
#[derive(Debug, Clone, PartialEq)]
pub struct DigitisedScene {
    /// Whether it is a pin in a large sheet, whose curves have the force as abscissa, by the table `[sheet]`; else a
    /// pin in a connecting rod, by the table `[rod]`.
    pub is_sheet: bool,
    /// Its numbers by their keys in `scene.toml` \[mm, N, MPa\].
    pub numbers: BTreeMap<&'static str, f64>,
}

const ROD: [Key; 12] = [
    ("pin_radius", "radius of the pin [mm]", Positive),
    ("clearance", "radial clearance between pin and hole [mm]", NonNegative),
    ("eye_outer_radius", "outer radius of the eye [mm]", Positive),
    ("shank_width", "full width of the shank [mm]", Positive),
    ("shank_end", "distance from the eye's centre to the shank's end [mm]", Positive),
    ("thickness", "thickness of pin and rod [mm]", Positive),
    ("force", "full force on the rod [N]", Positive),
    ("friction", "coefficient of friction in the source", NonNegative),
    ("pin.young", "Young's modulus of the pin [MPa]", Positive),
    ("pin.poisson", "Poisson's ratio of the pin", Poisson),
    ("rod.young", "Young's modulus of the rod [MPa]", Positive),
    ("rod.poisson", "Poisson's ratio of the rod", Poisson),
];

const SHEET: [Key; 9] = [
    ("pin_radius", "radius of the pin [mm]", Positive),
    ("clearance", "radial clearance between pin and hole [mm]", NonNegative),
    ("rim_radius", "distance from the hole's centre to where the sheet is held [mm]", Positive),
    ("thickness", "thickness of pin and sheet [mm]", Positive),
    ("friction", "coefficient of friction in the source", NonNegative),
    ("pin.young", "Young's modulus of the pin [MPa]", Positive),
    ("pin.poisson", "Poisson's ratio of the pin", Poisson),
    ("sheet.young", "Young's modulus of the sheet [MPa]", Positive),
    ("sheet.poisson", "Poisson's ratio of the sheet", Poisson),
];

impl DigitisedScene {
    /// Reads `scene.toml`, every key required; with a table `[sheet]` it is a sheet, else a rod.
    ///
    /// # Errors
    /// Names the key that is missing, unknown or out of range.
    pub fn read(file: &Path) -> Result<Self, Error> {
        let text = text_of(file, "write the source's dimensions, materials and load; see the README of the folder")?;
        let table = keys::parse(file, &text)?;
        let is_sheet = table.contains_key("sheet");
        let numbers = keys::numbers(file, &table, if is_sheet { &SHEET } else { &ROD })?;
        let scene = Self { is_sheet, numbers };
        let hole = scene.number("pin_radius") + scene.number("clearance");
        let eye = scene.number("eye_outer_radius");
        let beyond = match is_sheet {
            true => vec![("rim_radius", hole, format!("give a rim outside the hole of radius {hole} mm"))],
            false => vec![
                ("eye_outer_radius", hole, format!("give an eye outside its hole of radius {hole} mm")),
                ("shank_end", eye, format!("give a shank that ends outside the eye of radius {eye} mm")),
            ],
        };
        match beyond.into_iter().find(|(key, least, _)| scene.number(key) <= *least) {
            Some((key, _, remedy)) => Err(Error::refused(file, key, scene.number(key), remedy)),
            None => Ok(scene),
        }
    }

    /// The number of a key; NaN where the scene has none.
    pub fn number(&self, key: &str) -> f64 {
        self.numbers.get(key).copied().unwrap_or(f64::NAN)
    }

    /// Material of the `pin`, the `rod` or the `sheet`.
    pub fn material(&self, body: &str) -> Material {
        let [young, poisson] = ["young", "poisson"].map(|constant| self.number(&format!("{body}.{constant}")));
        Material { young, poisson }
    }

    /// Whether a curve of these quantities belongs to it: stresses along the arc to a rod, half-angles over the force
    /// to a sheet.
    pub(super) fn has_curve(&self, abscissa: Abscissa, ordinate: Ordinate) -> bool {
        let of_sheet = [abscissa == Abscissa::Force, ordinate == Ordinate::HalfAngle];
        of_sheet == [self.is_sheet; 2]
    }
}
