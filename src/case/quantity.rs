//! What a check asks for: a number of a run, or a number that a study found.

use std::borrow::Cow;
use std::fmt;

use crate::error::Coordinate;
use crate::markdown;
use crate::oracle;
use crate::solve::Displaced;

/// A quantity that can be held against something.
#[derive(Clone, Debug, PartialEq)]
pub enum Quantity {
    /// Largest pressure of the profile \[MPa\].
    PeakPressure,
    /// Half-width: half of what lies between begin and end of the contact, on a straight path \[mm\].
    HalfWidth,
    /// The same on an arc \[°\].
    HalfAngle,
    /// Second-moment width `2 √(∫p s²/∫p)` on a straight path \[mm\].
    SecondMomentWidth,
    /// The same functional of the angle on an arc \[°\].
    SecondMomentAngle,
    /// Centre of pressure \[mm\].
    Centre,
    /// Force on the whole contact along the load line \[N\].
    Resultant,
    /// Contact pressure \[MPa\].
    Pressure {
        /// Contact coordinate.
        at: Coordinate,
    },
    /// Circumferential stress of the secondary body's contact side \[MPa\].
    HoopStress {
        /// Contact coordinate \[rad\].
        at: f64,
    },
    /// Force of a support \[N\].
    Reaction {
        /// Index of the body.
        body: usize,
        /// Index of the support among those of the body.
        support: usize,
    },
    /// Displacement of a side, as its mean, or of a point \[mm\].
    Displacement(Displaced),
    /// Approach of the bodies of the contact, positive where they have come nearer \[mm\].
    Approach,
    /// Largest in-plane shear stress below the contact \[MPa\].
    Shear {
        /// Index of the body.
        body: usize,
    },
    /// Its depth below the surface \[mm\].
    ShearDepth {
        /// Index of the body.
        body: usize,
    },
    /// Error of the pressure profile, relative in L2 over one and a half half-widths.
    Profile,
    /// Share of the force that other edge means carry elsewhere.
    EdgeMeans,
    /// Largest departure of any point from the pressure of the oracle, over the largest of that.
    Departure,
    /// Degrees of freedom of the mesh.
    Dofs,
    /// A number of a study.
    Named {
        /// Noun phrase, as it stands in a sentence.
        name: Cow<'static, str>,
        /// Where, or of how many, it was found; empty where there is only one.
        at: String,
    },
}

impl Quantity {
    /// A number of a study, where it was found.
    pub fn at(name: impl Into<Cow<'static, str>>, at: impl Into<String>) -> Self {
        Self::Named { name: name.into(), at: at.into() }
    }

    /// The noun phrase, without the place.
    pub fn name(&self) -> &str {
        match self {
            Self::PeakPressure => "peak pressure",
            Self::HalfWidth => "half-width",
            Self::HalfAngle => "half-angle",
            Self::SecondMomentWidth | Self::SecondMomentAngle => "second-moment width",
            Self::Centre => "centre of pressure",
            Self::Resultant => "contact resultant",
            Self::Pressure { .. } => "contact pressure",
            Self::HoopStress { .. } => "hoop stress",
            Self::Reaction { .. } => "reaction",
            Self::Displacement(_) => "displacement",
            Self::Approach => "approach",
            Self::Shear { .. } => "largest shear stress below the contact",
            Self::ShearDepth { .. } => "depth of the largest shear stress",
            Self::Profile => "error of the pressure profile in L2",
            Self::EdgeMeans => "share of the force elsewhere by edge means",
            Self::Departure => "largest departure of the pressure at any point, over the largest pressure",
            Self::Dofs => "degrees of freedom",
            Self::Named { name, .. } => name,
        }
    }

    /// What an oracle is asked for it, and what turns the reading into this quantity: angles are read in radians, forces per
    /// thickness \[mm\]. None of what no oracle reads.
    pub fn of_oracle(&self, thickness: f64) -> Option<(oracle::Quantity, f64)> {
        let degrees = 1f64.to_degrees();
        Some(match self {
            Self::PeakPressure | Self::Departure => (oracle::Quantity::PeakPressure, 1.0),
            Self::HalfWidth => (oracle::Quantity::HalfWidth, 1.0),
            Self::HalfAngle => (oracle::Quantity::ContactAngle, degrees),
            Self::SecondMomentWidth => (oracle::Quantity::SecondMoment, 1.0),
            Self::SecondMomentAngle => (oracle::Quantity::SecondMoment, degrees),
            Self::Pressure { at } => (oracle::Quantity::Pressure { at: at.value() }, 1.0),
            Self::HoopStress { at } => (oracle::Quantity::HoopStress { at: *at }, 1.0),
            Self::Resultant => (oracle::Quantity::Resultant, thickness),
            _ => return None,
        })
    }

    /// The unit of a number of a run; none of a pure number.
    pub fn unit(&self) -> Option<&'static str> {
        match self {
            Self::PeakPressure | Self::Pressure { .. } | Self::HoopStress { .. } | Self::Shear { .. } => Some("MPa"),
            Self::HalfAngle | Self::SecondMomentAngle => Some("°"),
            Self::HalfWidth
            | Self::SecondMomentWidth
            | Self::Centre
            | Self::Displacement(_)
            | Self::Approach
            | Self::ShearDepth { .. } => Some("mm"),
            Self::Resultant | Self::Reaction { .. } => Some("N"),
            _ => None,
        }
    }
}

impl From<&'static str> for Quantity {
    fn from(name: &'static str) -> Self {
        Self::at(name, "")
    }
}

impl Quantity {
    /// Where it is: `at s = 4 mm`; none where its name says all.
    pub fn place(&self) -> Option<String> {
        match self {
            Self::Pressure { at: Coordinate::Length(at) } => Some(format!("at s = {} mm", markdown::bound(*at))),
            Self::Pressure { at: Coordinate::Angle(at) } => {
                Some(format!("at s = {}°", markdown::bound(at.to_degrees())))
            }
            Self::HoopStress { at } => Some(format!("at {:.0}°", at.to_degrees())),
            Self::Named { at, .. } => Some(at.to_string()).filter(|at| !at.is_empty()),
            _ => None,
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
