//! Colours, dashes and markers, safe for colour-blind readers; colours of fields and of classes, the same on light and
//! dark pages.
//!
//! The hues are those of Okabe & Ito 2008, darkened for light pages and lightened for dark ones until a line of each
//! has a contrast of 3:1 with its card, and text in it, ink or grey one of 4.5:1 (WCAG 2.1, criteria 1.4.3 and 1.4.11).

use super::theme::{Colour, Theme, blend};

/// The line element.
pub const LINE: Colour = Colour::new(0x0072B2, 0x5AA9E6);
/// The layer element.
pub const LAYER: Colour = Colour::new(0xC04F00, 0xF07C33);
/// The node element.
pub const NODE: Colour = Colour::new(0x007F5C, 0x2FBF93);
/// A fourth curve, of none of the three elements.
pub const PURPLE: Colour = Colour::new(0xB4558C, 0xE09BC6);
/// A fifth curve.
pub const SKY: Colour = Colour::new(0x3A8FC6, 0x9AD7FF);
/// A sixth curve.
pub const ORANGE: Colour = Colour::new(0xB07A00, 0xF2B63C);
/// Text, frames and references.
pub const INK: Colour = Colour::new(0x222222, 0xE8E8E5);
/// Secondary text.
pub const GREY: Colour = Colour::new(0x666666, 0xA3A9B0);
/// Grid lines and quiet outlines.
pub const PALE: Colour = Colour::new(0xE4E4E0, 0x33383E);
/// The card every figure stands on.
pub const CARD: Colour = Colour::new(0xFDFDFC, 0x15181C);

/// Colours of curves.
pub const CURVES: [Colour; 6] = [LINE, LAYER, NODE, PURPLE, SKY, ORANGE];

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
    /// A point of a cloud, small.
    Dot,
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
}

/// The colour thinned on the card: 1 leaves it, 0 is the card.
pub(super) fn tint(colour: Colour, share: f64) -> Colour {
    blend(CARD, colour, share)
}

/// Fills of schematic drawings, bodies: of the element, of the layer, of the pin, of the rod; and the springs of a line
/// element.
const FILLS: [Colour; 8] = [
    Colour::new(0xE5E5E4, 0x2C2F34),
    Colour::new(0xF0D7C5, 0x452E21),
    Colour::new(0xCCE2EF, 0x364855),
    Colour::new(0xD2E5F0, 0x32424E),
    Colour::new(0xB9D7E9, 0x445B6B),
    Colour::new(0xEFE5CF, 0x3D3422),
    Colour::new(0x338EC1, 0x4C8CBE),
    PALE,
];

/// The colour of a page for light ones.
pub(super) fn partner(light: &str) -> Option<Colour> {
    CURVES.into_iter().chain([INK, GREY, CARD]).chain(FILLS).find(|one| one.on(Theme::Light).to_string() == light)
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
    Colour::same(0xFBF3C4),
    Colour::same(0xC2E09B),
    Colour::same(0x5FC092),
    Colour::same(0x2A9396),
    Colour::same(0x2A5F8D),
    Colour::same(0x3A1F62),
];

const DIVERGING: [Colour; 7] = [
    Colour::same(0x1B3F7A),
    Colour::same(0x3F86BC),
    Colour::same(0xA6CDE3),
    Colour::same(0xF6F4F0),
    Colour::same(0xF4B892),
    Colour::same(0xCF5B43),
    Colour::same(0x7D1328),
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

/// Classes on maps, from good to bad. Any two of them differ in brightness by at least 1.5:1, for those who see no
/// green too.
pub const CLASSES: [Colour; 7] = [
    Colour::same(0xFAF6C3),
    Colour::same(0x93D78F),
    Colour::same(0x35B489),
    Colour::same(0x9F6B3E),
    Colour::same(0x923B2F),
    Colour::same(0x512B67),
    Colour::same(0x23132F),
];
/// Text on classes.
pub const ON_CLASSES: [Colour; 7] = [BLACK, BLACK, BLACK, WHITE, WHITE, WHITE, WHITE];
const BLACK: Colour = Colour::same(0x000000);
const WHITE: Colour = Colour::same(0xFFFFFF);
