//! Independent truth: what a result is held against, where it comes from, and how far it can be trusted.
//!
//! * [`analytic`]: closed forms, one file each.
//! * [`boundary`]: any profile on the half-plane, by a boundary method.
//! * [`cross_code`]: other finite element codes, run through Python or read from what such a run left.
//! * [`digitised`]: curves read off published figures, admitted only with their provenance.
//!
//! ```
//! use contact_vv::oracle::analytic::hertz::Hertz;
//! use contact_vv::oracle::{Oracle, Quantity, Reading};
//!
//! let hertz = Hertz { load: 1000.0, radius: 50.0, modulus: 230e3 };
//! assert!(matches!(hertz.read(Quantity::HalfWidth), Reading::Value { .. }));
//! assert!(matches!(hertz.read(Quantity::HoopStress { at: 0.0 }), Reading::Silent));
//! ```

use std::fmt;
use std::sync::Arc;

pub mod analytic;
pub mod boundary;
pub mod cross_code;
pub mod digitised;

/// What kind of truth a reference is; only `Analytic` verifies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, serde::Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ReferenceKind {
    /// A closed form: verification.
    Analytic,
    /// Another code: benchmarking.
    CrossCode,
    /// An experiment: validation.
    Measured,
    /// The same code asked in another way.
    SelfConsistency,
}

impl fmt::Display for ReferenceKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Analytic => "analytic",
            Self::CrossCode => "cross-code",
            Self::Measured => "measured",
            Self::SelfConsistency => "self-consistency",
        })
    }
}

/// Where a reference value comes from.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize)]
pub struct Source {
    /// Author, title, year, place in the text.
    pub citation: String,
    /// How it was obtained, such as "re-derived, original not at hand".
    pub note: String,
}

impl Source {
    fn new(citation: &str, note: &str) -> Self {
        Self { citation: citation.to_owned(), note: note.to_owned() }
    }
}

/// What is asked of an oracle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Quantity {
    /// Half-width of the contact, where its pressure ends \[mm\].
    HalfWidth,
    /// Half-width by second moment, `2 √(∫p s²/∫p)` \[mm\]; on arcs the same functional of the angle \[rad\].
    SecondMoment,
    /// Half-angle of the contact, from the load line to its edge \[rad\].
    ContactAngle,
    /// Largest contact pressure \[MPa\].
    PeakPressure,
    /// Contact force on the whole contact, per unit thickness \[N/mm\], positive in compression.
    Resultant,
    /// Contact pressure \[MPa\], positive in compression.
    Pressure {
        /// Distance from the centre of the contact \[mm\], or angle from the load line \[rad\].
        at: f64,
    },
    /// Circumferential stress on the rim of the hole \[MPa\], tension positive.
    HoopStress {
        /// Angle from the load line \[rad\].
        at: f64,
    },
    /// Circumferential stress on the rim of the pin \[MPa\], tension positive.
    PinHoopStress {
        /// Angle from the load line \[rad\].
        at: f64,
    },
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::HalfWidth => f.pad("half-width"),
            Self::SecondMoment => f.pad("half-width by second moment"),
            Self::ContactAngle => f.pad("contact half-angle"),
            Self::PeakPressure => f.pad("peak pressure"),
            Self::Resultant => f.pad("contact resultant"),
            Self::Pressure { at } => f.pad(&format!("pressure at {at}")),
            Self::HoopStress { at } => f.pad(&format!("hoop stress of the hole at {at}")),
            Self::PinHoopStress { at } => f.pad(&format!("hoop stress of the pin at {at}")),
        }
    }
}

/// What an oracle answers.
#[derive(Debug, Clone, PartialEq)]
pub enum Reading {
    /// A finite number.
    Value {
        /// The value, in the unit of the quantity.
        value: f64,
        /// Standard uncertainty ([`crate::uncertainty`]) in the same unit; zero for a closed form, which carries round-off only.
        uncertainty: f64,
    },
    /// The oracle says nothing about this quantity.
    Silent,
    /// The oracle should speak but cannot, and why.
    Unavailable(String),
}

/// An oracle that can be shared between threads.
pub type SharedOracle = Arc<dyn Oracle + Send + Sync>;

/// An independent source of reference values.
pub trait Oracle {
    /// Short name, as printed in tables.
    fn name(&self) -> &str;
    /// What kind of truth it is.
    fn kind(&self) -> ReferenceKind;
    /// Where it comes from.
    fn source(&self) -> Source;
    /// The reference value of a quantity, or why there is none.
    fn read(&self, quantity: Quantity) -> Reading;
}
