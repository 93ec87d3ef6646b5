//! The old names of cases.

use crate::case::definition::{Case, SharedOracle};
use crate::case::library::{self, Cylinder, PinPlate, TruncatedHertz};
use crate::error::Error;
use crate::scene::Scene;

/// A case.
pub type Problem = Case;
/// Names.
pub const PROBLEMS: [(&str, &str); 11] = library::NAMES;
/// Scene, elements of the default mesh, oracle.
pub type Parts = (Scene, usize, Option<SharedOracle>);

/// The case of a name.
pub fn problem(name: &str, a_over_r: Option<f64>) -> Result<Case, Error> {
    library::find(name, a_over_r)
}

fn parts(case: Case) -> Parts {
    (case.scene, case.resolution.elements, case.oracle)
}

/// Cylinder.
pub fn cylinder(numbers: Cylinder) -> Parts {
    parts(numbers.case())
}

/// Truncated Hertz.
pub fn truncated_hertz(numbers: TruncatedHertz) -> Parts {
    parts(numbers.case())
}

/// Plate.
pub fn plate(degrees: f64) -> PinPlate {
    PinPlate::of_half_angle(degrees)
}

/// Plate.
pub fn pin_plate(degrees: f64) -> Parts {
    parts(PinPlate::of_half_angle(degrees).case())
}

/// Bars.
pub fn bars(numbers: library::Bars) -> Parts {
    parts(numbers.case())
}

impl Case {
    /// A case from parts.
    pub fn new(name: &str, title: &str, (scene, elements, oracle): Parts) -> Self {
        Self { oracle, ..Self::of(name, title, scene, elements) }
    }
}
