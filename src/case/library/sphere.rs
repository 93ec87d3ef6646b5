//! Elastic sphere on a rigid plane: Hertz's point contact.
use crate::case::library::shared::{ENGINEERING, hertz_checks};
use crate::case::{Case, Check};
use crate::oracle::analytic::revolution::sphere;
use crate::scene::{Material, Scene};
use crate::solve::Formulation;

/// The lower half of an elastic sphere, pressed on a rigid plane by a uniform load on its horizontal cut.
#[derive(Clone, Copy, Debug)]
pub struct Sphere {
    /// Radius \[mm\].
    pub radius: f64,
    /// Elastic constants.
    pub material: Material,
    /// Radius of Hertz's contact over that of the sphere; it sets the load.
    pub a_over_r: f64,
}

impl Default for Sphere {
    fn default() -> Self {
        Self { radius: 50.0, material: Material::STEEL, a_over_r: 0.05 }
    }
}

impl Sphere {
    /// The case, with Hertz's solution.
    pub fn case(&self) -> Case {
        let a = self.a_over_r * self.radius;
        let scene = Scene::sphere_on_plane(self.radius, self.material, a);
        let modulus = scene.contact_modulus();
        let load = sphere::Sphere::load_for(a, self.radius, modulus);
        let oracle = sphere::Sphere { load, radius: self.radius, modulus };
        // What Hertz's half-space may be off a sphere.
        Case { model: self.a_over_r * self.a_over_r, ..Case::of("sphere", TITLE, scene, 16).against(oracle) }
    }
}

/// What it is.
pub(super) const TITLE: &str = "elastic sphere pressed on a rigid plane, its lower half";

/// Verified where it is as good as a half-space, and all nine compared at the load of the cylinder.
pub(super) fn cases() -> Vec<Case> {
    let [small, large] = [0.005, 0.05].map(|a_over_r| Sphere { a_over_r, ..Default::default() });
    let fine = "model error about 2e-5 at a/R = 0.005; 16 8-node cells on the radius of the contact";
    let of = |case: Sphere, checks: Vec<Check>| case.case().held_to(checks);
    vec![
        of(small, hertz_checks([5e-4; 2], [fine; 2])).named("sphere, a/R = 0.005"),
        Case {
            formulations: Formulation::compared(),
            ..of(large, hertz_checks([5e-3; 2], [ENGINEERING; 2])).named("sphere")
        },
    ]
}
