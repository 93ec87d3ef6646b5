//! The sites of the survey: random scenes of every family with one contact and a mesh made here.

use crate::study::random::{Site, unseen};

pub use crate::study::random::unseen::{EACH, FAMILIES, FIRST, JUDGED};

/// Every scene, in the order of the record.
pub fn sites() -> Vec<Site> {
    FAMILIES.into_iter().flat_map(unseen::of).collect()
}
