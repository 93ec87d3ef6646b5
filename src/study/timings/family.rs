//! Scenes whose accuracy is timed: which one, and how its mesh grows away from the contact.

use serde::{Deserialize, Serialize};

use crate::case::library::{Cylinder, TruncatedHertz};
use crate::oracle::analytic::hertz::Hertz;
use crate::scene::{Grading, Scene};
use crate::solve::{Formulation, Iteration};

/// Tolerance of every run: a thirtieth of the smallest error that is asked for.
pub const TOLERANCE: f64 = 1e-5;
/// Elements per half-width.
pub const ELEMENTS: [usize; 8] = [2, 3, 4, 5, 7, 10, 14, 20];
/// Elements per half-width up to which uniform meshes go.
const UNIFORM: usize = 10;

/// Which scene, and how its mesh grows away from the contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Family {
    /// Truncated Hertz on its graded mesh.
    #[serde(rename = "truncated-hertz")]
    Truncated,
    /// Truncated Hertz on a mesh that grows twice as fast from cell to cell.
    #[serde(rename = "truncated-hertz, steep")]
    Steep,
    /// Truncated Hertz on squares all of one size.
    #[serde(rename = "truncated-hertz, uniform")]
    Uniform,
    /// The cylinder on its graded mesh.
    Cylinder,
}

impl Family {
    /// All.
    pub const ALL: [Self; 4] = [Self::Truncated, Self::Steep, Self::Uniform, Self::Cylinder];

    /// Name in records.
    pub fn name(self) -> &'static str {
        match self {
            Self::Truncated => "truncated-hertz",
            Self::Steep => "truncated-hertz, steep",
            Self::Uniform => "truncated-hertz, uniform",
            Self::Cylinder => "cylinder",
        }
    }

    /// Formulations: all nine, on steep and uniform meshes the elements with kinematic load.
    pub fn formulations(self) -> Vec<Formulation> {
        let nine = Formulation::nine().into_iter();
        let kept = nine.filter(|f| !self.compares_meshes() || f.algorithm == Iteration::Kinematic);
        kept.map(|formulation| formulation.tolerance(TOLERANCE)).collect()
    }

    /// Whether the family is there for its mesh, not for the formulations.
    fn compares_meshes(self) -> bool {
        matches!(self, Self::Steep | Self::Uniform)
    }

    /// Elements per half-width, coarse to fine.
    pub fn elements(self) -> impl Iterator<Item = usize> {
        ELEMENTS.into_iter().filter(move |&elements| self != Self::Uniform || elements <= UNIFORM)
    }

    /// Nominal half-width \[mm\].
    pub fn nominal(self) -> f64 {
        match self {
            Self::Cylinder => Cylinder::default().half_width(),
            Self::Truncated | Self::Steep | Self::Uniform => TruncatedHertz::default().half_width(),
        }
    }

    /// The scene under the load of another half-width, with the outline, candidates and grading of the nominal one, and
    /// the Hertz solution.
    pub(super) fn loaded(self, half_width: f64) -> (Scene, Hertz) {
        let ratio = half_width / self.nominal();
        let (mut scene, load, radius) = match self {
            Self::Cylinder => {
                let nominal = Cylinder::default();
                let (a_over_r, stretch) = (nominal.a_over_r * ratio, nominal.stretch / ratio);
                let numbers = Cylinder { a_over_r, stretch, ..nominal };
                (numbers.scene(), numbers.load(), numbers.radius)
            }
            Self::Truncated | Self::Steep | Self::Uniform => {
                let nominal = TruncatedHertz::default();
                let (size, stretch) = (nominal.size / ratio, nominal.stretch / ratio);
                let numbers = TruncatedHertz { a_over_r: nominal.a_over_r * ratio, size, stretch, ..nominal };
                (numbers.scene(), numbers.load(), numbers.radius)
            }
        };
        scene.grading.unit = self.nominal();
        match self {
            Self::Truncated | Self::Cylinder => {}
            Self::Steep => scene.grading = Grading { along: 2.0, depth: 1.8, coarsest: 0.5, ..scene.grading },
            Self::Uniform => scene.grading = Grading { along: 1.0, depth: 1.0, ..scene.grading },
        }
        let modulus = scene.contact_modulus();
        (scene, Hertz { load, radius, modulus })
    }
}
