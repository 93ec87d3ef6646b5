//! Pin in a wide plate with clearance.
use std::f64::consts::{FRAC_PI_2, PI};

use crate::case::library::shared::{ARC_UNIT, body, fixed, hole_contact, pin_reference, symmetry};
use crate::case::{Against, Case, Check, Quantity};
use crate::measure::Quantity as Number;
use crate::mesh::Resolution;
use crate::oracle::analytic::Plane;
use crate::oracle::analytic::persson::PinInHole;
use crate::scene::{Circle, Component, Face, Grading, Load, Material, PlaneHypothesis, Scene, Sector, Shape};

/// Pin in a wide plate of the same material; the pin is fixed at its centre node only, where the force acts.
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
            material: Material::STEEL,
            force: 2000.0,
            stretch: FRAC_PI_2,
            unit: ARC_UNIT,
        }
    }
}

impl PinPlate {
    /// The scene: half by symmetry; the pin is a half disc loaded at its centre and supported by contact alone.
    pub fn scene(&self) -> Scene {
        let (centre, radius) = ([0.0, 0.0], self.pin_radius);
        let disc = Shape::Disc { centre, radius, sector: Sector::RightHalf, contact: Face::Bottom };
        let force = Load::Force { at: centre, force: [0.0, -0.5 * self.force] };
        let inner = Circle { centre: [0.0, self.clearance], radius: radius + self.clearance };
        let outer = Circle { radius: self.rim_radius, ..inner };
        let ring = Shape::Ring { pole: centre, inner, outer, sweep: PI, both_sides: false, contact: Face::Bottom };
        let rim = [Component::X, Component::Y].map(|component| fixed("outer", component, 0.0));
        let held = [symmetry("start"), symmetry("end")].into_iter().chain(rim).collect();
        Scene {
            name: "pin-plate".into(),
            plane: PlaneHypothesis::Stress,
            thickness: self.thickness,
            bodies: vec![
                body("pin", disc, self.material, vec![symmetry("axis")], vec![force]),
                body("plate", ring, self.material, held, vec![]),
            ],
            contacts: vec![hole_contact(self.pin_radius, self.clearance, self.stretch)],
            reference: pin_reference(self.force / self.thickness, self.pin_radius, self.clearance, [self.material; 2]),
            grading: Grading { unit: self.unit, along: 1.25, depth: 1.5, first: 0.4, coarsest: 0.045, end: 1.0 },
        }
    }
}

/// Contact half-angles \[degrees\] and their elements per 10 mm of arc.
const ANGLES: [(f64, usize); 3] = [(30.0, 48), (60.0, 24), (80.0, 24)];
/// Where the hoop stress of the hole is read \[degrees\].
const HOOP: [f64; 2] = [90.0, 180.0];

impl PinPlate {
    /// The plate whose contact half-angle is `degrees`, by Persson's load.
    pub fn of_half_angle(degrees: f64) -> Self {
        let numbers = Self::default();
        let load = PinInHole::load_for(degrees.to_radians(), numbers.clearance, numbers.material.young);
        Self { force: load * numbers.thickness, stretch: (1.5 * degrees).min(90.0).to_radians(), ..numbers }
    }

    /// The case, with Persson's solution.
    pub fn case(&self) -> Case {
        let oracle = PinInHole {
            radius: self.pin_radius,
            clearance: self.clearance,
            load: self.force / self.thickness,
            modulus: self.material.young,
            poisson: self.material.poisson,
            plane: Plane::Stress,
        };
        Case { model: RIM, ..Case::of("pin-plate", TITLE, self.scene(), 24).against(oracle) }
    }
}

/// What it is.
pub(super) const TITLE: &str = "pin in a wide plate with clearance";

/// Three contact angles against Persson.
pub(super) fn cases() -> Vec<Case> {
    let of = |(angle, elements)| {
        let case = PinPlate::of_half_angle(angle).case();
        let resolution = Resolution { elements, ..case.resolution };
        Case { resolution, ..case.named(format!("pin in plate, ε = {angle}°")).held_to(persson()) }
    };
    ANGLES.map(of).into()
}

/// What a finite plate is off the infinite one: of the order of the radius of the pin over that of its rim.
const RIM: f64 = 1.0 / 500.0;

fn persson() -> Vec<Check> {
    let rim = "rim of the plate at 500 radii";
    let nodal = "nodal stress from 2×2 Gauss points on the growing elements away from the contact";
    let width = "edge within an element, plate finite";
    let edge = "square-root edge, resolved by the elements on the arc";
    let mut checks = vec![
        Check::near(Number::PeakPressure, Against::Oracle, 1e-3, rim),
        Check::error(Quantity::Profile, Against::Oracle, 5e-3, edge),
        Check::near(Quantity::on_arc(Number::SecondMomentWidth), Against::Oracle, 3e-3, width),
    ];
    let hoop =
        |degrees: f64| Check::near(Number::HoopStress { at: degrees.to_radians() }, Against::Oracle, 1e-2, nodal);
    checks.extend(HOOP.map(hoop));
    checks
}
