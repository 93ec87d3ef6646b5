//! Kinds of scenes whose truth is known.

use serde::{Deserialize, Serialize};

/// A kind of scene whose truth is known.
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
    /// Powers of the distance, from 1.5 to 30.
    Power,
    /// Flat bottoms with round shoulders.
    Flat,
    /// Different powers on both sides.
    Skew,
    /// Humps beside the middle: one half of two that are alike, or two of different heights.
    Hump,
    /// Waves on a parabola: one stretch or several.
    Ripple,
    /// Polygons, whose pressure has no limit at the corners.
    Kink,
    /// Two elastic blocks, gaps of all these kinds.
    Blocks,
    /// Elastic rings on rigid pins.
    Ring,
    /// Layers on rigid profiles, sliding on their base or bonded to it.
    Layer,
    /// One of a row of contacts.
    Row,
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
            Self::Power => "power",
            Self::Flat => "flat",
            Self::Skew => "skew",
            Self::Hump => "hump",
            Self::Ripple => "ripple",
            Self::Kink => "kink",
            Self::Blocks => "blocks",
            Self::Ring => "ring",
            Self::Layer => "layer",
            Self::Row => "row",
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
            Self::Power => "power of the distance, 1.5 to 30, on a block",
            Self::Flat => "flat bottom with round shoulders on a block",
            Self::Skew => "different powers on both sides of a block",
            Self::Hump => "one or two humps on a block",
            Self::Ripple => "waves on a parabola, on a block",
            Self::Kink => "polygon on a block",
            Self::Blocks => "two blocks of different moduli",
            Self::Ring => "ring on a rigid pin",
            Self::Layer => "layer, sliding or bonded",
            Self::Row => "row of contacts",
        }
    }
}
