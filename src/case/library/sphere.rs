//! Elastic sphere on a rigid plane: Hertz's point contact.
use crate::case::Case;
use crate::case::library::shared::{ENGINEERING, hertz_checks};
use crate::oracle::analytic::revolution::sphere::Sphere;
use crate::scene::{Material, Scene};
use crate::solve::Formulation;

/// Radius \[mm\].
const RADIUS: f64 = 50.0;

/// The lower half of an elastic sphere, pressed on a rigid plane by a uniform load on its horizontal cut, with Hertz's
/// solution; the load follows from the radius of his contact over that of the sphere.
pub fn case(a_over_r: f64) -> Case {
    let a = a_over_r * RADIUS;
    let scene = Scene::sphere_on_plane(RADIUS, Material::STEEL, a);
    let modulus = scene.contact_modulus();
    let oracle = Sphere { load: Sphere::load_for(a, RADIUS, modulus), radius: RADIUS, modulus };
    let model = model_error(a_over_r, Material::STEEL.poisson);
    Case { model, ..Case::of("sphere", TITLE, scene, 16).against(oracle) }
}

/// What Hertz's half-space may be off a sphere: its peak is too high by `(1 − 2ν)²/5(1 − ν) · a/R`, and its radius of
/// contact too small by a little less than half, besides terms of the order of (a/R)².
///
/// The first is no closed form: it is what cells fitted to the contact tell for ν from −0.5 to 0.499 and a/R from 0.005
/// to 0.1. A cylinder has none of it.
pub fn model_error(a_over_r: f64, poisson: f64) -> f64 {
    a_over_r * ((1.0 - 2.0 * poisson).powi(2) / (5.0 * (1.0 - poisson)) + a_over_r)
}

/// What it is.
pub(super) const TITLE: &str = "elastic sphere pressed on a rigid plane, its lower half";

/// Verified where it is as good as a half-space, and all nine compared at the load of the cylinder.
pub(super) fn cases() -> Vec<Case> {
    let fine = "model error about 2e-4 at a/R = 0.005; 16 8-node cells on the radius of the contact";
    let [small, large] = [0.005, 0.05].map(case);
    let large = large.held_to(hertz_checks([5e-3; 2], [ENGINEERING; 2])).named("sphere");
    vec![
        small.held_to(hertz_checks([5e-4; 2], [fine; 2])).named("sphere, a/R = 0.005"),
        Case { formulations: Formulation::compared(), ..large },
    ]
}
