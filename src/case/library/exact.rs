//! The small scenes with exact solutions: patch test, press fit, two bars, own weight, flat punch.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::case::library::hertz::symmetry;
use crate::scene::{
    Body, Circle, Component, ContactPair, Face, Grading, Load, Material, Path, Place, PlaneHypothesis, Profile,
    ReferenceValues, Scene, Shape, Support,
};

/// Two equal blocks pressed on one another by a uniform pressure across a uniform clearance.
#[derive(Clone, Copy, Debug)]
pub struct Patch {
    /// Width of the modelled halves and height of each block \[mm\].
    pub side: f64,
    /// Elastic constants.
    pub material: Material,
    /// Pressure on the upper block \[MPa\].
    pub pressure: f64,
}

impl Default for Patch {
    fn default() -> Self {
        Self { side: 10.0, material: Material { young: 210e3, poisson: 0.3 }, pressure: 100.0 }
    }
}

impl Patch {
    /// The scene; the clearance is `q ℓ/E*`, so that the exact spring has κ = 1 and every rule can find it.
    pub fn scene(&self) -> Scene {
        let modulus = 0.5 * self.material.plane_modulus(PlaneHypothesis::Strain);
        let gap = self.pressure * self.side / modulus;
        let load = Load::Traction { boundary: "far".into(), traction: [0.0, -self.pressure] };
        Scene {
            name: "patch".into(),
            plane: PlaneHypothesis::Strain,
            thickness: 1.0,
            bodies: vec![
                block(
                    "upper",
                    [0.0, self.side],
                    [gap, gap + self.side],
                    Face::Bottom,
                    self.material,
                    vec![],
                    vec![load],
                ),
                block("lower", [0.0, self.side], [-self.side, 0.0], Face::Top, self.material, vec![held(0.0)], vec![]),
            ],
            contacts: vec![flat_contact(Some(1), gap, self.side)],
            reference: ReferenceValues { length: self.side, pressure: self.pressure, gap },
            grading: even(self.side),
        }
    }
}

/// Two bars in line with a gap; the end of the upper one is pushed down by `u`.
#[derive(Clone, Copy, Debug)]
pub struct Bars {
    /// Length of each bar \[mm\].
    pub length: f64,
    /// Width of the bars \[mm\].
    pub width: f64,
    /// Young's modulus; Poisson's ratio is zero \[MPa\].
    pub young: f64,
    /// Gap \[mm\].
    pub gap: f64,
    /// Displacement of the upper end over the gap.
    pub push: f64,
}

impl Default for Bars {
    fn default() -> Self {
        Self { length: 100.0, width: 25.0, young: 210e3, gap: 0.1, push: 1.5 }
    }
}

impl Bars {
    /// The scene, in plane stress.
    pub fn scene(&self) -> Scene {
        let material = Material { young: self.young, poisson: 0.0 };
        let u = self.push * self.gap;
        let pressure = self.young * u / (2.0 * self.length);
        let upper = [self.gap, self.gap + self.length];
        Scene {
            name: "bars".into(),
            plane: PlaneHypothesis::Stress,
            thickness: 1.0,
            bodies: vec![
                block("upper", [0.0, self.width], upper, Face::Bottom, material, vec![held(-u)], vec![]),
                block("lower", [0.0, self.width], [-self.length, 0.0], Face::Top, material, vec![held(0.0)], vec![]),
            ],
            contacts: vec![flat_contact(Some(1), self.gap, self.width)],
            reference: ReferenceValues {
                length: self.length,
                pressure,
                gap: pressure * self.length / (0.5 * self.young),
            },
            grading: even(self.width),
        }
    }
}

/// A block standing on a rigid plane under its own weight, its sides guided so that it only shortens.
#[derive(Clone, Copy, Debug)]
pub struct OwnWeight {
    /// Width of the modelled half \[mm\].
    pub width: f64,
    /// Height \[mm\].
    pub height: f64,
    /// Elastic constants.
    pub material: Material,
    /// Specific weight `ρ g` [N/mm³].
    pub weight: f64,
}

impl Default for OwnWeight {
    fn default() -> Self {
        Self { width: 20.0, height: 40.0, material: Material { young: 1e3, poisson: 0.3 }, weight: 1e-2 }
    }
}

impl OwnWeight {
    /// The scene: body force downwards, rigid plane below.
    pub fn scene(&self) -> Scene {
        let pressure = self.weight * self.height;
        let modulus = self.material.plane_modulus(PlaneHypothesis::Strain);
        let weight = Load::BodyForce([0.0, -self.weight]);
        let block = block(
            "block",
            [0.0, self.width],
            [0.0, self.height],
            Face::Bottom,
            self.material,
            vec![symmetry("right")],
            vec![weight],
        );
        Scene {
            name: "own-weight".into(),
            plane: PlaneHypothesis::Strain,
            thickness: 1.0,
            bodies: vec![block],
            contacts: vec![flat_contact(None, 0.0, self.width)],
            reference: ReferenceValues { length: self.height, pressure, gap: pressure * self.height / modulus },
            grading: even(self.width),
        }
    }
}

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
            materials: [Material { young: 210e3, poisson: 0.3 }, Material { young: 70e3, poisson: 0.33 }],
            plane: PlaneHypothesis::Stress,
        }
    }
}

impl PressFit {
    /// The scene: a quarter by symmetry, no load but the interference `δ`; `p_ref = E*δ/b`, so that `g_ref = δ`.
    pub fn scene(&self) -> Scene {
        let circle = |radius| Circle { centre: [0.0, 0.0], radius };
        let ring = |name: &str, inner, outer, contact, material| Body {
            density: 1.0,
            name: name.into(),
            shape: Shape::Ring {
                pole: [0.0, 0.0],
                inner: circle(inner),
                outer: circle(outer),
                sweep: FRAC_PI_2,
                contact,
            },
            material,
            supports: vec![
                symmetry("start"),
                Support { at: Place::Boundary("end".into()), component: Component::Y, value: 0.0 },
            ],
            loads: vec![],
        };
        let [inner, outer] = self.materials;
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
            contacts: vec![ContactPair::new(
                Some(1),
                Path::Arc(circle(self.interface)),
                Profile::Uniform(-self.interference),
                FRAC_PI_2,
            )],
            reference: ReferenceValues { length: self.interface, pressure, gap: self.interference },
            grading: Grading {
                unit: self.interface * FRAC_PI_2,
                along: 1.0,
                depth: 1.0,
                first: 1.0,
                coarsest: 1.0,
                end: 1.0,
            },
        }
    }
}

/// A rigid flat punch with sharp corners pressed on a large block.
#[derive(Clone, Copy, Debug)]
pub struct FlatPunch {
    /// Half-width of the punch \[mm\].
    pub half_width: f64,
    /// Width of the modelled half and height of the block over the punch's half-width.
    pub size: f64,
    /// Elastic constants.
    pub material: Material,
    /// Full load per thickness [N/mm].
    pub load: f64,
}

impl Default for FlatPunch {
    fn default() -> Self {
        Self { half_width: 1.0, size: 40.0, material: Material { young: 210e3, poisson: 0.3 }, load: 1000.0 }
    }
}

impl FlatPunch {
    /// The scene: the block is pressed on the punch by a uniform pressure on its far side.
    pub fn scene(&self) -> Scene {
        let a = self.half_width;
        let side = self.size * a;
        let pressure = self.load / (PI * a);
        let modulus = self.material.plane_modulus(PlaneHypothesis::Strain);
        let load = Load::Traction { boundary: "far".into(), traction: [0.0, -0.5 * self.load / side] };
        Scene {
            name: "flat-punch".into(),
            plane: PlaneHypothesis::Strain,
            thickness: 1.0,
            bodies: vec![block("block", [0.0, side], [0.0, side], Face::Bottom, self.material, vec![], vec![load])],
            contacts: vec![ContactPair::new(None, Path::HORIZONTAL, Profile::Punch { half_width: a }, a)],
            reference: ReferenceValues { length: a, pressure, gap: pressure * a / modulus },
            grading: Grading { unit: a, along: 1.4, depth: 1.4, first: 1.0, coarsest: 0.1, end: 0.02 },
        }
    }
}

fn block(
    name: &str,
    x: [f64; 2],
    y: [f64; 2],
    contact: Face,
    material: Material,
    mut supports: Vec<Support>,
    loads: Vec<Load>,
) -> Body {
    supports.push(symmetry("left"));
    Body { name: name.into(), shape: Shape::Rectangle { x, y, contact }, material, density: 1.0, supports, loads }
}

/// Prescribed vertical displacement of the side opposite to the contact.
fn held(value: f64) -> Support {
    Support { at: Place::Boundary("far".into()), component: Component::Y, value }
}

fn flat_contact(second: Option<usize>, gap: f64, stretch: f64) -> ContactPair {
    ContactPair::new(second, Path::HORIZONTAL, Profile::Uniform(gap), stretch)
}

/// Equal elements throughout.
fn even(unit: f64) -> Grading {
    Grading { unit, along: 1.0, depth: 1.0, first: 1.0, coarsest: 1.0, end: 1.0 }
}
