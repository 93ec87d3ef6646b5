//! Press fit of two rings.

use super::{Parameter, Plane, answer, finite, non_negative, poisson_ratio, positive};
use crate::oracle::{Oracle, Quantity, Reading, Source};
use crate::scene::Material;

/// Inner ring `a…b` pressed into an outer ring `b…c` (Lamé 1852).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PressFit {
    /// Bore of the inner ring `a ≥ 0` \[mm\]; zero for a solid shaft.
    pub bore: f64,
    /// Radius of the interface `b` \[mm\].
    pub interface: f64,
    /// Outer radius of the outer ring `c` \[mm\].
    pub outside: f64,
    /// Radial interference `δ` \[mm\], positive where the rings overlap before they are fitted.
    pub interference: f64,
    /// Material of the inner ring.
    pub inner: Material,
    /// Material of the outer ring.
    pub outer: Material,
    /// The two-dimensional state of both rings.
    pub plane: Plane,
}

/// Constants of the plane-stress formula: in plane strain `E → E/(1−ν²)`, `ν → ν/(1−ν)`. Rings of revolution whose ends are free
/// are in plane stress.
fn in_plane(material: Material, plane: Plane) -> Material {
    match plane {
        Plane::Stress | Plane::Axisymmetric | Plane::AxisymmetricAboutX => material,
        Plane::Strain => Material {
            young: material.young / (1.0 - material.poisson.powi(2)),
            poisson: material.poisson / (1.0 - material.poisson),
        },
    }
}

impl PressFit {
    /// Interface pressure \[MPa\].
    ///
    /// `p = δ / { b [ (1/E_o)((c²+b²)/(c²−b²) + ν_o) + (1/E_i)((b²+a²)/(b²−a²) − ν_i) ] }`.
    pub fn pressure(&self) -> f64 {
        let (inner, outer) = (in_plane(self.inner, self.plane), in_plane(self.outer, self.plane));
        let [a, b, c] = [self.bore, self.interface, self.outside].map(|radius| radius.powi(2));
        let widening = ((c + b) / (c - b) + outer.poisson) / outer.young;
        let narrowing = ((b + a) / (b - a) - inner.poisson) / inner.young;
        self.interference / (self.interface * (widening + narrowing))
    }

    /// Radial displacement of the inner ring at a radius \[mm\]: `−p b² ((1 − ν) r + (1 + ν) a²/r) / E (b² − a²)`.
    pub fn inner_displacement(&self, radius: f64) -> f64 {
        let Material { young, poisson } = in_plane(self.inner, self.plane);
        let [a, b] = [self.bore, self.interface].map(|radius| radius.powi(2));
        let shape = (1.0 - poisson) * radius + (1.0 + poisson) * a / radius;
        -self.pressure() * b * shape / (young * (b - a))
    }

    /// Radial displacement of the outer ring at a radius \[mm\]: `p b² ((1 − ν) r + (1 + ν) c²/r) / E (c² − b²)`.
    pub fn outer_displacement(&self, radius: f64) -> f64 {
        let Material { young, poisson } = in_plane(self.outer, self.plane);
        let [b, c] = [self.interface, self.outside].map(|radius| radius.powi(2));
        let shape = (1.0 - poisson) * radius + (1.0 + poisson) * c / radius;
        self.pressure() * b * shape / (young * (c - b))
    }

    fn parameters(&self) -> Vec<Parameter> {
        vec![
            non_negative("bore", self.bore),
            positive("interface", self.interface),
            Parameter {
                holds: self.interface > self.bore,
                range: "above the bore",
                ..finite("interface", self.interface)
            },
            Parameter {
                holds: self.outside > self.interface && self.outside.is_finite(),
                range: "above the interface and finite",
                ..finite("outside", self.outside)
            },
            non_negative("interference", self.interference),
            positive("inner.young", self.inner.young),
            poisson_ratio("inner.poisson", self.inner.poisson),
            positive("outer.young", self.outer.young),
            poisson_ratio("outer.poisson", self.outer.poisson),
        ]
    }
}

impl Oracle for PressFit {
    fn name(&self) -> &str {
        "Lamé"
    }

    fn source(&self) -> Source {
        Source::new(
            "G. Lamé 1852; S. Timoshenko and J. N. Goodier, Theory of Elasticity, 1951, §26",
            "re-derived; checked by the mismatch of radial displacements",
        )
    }

    fn read(&self, quantity: &Quantity) -> Reading {
        let parameters = self.parameters();
        let value = match quantity {
            Quantity::PeakPressure | Quantity::Pressure { .. } => self.pressure(),
            _ => return Reading::Silent,
        };
        answer(parameters, quantity, value)
    }
}
