//! The sites of the survey: families of scenes, and the accuracies asked for.

use serde::{Deserialize, Serialize};

/// Relative errors asked for.
pub const ASKED: [f64; 4] = [1e-2, 3e-3, 1e-3, 3e-4];
/// Scenes of a family whose mesh is fitted to one contact, and of one whose mesh is halved.
pub const EACH: [usize; 2] = [80, 40];

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
    /// Profiles on blocks, and cylinders, with a coarse mesh given.
    Mesh,
    /// Two profiles on blocks, cylinders or waves in one scene, whatever their sizes.
    Pair,
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
    pub const ALL: [Self; 7] =
        [Self::Polynomial, Self::Wedge, Self::Cosine, Self::Cylinder, Self::Pin, Self::Mesh, Self::Pair];

    /// Number of its scenes.
    pub fn each(self) -> usize {
        EACH[usize::from(matches!(self, Self::Mesh | Self::Pair))]
    }

    /// Name in the record.
    pub fn name(self) -> &'static str {
        match self {
            Self::Polynomial => "polynomial",
            Self::Wedge => "wedge",
            Self::Cosine => "cosine",
            Self::Cylinder => "cylinder",
            Self::Pin => "pin",
            Self::Mesh => "mesh",
            Self::Pair => "pair",
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
            Self::Mesh => "body with a coarse mesh given",
            Self::Pair => "two contacts",
        }
    }
}

/// Every scene, in the order of the record.
pub fn sites() -> Vec<Site> {
    Family::ALL.into_iter().flat_map(|family| (0..family.each()).map(move |number| Site { family, number })).collect()
}
