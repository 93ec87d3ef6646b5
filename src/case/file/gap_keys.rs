//! The keys of a gap.

use std::fmt;

use serde::de::value::MapAccessDeserializer;
use serde::de::{Error as _, MapAccess, Visitor};
use serde::{Deserialize, Deserializer};

use crate::case::file::values::{Keyed, Name, Number, Pair};

/// `gap = "drawn"` or `gap = { … }`, as a function of the contact coordinate s.
#[derive(Debug)]
pub enum GapTable {
    /// `gap = "drawn"`: as the meshes of the bodies are drawn.
    Drawn,
    /// `from = "bodies"`: as their shapes are drawn.
    From(Name),
    /// The same everywhere; negative is interference.
    Uniform(Number),
    /// Flat punch of this half-width, nothing beyond.
    Punch(Number),
    /// Circle of this radius on a plane.
    Circle(Number),
    /// Circles of both sides: radius of the first and of the second, negative where it is hollow.
    Circles(Pair),
    /// Parabola s²/2R of this radius.
    Parabola(Number),
    /// Even polynomial: coefficients of s², s⁴, s⁶, and so on.
    Even(Vec<Number>),
    /// Wedge of this slope.
    Wedge(Number),
    /// Points [s, g]: straight between them, or a monotone cubic through them.
    Table {
        /// The points.
        points: Vec<Pair>,
        /// Whether it is the cubic.
        smooth: bool,
    },
    /// Waves.
    Cosine(Keyed<CosineTable>),
    /// Pin in a hole, measured on the pin.
    Hole(Keyed<HoleTable>),
    /// The same measured on the hole.
    Pin(Keyed<HoleTable>),
}

/// `cosine = { amplitude = Δ, wavelength = λ }`: Δ (1 − cos 2πs/λ).
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CosineTable {
    /// Half the height of the waves.
    pub amplitude: Number,
    /// From crest to crest.
    pub wavelength: Number,
}

/// `hole = { radius = R, clearance = c }`, or `pin = { … }`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct HoleTable {
    /// Radius of the pin.
    pub radius: Number,
    /// Radial clearance.
    pub clearance: Number,
}

/// All keys that a gap may have: one of them, and `smooth` beside `table`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Keys {
    from: Option<Name>,
    uniform: Option<Number>,
    punch: Option<Number>,
    circle: Option<Number>,
    circles: Option<Pair>,
    parabola: Option<Number>,
    even: Option<Vec<Number>>,
    wedge: Option<Number>,
    table: Option<Vec<Pair>>,
    smooth: Option<bool>,
    cosine: Option<Keyed<CosineTable>>,
    hole: Option<Keyed<HoleTable>>,
    pin: Option<Keyed<HoleTable>>,
}

impl<'de> Deserialize<'de> for GapTable {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct WordOrKeys;
        impl<'de> Visitor<'de> for WordOrKeys {
            type Value = GapTable;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("\"drawn\" or a table, as in { circle = 50 }")
            }

            fn visit_str<E: serde::de::Error>(self, word: &str) -> Result<GapTable, E> {
                if word == "drawn" { Ok(GapTable::Drawn) } else { Err(E::unknown_variant(word, &["drawn"])) }
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<GapTable, A::Error> {
                Keys::deserialize(MapAccessDeserializer::new(map))?.gap().map_err(A::Error::custom)
            }
        }
        deserializer.deserialize_any(WordOrKeys)
    }
}

impl Keys {
    /// The one gap that is given.
    fn gap(self) -> Result<GapTable, &'static str> {
        if self.smooth.is_some() && self.table.is_none() {
            return Err("`smooth` goes with a `table` only");
        }
        let smooth = self.smooth.unwrap_or(false);
        let given = [
            self.from.map(GapTable::From),
            self.uniform.map(GapTable::Uniform),
            self.punch.map(GapTable::Punch),
            self.circle.map(GapTable::Circle),
            self.circles.map(GapTable::Circles),
            self.parabola.map(GapTable::Parabola),
            self.even.map(GapTable::Even),
            self.wedge.map(GapTable::Wedge),
            self.table.map(|points| GapTable::Table { points, smooth }),
            self.cosine.map(GapTable::Cosine),
            self.hole.map(GapTable::Hole),
            self.pin.map(GapTable::Pin),
        ];
        let mut given = given.into_iter().flatten();
        match (given.next(), given.next()) {
            (Some(gap), None) => Ok(gap),
            (None, _) => Err("the gap has no key, and needs one, as in { circle = 50 }"),
            (Some(_), Some(_)) => Err("the gap has two keys, and takes one, as in { circle = 50 }"),
        }
    }
}
