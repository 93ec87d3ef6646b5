//! Colours, dashes and markers, safe for colour-blind readers (Okabe & Ito 2008).

use plotters::style::RGBColor;

/// A colour, red–green–blue.
pub type Colour = RGBColor;

/// The line element.
pub const LINE: Colour = RGBColor(0x00, 0x72, 0xB2);
/// The layer element.
pub const LAYER: Colour = RGBColor(0xD5, 0x5E, 0x00);
/// The node element.
pub const NODE: Colour = RGBColor(0x00, 0x9E, 0x73);
/// A fourth curve, of none of the three elements.
pub const PURPLE: Colour = RGBColor(0xCC, 0x79, 0xA7);
/// A fifth curve.
pub const SKY: Colour = RGBColor(0x56, 0xB4, 0xE9);
/// A sixth curve.
pub const ORANGE: Colour = RGBColor(0xE6, 0x9F, 0x00);
/// Text, frames and references.
pub const INK: Colour = RGBColor(0x22, 0x22, 0x22);
/// Secondary text.
pub const GREY: Colour = RGBColor(0x66, 0x66, 0x66);
/// Grid lines and quiet outlines.
pub const PALE: Colour = RGBColor(0xE4, 0xE4, 0xE0);
/// The card every figure stands on, so that it reads on light and on dark pages.
pub const CARD: Colour = RGBColor(0xFD, 0xFD, 0xFC);

/// Runs on maps, by how they ended: quick, ordinary, long; stopped off the contact by a little, by more, by much; then slow or
/// stalled, cycling, diverged, unsupported, spilled.
pub const ENDS: [Colour; 11] = [
    RGBColor(0x00, 0x6D, 0x4F),
    RGBColor(0x5F, 0xC0, 0x92),
    RGBColor(0xCB, 0xE9, 0xD5),
    RGBColor(0xF6, 0xE8, 0xA8),
    RGBColor(0xE8, 0xC5, 0x47),
    RGBColor(0xA8, 0x86, 0x1D),
    RGBColor(0xD9, 0xD9, 0xD4),
    RGBColor(0xE6, 0x9F, 0x00),
    RGBColor(0xD5, 0x5E, 0x00),
    RGBColor(0x5A, 0x2A, 0x6B),
    RGBColor(0x56, 0xB4, 0xE9),
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
    /// Lengths drawn and left out in turn [display pixels]; empty when solid.
    pub(super) fn pattern(self) -> &'static [f64] {
        match self {
            Dash::Solid | Dash::Absent => &[],
            Dash::Dashed => &[8.0, 4.5],
            Dash::Dotted => &[2.2, 3.3],
            Dash::DashDot => &[9.0, 3.6, 2.2, 3.6],
            Dash::Long => &[13.0, 7.0],
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
    RGBColor(0xFB, 0xF3, 0xC4),
    RGBColor(0xC2, 0xE0, 0x9B),
    RGBColor(0x5F, 0xC0, 0x92),
    RGBColor(0x2A, 0x93, 0x96),
    RGBColor(0x2A, 0x5F, 0x8D),
    RGBColor(0x3A, 0x1F, 0x62),
];

const DIVERGING: [Colour; 7] = [
    RGBColor(0x1B, 0x3F, 0x7A),
    RGBColor(0x3F, 0x86, 0xBC),
    RGBColor(0xA6, 0xCD, 0xE3),
    RGBColor(0xF6, 0xF4, 0xF0),
    RGBColor(0xF4, 0xB8, 0x92),
    RGBColor(0xCF, 0x5B, 0x43),
    RGBColor(0x7D, 0x13, 0x28),
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
    RGBColor(mix(from.0, to.0), mix(from.1, to.1), mix(from.2, to.2))
}
