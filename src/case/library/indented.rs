//! Blocks of revolution that carry the tractions of a half-space, pressed by a rigid profile: a sphere, a cone.
use std::f64::consts::PI;

use crate::case::library::TruncatedHertz;
use crate::case::library::shared::{ENGINEERING, hertz_checks};
use crate::case::{Against, Case, Check, Quantity};
use crate::measure::Quantity as Number;
use crate::oracle::analytic::revolution::indentation::Indentation;
use crate::scene::{Material, PlaneHypothesis, Profile, ReferenceValues, Scene, VectorField};
use crate::solve::Formulation;

/// A block pressed by a rigid profile of revolution, with the closed-form tractions of its half-space on its other
/// sides.
#[derive(Clone, Debug)]
pub struct Indented {
    /// The contact of the half-space.
    pub contact: Indentation,
    /// Its profile in the scene.
    pub profile: Profile,
    /// Elastic constants.
    pub material: Material,
    /// Radius of the contact that block and candidates are drawn for \[mm\].
    pub drawn: f64,
    /// Candidate stretch over that radius, where the block allows it.
    pub stretch: f64,
}

impl Indented {
    /// Pressed to a contact of radius `a` \[mm\] by the profile `Σ c rⁿ`.
    pub fn to(a: f64, powers: Vec<[f64; 2]>, profile: Profile) -> Self {
        let material = Material::STEEL;
        let modulus = material.plane_modulus(PlaneHypothesis::Axisymmetric);
        let stretch = TruncatedHertz::default().stretch;
        Self { contact: Indentation::smooth(modulus, a, powers), profile, material, drawn: a, stretch }
    }

    /// By a paraboloid of radius 50 mm.
    pub fn by_sphere(a_over_r: f64) -> Self {
        let radius = 50.0;
        Self::to(a_over_r * radius, vec![[0.5 / radius, 2.0]], Profile::Parabola { radius })
    }

    /// By a cone that rises by 2 % of its radius, to a contact of 2.5 mm.
    pub fn by_cone() -> Self {
        let slope = 0.02;
        Self::to(2.5, vec![[slope, 1.0]], Profile::Wedge { slope })
    }

    /// The scene.
    pub fn scene(&self) -> Scene {
        let (a, nu, below) = (self.contact.radius, self.material.poisson, self.contact.clone());
        let stress = move |[r, depth]: [f64; 2]| below.potential(r, depth).stress(nu).in_plane();
        let Material { young, poisson } = self.material;
        let plain = TruncatedHertz::default();
        let stretch = self.stretch.min(plain.size);
        let block = TruncatedHertz { radius: self.drawn, young, poisson, a_over_r: 1.0, stretch, ..plain };
        let mut scene = block.scene_under(VectorField::of(stress));
        scene.plane = PlaneHypothesis::Axisymmetric;
        let pair = &mut scene.contacts[0];
        (pair.symmetric, pair.profile) = (false, self.profile.clone());
        // The peak of a semi-ellipsoid of the same load.
        let pressure = 1.5 * self.contact.load() / (PI * a * a);
        scene.reference = ReferenceValues { length: a, pressure, gap: self.profile.gap(a) };
        scene
    }

    /// The case, with the closed form whose stresses are its load.
    pub fn case(&self, name: &'static str, title: &'static str) -> Case {
        let scene = Scene { name: name.into(), ..self.scene() };
        Case::of(name, title, scene, 8).against(self.contact.clone())
    }
}

/// The truncated sphere under a load.
pub fn truncated_sphere(a_over_r: f64) -> Case {
    Indented::by_sphere(a_over_r).case("truncated-sphere", SPHERE)
}

/// The cone.
pub fn cone() -> Case {
    Indented::by_cone().case("cone", CONE)
}

/// What the truncated sphere is.
pub(super) const SPHERE: &str =
    "block of revolution with Hertz tractions pressed by a rigid paraboloid: Hertz's sphere without model error";
/// What the cone is.
pub(super) const CONE: &str = "block of revolution with the tractions of its half-space pressed by a rigid cone";

/// Both verified, and all nine compared.
pub(super) fn cases() -> Vec<Case> {
    let (sphere, cone) = (truncated_sphere(0.05), cone());
    let a = cone.scene.reference.length;
    // Below its tip the pressure is without limit.
    let of_cone = |tolerance: [f64; 2], because: [&'static str; 2]| {
        let pressure = Quantity::from(Number::Pressure { at: 0.5 * a });
        let pressure = Check::near(pressure, Against::Oracle, tolerance[0], because[0]);
        vec![pressure, hertz_checks(tolerance, because).remove(1)]
    };
    let because = ["8-node cells, 8 on the radius; no model error", "the edge lies between two nodes at worst"];
    let nine = |case: Case, checks: Vec<Check>| Case { checks, formulations: Formulation::compared(), ..case };
    vec![
        Case { checks: hertz_checks([2e-3; 2], because), ..sphere.clone().named("truncated sphere, verification") },
        nine(sphere.named("truncated sphere"), hertz_checks([1e-2; 2], [ENGINEERING; 2])),
        Case { checks: of_cone([5e-3, 2e-3], because), ..cone.clone().named("cone, verification") },
        nine(cone, of_cone([2e-2, 1e-2], [ENGINEERING; 2])),
    ]
}
