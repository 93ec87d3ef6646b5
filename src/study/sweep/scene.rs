//! What is swept, and over which initial stiffnesses.

use serde::Serialize;

use crate::case::Case;
use crate::case::library::{Cylinder, PinRod};
use crate::mesh::Resolution;

/// What is swept.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Scene {
    /// The cylinder, candidates to twice the half-width.
    Cylinder,
    /// The pin in the connecting-rod eye.
    PinRod,
    /// The cylinder, candidates that end where the contact does.
    AtTheEdge,
}

impl Scene {
    /// The paper's two examples.
    pub const PAPER: [Self; 2] = [Self::Cylinder, Self::PinRod];

    /// Name in charts.
    pub fn name(self) -> &'static str {
        match self {
            Self::Cylinder => "cylinder",
            Self::PinRod => "pin-rod",
            Self::AtTheEdge => "candidates end at the edge",
        }
    }

    /// The case on the mesh of the sweep.
    pub(super) fn case(self) -> Case {
        let case = self.of_library();
        let elements = match self {
            Self::Cylinder | Self::AtTheEdge => 8,
            Self::PinRod => 12,
        };
        Case { resolution: Resolution { elements, ..case.resolution }, ..case }
    }

    /// The case on the mesh of the library.
    pub(super) fn of_library(self) -> Case {
        match self {
            Self::Cylinder => Cylinder::default().case(),
            Self::PinRod => PinRod::default().case(),
            Self::AtTheEdge => Cylinder { stretch: 1.0, ..Default::default() }.case(),
        }
    }
}

/// Start stiffnesses: half decades from 1e-3 to 1e6.
pub(super) fn stiffnesses() -> impl Iterator<Item = f64> {
    (-6..=12).map(|k| 10f64.powf(0.5 * f64::from(k)))
}
