//! What is run: the record of each plane is read, and a part of it recomputed.

use crate::study::Planned;
use crate::study::atlas::plane::Plane;
use crate::study::atlas::run::{self, Numbers};

/// One trial a plane.
pub fn plan() -> Vec<Planned<Numbers>> {
    Plane::ALL.map(|plane| Planned::new("stability atlas", plane.name(), move || run::of_plane(plane))).into()
}
