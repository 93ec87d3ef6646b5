//! The keys of a load.

use serde::Deserialize;
use toml::Spanned;

use crate::case::file::hertz_load::HertzLoadTable;
use crate::case::file::values::{Keyed, Name, Number, Pair};

/// One load.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum LoadTable {
    /// `{ traction = { at = "far", value = [tx, ty] } }`, or `x` and `y` each with a law.
    Traction(Keyed<TractionTable>),
    /// `{ pressure = { at = "far", law = { … } } }`, normal to the boundary, positive inwards.
    Pressure(Keyed<PressureTable>),
    /// `{ moment = { at = "far", value = 500 } }`, a couple, counter-clockwise.
    Moment(Keyed<MomentTable>),
    /// `{ hertz = { at = "far", peak-pressure = p0, half-width = a } }`, the stresses of a half-plane under Hertz's pressure.
    Hertz(Keyed<HertzLoadTable>),
    /// `{ body-force = [fx, fy] }`, force per volume.
    BodyForce(Pair),
    /// `{ force = { at = [x, y], value = [fx, fy] } }`.
    Force(Keyed<ForceTable>),
    /// `{ rigid-face = { at = "far", component = "y", force = -100 } }`: the face stays flat and takes a total force.
    RigidFace(Keyed<RigidFaceTable>),
}

/// A traction on a boundary.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TractionTable {
    /// Boundary.
    pub at: Name,
    /// The part of it that carries the load; all of it where it is left out.
    pub part: Option<Spanned<Keyed<PartTable>>>,
    /// Components where they are the same everywhere.
    pub value: Option<Pair>,
    /// Total force on what is modelled, spread evenly.
    pub force: Option<Pair>,
    /// How the first component depends on the place; 0 where it is left out.
    pub x: Option<Spanned<LawTable>>,
    /// How the second does.
    pub y: Option<Spanned<LawTable>>,
}

/// A pressure on a boundary.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PressureTable {
    /// Boundary.
    pub at: Name,
    /// The part of it that carries the load; all of it where it is left out.
    pub part: Option<Spanned<Keyed<PartTable>>>,
    /// How it depends on the place.
    pub law: Spanned<LawTable>,
}

/// A couple on a boundary.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MomentTable {
    /// Boundary.
    pub at: Name,
    /// The part of it that carries the couple; all of it where it is left out.
    pub part: Option<Spanned<Keyed<PartTable>>>,
    /// Moment on what is modelled, counter-clockwise.
    pub value: Number,
}

/// `part = { along = "x", from = 2, to = 5 }`, or `{ centre = [x, y], from = 30, to = 60 }` in degrees.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PartTable {
    /// x or y.
    pub along: Option<Name>,
    /// Centre of the angle from the downward vertical.
    pub centre: Option<Pair>,
    /// Where the part begins.
    pub from: Number,
    /// Where it ends.
    pub to: Number,
}

/// How a pressure or a component of a traction depends on the place.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum LawTable {
    /// The same everywhere.
    Uniform(Number),
    /// `Σ c_k x^k`, or of y.
    Polynomial(Keyed<PolynomialTable>),
    /// `Σ c_k cos kθ`.
    Cosine(Keyed<SeriesTable>),
}

/// `polynomial = { along = "x", coefficients = [c0, c1, …] }`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PolynomialTable {
    /// x or y.
    pub along: Name,
    /// From the constant one on.
    pub coefficients: Vec<Number>,
}

/// `cosine = { centre = [x, y], coefficients = [c0, c1, …] }`, θ from the downward vertical about the centre.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SeriesTable {
    /// Centre of the angle.
    pub centre: Pair,
    /// From the constant one on.
    pub coefficients: Vec<Number>,
}

/// A force at a point.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ForceTable {
    /// The point.
    pub at: Pair,
    /// Components.
    pub value: Pair,
}

/// A total force on a face that stays flat.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RigidFaceTable {
    /// Boundary.
    pub at: Name,
    /// x or y.
    pub component: Name,
    /// Total force on the modelled half.
    pub force: Number,
}
