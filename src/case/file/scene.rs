//! The scene of a file, from its tables.

use toml::Spanned;

use crate::case::file::source::Source;
use crate::case::file::tables::{BodyTable, ContactTable, GrowthTable, Keyed, ReferenceTable};
use crate::case::file::units::Units;
use crate::case::file::{bodies, contact, reference};
use crate::error::Error;
use crate::scene::{Body, Grading, PlaneHypothesis, ReferenceValues, Scene};

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
    pub bodies: &'a [Keyed<BodyTable>],
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
        let body = |table: &Keyed<BodyTable>| {
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
