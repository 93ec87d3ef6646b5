//! The sites of the survey: random scenes, and the accuracies asked for.

use crate::study::random::{Family, Site, unseen};

/// Relative errors asked for.
pub const ASKED: [f64; 3] = [1e-2, 1e-3, 3e-4];
/// Families whose mesh is halved or made evenly finer, and scenes of each.
pub const EVENLY: [Family; 2] = [Family::Mesh, Family::Pair];
/// Scenes of each of these.
const EACH: usize = 40;

/// All families but flat punches, whose peak has no limit.
pub fn families() -> impl Iterator<Item = Family> {
    unseen::FAMILIES.into_iter().filter(|family| *family != Family::Punch).chain(EVENLY)
}

/// Every scene, in the order of the record.
pub fn sites() -> Vec<Site> {
    let of = |family: Family| unseen::of(family).take(if EVENLY.contains(&family) { EACH } else { unseen::EACH });
    families().flat_map(of).collect()
}
