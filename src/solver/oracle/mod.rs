//! Independent truth: what a result is held against, where it comes from, and how far it can be trusted.
//!
//! * [`analytic`]: closed forms, one file each.
//! * [`boundary`]: any profile on the half-plane, by a boundary method.
//!
//! ```
//! use signorini::oracle::analytic::hertz::Hertz;
//! use signorini::oracle::{Oracle, Quantity, Reading};
//!
//! let hertz = Hertz { load: 1000.0, radius: 50.0, modulus: 230e3 };
//! assert!(matches!(hertz.read(&Quantity::HalfWidth), Reading::Value { .. }));
//! assert!(matches!(hertz.read(&Quantity::HoopStress { at: 0.0 }), Reading::Silent));
//! ```

use std::fmt;
use std::sync::Arc;

pub mod analytic;
pub mod boundary;

pub use crate::measure::Quantity;

/// What kind of truth a reference is; only `Analytic` verifies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
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
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Source {
    /// Short name, as printed in tables.
    pub name: &'static str,
    /// Author, title, year, place in the text.
    pub citation: &'static str,
    /// How it was obtained, such as "re-derived, original not at hand".
    pub note: &'static str,
}

impl Source {
    /// All three.
    pub const fn new(name: &'static str, citation: &'static str, note: &'static str) -> Self {
        Self { name, citation, note }
    }
}

/// What an oracle answers.
#[derive(Debug, Clone, PartialEq)]
pub enum Reading {
    /// A finite number.
    Value {
        /// The value, in the unit of the quantity.
        value: f64,
        /// Standard uncertainty ([`crate::uncertainty`]) in the same unit; zero for a closed form, which carries
        /// round-off only.
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
    fn name(&self) -> &'static str {
        self.source().name
    }
    /// What kind of truth it is; a closed form where nothing else is said.
    fn kind(&self) -> ReferenceKind {
        ReferenceKind::Analytic
    }
    /// Where it comes from.
    fn source(&self) -> Source;
    /// The reference value of a quantity in its own unit, forces per unit thickness, or why there is none.
    fn read(&self, quantity: &Quantity) -> Reading;
}
