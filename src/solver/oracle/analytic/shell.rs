//! Thick shells under pressure, rings, cylinders and spheres, and one fitted into another.

use super::{Parameter, Plane, answer, finite, non_negative, poisson_ratio, positive};
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
}

impl Shape {
    /// What a ring is; one of revolution has free ends.
    pub fn of_ring(plane: Plane) -> Self {
        if plane == Plane::Strain { Self::FixedCylinder } else { Self::FreeCylinder }
    }
}

/// A thick shell (Lamé 1852; Timoshenko and Goodier, Theory of Elasticity, 1951, §§26, 127).
///
/// With `m = 3` of spheres and 2 of cylinders, inside `a` and outside `b`: `σ_r = A − B/r^m`,
/// `σ_θ = A + B/((m − 1) r^m)`, `A = (p_a a^m − p_b b^m)/(b^m − a^m)`, `B = (p_a − p_b) a^m b^m/(b^m − a^m)`.
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

    /// Radial, hoop and third stress \[MPa\]; the third is again the hoop stress of a sphere, the axial one of a
    /// cylinder.
    pub fn stress(&self, radius: f64) -> [f64; 3] {
        let [mean, rest] = self.constants();
        // Nothing of the second part is in a solid one, at its centre either.
        let part = if self.radii[0] > 0.0 { rest / radius.powi(self.power()) } else { 0.0 };
        let hoop = mean + part / f64::from(self.power() - 1);
        let third = match self.shape {
            Shape::Sphere => hoop,
            Shape::FreeCylinder => 0.0,
            Shape::FixedCylinder => 2.0 * self.material.poisson * mean,
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
pub struct PressFit {
    /// What both are.
    pub shape: Shape,
    /// Radii of the bore `a ≥ 0`, which is zero of a solid shaft, of the interface `b` and of the outside `c` \[mm\].
    pub radii: [f64; 3],
    /// Radial interference `δ` \[mm\], positive where they overlap before they are fitted.
    pub interference: f64,
    /// Materials of the inner and of the outer one.
    pub materials: [Material; 2],
}

impl PressFit {
    /// Both under a pressure between them \[MPa\].
    fn under(&self, pressure: f64) -> [Shell; 2] {
        let ([bore, interface, outside], [inner, outer]) = (self.radii, self.materials);
        let shell = |radii, pressures, material| Shell { shape: self.shape, radii, pressures, material };
        [shell([bore, interface], [0.0, pressure], inner), shell([interface, outside], [pressure, 0.0], outer)]
    }

    /// Pressure between them \[MPa\]: their displacements at the interface differ by the interference, and both are
    /// proportional to it.
    pub fn pressure(&self) -> f64 {
        let [inner, outer] = self.under(1.0).map(|shell| shell.displacement(self.radii[1]));
        self.interference / (outer - inner)
    }

    /// The inner and the outer one as they are fitted.
    pub fn fitted(&self) -> [Shell; 2] {
        self.under(self.pressure())
    }
}

impl Oracle for PressFit {
    fn source(&self) -> Source {
        let (citation, note) = match self.shape {
            Shape::Sphere => (
                "G. Lamé 1852; S. Timoshenko and J. N. Goodier, Theory of Elasticity, 1951, §§26, 127",
                "re-derived; checked by equilibrium and by the mismatch of radial displacements",
            ),
            Shape::FreeCylinder | Shape::FixedCylinder => (
                "G. Lamé 1852; S. Timoshenko and J. N. Goodier, Theory of Elasticity, 1951, §26",
                "re-derived; checked by the mismatch of radial displacements",
            ),
        };
        Source::new("Lamé", citation, note)
    }

    fn read(&self, quantity: &Quantity) -> Reading {
        let ([a, b, c], [inner, outer]) = (self.radii, self.materials);
        let parameters = vec![
            non_negative("bore", a),
            positive("interface", b),
            Parameter { holds: b > a, range: "above the bore", ..finite("interface", b) },
            Parameter {
                holds: c > b && c.is_finite(),
                range: "above the interface and finite",
                ..finite("outside", c)
            },
            non_negative("interference", self.interference),
            positive("inner.young", inner.young),
            poisson_ratio("inner.poisson", inner.poisson),
            positive("outer.young", outer.young),
            poisson_ratio("outer.poisson", outer.poisson),
        ];
        match quantity {
            Quantity::PeakPressure | Quantity::Pressure { .. } => answer(parameters, quantity, self.pressure()),
            _ => Reading::Silent,
        }
    }
}
