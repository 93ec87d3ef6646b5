//! Elastic cylinder on a rigid plane, and the truncated Hertz scene without its model error.

use std::f64::consts::PI;

use crate::scene::{
    Body, Component, ContactPair, Face, Grading, Load, Material, Path, Place, PlaneHypothesis, Profile,
    ReferenceValues, Scene, Sector, Shape, StressField, Support,
};

/// Elastic cylinder pressed on a rigid plane by a uniform load (paper, example a).
#[derive(Clone, Copy, Debug)]
pub struct Cylinder {
    /// Radius \[mm\].
    pub radius: f64,
    /// Young's modulus \[MPa\].
    pub young: f64,
    /// Poisson's ratio.
    pub poisson: f64,
    /// Hertz half-width over the radius; it sets the load.
    pub a_over_r: f64,
    /// Candidate stretch over the Hertz half-width.
    pub stretch: f64,
    /// How much of the cylinder is modelled, and where the load acts.
    pub model: CylinderModel,
}

/// How much of the cylinder is modelled, and where the uniform load acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CylinderModel {
    /// The lower quarter, loaded on its horizontal cut (the paper's model).
    Quarter,
    /// The half cylinder, loaded on the same horizontal line inside it.
    Half,
    /// The half cylinder, loaded per horizontal length on its upper arc.
    HalfLoadedAbove,
}

impl Default for Cylinder {
    fn default() -> Self {
        Self { radius: 50.0, young: 210e3, poisson: 0.3, a_over_r: 0.05, stretch: 2.0, model: CylinderModel::Quarter }
    }
}

impl Cylinder {
    /// Half-width `a` \[mm\] that Hertz gives under the scene's load.
    pub fn half_width(&self) -> f64 {
        self.a_over_r * self.radius
    }

    /// Full load per thickness `P = π a² E* / 4R` [N/mm].
    pub fn load(&self) -> f64 {
        let modulus = self.material().plane_modulus(PlaneHypothesis::Strain);
        PI * self.half_width().powi(2) * modulus / (4.0 * self.radius)
    }

    fn material(&self) -> Material {
        Material { young: self.young, poisson: self.poisson }
    }

    /// The scene: `q = P/2R` on the horizontal cut, symmetry on x = 0, rigid plane below.
    pub fn scene(&self) -> Scene {
        let q = self.load() / (2.0 * self.radius);
        let sector = if self.model == CylinderModel::Quarter { Sector::Quarter } else { Sector::RightHalf };
        let across = [0.0, -q];
        let load = match self.model {
            CylinderModel::Quarter => Load::Traction { boundary: "cut".into(), traction: across },
            CylinderModel::Half => Load::Traction { boundary: "middle".into(), traction: across },
            CylinderModel::HalfLoadedAbove => Load::Stress {
                boundary: "top".into(),
                field: StressField(std::sync::Arc::new(move |_| [0.0, -q, 0.0])),
            },
        };
        Scene {
            name: if sector == Sector::Quarter { "cylinder" } else { "cylinder-half" }.into(),
            plane: PlaneHypothesis::Strain,
            thickness: 1.0,
            bodies: vec![Body {
                density: 1.0,
                name: "cylinder".into(),
                shape: Shape::Disc { centre: [0.0, self.radius], radius: self.radius, sector, contact: Face::Bottom },
                material: self.material(),
                supports: vec![symmetry("axis")],
                loads: vec![load],
            }],
            contacts: vec![ContactPair::new(
                None,
                Path::HORIZONTAL,
                Profile::Circle { radius: self.radius },
                self.stretch * self.half_width(),
            )],
            reference: hertz_reference(self.half_width(), self.load(), self.radius),
            grading: Grading { unit: self.half_width(), along: 1.7, depth: 1.6, first: 1.0, coarsest: 0.3, end: 1.0 },
        }
    }
}

/// Rectangle pressed by a rigid parabola, with the closed-form Hertz tractions on its other sides.
#[derive(Clone)]
pub struct TruncatedHertz {
    /// Radius of curvature of the parabola \[mm\].
    pub radius: f64,
    /// Young's modulus \[MPa\].
    pub young: f64,
    /// Poisson's ratio.
    pub poisson: f64,
    /// Hertz half-width over the radius.
    pub a_over_r: f64,
    /// Width and height of the block over the half-width.
    pub size: f64,
    /// Candidate stretch over the half-width.
    pub stretch: f64,
}

impl Default for TruncatedHertz {
    fn default() -> Self {
        Self { radius: 50.0, young: 210e3, poisson: 0.3, a_over_r: 0.05, size: 8.0, stretch: 2.0 }
    }
}

impl TruncatedHertz {
    /// Half-width `a` \[mm\].
    pub fn half_width(&self) -> f64 {
        self.a_over_r * self.radius
    }

    /// Full load per thickness `P = π a² E* / 4R` [N/mm].
    pub fn load(&self) -> f64 {
        let modulus = self.material().plane_modulus(PlaneHypothesis::Strain);
        PI * self.half_width().powi(2) * modulus / (4.0 * self.radius)
    }

    fn material(&self) -> Material {
        Material { young: self.young, poisson: self.poisson }
    }

    /// The scene, with the half-space stress `(x, depth) ↦ [σ_x, σ_depth, τ]` of the same Hertz problem as its load.
    ///
    /// The block lies above the contact line y = 0, so that y is the depth.
    pub fn scene(&self, half_space: StressField) -> Scene {
        let a = self.half_width();
        let side = self.size * a;
        let field = |boundary: &'static str| Load::Stress { boundary: boundary.into(), field: half_space.clone() };
        Scene {
            name: "truncated-hertz".into(),
            plane: PlaneHypothesis::Strain,
            thickness: 1.0,
            bodies: vec![Body {
                density: 1.0,
                name: "block".into(),
                shape: Shape::Rectangle { x: [0.0, side], y: [0.0, side], contact: Face::Bottom },
                material: self.material(),
                supports: vec![symmetry("left")],
                loads: vec![field("right"), field("far")],
            }],
            contacts: vec![ContactPair::new(
                None,
                Path::HORIZONTAL,
                Profile::Parabola { radius: self.radius },
                self.stretch * a,
            )],
            reference: hertz_reference(a, self.load(), self.radius),
            grading: Grading { unit: a, along: 1.5, depth: 1.4, first: 1.0, coarsest: 0.2, end: 1.0 },
        }
    }
}

/// `ℓ = a`, `p_ref = p₀ = 2P/πa`, `g_ref = g(a) = a²/2R`.
fn hertz_reference(half_width: f64, load: f64, radius: f64) -> ReferenceValues {
    ReferenceValues {
        length: half_width,
        pressure: 2.0 * load / (PI * half_width),
        gap: half_width * half_width / (2.0 * radius),
    }
}

/// Symmetry about x = 0 on a named boundary.
pub(super) fn symmetry(boundary: &'static str) -> Support {
    Support { at: Place::Boundary(boundary.into()), component: Component::X, value: 0.0 }
}
