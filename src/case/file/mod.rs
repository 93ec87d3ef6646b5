//! A scene as a user writes it: tables of a TOML file, every value with its place.
//!
//! * [`tables`] — the keys.
//! * [`values`] — values with their places.
//! * [`units`] — names of units, and numbers in them.
//! * [`bodies`] — outlines, supports and loads.
//! * `blocks` — bodies from blocks.
//! * `compared` — the gap given against the drawn one.
//! * `curves` — the sides of shapes.
//! * `disc` — how much of a disc is modelled.
//! * `gmsh` — bodies from meshes.
//! * [`contact`] — contacts, their bodies, sides and paths.
//! * `side` — the side of a body that carries a contact.
//! * `gap` — the gap of a contact.
//! * [`gap_keys`] — its keys.
//! * `reference` — reference values.
//! * [`document`] — the whole file.
//! * `folder` — the files of a folder.
//! * [`oracle`] — the closed form of a contact.
//! * `mesh` — `[mesh]`.
//! * `wanted` — the checks, `support` — the support of one.
//! * [`places`] — where things are in the file.
//! * [`unsupported`] — physics that is not done here.
//!
//! Lengths, forces and stresses are in the units the file names, angles in degrees; the scene is in mm, N, MPa and radians.

mod blocks;
pub mod bodies;
mod compared;
pub mod contact;
mod curves;
mod disc;
pub mod document;
mod folder;
mod gap;
pub mod gap_keys;
mod gmsh;
mod mesh;
pub mod oracle;
pub mod places;
mod reference;
mod side;
mod support;
pub mod tables;
pub mod units;
pub mod unsupported;
pub mod values;
mod wanted;

use std::ops::Range;
use std::path::Path;

use toml::Spanned;

use crate::error::{Error, Located};
use crate::scene::{Body, Grading, PlaneHypothesis, ReferenceValues, Scene};

pub use folder::files_in;
pub use places::Places;
use tables::{ContactTable, GrowthTable, List, Pair, ReferenceTable};
use units::Units;
use unsupported::Unsupported;

/// The text of a file, to point into.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a> {
    /// The file.
    pub file: &'a Path,
    /// Its text.
    pub text: &'a str,
}

impl Source<'_> {
    /// Something wrong at a place.
    pub fn refused(&self, place: Range<usize>, message: impl Into<String>, remedy: impl Into<String>) -> Error {
        Error::at(Located::new((self.file, self.text), place), message, remedy)
    }

    /// A number that is finite and passes a test.
    pub fn number(
        &self,
        key: &str,
        value: &Spanned<f64>,
        expected: &str,
        holds: impl Fn(f64) -> bool,
    ) -> Result<f64, Error> {
        let found = *value.get_ref();
        if found.is_finite() && holds(found) {
            return Ok(found);
        }
        Err(self.refused(value.span(), format!("`{key}` is {found}"), format!("give {expected}")))
    }

    /// A number above zero.
    pub fn positive(&self, key: &str, value: &Spanned<f64>) -> Result<f64, Error> {
        let [least, most] = [1.0 / LARGEST, LARGEST];
        self.number(key, value, &format!("a number above 0, from {least:e} to {most:e}"), |x| x >= least && x <= most)
    }

    /// A number of a magnitude that squares and products survive.
    pub fn finite(&self, key: &str, value: &Spanned<f64>) -> Result<f64, Error> {
        self.number(key, value, &format!("a finite number below {LARGEST:e}"), |x| x.abs() <= LARGEST)
    }

    /// The entries of a list that must have so many.
    pub fn entries<'a, T, const N: usize>(&self, key: &str, list: &'a List<T>) -> Result<&'a [T; N], Error> {
        list.get_ref().as_slice().try_into().map_err(|_| {
            let written: Vec<&str> = self.text.get(list.span()).unwrap_or_default().split_whitespace().collect();
            let shown: String = written.join(" ").chars().take(LONGEST_SHOWN).collect();
            let remedy = format!("give {N} entries, not {}", list.get_ref().len());
            self.refused(list.span(), format!("`{key}` is {shown}"), remedy)
        })
    }

    /// A point or a vector.
    pub fn pair(&self, key: &str, value: &Pair) -> Result<[f64; 2], Error> {
        let [x, y] = self.entries(key, value)?;
        Ok([self.finite(key, x)?, self.finite(key, y)?])
    }

    /// One of some names.
    pub fn choice<T: Copy>(&self, what: &str, name: &Spanned<String>, known: &[(&str, T)]) -> Result<T, Error> {
        let found = known.iter().find(|(known, _)| known == name.get_ref());
        found.map(|(_, value)| *value).ok_or_else(|| {
            let names: Vec<String> = known.iter().map(|(name, _)| format!("`{name}`")).collect();
            let asked = Unsupported::asked_by(name.get_ref());
            let instead = asked.map_or_else(String::new, |asked| format!("; {}: {}", asked.holds, asked.instead));
            let remedy = format!("known: {}{instead}", names.join(", "));
            self.refused(name.span(), format!("there is no {what} `{}`", name.get_ref()), remedy)
        })
    }
}

/// Characters of a list that a message shows.
const LONGEST_SHOWN: usize = 60;
/// Largest magnitude of a number in a file.
const LARGEST: f64 = 1e13;

/// Growth of meshes whose file does not say: that of the Hertz scenes.
const GROWTH: Grading = Grading { unit: 1.0, along: 1.7, depth: 1.6, first: 1.0, coarsest: 0.3, end: 1.0 };

/// What a file says of the scene itself.
#[derive(Debug)]
pub struct Tables<'a> {
    /// Name of the scene.
    pub name: &'a str,
    /// Units of all numbers.
    pub units: Units,
    /// Plane strain or plane stress.
    pub plane: &'a Spanned<String>,
    /// Thickness.
    pub thickness: &'a Spanned<f64>,
    /// Bodies.
    pub bodies: &'a [tables::Keyed<tables::BodyTable>],
    /// The contacts, at least one.
    pub contacts: &'a [ContactTable],
    /// Reference values.
    pub reference: Option<&'a ReferenceTable>,
    /// Length that holds the elements.
    pub per: Option<&'a Spanned<f64>>,
    /// How the mesh grows.
    pub growth: Option<&'a GrowthTable>,
}

impl Tables<'_> {
    /// The scene in mm, N, MPa and radians.
    pub fn scene(&self, source: Source) -> Result<Scene, Error> {
        let known = [("strain", PlaneHypothesis::Strain), ("stress", PlaneHypothesis::Stress)];
        let plane = source.choice("plane hypothesis", self.plane, &known)?;
        let body = |table: &tables::Keyed<tables::BodyTable>| {
            bodies::body(source, &self.units, plane, contact::is_across(self.contacts, table), table)
        };
        let bodies = self.bodies.iter().map(body).collect::<Result<Vec<Body>, Error>>()?;
        bodies::refuse_equal_names(source, self.bodies)?;
        let contacts = contact::pairs(source, &self.units, self.bodies, &bodies, self.contacts)?;
        let mut scene = Scene {
            name: self.name.into(),
            plane,
            thickness: self.units.length * source.positive("thickness", self.thickness)?,
            bodies,
            contacts,
            reference: ReferenceValues { length: 1.0, pressure: 1.0, gap: 1.0 },
            grading: self.grading(source)?,
        };
        scene.reference = reference::values(source, &self.units, &scene, self.reference)?;
        Ok(scene)
    }

    fn grading(&self, source: Source) -> Result<Grading, Error> {
        let mut grading = GROWTH;
        grading.unit = self.units.length * self.per.map_or(Ok(1.0), |per| source.positive("per", per))?;
        let Some(table) = self.growth else { return Ok(grading) };
        let ratio = |key: &str, value: &Option<Spanned<f64>>, default: f64| match value {
            Some(value) => source.number(key, value, "a ratio between 1 and 5", |x| (1.0..=5.0).contains(&x)),
            None => Ok(default),
        };
        let share = |key: &str, value: &Option<Spanned<f64>>, default: f64| match value {
            Some(value) => source.number(key, value, "a number between 0.01 and 5", |x| (0.01..=5.0).contains(&x)),
            None => Ok(default),
        };
        grading.along = ratio("along", &table.along, grading.along)?;
        grading.depth = ratio("depth", &table.depth, grading.depth)?;
        grading.coarsest = share("coarsest", &table.coarsest, grading.coarsest)?;
        grading.first = share("first", &table.first, grading.first)?;
        grading.end = share("end", &table.end, grading.end)?;
        Ok(grading)
    }
}
