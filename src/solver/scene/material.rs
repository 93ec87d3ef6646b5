//! Elastic constants and the plane hypothesis.

use crate::error::{self, Error};
use crate::scene::range::positive;

/// Plane strain or plane stress.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlaneHypothesis {
    /// `ε_z = 0`.
    Strain,
    /// `σ_z = 0`.
    Stress,
}

/// Largest Poisson's ratio in plane strain.
///
/// At 0.5 a body keeps its volume, `λ = 2μν/(1 − 2ν)` is infinite and displacements alone no longer give the pressure. At
/// 0.4999 `λ = 4999 μ`, and round-off in the stiffness takes four digits.
pub const LARGEST_POISSON: f64 = 0.4999;

impl PlaneHypothesis {
    /// Whether bodies may have a Poisson's ratio.
    pub fn takes(self, poisson: f64) -> bool {
        match self {
            Self::Strain => poisson > -1.0 && poisson <= LARGEST_POISSON,
            Self::Stress => poisson > -1.0 && poisson < 1.0,
        }
    }

    /// Kolosov's constant `κ'`: `(3−ν)/(1+ν)` in plane stress, `3−4ν` in plane strain.
    pub fn kolosov(self, poisson: f64) -> f64 {
        match self {
            Self::Stress => (3.0 - poisson) / (1.0 + poisson),
            Self::Strain => 3.0 - 4.0 * poisson,
        }
    }

    /// The Poisson's ratios that bodies may have, in words.
    pub fn poisson_range(self) -> String {
        match self {
            Self::Strain => format!(
                "above -1 and at most {LARGEST_POISSON} in plane strain, which serves for bodies that keep their volume"
            ),
            Self::Stress => "between -1 and 1, both excluded".into(),
        }
    }
}

/// Homogeneous isotropic linear elasticity.
#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// Young's modulus \[MPa\].
    pub young: f64,
    /// Poisson's ratio.
    pub poisson: f64,
}

impl Material {
    /// Steel as the examples have it: 210 GPa, 0.3.
    pub const STEEL: Self = Self { young: 210e3, poisson: 0.3 };

    /// Plane modulus `E/(1−ν²)` in plane strain, `E` in plane stress \[MPa\].
    pub fn plane_modulus(&self, plane: PlaneHypothesis) -> f64 {
        match plane {
            PlaneHypothesis::Strain => self.young / (1.0 - self.poisson * self.poisson),
            PlaneHypothesis::Stress => self.young,
        }
    }

    /// Elasticity matrix `D` with `[σ_x, σ_y, τ_xy] = D [ε_x, ε_y, γ_xy]` \[MPa\].
    ///
    /// Plane stress with `E`, `ν`; plane strain is the same with `E/(1−ν²)`, `ν/(1−ν)`.
    pub fn stiffness(&self, plane: PlaneHypothesis) -> [[f64; 3]; 3] {
        let (e, nu) = match plane {
            PlaneHypothesis::Stress => (self.young, self.poisson),
            PlaneHypothesis::Strain => (self.plane_modulus(plane), self.poisson / (1.0 - self.poisson)),
        };
        let c = e / (1.0 - nu * nu);
        [[c, c * nu, 0.0], [c * nu, c, 0.0], [0.0, 0.0, c * (1.0 - nu) / 2.0]]
    }

    /// Refuses constants for which the elasticity matrix is not positive definite, or too close to infinite.
    pub fn validate(&self, place: &error::Place, plane: PlaneHypothesis) -> Result<(), Error> {
        positive(place, "young", self.young)?;
        if plane.takes(self.poisson) {
            return Ok(());
        }
        let expected = format!("it must lie {}", plane.poisson_range());
        let remedy = match plane {
            PlaneHypothesis::Strain => format!("use for instance 0.3, or {LARGEST_POISSON}"),
            PlaneHypothesis::Stress => "use for instance 0.3".into(),
        };
        Err(Error::value(place, "poisson", self.poisson, expected, remedy))
    }
}
