//! Press fit of two rings.
use std::f64::consts::FRAC_PI_2;

use crate::case::library::shared::{body, even, fixed, symmetry};
use crate::case::{Against, Case, Check, Quantity};
use crate::oracle::analytic::shell;
use crate::scene::{
    Circle, Component, ContactPair, Face, Material, Path, PlaneHypothesis, Profile, ReferenceValues, Scene, Shape,
};
use crate::solve::{Element, Formulation, Iteration};

/// Two rings pressed together: the inner one is too large by the interference.
#[derive(Clone, Copy, Debug)]
pub struct PressFit {
    /// Inner radius of the inner ring \[mm\].
    pub inner: f64,
    /// Radius of the interface \[mm\].
    pub interface: f64,
    /// Outer radius of the outer ring \[mm\].
    pub outer: f64,
    /// Radial interference \[mm\].
    pub interference: f64,
    /// Elastic constants of the inner and the outer ring.
    pub materials: [Material; 2],
    /// Plane hypothesis.
    pub plane: PlaneHypothesis,
}

impl Default for PressFit {
    fn default() -> Self {
        Self {
            inner: 20.0,
            interface: 40.0,
            outer: 70.0,
            interference: 0.02,
            materials: [Material::STEEL, Material { young: 70e3, poisson: 0.33 }],
            plane: PlaneHypothesis::Stress,
        }
    }
}

impl PressFit {
    /// The scene: a quarter by symmetry, no load but the interference `δ`; `p_ref = E*δ/b`, so that `g_ref = δ`.
    pub fn scene(&self) -> Scene {
        let circle = |radius| Circle { centre: [0.0, 0.0], radius };
        let ring = |name, inner, outer, contact, material| {
            let [inner, outer] = [inner, outer].map(circle);
            let shape = Shape::Ring { pole: [0.0, 0.0], inner, outer, sweep: FRAC_PI_2, both_sides: false, contact };
            body(name, shape, material, vec![symmetry("start"), fixed("end", Component::Y, 0.0)], vec![])
        };
        let ([inner, outer], path) = (self.materials, Path::Arc(circle(self.interface)));
        let compliance: f64 = self.materials.iter().map(|m| 1.0 / m.plane_modulus(self.plane)).sum();
        let pressure = self.interference / (self.interface * compliance);
        Scene {
            name: "press-fit".into(),
            plane: self.plane,
            thickness: 1.0,
            bodies: vec![
                ring("inner ring", self.inner, self.interface, Face::Top, inner),
                ring("outer ring", self.interface, self.outer, Face::Bottom, outer),
            ],
            contacts: vec![ContactPair::new(Some(1), path, Profile::Uniform(-self.interference), FRAC_PI_2)],
            reference: ReferenceValues { length: self.interface, pressure, gap: self.interference },
            grading: even(self.interface * FRAC_PI_2),
        }
    }

    /// The case, with Lamé's solution.
    pub fn case(&self) -> Case {
        Case::of("press-fit", TITLE, self.scene(), 32).against(self.closed_form())
    }

    /// Lamé's solution.
    pub fn closed_form(&self) -> shell::PressFit {
        let &Self { inner, interface, outer, interference, materials, plane } = self;
        let (shape, radii) = (shell::Shape::of_ring(plane), [inner, interface, outer]);
        shell::PressFit { shape, radii, interference, materials }
    }
}

/// What it is.
pub(super) const TITLE: &str = "press fit of two rings";

/// Both plane hypotheses, by kinematic load and by constant stiffness.
pub(super) fn cases() -> Vec<Case> {
    let check =
        Check::error(Quantity::Departure, Against::Oracle, 1e-4, "edges of 8-node cells are parabolas, not arcs");
    let of = |(name, plane)| {
        let constant = Formulation::new(Element::Node, Iteration::Constant).tolerance(1e-8);
        let case = PressFit { plane, ..Default::default() }.case();
        Case {
            formulations: vec![Formulation::verification(), constant],
            checks: vec![check.clone()],
            ..case.named(name)
        }
    };
    let planes = [PlaneHypothesis::Stress, PlaneHypothesis::Strain];
    ["press fit, plane stress", "press fit, plane strain"].into_iter().zip(planes).map(of).collect()
}
