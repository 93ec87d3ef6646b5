//! The checks of a scene file.

use serde::Deserialize;
use toml::Spanned;

use crate::case::file::Source;
use crate::case::file::tables::{BodyTable, Keyed, Name, Number};
use crate::case::file::units::Units;
use crate::case::{Check, Quantity, Reference, Relation};
use crate::error::{Coordinate, Error};
use crate::measure::display_factor;
use crate::oracle::{self, ReferenceKind, SharedOracle};
use crate::scene::{ContactPair, Scene};

use super::displaced::DisplacedName;
use super::support::SupportName;

/// `[[check]]`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct CheckTable {
    quantity: Name,
    contact: Option<Name>,
    at: Option<Number>,
    support: Option<Spanned<SupportName>>,
    of: Option<Spanned<DisplacedName>>,
    body: Option<Name>,
    value: Option<Number>,
    tolerance: Number,
    #[serde(rename = "model-error")]
    model_error: Option<Number>,
    kind: Option<Name>,
    source: Option<String>,
    because: Option<String>,
}

/// What a check may ask for, as files name it.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Asked {
    PeakPressure,
    HalfWidth,
    SecondMomentWidth,
    Centre,
    Resultant,
    Pressure,
    Reaction,
    Displacement,
    Approach,
    Shear,
    ShearDepth,
}

const QUANTITIES: [(&str, Asked); 11] = [
    ("peak-pressure", Asked::PeakPressure),
    (HALF_WIDTH, Asked::HalfWidth),
    (SECOND_MOMENT_WIDTH, Asked::SecondMomentWidth),
    ("centre", Asked::Centre),
    ("resultant", Asked::Resultant),
    ("pressure", Asked::Pressure),
    ("reaction", Asked::Reaction),
    ("displacement", Asked::Displacement),
    ("approach", Asked::Approach),
    ("shear", Asked::Shear),
    ("shear-depth", Asked::ShearDepth),
];
/// Names of the half-width, half of what lies between begin and end, and of the second-moment width, which had another.
pub(super) const HALF_WIDTH: &str = "contact-half-width";
pub(super) const SECOND_MOMENT_WIDTH: &str = "second-moment-width";
const OLD: &str = "half-width";

/// Refuses the name that the second-moment width had: of a contact that is no semi-ellipse it is no half-width.
pub(super) fn refuse_old(source: Source, name: &Name) -> Result<(), Error> {
    if name.get_ref() != OLD {
        return Ok(());
    }
    let message =
        format!("the quantity `{OLD}` was the second-moment width, which is the half-width of a semi-ellipse alone");
    let remedy = format!(
        "write `{SECOND_MOMENT_WIDTH}`, 2 √(∫p (s − c)²/∫p), or `{HALF_WIDTH}`, half of what lies between begin and end"
    );
    Err(source.refused(name.span(), message, remedy))
}

/// What is said of keys that belong to other quantities.
const SUPPORT: [&str; 2] = ["only a `reaction` has a support", "leave `support` out"];
const OF: [&str; 2] = ["only a `displacement` is that of a place", "leave `of` out"];
const BODY: [&str; 2] = ["only `shear` and `shear-depth` are taken in one body", "leave `body` out"];
const KINDS: [(&str, ReferenceKind); 4] = [
    ("analytic", ReferenceKind::Analytic),
    ("cross-code", ReferenceKind::CrossCode),
    ("measured", ReferenceKind::Measured),
    ("self-consistency", ReferenceKind::SelfConsistency),
];
impl Asked {
    /// Of what it is a number, where that is no contact.
    fn belongs_to(self) -> Option<&'static str> {
        match self {
            Self::Reaction => Some("a reaction belongs to a support"),
            Self::Displacement => Some("a displacement belongs to a body"),
            _ => None,
        }
    }
}

impl CheckTable {
    /// The contact that is named; one that is not named must be the only one.
    fn contact(&self, source: Source, quantity: Asked, scene: &Scene) -> Result<usize, Error> {
        let known: Vec<_> = scene.contacts.iter().enumerate().map(|(k, pair)| (pair.name.as_str(), k)).collect();
        match (&self.contact, quantity.belongs_to()) {
            (Some(name), Some(belongs)) => Err(source.refused(name.span(), belongs, "leave `contact` out")),
            (Some(name), None) => source.choice("contact", name, &known),
            (None, None) if known.len() > 1 => {
                let names: Vec<String> = known.iter().map(|(name, _)| format!("`{name}`")).collect();
                let message = "the scene has several contacts, and the check does not say which it means";
                let remedy = format!("add `contact = \"…\"`, one of {}", names.join(", "));
                Err(source.refused(self.quantity.span(), message, remedy))
            }
            (None, _) => Ok(0),
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
        refuse_old(source, &self.quantity)?;
        let asked = source.choice("quantity", &self.quantity, &QUANTITIES)?;
        let contact = self.contact(source, asked, scene)?;
        let pair = &scene.contacts[contact];
        // What turns a contact coordinate of the file into mm or rad.
        let along = if pair.path.is_straight() { units.length } else { 1.0 / display_factor(&pair.path) };
        let at = self.place(source, asked, pair, along)?;
        self.refuse_unused(source, asked)?;
        let (quantity, unit) = match asked {
            Asked::PeakPressure => (Quantity::PeakPressure, units.stress),
            Asked::HalfWidth if pair.path.is_straight() => (Quantity::HalfWidth, units.length),
            Asked::HalfWidth => (Quantity::HalfAngle, 1.0),
            Asked::SecondMomentWidth if pair.path.is_straight() => (Quantity::SecondMomentWidth, units.length),
            // Given and told in degrees.
            Asked::SecondMomentWidth => (Quantity::SecondMomentAngle, 1.0),
            Asked::Centre => (Quantity::Centre, along),
            Asked::Resultant => (Quantity::Resultant, units.force),
            Asked::Pressure if pair.path.is_straight() => {
                (Quantity::Pressure { at: Coordinate::Length(at) }, units.stress)
            }
            Asked::Pressure => (Quantity::Pressure { at: Coordinate::Angle(at) }, units.stress),
            Asked::Reaction => (self.reaction(source, bodies)?, units.force),
            Asked::Displacement => (self.displacement(source, units, scene)?, units.length),
            Asked::Approach => (self.approach(source, scene, contact)?, units.length),
            Asked::Shear => (Quantity::Shear { body: self.body(source, scene, pair)? }, units.stress),
            Asked::ShearDepth => (Quantity::ShearDepth { body: self.body(source, scene, pair)? }, units.length),
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
        // As the tolerance: relative, or in the unit of the file.
        let scale = if check.relation == Relation::Near { 1.0 } else { unit };
        let model = self.model_error.as_ref().map(|model| source.positive("model-error", model)).transpose()?;
        Ok(Check { contact, model: scale * model.unwrap_or(0.0), ..check })
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

    /// Refuses keys that belong to other quantities.
    fn refuse_unused(&self, source: Source, asked: Asked) -> Result<(), Error> {
        let below = matches!(asked, Asked::Shear | Asked::ShearDepth);
        let unused = [
            (self.support.as_ref().map(Spanned::span), asked == Asked::Reaction, SUPPORT),
            (self.of.as_ref().map(Spanned::span), asked == Asked::Displacement, OF),
            (self.body.as_ref().map(Spanned::span), below, BODY),
        ];
        let unused = unused.into_iter().find_map(|(span, used, told)| span.filter(|_| !used).map(|span| (span, told)));
        unused.map_or(Ok(()), |(span, [message, remedy])| Err(source.refused(span, message, remedy)))
    }

    /// Force of the support that is named.
    fn reaction(&self, source: Source, bodies: &[Keyed<BodyTable>]) -> Result<Quantity, Error> {
        let Some(support) = &self.support else {
            let remedy = "add `support = { body = \"…\", at = \"…\", component = \"…\" }`, as the body lists it";
            return Err(source.refused(self.quantity.span(), "a reaction without its support", remedy));
        };
        let [body, support] = support.get_ref().find(source, bodies)?;
        Ok(Quantity::Reaction { body, support })
    }

    /// Displacement of the side or the point that is named.
    fn displacement(&self, source: Source, units: &Units, scene: &Scene) -> Result<Quantity, Error> {
        let Some(of) = &self.of else {
            let remedy = "add `of = { body = \"…\", at = \"…\", component = \"…\" }`; `at` may be a point";
            return Err(source.refused(self.quantity.span(), "a displacement without its place", remedy));
        };
        Ok(Quantity::Displacement(of.get_ref().find(source, units, scene)?))
    }

    /// Approach of the bodies of a contact that has one.
    fn approach(&self, source: Source, scene: &Scene, contact: usize) -> Result<Quantity, Error> {
        if scene.pressed_sides(contact).is_some() {
            return Ok(Quantity::Approach);
        }
        let message = "the contact has no `approach`: not every body of it is pressed along y at one side only, or all is prescribed";
        let remedy = "ask for the `displacement` of the sides that are meant";
        Err(source.refused(self.quantity.span(), message, remedy))
    }

    /// The body below whose surface the shear stress is meant; one that is not named must be the only one.
    fn body(&self, source: Source, scene: &Scene, pair: &ContactPair) -> Result<usize, Error> {
        let names: Vec<_> = pair.bodies().map(|body| (scene.bodies[body].name.as_str(), body)).collect();
        match (&self.body, names.as_slice()) {
            (Some(name), _) => source.choice("body of the contact", name, &names),
            (None, [(_, only)]) => Ok(*only),
            (None, _) => {
                let names: Vec<String> = names.iter().map(|(name, _)| format!("`{name}`")).collect();
                let message = "the contact has two elastic bodies, and the check does not say which it means";
                let remedy = format!("add `body = \"…\"`, one of {}", names.join(", "));
                Err(source.refused(self.quantity.span(), message, remedy))
            }
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
            Quantity::HalfWidth => read(oracle::Quantity::HalfWidth),
            Quantity::HalfAngle => read(oracle::Quantity::ContactAngle).in_degrees(),
            Quantity::SecondMomentWidth => read(oracle::Quantity::SecondMoment),
            Quantity::SecondMomentAngle => read(oracle::Quantity::SecondMoment).in_degrees(),
            Quantity::Pressure { at } => read(oracle::Quantity::Pressure { at: at.value() }),
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
