//! Hertz's scenes, built in code: a cylinder, or a sphere, on a rigid plane.

use std::f64::consts::PI;

use crate::scene::{
    Action, Body, Component, ContactPair, Face, Grading, Load, Material, Path, Place, PlaneHypothesis, Profile,
    ReferenceValues, Scene, Sector, Shape, Support,
};

/// Candidates reach as many half-widths as this.
const STRETCH: f64 = 2.0;

impl Scene {
    /// The lower quarter of a long cylinder, pressed on a rigid plane by the load per thickness `P = π a² E*/4R` under
    /// which Hertz's half-width is a: `q = P/2R` on the horizontal cut, symmetry on x = 0, plane strain. Lengths in mm.
    ///
    /// ```
    /// use signorini::mesh::{Order, Resolution};
    /// use signorini::scene::{Material, Scene};
    /// use signorini::solve::{Discretisation, Formulation, Run};
    ///
    /// let scene = Scene::cylinder_on_plane(50.0, Material::STEEL, 2.5);
    /// let resolution = Resolution { elements: 8, refinement: 0, order: Order::Quadratic };
    /// let discretisation = Discretisation::of(scene, resolution)?;
    /// let run = Run::of(&discretisation, &Formulation::verification())?;
    /// let peak = run.measures().peak.pressure;
    /// let hertz = 210e3 / (1.0 - 0.3f64.powi(2)) * 2.5 / (2.0 * 50.0);
    /// assert!((peak / hertz - 1.0).abs() < 2e-3);
    /// # Ok::<(), signorini::error::Error>(())
    /// ```
    pub fn cylinder_on_plane(radius: f64, material: Material, half_width: f64) -> Self {
        let plane = PlaneHypothesis::Strain;
        let load = PI * half_width.powi(2) * material.plane_modulus(plane) / (4.0 * radius);
        let shape = Shape::Disc { centre: [0.0, radius], radius, sector: Sector::Quarter, contact: Face::Bottom };
        let pressed = Load::on("cut", Action::Uniform([0.0, -load / (2.0 * radius)]));
        let stretch = STRETCH * half_width;
        Self {
            name: "cylinder".into(),
            plane,
            thickness: 1.0,
            bodies: vec![Body {
                density: 1.0,
                name: "cylinder".into(),
                shape,
                material,
                supports: vec![Support { at: Place::Boundary("axis".into()), component: Component::X, value: 0.0 }],
                loads: vec![pressed],
            }],
            contacts: vec![ContactPair::new(None, Path::HORIZONTAL, Profile::Circle { radius }, stretch)],
            reference: ReferenceValues::hertz(half_width, load, radius),
            grading: Grading { unit: half_width, along: 1.7, depth: 1.6, first: 1.0, coarsest: 0.3, end: 1.0 },
        }
    }

    /// The lower half of a sphere, pressed on a rigid plane by the force `F = 4E*a³/3R` \[N\] under which Hertz's
    /// circle of contact has the radius a: `q = F/πR²` on the horizontal cut. Lengths in mm.
    ///
    /// ```
    /// use signorini::mesh::{Order, Resolution};
    /// use signorini::scene::{Material, Scene};
    /// use signorini::solve::{Discretisation, Formulation, Run};
    ///
    /// let scene = Scene::sphere_on_plane(50.0, Material::STEEL, 0.5);
    /// let resolution = Resolution { elements: 8, refinement: 0, order: Order::Quadratic };
    /// let discretisation = Discretisation::of(scene, resolution)?;
    /// let run = Run::of(&discretisation, &Formulation::verification())?;
    /// let hertz = 2.0 * 210e3 / (1.0 - 0.3f64.powi(2)) * 0.5 / (std::f64::consts::PI * 50.0);
    /// assert!((run.measures().peak.pressure / hertz - 1.0).abs() < 2e-3);
    /// # Ok::<(), signorini::error::Error>(())
    /// ```
    pub fn sphere_on_plane(radius: f64, material: Material, contact_radius: f64) -> Self {
        let mut scene = Self::cylinder_on_plane(radius, material, contact_radius);
        let load = 4.0 * scene.contact_modulus() * contact_radius.powi(3) / (3.0 * radius);
        scene.name = "sphere".into();
        scene.plane = PlaneHypothesis::Axisymmetric;
        scene.bodies[0].name = "sphere".into();
        let traction = [0.0, -load / (PI * radius * radius)];
        scene.bodies[0].loads = vec![Load::on("cut", Action::Uniform(traction))];
        scene.contacts[0].symmetric = false;
        scene.reference = ReferenceValues::hertz_sphere(contact_radius, load, radius);
        scene
    }
}

impl ReferenceValues {
    /// `ℓ = a`, `p_ref = p₀ = 2P/πa`, `g_ref = g(a) = a²/2R`.
    pub fn hertz(half_width: f64, load: f64, radius: f64) -> Self {
        Self {
            length: half_width,
            pressure: 2.0 * load / (PI * half_width),
            gap: half_width * half_width / (2.0 * radius),
        }
    }

    /// `ℓ = a`, `p_ref = p₀ = 3F/2πa²`, `g_ref = g(a) = a²/2R` of a sphere.
    pub fn hertz_sphere(contact_radius: f64, load: f64, radius: f64) -> Self {
        let pressure = 1.5 * load / (PI * contact_radius * contact_radius);
        Self { pressure, ..Self::hertz(contact_radius, load, radius) }
    }
}
