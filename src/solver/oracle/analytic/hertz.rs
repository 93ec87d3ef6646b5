//! Hertz's line contact and the stresses below it.

use std::f64::consts::PI;

use super::{answer, positive};
use crate::oracle::{Oracle, Quantity, Reading, Source};

/// Line contact of two cylinders, or of a cylinder and a plane (Johnson, Contact Mechanics, 1985, §4.2).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hertz {
    /// Full load per unit length `P` \[N/mm\], positive in compression.
    pub load: f64,
    /// Relative radius `R`, `1/R = Σ 1/R_i` \[mm\]; an enclosing surface counts negative.
    pub radius: f64,
    /// Contact modulus `E*` \[MPa\].
    pub modulus: f64,
}

impl Hertz {
    /// Half-width `a = √(4PR / πE*)` \[mm\], which is also `2 √(∫p x²/∫p)`.
    pub fn half_width(&self) -> f64 {
        (4.0 * self.load * self.radius / (PI * self.modulus)).sqrt()
    }

    /// Peak pressure `p₀ = √(PE* / πR)` \[MPa\].
    pub fn peak_pressure(&self) -> f64 {
        (self.load * self.modulus / (PI * self.radius)).sqrt()
    }

    /// Pressure `p = p₀ √(1 − x²/a²)` \[MPa\] at `x` \[mm\], zero outside the contact.
    pub fn pressure(&self, x: f64) -> f64 {
        let s = x / self.half_width();
        if s.abs() > 1.0 {
            return 0.0;
        }
        self.peak_pressure() * ((1.0 - s) * (1.0 + s)).sqrt()
    }

    /// Load per unit length `P = πE*a² / 4R` \[N/mm\] that makes a contact of half-width `a` \[mm\].
    pub fn load_for(half_width: f64, radius: f64, modulus: f64) -> f64 {
        PI * modulus * half_width.powi(2) / (4.0 * radius)
    }

    /// Stresses `[σ_x, σ_z, τ_xz]` \[MPa\] in the half-plane; `x` right, `z ≥ 0` into the body \[mm\], tension
    /// positive.
    ///
    /// With `m² − n² = a² − x² + z²`, `mn = xz`, `m ≥ 0` and `q = m² − z²` (McEwen 1949; Johnson 1985, §4.2):
    ///
    /// * `σ_x  = −(p₀/a) { m [1 + (z²+n²)/(m²+n²)] − 2z } = −(p₀/a) (m−z) [m(m−z) + 2n²] / (m²+n²)`,
    /// * `σ_z  = −(p₀/a) m q / (m²+n²)`,
    /// * `τ_xz = −(p₀/a) n q / (m²+n²)`,
    ///
    /// where `q = a²m² / (m²+x²)` and `m − z = q / (m+z)` keep the digits that cancel far away.
    /// Not a number at the edges `x = ±a, z = 0`, where `m² + n² = 0`.
    pub fn stress(&self, x: f64, z: f64) -> [f64; 3] {
        let a = self.half_width();
        let (m, n) = elliptic(a, x, z);
        let q = if m > 0.0 { a.powi(2) / (1.0 + (x / m).powi(2)) } else { 0.0 };
        let m_less_z = if m > 0.0 { q / (m + z) } else { -z };
        let scale = -self.peak_pressure() / (a * (m.powi(2) + n.powi(2)));

        [scale * m_less_z * (m * m_less_z + 2.0 * n.powi(2)), scale * m * q, scale * n * q]
    }
}

/// McEwen's `m ≥ 0` and `n` with the sign of `x`; the smaller one from `mn = xz`, free of cancellation.
fn elliptic(a: f64, x: f64, z: f64) -> (f64, f64) {
    let difference = (a - x) * (a + x) + z.powi(2);
    let sum = difference.hypot(2.0 * x * z);
    if difference >= 0.0 {
        let m = (0.5 * (sum + difference)).sqrt();
        let n = if m > 0.0 { x * z / m } else { 0.0 };
        return (m, n);
    }
    let n = (0.5 * (sum - difference)).sqrt().copysign(x);
    (x * z / n, n)
}

impl Oracle for Hertz {
    fn source(&self) -> Source {
        Source::new(
            "Hertz",
            "H. Hertz 1882; K. L. Johnson, Contact Mechanics, 1985, §4.2",
            "re-derived; interior stresses checked against integration of Flamant's solution",
        )
    }

    fn read(&self, quantity: &Quantity) -> Reading {
        let parameters =
            vec![positive("load", self.load), positive("radius", self.radius), positive("modulus", self.modulus)];
        let value = match quantity {
            Quantity::HalfWidth | Quantity::SecondMomentWidth => self.half_width(),
            Quantity::PeakPressure => self.peak_pressure(),
            Quantity::Resultant => self.load,
            Quantity::Pressure { at } => self.pressure(*at),
            _ => return Reading::Silent,
        };
        answer(parameters, quantity, value)
    }
}
