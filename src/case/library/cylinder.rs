//! Elastic cylinder on a rigid plane (the paper's example a).
use std::f64::consts::PI;

use crate::case::Case;
use crate::case::library::shared::{ENGINEERING, hertz_checks};
use crate::mesh::Resolution;
use crate::oracle::analytic::hertz::Hertz;
use crate::scene::{Action, Component, Face, Load, Material, PlaneHypothesis, Scene, Sector, Shape, VectorField};
use crate::solve::Formulation;

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
    /// The lower quarter of a cylinder between two plates: its horizontal cut stays flat.
    BetweenPlates,
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
        let mut scene = Scene::cylinder_on_plane(self.radius, self.material(), self.half_width());
        scene.contacts[0].stretch = self.stretch * self.half_width();
        let q = self.load() / (2.0 * self.radius);
        let load = match self.model {
            CylinderModel::Quarter => return scene,
            CylinderModel::BetweenPlates => {
                Load::RigidFace { boundary: "cut".into(), component: Component::Y, force: -0.5 * self.load() }
            }
            CylinderModel::Half => Load::on("middle", Action::Uniform([0.0, -q])),
            CylinderModel::HalfLoadedAbove => Load::on("top", Action::Stress(VectorField::of(move |_| [0.0, -q, 0.0]))),
        };
        let body = &mut scene.bodies[0];
        body.loads = vec![load];
        if self.model != CylinderModel::BetweenPlates {
            let (centre, radius) = ([0.0, self.radius], self.radius);
            body.shape = Shape::Disc { centre, radius, sector: Sector::RightHalf, contact: Face::Bottom };
            scene.name = "cylinder-half".into();
        }
        scene
    }

    /// The case, with Hertz's solution.
    pub fn case(&self) -> Case {
        let scene = self.scene();
        let oracle = Hertz { load: self.load(), radius: self.radius, modulus: scene.contact_modulus() };
        // What Hertz's half-plane may be off a cylinder: of the order of (a/R)².
        let model = self.a_over_r * self.a_over_r;
        Case { source: SOURCE.into(), model, ..Case::of("cylinder", TITLE, scene, 12).against(oracle) }
    }
}

/// What it is.
pub(super) const TITLE: &str = "elastic cylinder pressed on a rigid plane, the lower quarter (paper, example a)";
/// Its dimensions are not in the text of the paper.
const SOURCE: &str = "J. Égert 1999, first example; dimensions chosen here";

/// Name of the case of all nine.
pub const NINE: &str = "cylinder";

/// Verified at two loads, and all nine compared.
pub(super) fn cases() -> Vec<Case> {
    let model = "model error at a/R = 0.05 plus discretisation; see the model error beside it";
    let verified = Cylinder::default().case();
    let small = Cylinder { a_over_r: 0.005, ..Default::default() }.case();
    let fine = "model error below (a/R)² = 2.5e-5; 16 8-node cells per half-width";
    let checks = hertz_checks([1e-3; 2], [model; 2]);
    let small_checks = hertz_checks([2e-4, 5e-4], [fine, "the edge lies between two nodes"]);
    let resolution = Resolution { elements: 16, ..small.resolution };
    let all = hertz_checks([1e-2; 2], [ENGINEERING; 2]);
    vec![
        verified.clone().named("cylinder, verification").held_to(checks),
        Case { resolution, ..small.named("cylinder, a/R = 0.005").held_to(small_checks) },
        Case { formulations: Formulation::compared(), ..verified.named(NINE).held_to(all) },
    ]
}
