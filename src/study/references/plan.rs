//! Which scenes.

use crate::case::Case;
use crate::case::library::{Cylinder, find};
use crate::study::Planned;
use crate::study::references::run::{Numbers, numbers};

/// Cases of the library.
const NAMED: [&str; 3] = ["cylinder", "pin-rod", "pin-plate"];

/// One trial a scene: those of the library, and the cylinder with a contact twice as wide.
pub fn plan() -> Vec<Planned<Numbers>> {
    let wide = Cylinder { a_over_r: 0.1, ..Cylinder::default() }.case().named("cylinder, a/R = 0.1");
    let known = NAMED.map(|name| find(name, None));
    let trial = |name: String, case: Result<Case, crate::error::Error>| {
        Planned::new("reference answers", name, move || numbers(case.as_ref().map_err(Clone::clone)?))
    };
    let named = NAMED.iter().zip(known).map(|(name, case)| trial((*name).into(), case));
    named.chain([trial(wide.name.clone(), Ok(wide.clone()))]).collect()
}
