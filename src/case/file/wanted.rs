//! The checks of a scene file.

use serde::Deserialize;
use toml::Spanned;

use crate::case::file::Source;
use crate::case::file::tables::{BodyTable, Keyed, Name, Number};
use crate::case::file::units::Units;
use crate::case::{Judged, Reference};
use crate::error::Error;
use crate::measure::{display_factor, profile};
use crate::oracle::ReferenceKind;
use crate::scene::Scene;
use crate::solve::Discretisation;
use crate::solve::run::{Contact, Run};

use super::support::SupportName;

/// `[[check]]`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct CheckTable {
    quantity: Name,
    contact: Option<Name>,
    at: Option<Number>,
    support: Option<Spanned<SupportName>>,
    value: Number,
    tolerance: Number,
    kind: Option<Name>,
    source: Option<String>,
    because: Option<String>,
}

/// What a check asks.
#[derive(Clone, Debug)]
pub(super) struct Wanted {
    quantity: Quantity,
    /// Index of the contact in the scene.
    contact: usize,
    /// Contact coordinate \[mm, or rad\].
    at: f64,
    /// Body and support of a reaction.
    support: Option<[usize; 2]>,
    value: f64,
    /// Relative; where the value is 0 absolute.
    tolerance: f64,
    kind: ReferenceKind,
    source: String,
    because: String,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Quantity {
    PeakPressure,
    HalfWidth,
    Centre,
    Resultant,
    Pressure,
    Reaction,
}

const QUANTITIES: [(&str, Quantity); 6] = [
    ("peak-pressure", Quantity::PeakPressure),
    ("half-width", Quantity::HalfWidth),
    ("centre", Quantity::Centre),
    ("resultant", Quantity::Resultant),
    ("pressure", Quantity::Pressure),
    ("reaction", Quantity::Reaction),
];
const KINDS: [(&str, ReferenceKind); 4] = [
    ("analytic", ReferenceKind::Analytic),
    ("cross-code", ReferenceKind::CrossCode),
    ("measured", ReferenceKind::Measured),
    ("self-consistency", ReferenceKind::SelfConsistency),
];
impl Wanted {
    pub(super) fn check(&self, discretisation: &Discretisation, run: &Run) -> Result<Judged, Error> {
        let points = run.solution.points_of(self.contact);
        let Contact { measures, transmitted, unbounded, .. } = &run.contacts[self.contact];
        let (name, value) = match self.quantity {
            // A peak without a limit is no number to be judged.
            Quantity::PeakPressure if unbounded.is_some() => {
                ("peak pressure, which has no limit [MPa]".into(), f64::NAN)
            }
            Quantity::PeakPressure => ("peak pressure [MPa]".into(), measures.peak.pressure),
            Quantity::HalfWidth => ("half-width [mm or rad]".into(), measures.half_width),
            Quantity::Centre => ("centre of pressure [mm]".into(), measures.centre),
            Quantity::Resultant => ("resultant [N]".into(), *transmitted),
            Quantity::Pressure => {
                let stretch = discretisation.scene.contacts[self.contact].stretch;
                (format!("pressure at s = {:.6} [MPa]", self.at), profile::interpolate(points, stretch, self.at))
            }
            Quantity::Reaction => ("reaction [N]".into(), self.reaction(discretisation, run)?),
        };
        // A run that broke off has no value to be judged.
        let value = if run.solution.converged() { value } else { f64::NAN };
        let reference = Reference { name: self.source.clone(), kind: self.kind, value: self.value };
        let requirement = format!("The file's own check: {}", self.source);
        let because = self.because.clone();
        Ok(match self.value.abs() > 0.0 {
            true => Judged::relative(requirement, name, value, reference, self.tolerance, because),
            false => Judged::norm(requirement, name, value.abs(), reference, self.tolerance, because),
        })
    }

    fn reaction(&self, discretisation: &Discretisation, run: &Run) -> Result<f64, Error> {
        let reactions = discretisation.reactions_under(run.share(), &run.solution)?;
        let wanted = reactions.iter().find(|reaction| self.support == Some([reaction.body, reaction.support]));
        Ok(wanted.map_or(f64::NAN, |reaction| reaction.force))
    }
}

impl CheckTable {
    /// The contact that is named; one that is not named must be the only one.
    fn contact(&self, source: Source, quantity: Quantity, scene: &Scene) -> Result<usize, Error> {
        let known: Vec<_> = scene.contacts.iter().enumerate().map(|(k, pair)| (pair.name.as_str(), k)).collect();
        match &self.contact {
            Some(name) if quantity == Quantity::Reaction => {
                Err(source.refused(name.span(), "a reaction belongs to a support", "leave `contact` out"))
            }
            Some(name) => source.choice("contact", name, &known),
            None if known.len() > 1 && quantity != Quantity::Reaction => {
                let names: Vec<String> = known.iter().map(|(name, _)| format!("`{name}`")).collect();
                let message = "the scene has several contacts, and the check does not say which it means";
                let remedy = format!("add `contact = \"…\"`, one of {}", names.join(", "));
                Err(source.refused(self.quantity.span(), message, remedy))
            }
            None => Ok(0),
        }
    }

    pub(super) fn wanted(
        &self,
        source: Source,
        units: &Units,
        bodies: &[Keyed<BodyTable>],
        scene: &Scene,
    ) -> Result<Wanted, Error> {
        let quantity = source.choice("quantity", &self.quantity, &QUANTITIES)?;
        let contact = self.contact(source, quantity, scene)?;
        let pair = &scene.contacts[contact];
        // What turns a contact coordinate of the file into mm or rad.
        let along = if pair.path.is_straight() { units.length } else { 1.0 / display_factor(&pair.path) };
        let unit = match quantity {
            Quantity::PeakPressure | Quantity::Pressure => units.stress,
            Quantity::Resultant | Quantity::Reaction => units.force,
            Quantity::HalfWidth | Quantity::Centre => along,
        };
        if quantity == Quantity::Centre && !pair.path.has_both_sides() {
            let remedy = "leave the check out, or give `both-sides = true` in [contact]";
            return Err(source.refused(self.quantity.span(), "a contact that begins at x = 0 has no `centre`", remedy));
        }
        let at = match (&self.at, quantity) {
            (Some(at), Quantity::Pressure) if pair.path.has_both_sides() => {
                let [end, shown] = [pair.stretch * (1.0 + 1e-9), pair.stretch / along];
                along
                    * source.number("at", at, &format!("a coordinate from -{shown} to {shown}"), |s| {
                        (along * s).abs() <= end
                    })?
            }
            (Some(at), Quantity::Pressure) => {
                along * source.number("at", at, "a coordinate from 0 on", |s| s >= 0.0)?
            }
            (None, Quantity::Pressure) => {
                return Err(source.refused(self.quantity.span(), "a pressure without a place", "add `at`"));
            }
            (Some(at), _) => {
                return Err(source.refused(at.span(), "only `pressure` is taken at a place", "leave `at` out"));
            }
            (None, _) => f64::NAN,
        };
        let support = match (&self.support, quantity) {
            (Some(support), Quantity::Reaction) => Some(support.get_ref().find(source, bodies)?),
            (None, Quantity::Reaction) => {
                let remedy = "add `support = { body = \"…\", at = \"…\", component = \"…\" }`, as the body lists it";
                return Err(source.refused(self.quantity.span(), "a reaction without its support", remedy));
            }
            (Some(support), _) => {
                return Err(source.refused(support.span(), "only a `reaction` has a support", "leave `support` out"));
            }
            (None, _) => None,
        };
        let kind = self.kind.as_ref().map(|kind| source.choice("kind of reference", kind, &KINDS)).transpose()?;
        let value = source.finite("value", &self.value)?;
        let tolerance = source.positive("tolerance", &self.tolerance)?;
        Ok(Wanted {
            quantity,
            contact,
            at,
            support,
            value: unit * value,
            tolerance: if value.abs() > 0.0 { tolerance } else { unit * tolerance },
            kind: kind.unwrap_or(ReferenceKind::SelfConsistency),
            source: self.source.clone().unwrap_or_else(|| "the value given".into()),
            because: self.because.clone().unwrap_or_else(|| "the tolerance given".into()),
        })
    }
}
