//! Which scenes the study holds, and to which accuracies they are solved.

use serde::{Deserialize, Serialize};

/// Relative errors asked for.
pub const ASKED: [f64; 4] = [1e-2, 3e-3, 1e-3, 3e-4];
/// Scenes of a family.
pub const EACH: usize = 80;

/// A kind of scene with a closed form.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Family {
    /// Even polynomials up to the sixth power, every second one with its peak off the centre.
    Polynomial,
    /// Wedges with a round tip.
    Wedge,
    /// Waves.
    Cosine,
    /// Cylinders on a rigid plane.
    Cylinder,
    /// Pins in a wide plate.
    Pin,
}

/// A scene of the study.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Site {
    /// Its family.
    pub family: Family,
    /// Its number in the family.
    pub number: usize,
}

impl Site {
    /// Name of its own.
    pub fn key(&self) -> String {
        format!("{}-{}", self.family.name(), self.number)
    }
}

impl Family {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::Polynomial, Self::Wedge, Self::Cosine, Self::Cylinder, Self::Pin];

    /// Name in the record.
    pub fn name(self) -> &'static str {
        match self {
            Self::Polynomial => "polynomial",
            Self::Wedge => "wedge",
            Self::Cosine => "cosine",
            Self::Cylinder => "cylinder",
            Self::Pin => "pin",
        }
    }

    /// Name in results.
    pub fn title(self) -> &'static str {
        match self {
            Self::Polynomial => "even polynomial on a block, peak also off the centre",
            Self::Wedge => "wedge with a round tip on a block",
            Self::Cosine => "waves on a block",
            Self::Cylinder => "cylinder on a plane",
            Self::Pin => "pin in a wide plate",
        }
    }
}

/// Every scene, in the order of the record.
pub fn sites() -> Vec<Site> {
    Family::ALL.into_iter().flat_map(|family| (0..EACH).map(move |number| Site { family, number })).collect()
}
