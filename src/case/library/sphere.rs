//! Elastic sphere on a rigid plane: Hertz's point contact.
use crate::case::Case;
use crate::case::library::shared::{ENGINEERING, hertz_checks};
use crate::oracle::analytic::revolution::sphere::Sphere;
use crate::scene::{Material, Scene};
use crate::solve::Formulation;

/// Radius \[mm\].
const RADIUS: f64 = 50.0;

/// The lower half of an elastic sphere, pressed on a rigid plane by a uniform load on its horizontal cut, with Hertz's solution; the
/// load follows from the radius of his contact over that of the sphere.
pub fn case(a_over_r: f64) -> Case {
    let a = a_over_r * RADIUS;
    let scene = Scene::sphere_on_plane(RADIUS, Material::STEEL, a);
    let modulus = scene.contact_modulus();
    let oracle = Sphere { load: Sphere::load_for(a, RADIUS, modulus), radius: RADIUS, modulus };
    // What Hertz's half-space may be off a sphere.
    Case { model: a_over_r * a_over_r, ..Case::of("sphere", TITLE, scene, 16).against(oracle) }
}

/// What it is.
pub(super) const TITLE: &str = "elastic sphere pressed on a rigid plane, its lower half";

/// Verified where it is as good as a half-space, and all nine compared at the load of the cylinder.
pub(super) fn cases() -> Vec<Case> {
    let fine = "model error about 2e-5 at a/R = 0.005; 16 8-node cells on the radius of the contact";
    let [small, large] = [0.005, 0.05].map(case);
    let large = large.held_to(hertz_checks([5e-3; 2], [ENGINEERING; 2])).named("sphere");
    vec![
        small.held_to(hertz_checks([5e-4; 2], [fine; 2])).named("sphere, a/R = 0.005"),
        Case { formulations: Formulation::compared(), ..large },
    ]
}
