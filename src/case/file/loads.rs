//! Loads of a body.

use std::f64::consts::PI;

use crate::case::file::form::Form::{List, Number, OneOf, Table, Text};
use crate::case::file::form::{Form, PAIR, may, must};
use crate::case::file::named::{boundary, component, outer};
use crate::case::file::value::Value;
use crate::error::Error;
use crate::oracle::analytic::hertz::Hertz;
use crate::oracle::analytic::revolution::half_space::Potential;
use crate::scene::{Action, Along, Load, Material, PlaneHypothesis, Shape, SidePart, VectorField};

/// One load.
pub(super) const LOAD: Form = OneOf(&[
    // The same everywhere, by its total force, or by a law for each component; on all of a boundary or a part of it.
    (
        "traction",
        Table(&[
            must("at", Text),
            may("part", PART),
            may("value", PAIR),
            may("force", PAIR),
            may("x", LAW),
            may("y", LAW),
        ]),
    ),
    // Normal to the boundary, positive inwards.
    ("pressure", Table(&[must("at", Text), may("part", PART), must("law", LAW)])),
    // A couple on what is modelled, counter-clockwise.
    ("moment", Table(&[must("at", Text), may("part", PART), must("value", Number)])),
    // The stresses of a half-plane, or half-space, under Hertz's pressure, so that a truncated body has no model error;
    // `centre` is the middle of the contact.
    (
        "hertz",
        Table(&[must("at", Text), must("peak-pressure", Number), must("half-width", Number), may("centre", PAIR)]),
    ),
    // Force per volume.
    ("body-force", PAIR),
    // At a point.
    ("force", Table(&[must("at", PAIR), must("value", PAIR)])),
    // The face stays flat and takes a total force on what is modelled.
    ("rigid-face", Table(&[must("at", Text), must("component", Text), must("force", Number)])),
]);

/// `{ along = "x", from = 2, to = 5 }`, or `{ centre = [x, y], from = 30, to = 60 }` in degrees from the downward
/// vertical.
const PART: Form = Table(&[may("along", Text), may("centre", PAIR), must("from", Number), must("to", Number)]);

/// How a pressure or a component of a traction depends on the place.
const LAW: Form = OneOf(&[
    ("uniform", Number),
    // Σ c_k x^k, or of y.
    ("polynomial", Table(&[must("along", Text), must("coefficients", List(&Number))])),
    // Σ c_k cos kθ, θ from the downward vertical about the centre.
    ("cosine", Table(&[must("centre", PAIR), must("coefficients", List(&Number))])),
]);

/// A load on a body of a shape and a material.
pub(super) fn load(of: (PlaneHypothesis, Material), shape: &Shape, given: Value) -> Result<Load, Error> {
    let units = given.units;
    let (name, table) = given.only();
    let boundary = || boundary(shape, table.at("at"));
    Ok(match name {
        "traction" => traction(shape, table)?,
        "pressure" => {
            let (boundary, field) = (outer(shape, table.at("at"))?, pressure(table.at("law"))?);
            Load::OnSide { boundary, part: part(table)?, action: Action::Stress(field) }
        }
        "moment" => Load::OnSide {
            boundary: boundary()?,
            part: part(table)?,
            action: Action::Moment(units.force * units.length * table.at("value").finite()?),
        },
        "hertz" => Load::on(outer(shape, table.at("at"))?, Action::Stress(hertz(of, table)?)),
        "body-force" => Load::BodyForce(table.pair()?.map(|f| units.specific_weight() * f)),
        "force" => {
            Load::Force { at: table.at("at").point()?, force: table.at("value").pair()?.map(|f| units.force * f) }
        }
        "rigid-face" => Load::RigidFace {
            boundary: boundary()?,
            component: component(table.at("component"))?,
            force: units.force * table.at("force").finite()?,
        },
        _ => table.unknown(),
    })
}

/// Most coefficients of a law.
const MOST_TERMS: usize = 16;
/// Once around \[°\].
const FULL_TURN: f64 = 360.0;

/// A traction: the same everywhere, that of a total force, or each component by its law.
fn traction(shape: &Shape, table: Value) -> Result<Load, Error> {
    let units = table.units;
    let boundary = boundary(shape, table.at("at"))?;
    let part = part(table)?;
    let action = match ["value", "force", "x", "y"].map(|key| table.get(key)) {
        [Some(pair), None, None, None] => Action::Uniform(pair.pair()?.map(|t| units.stress * t)),
        [None, Some(pair), None, None] => Action::Total(pair.pair()?.map(|f| units.force * f)),
        [None, None, x, y] if x.is_some() || y.is_some() => {
            let component = |given: Option<Value>| given.map_or_else(|| Ok(Box::new(|_: [f64; 2]| 0.0) as Law), law);
            let (x, y) = (component(x)?, component(y)?);
            Action::Field(VectorField::of(move |point| [x(point), y(point)]))
        }
        _ => {
            let remedy = "give `value = [tx, ty]`, a total `force = [fx, fy]`, or a law for `x`, `y` or both";
            return Err(table.at("at").refused("the traction has no value, or two", remedy));
        }
    };
    Ok(Load::OnSide { boundary, part, action })
}

/// The part of a side that a load acts on; none where it acts on all of it.
fn part(load: Value) -> Result<Option<SidePart>, Error> {
    let Some(table) = load.get("part") else { return Ok(None) };
    let [from, to] = [table.at("from").finite()?, table.at("to").finite()?];
    let message = format!("the part goes from {from} to {to}, and has no length");
    table.refuse_if(from >= to, message, "give `from` below `to`")?;
    let (along, unit) = match (table.get("along"), table.get("centre")) {
        (Some(name), None) => (Along::Axis(component(name)?), table.units.length),
        (None, Some(centre)) => {
            let centre = centre.point()?;
            let message = format!("the part goes from {from} to {to} degrees, more than once around");
            table.refuse_if(to - from > FULL_TURN, message, format!("let it end {FULL_TURN} on at most"))?;
            (Along::Angle { centre }, 1f64.to_radians())
        }
        _ => {
            let remedy = "give `along = \"x\"` or \"y\", or for angles from the downward vertical `centre = [x, y]`";
            return Err(table.refused("the part has no coordinate, or two", remedy));
        }
    };
    Ok(Some(SidePart { along, from: unit * from, to: unit * to }))
}

/// The stress `σ = −p I`, whose traction on any side is the pressure.
fn pressure(given: Value) -> Result<VectorField<3>, Error> {
    let at = law(given)?;
    Ok(VectorField::of(move |point| {
        let p = at(point);
        [-p, -p, 0.0]
    }))
}

/// The stresses under `p = p₀ √(1 − (x/a)²)` on a half-plane above or below the contact \[MPa\].
///
/// Of bodies of revolution those below `p = p₀ √(1 − (r/a)²)` on a half-space, which depend on Poisson's ratio too.
fn hertz((plane, material): (PlaneHypothesis, Material), table: Value) -> Result<VectorField<3>, Error> {
    let peak = table.units.stress * table.at("peak-pressure").positive()?;
    let a = table.at("half-width").length()?;
    let [x0, y0] = table.get("centre").map_or(Ok([0.0; 2]), Value::point)?;
    if plane.is_of_revolution() {
        let is_elsewhere = x0.abs() > 0.0 || plane.radial() == Some(1);
        let message = "these stresses are those below a circle around the axis x = 0";
        table.refuse_if(is_elsewhere, message, "give a `centre` at x = 0, of bodies that are turned about x = 0")?;
        return Ok(VectorField::of(move |[r, y]| {
            let below = Potential::hertz(a, r, (y - y0).abs()).times(peak / a).stress(material.poisson);
            let [radial, axial, shear] = below.in_plane();
            [radial, axial, shear * (y - y0).signum()]
        }));
    }
    // Stresses depend on P and a alone: a² = 4PR/πE* holds with E* = 1.
    let load = 0.5 * PI * a * peak;
    let hertz = Hertz { load, radius: PI * a * a / (4.0 * load), modulus: 1.0 };
    Ok(VectorField::of(move |[x, y]| {
        let [along, across, shear] = hertz.stress(x - x0, (y - y0).abs());
        [along, across, shear * (y - y0).signum()]
    }))
}

/// A stress as a function of the place \[MPa\].
type Law = Box<dyn Fn([f64; 2]) -> f64 + Send + Sync>;

/// Uniform, a polynomial in a coordinate, or a cosine series in the angle.
fn law(given: Value) -> Result<Law, Error> {
    let units = given.units;
    let (name, table) = given.only();
    let coefficients = |per: f64| -> Result<Vec<f64>, Error> {
        let list = table.list("coefficients");
        let message = format!("the law has {} coefficients", list.len());
        given.refuse_if(list.is_empty() || list.len() > MOST_TERMS, message, format!("give 1 to {MOST_TERMS}"))?;
        list.iter().zip(0..).map(|(value, k)| Ok(units.stress * value.finite()? / per.powi(k))).collect()
    };
    Ok(match name {
        "uniform" => {
            let value = units.stress * table.finite()?;
            Box::new(move |_| value)
        }
        "polynomial" => {
            let k = component(table.at("along"))?.index();
            let coefficients = coefficients(units.length)?;
            Box::new(move |point| coefficients.iter().rev().fold(0.0, |sum, c| c + sum * point[k]))
        }
        "cosine" => {
            let [x, y] = table.at("centre").point()?;
            let coefficients = coefficients(1.0)?;
            Box::new(move |point| {
                let angle = (point[0] - x).atan2(y - point[1]);
                coefficients.iter().zip(0..).map(|(c, k)| c * (f64::from(k) * angle).cos()).sum()
            })
        }
        _ => table.unknown(),
    })
}
