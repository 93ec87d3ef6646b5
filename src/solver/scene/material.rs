//! Elastic constants, and what a scene in two coordinates stands for.

use crate::error::{self, Error, positive};

/// Plane strain, plane stress, or bodies of revolution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlaneHypothesis {
    /// `ε_z = 0`.
    Strain,
    /// `σ_z = 0`.
    Stress,
    /// Bodies of revolution about x = 0: x is the radius r, y the axial coordinate, and `ε_θ = u_r/r`.
    Axisymmetric,
    /// The same about y = 0: y is the radius, and x the axial coordinate.
    AxisymmetricAboutX,
}

/// Largest Poisson's ratio in plane strain and of bodies of revolution.
///
/// At 0.5 a body keeps its volume, `λ = 2μν/(1 − 2ν)` is infinite and displacements alone no longer give the pressure.
/// At 0.4999 `λ = 4999 μ`, and round-off in the stiffness takes four digits.
pub const LARGEST_POISSON: f64 = 0.4999;

impl PlaneHypothesis {
    /// In a word.
    pub fn name(self) -> &'static str {
        match self {
            Self::Strain => "strain",
            Self::Stress => "stress",
            Self::Axisymmetric | Self::AxisymmetricAboutX => "axisymmetric",
        }
    }

    /// Whether bodies may have a Poisson's ratio.
    pub fn takes(self, poisson: f64) -> bool {
        match self {
            Self::Strain | Self::Axisymmetric | Self::AxisymmetricAboutX => {
                poisson > -1.0 && poisson <= LARGEST_POISSON
            }
            Self::Stress => poisson > -1.0 && poisson < 1.0,
        }
    }

    /// Whether the bodies are of revolution.
    pub fn is_of_revolution(self) -> bool {
        self.radial().is_some()
    }

    /// Which coordinate of bodies of revolution is the radius: x, 0, or y, 1; none in the plane.
    pub fn radial(self) -> Option<usize> {
        match self {
            Self::Strain | Self::Stress => None,
            Self::Axisymmetric => Some(0),
            Self::AxisymmetricAboutX => Some(1),
        }
    }

    /// Kolosov's constant `κ'`: `(3−ν)/(1+ν)` in plane stress, `3−4ν` in plane strain, and near a circular edge of a
    /// body of revolution, where it is as good as plane.
    pub fn kolosov(self, poisson: f64) -> f64 {
        match self {
            Self::Stress => (3.0 - poisson) / (1.0 + poisson),
            Self::Strain | Self::Axisymmetric | Self::AxisymmetricAboutX => 3.0 - 4.0 * poisson,
        }
    }

    /// The Poisson's ratios that bodies may have, in words.
    pub fn poisson_range(self) -> String {
        let of = match self {
            Self::Strain => "plane strain, which serves for bodies",
            Self::Axisymmetric | Self::AxisymmetricAboutX => "bodies of revolution, which serves for those",
            Self::Stress => return "between -1 and 1, both excluded".into(),
        };
        format!("above -1 and at most {LARGEST_POISSON} in {of} that keep their volume")
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

    /// Plane modulus `E/(1−ν²)` in plane strain and of bodies of revolution, `E` in plane stress \[MPa\].
    pub fn plane_modulus(&self, plane: PlaneHypothesis) -> f64 {
        match plane {
            PlaneHypothesis::Stress => self.young,
            // A narrow contact around the axis is as good as straight.
            _ => self.young / (1.0 - self.poisson * self.poisson),
        }
    }

    /// Elasticity matrix `D` with `[σ_x, σ_y, τ_xy] = D [ε_x, ε_y, γ_xy]` \[MPa\].
    ///
    /// Plane stress with `E`, `ν`; plane strain is the same with `E/(1−ν²)`, `ν/(1−ν)`. Of bodies of revolution it is
    /// that of plane strain, to which the hoop strain adds `σ_r += D₁₂ ε_θ`, `σ_z += D₁₂ ε_θ`;
    /// `σ_θ = D₁₂ (ε_r + ε_z) + D₁₁ ε_θ`.
    pub fn stiffness(&self, plane: PlaneHypothesis) -> [[f64; 3]; 3] {
        let (e, nu) = match plane {
            PlaneHypothesis::Stress => (self.young, self.poisson),
            _ => (self.plane_modulus(plane), self.poisson / (1.0 - self.poisson)),
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
            PlaneHypothesis::Stress => "use for instance 0.3".into(),
            _ => format!("use for instance 0.3, or {LARGEST_POISSON}"),
        };
        Err(Error::value(place, "poisson", self.poisson, expected, remedy))
    }
}
