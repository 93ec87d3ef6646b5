//! The sites of the survey: random scenes, and the accuracies asked for.

use crate::study::random::{Family, Site, unseen};

/// Relative errors asked for.
pub const ASKED: [f64; 5] = [3e-2, 1e-2, 3e-3, 1e-3, 3e-4];
/// Families whose mesh is halved or made evenly finer, and scenes of each.
pub const EVENLY: [Family; 2] = [Family::Mesh, Family::Pair];
/// Scenes of each of these.
const EACH: usize = 20;
/// Scenes of each family of drawn gaps: sharp tops take large meshes.
const DRAWN: usize = 30;
/// Scenes of each other family.
const OTHERS: usize = 90;

/// All families but those whose peak has no limit.
pub fn families() -> impl Iterator<Item = Family> {
    let has_limit = |family: &Family| !matches!(family, Family::Punch | Family::Kink);
    unseen::FAMILIES.into_iter().filter(has_limit).chain(EVENLY)
}

/// Every scene, in the order of the record.
pub fn sites() -> Vec<Site> {
    let each = |family: Family| match family {
        Family::Mesh | Family::Pair => EACH,
        Family::Power | Family::Flat | Family::Skew | Family::Hump | Family::Ripple | Family::Blocks => DRAWN,
        Family::Layer | Family::Row => DRAWN,
        _ => OTHERS,
    };
    families().flat_map(|family| unseen::of(family).take(each(family))).collect()
}
