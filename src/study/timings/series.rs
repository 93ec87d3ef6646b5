//! Series of meshes on which the accuracy of truncated Hertz is timed: ours, and those of other codes.

use crate::case::library::TruncatedHertz;
use crate::mesh::Order;
use crate::named::named_enum;
use crate::oracle::analytic::hertz::Hertz;
use crate::scene::{Grading, Scene};
use crate::solve::{Formulation, Iteration};

/// Tolerance of every run: a thirtieth of the smallest error that is asked for.
pub const TOLERANCE: f64 = 1e-5;
/// Elements per half-width.
const ELEMENTS: [usize; 8] = [2, 3, 4, 5, 7, 10, 14, 20];
/// Digits for which meshes are fitted.
const DIGITS: [usize; 3] = [4, 5, 6];

named_enum! {
    /// A series of meshes, coarse to fine.
    pub enum Series {
        /// Cells with 4 nodes, graded as in the library.
        Linear = "truncated-hertz, 4-node",
        /// Cells with 8 nodes, graded as in the library.
        Quadratic = "truncated-hertz, 8-node",
        /// Cells with 4 nodes that grow twice as fast.
        SteepLinear = "truncated-hertz, steep, 4-node",
        /// Cells with 8 nodes that grow twice as fast.
        SteepQuadratic = "truncated-hertz, steep, 8-node",
        /// Cells of high order, fitted to the end of the contact that they find.
        Fitted = "truncated-hertz, fitted",
        /// By exact active sets.
        ScikitFem = "scikit-fem",
        /// By a penalty.
        Dolfinx = "dolfinx",
        /// At high order, by an augmented Lagrangian.
        Ngsolve = "NGSolve",
    }
}

impl Series {
    /// Ours.
    pub const OURS: [Self; 5] = [Self::Linear, Self::Quadratic, Self::SteepLinear, Self::SteepQuadratic, Self::Fitted];
    /// Codes on meshes of their own.
    pub const CODES: [Self; 3] = [Self::ScikitFem, Self::Dolfinx, Self::Ngsolve];
    /// These as a command line names them.
    pub const ASKED: &[(Self, &str, &str)] = Self::TOLD.split_at(Self::OURS.len()).1;

    /// Order of our cells whose mesh does not know where the contact ends.
    pub fn order(self) -> Option<Order> {
        match self {
            Self::Linear | Self::SteepLinear => Some(Order::Linear),
            Self::Quadratic | Self::SteepQuadratic => Some(Order::Quadratic),
            Self::Fitted | Self::ScikitFem | Self::Dolfinx | Self::Ngsolve => None,
        }
    }

    fn is_steep(self) -> bool {
        matches!(self, Self::SteepLinear | Self::SteepQuadratic)
    }

    /// Our meshes: elements per half-width, or digits for which they are fitted.
    pub fn meshes(self) -> &'static [usize] {
        match self.order() {
            Some(_) => &ELEMENTS,
            None if self == Self::Fitted => &DIGITS,
            None => &[],
        }
    }

    /// Our formulations: all nine, on steep meshes the elements with kinematic load, on fitted ones the fastest.
    pub fn formulations(self) -> Vec<Formulation> {
        if self == Self::Fitted {
            return vec![Formulation::verification()];
        }
        let nine = Formulation::nine().into_iter();
        let kept = nine.filter(|formulation| !self.is_steep() || formulation.algorithm == Iteration::Kinematic);
        kept.map(|formulation| formulation.tolerance(TOLERANCE)).collect()
    }

    /// The scene under the load of another half-width, with the outline, candidates and grading of the nominal one, and
    /// the Hertz solution.
    pub(super) fn loaded(self, half_width: f64) -> (Scene, Hertz) {
        let ratio = half_width / nominal();
        let base = TruncatedHertz::default();
        let (size, stretch) = (base.size / ratio, base.stretch / ratio);
        let numbers = TruncatedHertz { a_over_r: base.a_over_r * ratio, size, stretch, ..base };
        let mut scene = numbers.scene();
        scene.grading.unit = nominal();
        if self.is_steep() {
            scene.grading = Grading { along: 2.0, depth: 1.8, coarsest: 0.5, ..scene.grading };
        }
        let modulus = scene.contact_modulus();
        (scene, Hertz { load: numbers.load(), radius: numbers.radius, modulus })
    }
}

/// Nominal half-width \[mm\].
pub fn nominal() -> f64 {
    TruncatedHertz::default().half_width()
}
