//! The checks of a scene file.

use serde::Deserialize;
use toml::Spanned;

use crate::case::file::Source;
use crate::case::file::tables::{BodyTable, Keyed, Name, Number};
use crate::case::file::units::Units;
use crate::case::{Check, Quantity, Reference};
use crate::error::Error;
use crate::measure::display_factor;
use crate::oracle::{self, ReferenceKind, SharedOracle};
use crate::scene::{ContactPair, Scene};

use super::support::SupportName;

/// `[[check]]`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct CheckTable {
    quantity: Name,
    contact: Option<Name>,
    at: Option<Number>,
    support: Option<Spanned<SupportName>>,
    value: Option<Number>,
    tolerance: Number,
    kind: Option<Name>,
    source: Option<String>,
    because: Option<String>,
}

/// What a check may ask for, as files name it.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Asked {
    PeakPressure,
    HalfWidth,
    Centre,
    Resultant,
    Pressure,
    Reaction,
}

const QUANTITIES: [(&str, Asked); 6] = [
    ("peak-pressure", Asked::PeakPressure),
    ("half-width", Asked::HalfWidth),
    ("centre", Asked::Centre),
    ("resultant", Asked::Resultant),
    ("pressure", Asked::Pressure),
    ("reaction", Asked::Reaction),
];
const KINDS: [(&str, ReferenceKind); 4] = [
    ("analytic", ReferenceKind::Analytic),
    ("cross-code", ReferenceKind::CrossCode),
    ("measured", ReferenceKind::Measured),
    ("self-consistency", ReferenceKind::SelfConsistency),
];
impl CheckTable {
    /// The contact that is named; one that is not named must be the only one.
    fn contact(&self, source: Source, quantity: Asked, scene: &Scene) -> Result<usize, Error> {
        let known: Vec<_> = scene.contacts.iter().enumerate().map(|(k, pair)| (pair.name.as_str(), k)).collect();
        match &self.contact {
            Some(name) if quantity == Asked::Reaction => {
                Err(source.refused(name.span(), "a reaction belongs to a support", "leave `contact` out"))
            }
            Some(name) => source.choice("contact", name, &known),
            None if known.len() > 1 && quantity != Asked::Reaction => {
                let names: Vec<String> = known.iter().map(|(name, _)| format!("`{name}`")).collect();
                let message = "the scene has several contacts, and the check does not say which it means";
                let remedy = format!("add `contact = \"…\"`, one of {}", names.join(", "));
                Err(source.refused(self.quantity.span(), message, remedy))
            }
            None => Ok(0),
        }
    }

    /// The check, in the scene's units.
    pub(super) fn check(
        &self,
        source: Source,
        units: &Units,
        bodies: &[Keyed<BodyTable>],
        scene: &Scene,
        oracles: &[Option<SharedOracle>],
    ) -> Result<Check, Error> {
        let asked = source.choice("quantity", &self.quantity, &QUANTITIES)?;
        let contact = self.contact(source, asked, scene)?;
        let pair = &scene.contacts[contact];
        // What turns a contact coordinate of the file into mm or rad.
        let along = if pair.path.is_straight() { units.length } else { 1.0 / display_factor(&pair.path) };
        let at = self.place(source, asked, pair, along)?;
        let support = self.support(source, asked, bodies)?;
        let (quantity, unit) = match (asked, support) {
            (Asked::PeakPressure, _) => (Quantity::PeakPressure, units.stress),
            (Asked::HalfWidth, _) => (Quantity::HalfWidth, along),
            (Asked::Centre, _) => (Quantity::Centre, along),
            (Asked::Resultant, _) => (Quantity::Resultant, units.force),
            (Asked::Reaction, Some([body, support])) => (Quantity::Reaction { body, support }, units.force),
            (Asked::Pressure, _) | (Asked::Reaction, None) => (Quantity::Pressure { at }, units.stress),
        };
        let kind = self.kind.as_ref().map(|kind| source.choice("kind of reference", kind, &KINDS)).transpose()?;
        let tolerance = source.positive("tolerance", &self.tolerance)?;
        let reference = match &self.value {
            Some(value) => Reference {
                name: self.source.clone().unwrap_or_else(|| "the value given".into()),
                kind: kind.unwrap_or(ReferenceKind::SelfConsistency),
                value: unit * source.finite("value", value)?,
                uncertainty: None,
            },
            None => self.read(source, &quantity, scene.thickness, oracles[contact].as_ref())?,
        };
        let because = self.because.clone().unwrap_or_else(|| "the tolerance given".into());
        let check = match reference.value.abs() > 0.0 {
            true => Check::near(quantity, reference, tolerance, because),
            // Nothing is relative to 0.
            false => Check::absolute(quantity, reference, unit * tolerance, because),
        };
        Ok(Check { contact, ..check })
    }

    /// Where a pressure is asked for \[mm, or rad on an arc\]; NaN for what has no place.
    fn place(&self, source: Source, asked: Asked, pair: &ContactPair, along: f64) -> Result<f64, Error> {
        let both = pair.path.has_both_sides();
        match (&self.at, asked) {
            (Some(at), Asked::Pressure) if both => {
                let [end, shown] = [pair.stretch * (1.0 + 1e-9), pair.stretch / along];
                let expected = format!("a coordinate from -{shown} to {shown}");
                Ok(along * source.number("at", at, &expected, |s| (along * s).abs() <= end)?)
            }
            (Some(at), Asked::Pressure) => Ok(along * source.number("at", at, "a coordinate from 0 on", |s| s >= 0.0)?),
            (None, Asked::Pressure) => {
                Err(source.refused(self.quantity.span(), "a pressure without a place", "add `at`"))
            }
            (Some(at), _) => Err(source.refused(at.span(), "only `pressure` is taken at a place", "leave `at` out")),
            (None, Asked::Centre) if !both => {
                let remedy = "leave the check out, or give `both-sides = true` in [contact]";
                Err(source.refused(self.quantity.span(), "a contact that begins at x = 0 has no `centre`", remedy))
            }
            (None, _) => Ok(f64::NAN),
        }
    }

    /// Indices of the body and of its support whose reaction is asked for.
    fn support(&self, source: Source, asked: Asked, bodies: &[Keyed<BodyTable>]) -> Result<Option<[usize; 2]>, Error> {
        match (&self.support, asked) {
            (Some(support), Asked::Reaction) => Ok(Some(support.get_ref().find(source, bodies)?)),
            (None, Asked::Reaction) => {
                let remedy = "add `support = { body = \"…\", at = \"…\", component = \"…\" }`, as the body lists it";
                Err(source.refused(self.quantity.span(), "a reaction without its support", remedy))
            }
            (Some(support), _) => {
                Err(source.refused(support.span(), "only a `reaction` has a support", "leave `support` out"))
            }
            (None, _) => Ok(None),
        }
    }

    /// What the closed form of the contact says of a quantity.
    fn read(
        &self,
        source: Source,
        quantity: &Quantity,
        thickness: f64,
        oracle: Option<&SharedOracle>,
    ) -> Result<Reference, Error> {
        let place = self.quantity.span();
        let Some(oracle) = oracle else {
            let remedy = "give `value`, or the contact an `oracle`";
            return Err(source.refused(place, "the check has nothing to be held against", remedy));
        };
        if let Some(kind) = &self.kind {
            return Err(source.refused(kind.span(), "the kind is that of the oracle", "leave `kind` out"));
        }
        let read = |asked| Reference::read(oracle.as_ref(), asked);
        let reference = match quantity {
            Quantity::PeakPressure => read(oracle::Quantity::PeakPressure),
            Quantity::HalfWidth => read(oracle::Quantity::SecondMoment),
            Quantity::Pressure { at } => read(oracle::Quantity::Pressure { at: *at }),
            Quantity::Resultant => {
                let per_thickness = read(oracle::Quantity::Resultant);
                per_thickness.times(thickness)
            }
            _ => Reference::own(oracle.name(), f64::NAN),
        };
        if reference.value.is_finite() {
            return Ok(reference);
        }
        let message = format!("{} gives no {} here", oracle.name(), quantity.name());
        Err(source.refused(place, message, "give `value`, or mend the numbers of the `oracle`"))
    }
}
