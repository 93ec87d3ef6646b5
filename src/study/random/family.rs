//! Kinds of scenes with a closed form.

use serde::{Deserialize, Serialize};

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
    /// Parabolas on blocks: Hertz without model error.
    Hertz,
    /// Two elastic cylinders of any moduli.
    Cylinders,
    /// Rings pressed into one another.
    PressFit,
    /// Blocks under a load beside their middle.
    Eccentric,
    /// Flat punches with sharp corners.
    Punch,
    /// Whole blocks that roll on a parabola until the contact lies beside its vertex.
    Rolling,
}

/// A scene of a family.
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
    /// Name in records.
    pub fn name(self) -> &'static str {
        match self {
            Self::Polynomial => "polynomial",
            Self::Wedge => "wedge",
            Self::Cosine => "cosine",
            Self::Cylinder => "cylinder",
            Self::Pin => "pin",
            Self::Mesh => "mesh",
            Self::Pair => "pair",
            Self::Hertz => "hertz",
            Self::Cylinders => "cylinders",
            Self::PressFit => "press-fit",
            Self::Eccentric => "eccentric",
            Self::Punch => "punch",
            Self::Rolling => "rolling",
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
            Self::Hertz => "truncated Hertz",
            Self::Cylinders => "two cylinders of different moduli",
            Self::PressFit => "press fit of two rings",
            Self::Eccentric => "block under an eccentric load",
            Self::Punch => "flat punch on a block",
            Self::Rolling => "block that rolls on a parabola, contact beside its vertex",
        }
    }
}
