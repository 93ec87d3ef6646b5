//! Colours of scalar fields and of classes on maps: the same on light and dark pages.

use super::theme::{Colour, blend};

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

/// Classes on maps, from good to bad. Any two of them differ in brightness by at least 1.5:1, for those who see no green too.
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
