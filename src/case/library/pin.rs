//! A pin in a connecting-rod eye, and a pin in a wide plate.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::case::library::hertz::symmetry;
use crate::scene::{
    Body, Circle, Component, ContactPair, Face, Grading, Load, Material, Path, Place, PlaneHypothesis, Profile,
    ReferenceValues, Scene, Sector, Shape, Support,
};

/// Length of arc that holds `N` elements of the candidate stretch on pins \[mm\].
pub const ARC_UNIT: f64 = 10.0;

/// Pin and connecting rod (paper, example b); every number of the scene is here.
#[derive(Clone, Copy, Debug)]
pub struct PinRod {
    /// Radius of the pin \[mm\].
    pub pin_radius: f64,
    /// Radial clearance \[mm\].
    pub clearance: f64,
    /// Outer radius of the eye \[mm\].
    pub eye_outer_radius: f64,
    /// Width of the shank \[mm\].
    pub shank_width: f64,
    /// Height of the shank's flat end above the eye's centre \[mm\].
    pub shank_end: f64,
    /// Thickness of pin and rod \[mm\].
    pub thickness: f64,
    /// Elastic constants of the pin.
    pub pin: Material,
    /// Elastic constants of the rod.
    pub rod: Material,
    /// Force on the whole rod, upwards \[N\].
    pub force: f64,
    /// Candidates lie between the load line and this angle \[rad\].
    pub stretch: f64,
    /// Arc length that holds `N` elements \[mm\].
    pub unit: f64,
}

impl Default for PinRod {
    fn default() -> Self {
        let steel = Material { young: 210e3, poisson: 0.3 };
        Self {
            pin_radius: 10.0,
            clearance: 0.05,
            eye_outer_radius: 20.0,
            shank_width: 20.0,
            shank_end: 60.0,
            thickness: 1.0,
            pin: steel,
            rod: steel,
            force: 2000.0,
            stretch: 75f64.to_radians(),
            unit: ARC_UNIT,
        }
    }
}

impl PinRod {
    /// The scene: half by symmetry, pin held on its horizontal diameter, rod pulled upwards by a rigid end face.
    pub fn scene(&self) -> Scene {
        let pin = Body {
            density: 1.0,
            name: "pin".into(),
            shape: Shape::Disc {
                centre: [0.0, 0.0],
                radius: self.pin_radius,
                sector: Sector::Quarter,
                contact: Face::Bottom,
            },
            material: self.pin,
            supports: vec![
                symmetry("axis"),
                Support { at: Place::Boundary("cut".into()), component: Component::Y, value: 0.0 },
            ],
            loads: vec![],
        };
        let rod = Body {
            density: 1.0,
            name: "rod".into(),
            shape: Shape::Eye {
                pole: [0.0, 0.0],
                hole: Circle { centre: [0.0, self.clearance], radius: self.pin_radius + self.clearance },
                outer_radius: self.eye_outer_radius,
                shank_half_width: 0.5 * self.shank_width,
                shank_end: self.shank_end,
            },
            material: self.rod,
            supports: vec![symmetry("axis")],
            loads: vec![Load::RigidFace { boundary: "end".into(), component: Component::Y, force: 0.5 * self.force }],
        };
        Scene {
            name: "pin-rod".into(),
            plane: PlaneHypothesis::Stress,
            thickness: self.thickness,
            bodies: vec![pin, rod],
            contacts: vec![hole_contact(self.pin_radius, self.clearance, self.stretch)],
            reference: pin_reference(
                self.force / self.thickness,
                self.pin_radius,
                self.clearance,
                [self.pin, self.rod],
            ),
            grading: Grading { unit: self.unit, along: 1.7, depth: 1.6, first: 1.0, coarsest: 0.3, end: 1.0 },
        }
    }
}

/// Pin in a wide plate of the same material; the pin is held at its centre node only, where the force acts.
#[derive(Clone, Copy, Debug)]
pub struct PinPlate {
    /// Radius of the pin \[mm\].
    pub pin_radius: f64,
    /// Radial clearance \[mm\].
    pub clearance: f64,
    /// Radius of the plate's fixed rim \[mm\].
    pub rim_radius: f64,
    /// Thickness \[mm\].
    pub thickness: f64,
    /// Elastic constants of both bodies.
    pub material: Material,
    /// Force on the whole pin, downwards \[N\].
    pub force: f64,
    /// Candidates lie between the load line and this angle \[rad\].
    pub stretch: f64,
    /// Arc length that holds `N` elements \[mm\].
    pub unit: f64,
}

impl Default for PinPlate {
    fn default() -> Self {
        Self {
            pin_radius: 10.0,
            clearance: 0.01,
            rim_radius: 5000.0,
            thickness: 1.0,
            material: Material { young: 210e3, poisson: 0.3 },
            force: 2000.0,
            stretch: FRAC_PI_2,
            unit: ARC_UNIT,
        }
    }
}

impl PinPlate {
    /// The scene: half by symmetry; the pin is a half disc loaded at its centre and held by contact alone.
    pub fn scene(&self) -> Scene {
        let pin = Body {
            density: 1.0,
            name: "pin".into(),
            shape: Shape::Disc {
                centre: [0.0, 0.0],
                radius: self.pin_radius,
                sector: Sector::RightHalf,
                contact: Face::Bottom,
            },
            material: self.material,
            supports: vec![symmetry("axis")],
            loads: vec![Load::Force { at: [0.0, 0.0], force: [0.0, -0.5 * self.force] }],
        };
        let hole = Circle { centre: [0.0, self.clearance], radius: self.pin_radius + self.clearance };
        let fixed = |component| Support { at: Place::Boundary("outer".into()), component, value: 0.0 };
        let plate = Body {
            density: 1.0,
            name: "plate".into(),
            shape: Shape::Ring {
                pole: [0.0, 0.0],
                inner: hole,
                outer: Circle { centre: hole.centre, radius: self.rim_radius },
                sweep: PI,
                contact: Face::Bottom,
            },
            material: self.material,
            supports: vec![symmetry("start"), symmetry("end"), fixed(Component::X), fixed(Component::Y)],
            loads: vec![],
        };
        Scene {
            name: "pin-plate".into(),
            plane: PlaneHypothesis::Stress,
            thickness: self.thickness,
            bodies: vec![pin, plate],
            contacts: vec![hole_contact(self.pin_radius, self.clearance, self.stretch)],
            reference: pin_reference(self.force / self.thickness, self.pin_radius, self.clearance, [self.material; 2]),
            grading: Grading { unit: self.unit, along: 1.25, depth: 1.5, first: 0.4, coarsest: 0.045, end: 1.0 },
        }
    }
}

fn hole_contact(radius: f64, clearance: f64, stretch: f64) -> ContactPair {
    let path = Path::Arc(Circle { centre: [0.0, 0.0], radius });
    ContactPair::new(Some(1), path, Profile::Hole { radius, clearance }, stretch)
}

/// `ℓ = R`, `p_ref = F/tR`, `g_ref = c`, or `p_ref ℓ/E*` where there is no clearance (plane stress).
fn pin_reference(load: f64, radius: f64, clearance: f64, materials: [Material; 2]) -> ReferenceValues {
    let pressure = load / radius;
    let compliance: f64 = materials.iter().map(|m| 1.0 / m.young).sum();
    let gap = if clearance > 0.0 { clearance } else { pressure * radius * compliance };
    ReferenceValues { length: radius, pressure, gap }
}
