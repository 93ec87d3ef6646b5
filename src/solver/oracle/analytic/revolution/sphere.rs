//! Hertz's point contact and the stresses below it.

use std::f64::consts::PI;

use super::half_space::Potential;
use crate::oracle::analytic::{answer, largest, positive};
use crate::oracle::{Oracle, Quantity, Reading, Source};

/// Contact of two spheres, or of a sphere and a plane, each a paraboloid (Johnson, Contact Mechanics, 1985, §4.2).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sphere {
    /// Load `F` \[N\], positive in compression.
    pub load: f64,
    /// Relative radius `R`, `1/R = Σ 1/R_i` \[mm\]; an enclosing surface counts negative.
    pub radius: f64,
    /// Contact modulus `E*`, `1/E* = Σ (1 − ν_i²)/E_i` \[MPa\].
    pub modulus: f64,
}

impl Sphere {
    /// Radius of the contact `a = (3FR/4E*)^{1/3}` \[mm\].
    pub fn contact_radius(&self) -> f64 {
        (0.75 * self.load * self.radius / self.modulus).cbrt()
    }

    /// Peak pressure `p₀ = 3F/2πa²` \[MPa\].
    pub fn peak_pressure(&self) -> f64 {
        1.5 * self.load / (PI * self.contact_radius().powi(2))
    }

    /// Pressure `p = p₀ √(1 − r²/a²)` \[MPa\] at `r` \[mm\], zero outside the contact.
    pub fn pressure(&self, r: f64) -> f64 {
        let s = r / self.contact_radius();
        if s.abs() > 1.0 {
            return 0.0;
        }
        self.peak_pressure() * ((1.0 - s) * (1.0 + s)).sqrt()
    }

    /// Approach of points far from the contact `δ = a²/R` \[mm\].
    pub fn approach(&self) -> f64 {
        self.contact_radius().powi(2) / self.radius
    }

    /// Load `F = 4E*a³/3R` \[N\] that makes a contact of radius `a` \[mm\].
    pub fn load_for(contact_radius: f64, radius: f64, modulus: f64) -> f64 {
        4.0 * modulus * contact_radius.powi(3) / (3.0 * radius)
    }

    /// The potential below the contact, which stresses and displacements follow from; `z ≥ 0` into the body \[mm\].
    pub fn potential(&self, r: f64, z: f64) -> Potential {
        let a = self.contact_radius();
        Potential::hertz(a, r, z).times(self.peak_pressure() / a)
    }

    /// `[σ_z, σ_r]` on the axis \[MPa\]; there `σ_θ = σ_r` (Johnson 1985, eq. 3.45).
    ///
    /// `σ_z = −p₀/(1 + s²)`, `σ_r = −p₀ [(1 + ν)(1 − s atan 1/s) − 1/2(1 + s²)]`, `s = z/a`.
    pub fn on_axis(&self, z: f64, poisson: f64) -> [f64; 2] {
        let s = z / self.contact_radius();
        let along = 1.0 / (1.0 + s * s);
        let across = (1.0 + poisson) * (1.0 - s * 1_f64.atan2(s)) - 0.5 * along;
        [along, across].map(|part| -self.peak_pressure() * part)
    }

    /// Depth of the largest shear stress, which lies on the axis for `ν` up to a half \[mm\], and its value \[MPa\].
    ///
    /// About 0.31 p₀ at 0.48 a for ν = 0.3.
    pub fn largest_shear(&self, poisson: f64) -> [f64; 2] {
        let shear = |z: f64| {
            let [axial, radial] = self.on_axis(z, poisson);
            0.5 * (radial - axial)
        };
        let depth = largest([2.0 * self.contact_radius(), 0.0], |z| shear(z.abs()));
        [depth, shear(depth)]
    }
}

impl Oracle for Sphere {
    fn source(&self) -> Source {
        Source::new(
            "Hertz's sphere",
            "H. Hertz 1882; M. T. Huber 1904; K. L. Johnson, Contact Mechanics, 1985, §§3.4, 4.2",
            "re-derived; surface displacements checked by elliptic integrals, stresses by equilibrium",
        )
    }

    fn read(&self, quantity: &Quantity) -> Reading {
        let parameters =
            vec![positive("load", self.load), positive("radius", self.radius), positive("modulus", self.modulus)];
        let value = match quantity {
            Quantity::HalfWidth | Quantity::SecondMomentWidth => self.contact_radius(),
            Quantity::PeakPressure => self.peak_pressure(),
            Quantity::Resultant => self.load,
            Quantity::Approach => self.approach(),
            Quantity::Pressure { at } => self.pressure(*at),
            _ => return Reading::Silent,
        };
        answer(parameters, quantity, value)
    }
}
