//! Comparison errors with another code, and what their uncertainties are made of (ASME V&V 20-2009).

use std::f64::consts::PI;

use serde::Serialize;

use crate::markdown;
use crate::oracle::cross_code::Method;
use crate::study::cross_code::benchmark::Scene;
use crate::study::cross_code::physical::{ClosedForm, Compared, Finder, Found, Measured};
use crate::uncertainty::Comparison;

/// A number that is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Number {
    /// Peak pressure.
    Peak,
    /// Half-width by second moment.
    Width,
}

impl Number {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Peak, Self::Width];

    /// The number of a code, in its unit.
    pub fn of(self, scene: Scene, found: &Found) -> Measured {
        match self {
            Self::Peak => found.peak,
            Self::Width => found.half_width.times(self.per_unit(scene)),
        }
    }

    /// The number of a closed form, in its unit.
    pub fn of_closed_form(self, scene: Scene, closed: &ClosedForm) -> f64 {
        match self {
            Self::Peak => closed.peak,
            Self::Width => closed.half_width * self.per_unit(scene),
        }
    }

    /// Factor from MPa, mm or rad to its unit: angles are told in degrees.
    pub fn per_unit(self, scene: Scene) -> f64 {
        match self {
            Self::Width if scene.is_arc() => 180.0 / PI,
            Self::Peak | Self::Width => 1.0,
        }
    }

    /// Its name.
    pub fn noun(self) -> &'static str {
        match self {
            Self::Peak => "peak pressure",
            Self::Width => "second-moment width",
        }
    }

    /// Its unit, and its symbol where that differs from scene to scene.
    pub fn unit(self, scene: Scene) -> &'static str {
        match self {
            Self::Peak => "[MPa]",
            Self::Width if scene.is_arc() => "2 √(∫pθ²/∫p) [°]",
            Self::Width => "a [mm]",
        }
    }

    /// Its name with its unit.
    pub fn name(self, scene: Scene) -> String {
        format!("{}, {}", self.noun(), self.unit(scene))
    }
}

/// Standard uncertainties of a comparison, in the unit of the number.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Sources {
    /// Of our mesh.
    pub ours: f64,
    /// Of their mesh.
    pub theirs: f64,
    /// Of their penalty: what it differs by from exact contact in one code on the same meshes, both in the limit; 0 without. Springs
    /// of the same stiffness change our own answers by far less round a pin: there it is the two pressures an edge, which scatter from
    /// edge to edge where meshes do not match.
    pub penalty: f64,
    /// Of their measure of the peak: what it differs by from ours on our profile; 0 of the width, which all measure alike.
    pub measure: f64,
}

impl Sources {
    /// Those that are not nothing, as they stand in a reason.
    pub fn names(&self) -> String {
        let all = [
            ("our mesh", self.ours),
            ("their mesh", self.theirs),
            ("penalty", self.penalty),
            ("measure", self.measure),
        ];
        let told = all.into_iter().filter(|(_, u)| u.is_nan() || *u > 0.0);
        let told: Vec<String> = told.map(|(name, u)| format!("{name} {}", markdown::significant(u, 2))).collect();
        told.join(" ⊕ ")
    }
}

/// Ours against what another code found.
pub fn against(compared: &Compared, found: &Found, number: Number) -> (Comparison, Sources) {
    let (ours, theirs) = (number.of(compared.scene, &compared.ours), number.of(compared.scene, found));
    let sources = Sources {
        ours: ours.uncertainty,
        theirs: theirs.uncertainty,
        penalty: match found.by {
            Finder::Theirs(_, Method::Penalty) => compared.cost_of_penalty(number),
            Finder::Theirs(_, Method::ActiveSet) | Finder::Independent(_) | Finder::Ours => 0.0,
        },
        measure: match number {
            Number::Peak => (compared.peak_as_theirs - ours.value).abs(),
            Number::Width => 0.0,
        },
    };
    let all = [sources.ours, sources.theirs, sources.penalty, sources.measure];
    (Comparison::of(ours.value, theirs.value, all), sources)
}

/// A number against the closed form of the scene itself.
pub fn exactly(measured: Measured, exact: f64) -> Comparison {
    Comparison::of(measured.value, exact, [measured.uncertainty])
}

impl Compared {
    /// By the penalty and without it, in the code that has both.
    pub fn both_methods(&self) -> Option<[&Found; 2]> {
        self.others.iter().find_map(|other| {
            let by = |method| other.found.iter().find(|found| found.by == Finder::Theirs(other.code, method));
            Some([by(Method::Penalty)?, by(Method::ActiveSet)?])
        })
    }

    /// What the penalty changes a number by, apart from the mesh; NaN where no code has both methods.
    fn cost_of_penalty(&self, number: Number) -> f64 {
        self.both_methods().map_or(f64::NAN, |both| {
            let [soft, exact] = both.map(|found| number.of(self.scene, found).limit);
            (soft - exact).abs()
        })
    }
}
