//! Scenes whose numbers were not used to choose how far anything is counted on.

use crate::study::random::{Family, Site};

/// Scenes of a family.
pub const EACH: usize = 200;
/// Number of the first one: from scenes of lower numbers the constants of the bars were chosen.
pub const FIRST: usize = 90_000;
/// Families with one contact and a mesh made here.
pub const FAMILIES: [Family; 21] = [
    Family::Hertz,
    Family::Polynomial,
    Family::Wedge,
    Family::Cosine,
    Family::Cylinder,
    Family::Cylinders,
    Family::Pin,
    Family::PressFit,
    Family::Eccentric,
    Family::Punch,
    Family::Rolling,
    Family::Power,
    Family::Flat,
    Family::Skew,
    Family::Hump,
    Family::Ripple,
    Family::Kink,
    Family::Blocks,
    Family::Ring,
    Family::Layer,
    Family::Row,
];

/// Families of smooth tops, of which every bar is judged; of the others, any gap with its truth by the boundary method or a series, those that
/// are told.
pub const JUDGED: [Family; 11] = [
    Family::Hertz,
    Family::Polynomial,
    Family::Wedge,
    Family::Cosine,
    Family::Cylinder,
    Family::Cylinders,
    Family::Pin,
    Family::PressFit,
    Family::Eccentric,
    Family::Punch,
    Family::Rolling,
];

/// Those of a family.
pub fn of(family: Family) -> impl Iterator<Item = Site> {
    (FIRST..FIRST + EACH).map(move |number| Site { family, number })
}
