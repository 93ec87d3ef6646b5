//! Loads from their tables.

use std::sync::Arc;

use toml::Spanned;

use crate::case::file::Source;
use crate::case::file::load_keys::{LawTable, LoadTable, PartTable, TractionTable};
use crate::case::file::named::{boundary, component, refuse_inside};
use crate::case::file::units::Units;
use crate::case::file::values::Keyed;
use crate::error::Error;
use crate::scene::{Action, Along, Load, Shape, SidePart, StressField, TractionField};

/// A load on a body of a shape.
pub(super) fn load(source: Source, units: &Units, shape: &Shape, table: &Spanned<LoadTable>) -> Result<Load, Error> {
    Ok(match table.get_ref() {
        LoadTable::Traction(table) => traction(source, units, shape, table)?,
        LoadTable::Pressure(table) => {
            refuse_inside(source, shape, &table.at)?;
            let (boundary, field) = (boundary(source, units, shape, &table.at)?, pressure(source, units, &table.law)?);
            match part(source, units, table.part.as_ref())? {
                None => Load::Stress { boundary, field },
                part => Load::OnSide { boundary, part, action: Action::Stress(field) },
            }
        }
        LoadTable::Moment(table) => Load::OnSide {
            boundary: boundary(source, units, shape, &table.at)?,
            part: part(source, units, table.part.as_ref())?,
            action: Action::Moment(units.force * units.length * source.finite("value", &table.value)?),
        },
        LoadTable::Hertz(table) => {
            refuse_inside(source, shape, &table.at)?;
            Load::Stress { boundary: boundary(source, units, shape, &table.at)?, field: table.field(source, units)? }
        }
        LoadTable::BodyForce(pair) => {
            let density = units.force / units.length.powi(3);
            Load::BodyForce(source.pair("body-force", pair)?.map(|f| density * f))
        }
        LoadTable::Force(table) => Load::Force {
            at: source.pair("at", &table.at)?.map(|x| units.length * x),
            force: source.pair("value", &table.value)?.map(|f| units.force * f),
        },
        LoadTable::RigidFace(table) => Load::RigidFace {
            boundary: boundary(source, units, shape, &table.at)?,
            component: component(source, &table.component)?,
            force: units.force * source.finite("force", &table.force)?,
        },
    })
}

/// Most coefficients of a law.
const MOST_TERMS: usize = 16;
/// Once around \[°\].
const FULL_TURN: f64 = 360.0;

/// A traction: the same everywhere, that of a total force, or each component by its law.
fn traction(source: Source, units: &Units, shape: &Shape, table: &TractionTable) -> Result<Load, Error> {
    let boundary = boundary(source, units, shape, &table.at)?;
    let part = part(source, units, table.part.as_ref())?;
    let action = match (&table.value, &table.force, &table.x, &table.y) {
        (Some(pair), None, None, None) => Action::Uniform(source.pair("value", pair)?.map(|t| units.stress * t)),
        (None, Some(pair), None, None) => Action::Total(source.pair("force", pair)?.map(|f| units.force * f)),
        (None, None, x, y) if x.is_some() || y.is_some() => {
            let component = |given: &Option<Spanned<LawTable>>| {
                given.as_ref().map_or_else(|| Ok(Box::new(|_: [f64; 2]| 0.0) as Law), |given| law(source, units, given))
            };
            let (x, y) = (component(x)?, component(y)?);
            Action::Field(TractionField(Arc::new(move |point| [x(point), y(point)])))
        }
        _ => {
            let remedy = "give `value = [tx, ty]`, a total `force = [fx, fy]`, or a law for `x`, `y` or both";
            return Err(source.refused(table.at.span(), "the traction has no value, or two", remedy));
        }
    };
    Ok(match (part, action) {
        (None, Action::Uniform(traction)) => Load::Traction { boundary, traction },
        (None, Action::Field(field)) => Load::TractionField { boundary, field },
        (part, action) => Load::OnSide { boundary, part, action },
    })
}

/// The part of a side that a load acts on; none where it acts on all of it.
fn part(source: Source, units: &Units, table: Option<&Spanned<Keyed<PartTable>>>) -> Result<Option<SidePart>, Error> {
    let Some(spanned) = table else { return Ok(None) };
    let table = spanned.get_ref();
    let [from, to] = [source.finite("from", &table.from)?, source.finite("to", &table.to)?];
    if from >= to {
        let message = format!("the part goes from {from} to {to}, and has no length");
        return Err(source.refused(spanned.span(), message, "give `from` below `to`"));
    }
    let (along, unit) = match (&table.along, &table.centre) {
        (Some(name), None) => (Along::Axis(component(source, name)?), units.length),
        (None, Some(centre)) => {
            let centre = source.pair("centre", centre)?.map(|x| units.length * x);
            if to - from > FULL_TURN {
                let message = format!("the part goes from {from} to {to} degrees, more than once around");
                return Err(source.refused(spanned.span(), message, format!("let it end {FULL_TURN} on at most")));
            }
            (Along::Angle { centre }, 1f64.to_radians())
        }
        _ => {
            let remedy = "give `along = \"x\"` or \"y\", or for angles from the downward vertical `centre = [x, y]`";
            return Err(source.refused(spanned.span(), "the part has no coordinate, or two", remedy));
        }
    };
    Ok(Some(SidePart { along, from: unit * from, to: unit * to }))
}

/// The stress `σ = −p I`, whose traction on any side is the pressure.
fn pressure(source: Source, units: &Units, given: &Spanned<LawTable>) -> Result<StressField, Error> {
    let at = law(source, units, given)?;
    Ok(StressField(Arc::new(move |point| {
        let p = at(point);
        [-p, -p, 0.0]
    })))
}

/// A stress as a function of the place \[MPa\].
type Law = Box<dyn Fn([f64; 2]) -> f64 + Send + Sync>;

/// Uniform, a polynomial in a coordinate, or a cosine series in the angle.
fn law(source: Source, units: &Units, law: &Spanned<LawTable>) -> Result<Law, Error> {
    let list = |given: &[Spanned<f64>], per: f64| -> Result<Vec<f64>, Error> {
        if given.is_empty() || given.len() > MOST_TERMS {
            let message = format!("the law has {} coefficients", given.len());
            return Err(source.refused(law.span(), message, format!("give 1 to {MOST_TERMS}")));
        }
        let each = given
            .iter()
            .enumerate()
            .map(|(k, value)| Ok(units.stress * source.finite("coefficients", value)? / per.powi(k as i32)));
        each.collect()
    };
    Ok(match law.get_ref() {
        LawTable::Uniform(value) => {
            let value = units.stress * source.finite("uniform", value)?;
            Box::new(move |_| value)
        }
        LawTable::Polynomial(table) => {
            let k = component(source, &table.along)?.index();
            let coefficients = list(&table.coefficients, units.length)?;
            Box::new(move |point| coefficients.iter().rev().fold(0.0, |sum, c| c + sum * point[k]))
        }
        LawTable::Cosine(table) => {
            let [x, y] = source.pair("centre", &table.centre)?.map(|x| units.length * x);
            let coefficients = list(&table.coefficients, 1.0)?;
            Box::new(move |point| {
                let angle = (point[0] - x).atan2(y - point[1]);
                coefficients.iter().zip(0..).map(|(c, k)| c * (f64::from(k) * angle).cos()).sum()
            })
        }
    })
}
