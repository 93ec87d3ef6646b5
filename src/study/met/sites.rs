//! The sites of the survey: random scenes, and the accuracies asked for.

use crate::study::random::{Family, Site};

/// Relative errors asked for.
pub const ASKED: [f64; 4] = [1e-2, 3e-3, 1e-3, 3e-4];
/// Families whose mesh is fitted to one contact, and those whose mesh is halved, with the number of scenes of each.
pub const FAMILIES: [(Family, usize); 7] = [
    (Family::Polynomial, 80),
    (Family::Wedge, 80),
    (Family::Cosine, 80),
    (Family::Cylinder, 80),
    (Family::Pin, 80),
    (Family::Mesh, 40),
    (Family::Pair, 40),
];

/// Every scene, in the order of the record.
pub fn sites() -> Vec<Site> {
    FAMILIES.into_iter().flat_map(|(family, each)| (0..each).map(move |number| Site { family, number })).collect()
}
