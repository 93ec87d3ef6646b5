//! A rigid flat punch on a half-plane.

use std::f64::consts::PI;

use super::{answer, positive};
use crate::oracle::{Oracle, Quantity, Reading, Source};

/// Rigid flat punch with sharp corners (Sadowsky 1928; Johnson, Contact Mechanics, 1985, §2.8).
///
/// The peak is infinite, so it is not read: compare the pressure at the centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlatPunch {
    /// Full load per unit length `P` \[N/mm\].
    pub load: f64,
    /// Half-width of the punch `a` \[mm\].
    pub half_width: f64,
}

impl FlatPunch {
    /// Pressure `p = P / (π √(a² − x²))` \[MPa\] at `x` \[mm\]; infinite at the corners, zero outside.
    pub fn pressure(&self, x: f64) -> f64 {
        let inside = (self.half_width - x) * (self.half_width + x);
        if inside < 0.0 {
            return 0.0;
        }
        self.load / (PI * inside.sqrt())
    }

    /// Stresses `[σ_x, σ_z, τ_xz]` \[MPa\] in the half-plane; `x` right, `z ≥ 0` into the body \[mm\], tension
    /// positive.
    ///
    /// Flamant's solution, integrated: with `ζ = x + iz` and `F = ∫ p ds/(s − ζ) = −P/√(ζ² − a²)`,
    ///
    /// * `σ_x + σ_z = −(2/π) Im F`,
    /// * `σ_z − σ_x = (2/π) z Re F'`,
    /// * `τ_xz = (1/π) z Im F'`, `F' = P ζ/(ζ² − a²)^{3/2}`.
    ///
    /// Not a number at the corners `x = ±a, z = 0`.
    pub fn stress(&self, x: f64, z: f64) -> [f64; 3] {
        let a = self.half_width;
        // ζ² − a² = r e^{iψ} with ψ from 0 to 2π, as its root lies in the upper half-plane like ζ.
        let [real, imaginary] = [(x - a) * (x + a) - z * z, 2.0 * x * z];
        let (size, angle) = (real.hypot(imaginary), imaginary.atan2(real));
        let angle = if angle < 0.0 { angle + 2.0 * PI } else { angle };
        let potential = self.load / size.sqrt() * (0.5 * angle).sin();
        // 1/(ζ² − a²)^{3/2} = r^{−3/2} e^{−3iψ/2}.
        let (sin, cos) = (1.5 * angle).sin_cos();
        let scale = self.load / size.powf(1.5);
        let derivative = [scale * (x * cos + z * sin), scale * (z * cos - x * sin)];
        let sum = -2.0 / PI * potential;
        let [difference, shear] = [2.0 / PI * z * derivative[0], z / PI * derivative[1]];
        [0.5 * (sum - difference), 0.5 * (sum + difference), shear]
    }

    /// Half-width by second moment `2 √(∫p x²/∫p) = √2 a` \[mm\].
    pub fn second_moment(&self) -> f64 {
        std::f64::consts::SQRT_2 * self.half_width
    }
}

impl Oracle for FlatPunch {
    fn source(&self) -> Source {
        Source::new(
            "flat punch",
            "M. Sadowsky 1928; K. L. Johnson, Contact Mechanics, 1985, §2.8",
            "re-derived, originals not at hand; checked by equilibrium",
        )
    }

    fn read(&self, quantity: &Quantity) -> Reading {
        let parameters = vec![positive("load", self.load), positive("half_width", self.half_width)];
        let value = match quantity {
            Quantity::HalfWidth => self.half_width,
            Quantity::SecondMomentWidth => self.second_moment(),
            Quantity::Resultant => self.load,
            Quantity::Pressure { at } => self.pressure(*at),
            _ => return Reading::Silent,
        };
        answer(parameters, quantity, value)
    }
}
