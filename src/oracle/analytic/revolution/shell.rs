//! Thick shells under pressure, spheres and cylinders, and one fitted into another.

use crate::oracle::analytic::{Parameter, answer, finite, non_negative};
use crate::oracle::{Oracle, Quantity, Reading, Source};
use crate::scene::Material;

/// What a shell is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// A sphere.
    Sphere,
    /// A cylinder of free ends, `σ_z = 0`.
    FreeCylinder,
    /// A cylinder between rigid planes, `ε_z = 0`.
    FixedCylinder,
    /// A cylinder whose ends carry the pressures, as those of a vessel do.
    ClosedCylinder,
}

/// A thick shell (Lamé 1852; Timoshenko and Goodier, Theory of Elasticity, 1951, §§26, 127).
///
/// With `m = 3` of spheres and 2 of cylinders, inside `a` and outside `b`: `σ_r = A − B/r^m`, `σ_θ = A + B/((m − 1) r^m)`,
/// `A = (p_a a^m − p_b b^m)/(b^m − a^m)`, `B = (p_a − p_b) a^m b^m/(b^m − a^m)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shell {
    /// What it is.
    pub shape: Shape,
    /// Inner and outer radius \[mm\]; an inner radius of zero makes it solid.
    pub radii: [f64; 2],
    /// Pressures inside and outside \[MPa\].
    pub pressures: [f64; 2],
    /// Its material.
    pub material: Material,
}

impl Shell {
    fn power(&self) -> i32 {
        if self.shape == Shape::Sphere { 3 } else { 2 }
    }

    /// `A` and `B`.
    fn constants(&self) -> [f64; 2] {
        let [a, b] = self.radii.map(|radius| radius.powi(self.power()));
        let [inside, outside] = self.pressures;
        [(inside * a - outside * b) / (b - a), (inside - outside) * a * b / (b - a)]
    }

    /// Radial, hoop and third stress \[MPa\]; the third is again the hoop stress of a sphere, the axial one of a cylinder.
    pub fn stress(&self, radius: f64) -> [f64; 3] {
        let [mean, rest] = self.constants();
        // Nothing of the second part is in a solid one, at its centre either.
        let part = if self.radii[0] > 0.0 { rest / radius.powi(self.power()) } else { 0.0 };
        let hoop = mean + part / f64::from(self.power() - 1);
        let third = match self.shape {
            Shape::Sphere => hoop,
            Shape::FreeCylinder => 0.0,
            Shape::FixedCylinder => 2.0 * self.material.poisson * mean,
            Shape::ClosedCylinder => mean,
        };
        [mean - part, hoop, third]
    }

    /// Radial displacement `u = r (σ_θ − ν (σ_r + σ₃))/E` \[mm\].
    pub fn displacement(&self, radius: f64) -> f64 {
        let [radial, hoop, third] = self.stress(radius);
        radius * (hoop - self.material.poisson * (radial + third)) / self.material.young
    }
}

/// An inner shell and an outer one that overlap by a radial interference before they are fitted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fitted {
    /// The inner shell; its outer radius is that of the interface.
    pub inner: Shell,
    /// The outer shell.
    pub outer: Shell,
    /// Radial interference \[mm\].
    pub interference: f64,
}

impl Fitted {
    /// Pressure between them \[MPa\].
    ///
    /// Their displacements at the interface differ by the interference; both are proportional to the pressure.
    pub fn pressure(&self) -> f64 {
        let interface = self.inner.radii[1];
        let narrowing = -Shell { pressures: [0.0, 1.0], ..self.inner }.displacement(interface);
        let widening = Shell { pressures: [1.0, 0.0], ..self.outer }.displacement(interface);
        self.interference / (narrowing + widening)
    }
}

impl Oracle for Fitted {
    fn name(&self) -> &str {
        "Lamé"
    }

    fn source(&self) -> Source {
        Source::new(
            "G. Lamé 1852; S. Timoshenko and J. N. Goodier, Theory of Elasticity, 1951, §§26, 127",
            "re-derived; checked by equilibrium and by the mismatch of radial displacements",
        )
    }

    fn read(&self, quantity: &Quantity) -> Reading {
        let [[a, b], [_, c]] = [self.inner.radii, self.outer.radii];
        let parameters = vec![
            non_negative("bore", a),
            Parameter { holds: b > a, range: "above the bore", ..finite("interface", b) },
            Parameter {
                holds: c > b && c.is_finite(),
                range: "above the interface and finite",
                ..finite("outside", c)
            },
            non_negative("interference", self.interference),
        ];
        match quantity {
            Quantity::PeakPressure | Quantity::Pressure { .. } => answer(parameters, quantity, self.pressure()),
            _ => Reading::Silent,
        }
    }
}
