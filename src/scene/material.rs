//! Elastic constants and the plane hypothesis.

use crate::error::Error;
use crate::scene::positive;

/// Plane strain or plane stress.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlaneHypothesis {
    /// `ε_z = 0`.
    Strain,
    /// `σ_z = 0`.
    Stress,
}

/// Homogeneous isotropic linear elasticity.
#[derive(Clone, Copy, Debug)]
pub struct Material {
    /// Young's modulus \[MPa\].
    pub young: f64,
    /// Poisson's ratio.
    pub poisson: f64,
}

impl Material {
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

    /// Refuses constants for which the elasticity matrix is not positive definite.
    pub fn validate(&self, place: &str, plane: PlaneHypothesis) -> Result<(), Error> {
        positive(place, "young", self.young)?;
        let limit = match plane {
            PlaneHypothesis::Strain => 0.5,
            PlaneHypothesis::Stress => 1.0,
        };
        if self.poisson > -1.0 && self.poisson < limit {
            return Ok(());
        }
        let expected = format!("it must lie between -1 and {limit}, both excluded");
        Err(Error::value(place, "poisson", self.poisson, expected, "use for instance 0.3"))
    }
}
