//! Colours, dashes and markers, safe for colour-blind readers (Okabe & Ito 2008).

use std::fmt;

/// A colour, red–green–blue.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Colour(pub u8, pub u8, pub u8);

impl fmt::Display for Colour {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "#{:02X}{:02X}{:02X}", self.0, self.1, self.2)
    }
}

/// The line element.
pub const LINE: Colour = Colour(0x00, 0x72, 0xB2);
/// The layer element.
pub const LAYER: Colour = Colour(0xD5, 0x5E, 0x00);
/// The node element.
pub const NODE: Colour = Colour(0x00, 0x9E, 0x73);
/// A fourth curve, of none of the three elements.
pub const PURPLE: Colour = Colour(0xCC, 0x79, 0xA7);
/// A fifth curve.
pub const SKY: Colour = Colour(0x56, 0xB4, 0xE9);
/// A sixth curve.
pub const ORANGE: Colour = Colour(0xE6, 0x9F, 0x00);
/// Text, frames and references.
pub const INK: Colour = Colour(0x22, 0x22, 0x22);
/// Secondary text.
pub const GREY: Colour = Colour(0x66, 0x66, 0x66);
/// Grid lines and quiet outlines.
pub const PALE: Colour = Colour(0xE4, 0xE4, 0xE0);
/// The card every figure stands on, so that it reads on light and on dark pages.
pub const CARD: Colour = Colour(0xFD, 0xFD, 0xFC);

/// Runs on maps, by how they ended: quick, ordinary, long; stopped off the contact by a little, by more, by much; then not
/// converged or stalled, cycling, diverged, unsupported, beyond the candidates.
pub const ENDS: [Colour; 11] = [
    Colour(0x00, 0x6D, 0x4F),
    Colour(0x5F, 0xC0, 0x92),
    Colour(0xCB, 0xE9, 0xD5),
    Colour(0xF6, 0xE8, 0xA8),
    Colour(0xE8, 0xC5, 0x47),
    Colour(0xA8, 0x86, 0x1D),
    Colour(0xD9, 0xD9, 0xD4),
    Colour(0xE6, 0x9F, 0x00),
    Colour(0xD5, 0x5E, 0x00),
    Colour(0x5A, 0x2A, 0x6B),
    Colour(0x56, 0xB4, 0xE9),
];

/// How a curve is dashed: names the algorithm.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dash {
    /// Varying stiffness.
    Solid,
    /// Constant stiffness.
    Dashed,
    /// Kinematic load.
    Dotted,
    /// A further variant.
    DashDot,
    /// References.
    Long,
    /// Points only: measured values.
    Absent,
}

impl Dash {
    /// Lengths drawn and left out in turn [display pixels].
    pub(super) fn pattern(self) -> &'static str {
        match self {
            Dash::Solid | Dash::Absent => "none",
            Dash::Dashed => "8 4.5",
            Dash::Dotted => "2.2 3.3",
            Dash::DashDot => "9 3.6 2.2 3.6",
            Dash::Long => "13 7",
        }
    }
}

/// The sign on the points of a curve: names the mesh or the formulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Marker {
    /// No sign.
    Absent,
    /// A disc.
    Circle,
    /// A square.
    Square,
    /// A square on its corner.
    Diamond,
    /// A triangle pointing up.
    Triangle,
    /// A triangle pointing down.
    Wedge,
    /// A diagonal cross.
    Cross,
}

/// How one curve is drawn.
#[derive(Clone, Copy, Debug)]
pub struct Style {
    /// The contact element.
    pub colour: Colour,
    /// The algorithm.
    pub dash: Dash,
    /// The mesh or the formulation.
    pub marker: Marker,
}

impl Style {
    /// A run of this suite.
    pub fn run(colour: Colour, dash: Dash, marker: Marker) -> Style {
        Style { colour, dash, marker }
    }

    /// An analytic reference: black, dashed, unmarked.
    pub fn reference() -> Style {
        Style::run(INK, Dash::Long, Marker::Absent)
    }

    /// Measured values: points without a line.
    pub fn measured(marker: Marker) -> Style {
        Style::run(INK, Dash::Absent, marker)
    }
}

/// The colours of a scalar field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColourMap {
    /// From yellow (small) over green to dark blue (large).
    Sequential,
    /// From blue over near-white at zero to red; the range is made symmetric.
    Diverging,
}

const SEQUENTIAL: [Colour; 6] = [
    Colour(0xFB, 0xF3, 0xC4),
    Colour(0xC2, 0xE0, 0x9B),
    Colour(0x5F, 0xC0, 0x92),
    Colour(0x2A, 0x93, 0x96),
    Colour(0x2A, 0x5F, 0x8D),
    Colour(0x3A, 0x1F, 0x62),
];

const DIVERGING: [Colour; 7] = [
    Colour(0x1B, 0x3F, 0x7A),
    Colour(0x3F, 0x86, 0xBC),
    Colour(0xA6, 0xCD, 0xE3),
    Colour(0xF6, 0xF4, 0xF0),
    Colour(0xF4, 0xB8, 0x92),
    Colour(0xCF, 0x5B, 0x43),
    Colour(0x7D, 0x13, 0x28),
];

impl ColourMap {
    /// Colour at a fraction 0…1 of the range.
    pub(super) fn colour(self, fraction: f64) -> Colour {
        let anchors: &[Colour] = match self {
            ColourMap::Sequential => &SEQUENTIAL,
            ColourMap::Diverging => &DIVERGING,
        };
        let place = fraction.clamp(0.0, 1.0) * (anchors.len() - 1) as f64;
        let below = (place.floor() as usize).min(anchors.len() - 2);
        blend(anchors[below], anchors[below + 1], place - below as f64)
    }
}

/// The colour thinned on the card: 1 leaves it, 0 is the card.
pub(super) fn tint(colour: Colour, share: f64) -> Colour {
    blend(CARD, colour, share)
}

fn blend(from: Colour, to: Colour, share: f64) -> Colour {
    let mix = |a: u8, b: u8| (f64::from(a) + share * (f64::from(b) - f64::from(a))).round() as u8;
    Colour(mix(from.0, to.0), mix(from.1, to.1), mix(from.2, to.2))
}
