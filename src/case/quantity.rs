//! What a check asks for: a number of a run, or a number that a study found.

use std::borrow::Cow;
use std::fmt;

use crate::markdown;
use crate::measure;
use crate::scene::Scene;

/// A quantity that can be held against something.
#[derive(Clone, Debug, PartialEq)]
pub enum Quantity {
    /// A number that one quotes of a run.
    Number {
        /// Which.
        of: measure::Quantity,
        /// What it lies along.
        along: Along,
    },
    /// Error of the pressure profile, relative in L2 over one and a half half-widths.
    Profile,
    /// Share of the force that other edge means carry elsewhere.
    EdgeMeans,
    /// Largest departure of any point from the pressure of the oracle, over the largest of that.
    Departure,
    /// A number of a study.
    Named {
        /// Noun phrase, as it stands in a sentence.
        name: Cow<'static, str>,
        /// Where, or of how many, it was found; empty where there is only one.
        at: String,
    },
}

/// What the contact coordinate of a number is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Along {
    /// A length on a straight path; also of what lies nowhere.
    Line,
    /// An angle on an arc: places and widths are told in degrees.
    Arc,
    /// The radius from the axis of bodies of revolution on: widths are radii of a circle.
    Radius,
}

impl From<&'static str> for Quantity {
    fn from(name: &'static str) -> Self {
        Self::at(name, "")
    }
}

/// A number of a contact on a straight path.
impl From<measure::Quantity> for Quantity {
    fn from(of: measure::Quantity) -> Self {
        Self::Number { of, along: Along::Line }
    }
}

impl Quantity {
    /// A number of a study, where it was found.
    pub fn at(name: impl Into<Cow<'static, str>>, at: impl Into<String>) -> Self {
        Self::Named { name: name.into(), at: at.into() }
    }

    /// A number of a contact of a scene.
    pub fn on(scene: &Scene, contact: usize, of: measure::Quantity) -> Self {
        match (scene.contacts[contact].path.is_straight(), scene.is_around_axis(contact)) {
            (false, _) => Self::on_arc(of),
            (true, false) => of.into(),
            (true, true) => Self::Number { of, along: Along::Radius },
        }
    }

    /// A number of a contact on an arc.
    pub fn on_arc(of: measure::Quantity) -> Self {
        let is_along = of.unit(true) != of.unit(false) || matches!(of, measure::Quantity::Pressure { .. });
        Self::Number { of, along: if is_along { Along::Arc } else { Along::Line } }
    }

    /// The number of a run that it is, if it is one.
    pub fn number(&self) -> Option<&measure::Quantity> {
        match self {
            Self::Number { of, .. } => Some(of),
            _ => None,
        }
    }

    /// The noun phrase, without the place.
    pub fn name(&self) -> &str {
        match self {
            Self::Number { of: measure::Quantity::HalfWidth, along: Along::Radius } => "contact radius",
            Self::Number { of: measure::Quantity::SecondMomentWidth, along: Along::Radius } => "second-moment radius",
            Self::Number { of, along } => of.name(*along == Along::Arc),
            Self::Profile => "error of the pressure profile in L2",
            Self::EdgeMeans => "share of the force elsewhere by edge means",
            Self::Departure => "largest departure of the pressure at any point, over the largest pressure",
            Self::Named { name, .. } => name,
        }
    }

    /// The unit of a number of a run; none of a pure number.
    pub fn unit(&self) -> Option<&'static str> {
        match self {
            Self::Number { of, along } => Some(of.unit(*along == Along::Arc).0),
            _ => None,
        }
    }

    /// What turns the number as it was measured into that unit.
    pub fn factor(&self) -> f64 {
        match self {
            Self::Number { of, along } => of.unit(*along == Along::Arc).1,
            _ => 1.0,
        }
    }

    /// The contact coordinate that a number of a run is taken at, such as `s = 4 mm`; none where its name says all.
    pub fn coordinate(&self) -> Option<String> {
        match self {
            Self::Number { of: measure::Quantity::Pressure { at }, along } => Some(match along {
                Along::Line => format!("s = {} mm", markdown::bound(*at)),
                Along::Radius => format!("r = {} mm", markdown::bound(*at)),
                Along::Arc => format!("s = {}°", markdown::bound(at.to_degrees())),
            }),
            Self::Number { of: measure::Quantity::HoopStress { at }, .. } => Some(format!("{:.0}°", at.to_degrees())),
            _ => None,
        }
    }

    /// Where it is: `at s = 4 mm`; none where its name says all.
    pub fn place(&self) -> Option<String> {
        match self {
            Self::Named { at, .. } => Some(at.to_string()).filter(|at| !at.is_empty()),
            _ => self.coordinate().map(|coordinate| format!("at {coordinate}")),
        }
    }
}

/// The noun phrase with its place and unit.
impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())?;
        if let Some(place) = self.place() {
            write!(f, "{}{place}", if matches!(self, Self::Named { .. }) { ", " } else { " " })?;
        }
        self.unit().map_or(Ok(()), |unit| write!(f, " [{unit}]"))
    }
}
