//! `[[check]]`: the checks of a scene file.

use crate::case::file::form::Form::{Number, Table, Text, Word};
use crate::case::file::form::{Form, listed, may, must, names};
use crate::case::file::named::{self, OF_BODY};
use crate::case::file::value::Value;
use crate::case::{self, Check, Reference, Relation};
use crate::error::Error;
use crate::measure::{Quantity, display_factor};
use crate::oracle::{ReferenceKind, SharedOracle};
use crate::scene::{Component, ContactPair, Displaced, Place, Scene};

/// `[[check]]`.
pub(super) const CHECK: Form = Table(&[
    must("quantity", Word(|| names(&QUANTITIES))).told("what is measured"),
    may("contact", Text).told("of which contact, where there are several"),
    may("at", Number).told("where, of a pressure"),
    may("support", OF_BODY),
    may("of", OF_BODY),
    may("body", Text),
    may("value", Number).told("what it shall be; what the `oracle` of the contact says where it is left out"),
    must("tolerance", Number).told("relative; absolute where the value is 0"),
    may("model-error", Number).told("what a closed form itself may be off for this scene"),
    may("kind", Word(|| names(&KINDS))).told("what kind of truth the value is"),
    may("source", Text).told("where the value comes from"),
    may("because", Text).told("why this tolerance"),
]);

/// What a check may ask for, as files name it; its place, body, support or side is filled in from the other keys. The
/// half-width lies between begin and end. What an accuracy may be of comes first.
pub(super) const QUANTITIES: [(&str, &Quantity); 12] = [
    ("peak-pressure", &Quantity::PeakPressure),
    ("half-width", &Quantity::HalfWidth),
    ("contact-half-width", &Quantity::HalfWidth),
    ("second-moment-width", &Quantity::SecondMomentWidth),
    ("centre", &Quantity::Centre),
    ("resultant", &Quantity::Resultant),
    ("pressure", &Quantity::Pressure { at: f64::NAN }),
    ("reaction", &Quantity::Reaction { body: 0, support: 0 }),
    ("displacement", &Quantity::Displacement(NOWHERE)),
    ("approach", &Quantity::Approach),
    ("shear", &Quantity::Shear { body: 0 }),
    ("shear-depth", &Quantity::ShearDepth { body: 0 }),
];
const NOWHERE: Displaced = Displaced { body: 0, at: Place::Point([f64::NAN; 2]), component: Component::Y };
/// How many of them an accuracy may be of.
pub(super) const OF_ACCURACY: usize = 4;

const KINDS: [(&str, ReferenceKind); 4] = [
    ("analytic", ReferenceKind::Analytic),
    ("cross-code", ReferenceKind::CrossCode),
    ("measured", ReferenceKind::Measured),
    ("self-consistency", ReferenceKind::SelfConsistency),
];

/// A check in the units of the scene, whose bodies were read from `bodies`.
pub(super) fn check(
    table: Value,
    bodies: &[Value],
    scene: &Scene,
    oracles: &[Option<SharedOracle>],
) -> Result<Check, Error> {
    let (name, units) = (table.at("quantity"), table.units);
    let asked = name.choice("quantity", &QUANTITIES)?;
    let contact = contact(table, asked, scene)?;
    let pair = &scene.contacts[contact];
    let is_straight = pair.path.is_straight();
    // What turns a contact coordinate of the file into mm or rad.
    let along = if is_straight { units.length } else { 1.0 / display_factor(&pair.path) };
    let at = place(table, asked, pair, along)?;
    refuse_unused(table, asked)?;
    let quantity = match asked {
        Quantity::Pressure { .. } => Quantity::Pressure { at },
        Quantity::Reaction { .. } => {
            let remedy = "add `support = { body = \"…\", at = \"…\", component = \"…\" }`, as the body lists it";
            let without = || name.refused("a reaction without its support", remedy);
            named::reaction(table.get("support").ok_or_else(without)?, bodies, &scene.bodies)?
        }
        Quantity::Displacement(_) => {
            let remedy = "add `of = { body = \"…\", at = \"…\", component = \"…\" }`; `at` may be a point";
            let of = table.get("of").ok_or_else(|| name.refused("a displacement without its place", remedy))?;
            Quantity::Displacement(named::displaced(of, &scene.bodies)?)
        }
        Quantity::Shear { .. } => Quantity::Shear { body: body(table, scene, pair)? },
        Quantity::ShearDepth { .. } => Quantity::ShearDepth { body: body(table, scene, pair)? },
        other => other.clone(),
    };
    if quantity == Quantity::Approach {
        refuse_no_approach(name, scene, contact)?;
    }
    let unit = match &quantity {
        Quantity::Resultant | Quantity::Reaction { .. } => units.force,
        Quantity::PeakPressure | Quantity::Pressure { .. } | Quantity::Shear { .. } => units.stress,
        Quantity::Displacement(_) | Quantity::Approach | Quantity::ShearDepth { .. } => units.length,
        // Given and told in degrees.
        _ if !is_straight => 1.0,
        _ => units.length,
    };
    let quantity = case::Quantity::on(scene, contact, quantity);
    let kind = table.get("kind").map(|kind| kind.choice("kind of reference", &KINDS)).transpose()?;
    let tolerance = table.at("tolerance").positive()?;
    let reference = match table.get("value") {
        Some(value) => Reference {
            name: table.get("source").map_or("the value given", Value::text).into(),
            kind: kind.unwrap_or(ReferenceKind::SelfConsistency),
            value: unit * value.finite()?,
            uncertainty: None,
        },
        None => read(table, &quantity, scene, contact, oracles[contact].as_ref())?,
    };
    let because = table.get("because").map_or("the tolerance given", Value::text).to_owned();
    let check = match reference.value.abs() > 0.0 {
        true => Check::near(quantity, reference, tolerance, because),
        // Nothing is relative to 0.
        false => Check::absolute(quantity, reference, unit * tolerance, because),
    };
    // As the tolerance: relative, or in the unit of the file.
    let scale = if check.relation == Relation::Near { 1.0 } else { unit };
    let model = table.get("model-error").map_or(Ok(0.0), Value::positive)?;
    Ok(Check { contact, model: scale * model, ..check })
}

/// The contact that is named; one that is not named must be the only one.
fn contact(table: Value, asked: &Quantity, scene: &Scene) -> Result<usize, Error> {
    let belongs_elsewhere = match asked {
        Quantity::Reaction { .. } => Some("a reaction belongs to a support"),
        Quantity::Displacement(_) => Some("a displacement belongs to a body"),
        _ => None,
    };
    let known: Vec<_> = scene.contacts.iter().enumerate().map(|(k, pair)| (pair.name.as_str(), k)).collect();
    match (table.get("contact"), belongs_elsewhere) {
        (Some(name), Some(belongs)) => Err(name.refused(belongs, "leave `contact` out")),
        (Some(name), None) => name.choice("contact", &known),
        (None, None) if known.len() > 1 => {
            let message = "the scene has several contacts, and the check does not say which it means";
            let remedy = format!("add `contact = \"…\"`, one of {}", listed(known.iter().map(|(name, _)| *name)));
            Err(table.at("quantity").refused(message, remedy))
        }
        (None, _) => Ok(0),
    }
}

/// Where a pressure is asked for \[mm, or rad on an arc\]; NaN for what has no place.
fn place(table: Value, asked: &Quantity, pair: &ContactPair, along: f64) -> Result<f64, Error> {
    let both = pair.path.has_both_sides();
    match (table.get("at"), asked) {
        (Some(at), Quantity::Pressure { .. }) => {
            let [end, shown] = [pair.stretch * (1.0 + 1e-9), pair.stretch / along];
            let begin = if both { format!("-{shown}") } else { "0".into() };
            let expected = format!("a coordinate from {begin} to {shown}, where contact may occur");
            Ok(along * at.within(&expected, |s| (along * s).abs() <= end && (both || s >= 0.0))?)
        }
        (None, Quantity::Pressure { .. }) => {
            Err(table.at("quantity").refused("a pressure without a place", "add `at`"))
        }
        (Some(at), _) => Err(at.refused("only `pressure` is taken at a place", "leave `at` out")),
        (None, Quantity::Centre) if !both => {
            let remedy = "leave the check out, or give `both-sides = true` in [contact]";
            Err(table.at("quantity").refused("a contact that begins at x = 0 has no `centre`", remedy))
        }
        (None, _) => Ok(f64::NAN),
    }
}

/// Refuses keys that belong to other quantities.
fn refuse_unused(table: Value, asked: &Quantity) -> Result<(), Error> {
    let is_below = matches!(asked, Quantity::Shear { .. } | Quantity::ShearDepth { .. });
    let keys = [
        ("support", matches!(asked, Quantity::Reaction { .. }), "only a `reaction` has a support"),
        ("of", matches!(asked, Quantity::Displacement(_)), "only a `displacement` is that of a place"),
        ("body", is_below, "only `shear` and `shear-depth` are taken in one body"),
    ];
    keys.into_iter().try_for_each(|(key, is_used, told)| {
        Value::refuse(table.get(key).filter(|_| !is_used), told, format!("leave `{key}` out"))
    })
}

/// Refuses the approach of bodies that have none.
fn refuse_no_approach(name: Value, scene: &Scene, contact: usize) -> Result<(), Error> {
    let message = "the contact has no `approach`: not every body of it is pressed along y at one side only, or all of \
        them are fixed";
    let has_none = scene.pressed_sides(contact).is_none();
    name.refuse_if(has_none, message, "ask for the `displacement` of the sides that are meant")
}

/// The body below whose surface the shear stress is meant; one that is not named must be the only one.
fn body(table: Value, scene: &Scene, pair: &ContactPair) -> Result<usize, Error> {
    let known: Vec<_> = pair.bodies().map(|body| (scene.bodies[body].name.as_str(), body)).collect();
    match (table.get("body"), known.as_slice()) {
        (Some(name), _) => name.choice("body of the contact", &known),
        (None, [(_, only)]) => Ok(*only),
        (None, _) => {
            let message = "the contact has two elastic bodies, and the check does not say which it means";
            let remedy = format!("add `body = \"…\"`, one of {}", listed(known.iter().map(|(name, _)| *name)));
            Err(table.at("quantity").refused(message, remedy))
        }
    }
}

/// What the closed form of the contact says of a quantity.
fn read(
    table: Value,
    quantity: &case::Quantity,
    scene: &Scene,
    contact: usize,
    oracle: Option<&SharedOracle>,
) -> Result<Reference, Error> {
    let name = table.at("quantity");
    let Some(oracle) = oracle else {
        let remedy = "give `value`, or the contact an `oracle`";
        return Err(name.refused("the check has nothing to be held against", remedy));
    };
    Value::refuse(table.get("kind"), "the kind is that of the oracle", "leave `kind` out")?;
    let reading = quantity.number().map(|number| Reference::of(oracle.as_ref(), scene, contact, number));
    let reference = reading.map(|reading| reading.times(quantity.factor()));
    reference.filter(|reference| reference.value.is_finite()).ok_or_else(|| {
        let message = format!("{} gives no {} here", oracle.name(), quantity.name());
        name.refused(message, "give `value`, or mend the numbers of the `oracle`")
    })
}
