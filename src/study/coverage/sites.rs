//! The sites of the survey: random scenes of every family with one contact and a mesh made here.

use crate::study::random::{Family, Site};

/// Scenes of a family.
pub const EACH: usize = 200;
/// Number of the first one: from scenes of lower numbers the constants of the bars were chosen.
pub const FIRST: usize = 50_000;
/// Families.
pub const FAMILIES: [Family; 10] = [
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
];

/// Every scene, in the order of the record.
pub fn sites() -> Vec<Site> {
    let of = |family| (FIRST..FIRST + EACH).map(move |number| Site { family, number });
    FAMILIES.into_iter().flat_map(of).collect()
}
