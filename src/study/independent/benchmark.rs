//! The scenes that every code solves on its own meshes, as numbers.

use std::collections::BTreeMap;

use crate::case::Case;
use crate::case::library::{Cylinder, PinPlate, PinRod, TruncatedHertz};
use crate::named::named_enum;
use crate::oracle::cross_code::PhysicalScene;

/// Meshes of each refinement series.
pub const LEVELS: usize = 3;
/// Degrees of freedom up to which the tests ask for a mesh of a series: the finest takes nine tenths of the time, and freezing asks it.
pub const ASKED: usize = 20_000;
/// Stretches of equal length over which profiles are compared by their means; the stations are their middles.
pub const STATIONS: usize = 40;
/// Half-angle of the contact in the wide plate \[degrees\].
const PLATE_ANGLE: f64 = 60.0;

named_enum! {
    /// A scene that every code solves, by its name in the frozen files.
    pub enum Scene {
        /// The cylinder on its plane at a/R = 0.05.
        Cylinder = "cylinder, a/R = 0.05",
        /// The same at a/R = 0.1.
        WiderCylinder = "cylinder, a/R = 0.1",
        /// Hertz without model error.
        TruncatedHertz = "truncated Hertz",
        /// The pin in the eye of the rod.
        PinRod = "pin-rod",
        /// The pin in a wide plate.
        PinPlate = "pin in plate",
    }
}

/// A scene for all codes.
pub struct Benchmark {
    /// Which.
    pub scene: Scene,
    /// The scene for the other codes.
    pub physical: PhysicalScene,
    /// The scene for us, with its closed form if there is one.
    pub case: Case,
    /// Elements of our coarsest mesh per half-width, or per 10 mm of arc.
    pub elements: usize,
}

impl Scene {
    /// Whether the contact coordinate is an angle.
    pub fn is_arc(self) -> bool {
        matches!(self, Self::PinRod | Self::PinPlate)
    }

    /// The scene in numbers.
    pub fn benchmark(self) -> Benchmark {
        match self {
            Self::Cylinder => self.cylinder(0.05),
            Self::WiderCylinder => self.cylinder(0.1),
            Self::TruncatedHertz => {
                let block = TruncatedHertz::default();
                let reach = 1.25 * block.half_width();
                let mut given = hertz_numbers(block.radius, block.young, block.poisson, block.a_over_r, block.stretch);
                given.insert("size".into(), block.size);
                self.of(block.case(), given, reach, 8)
            }
            Self::PinRod => {
                let rod = PinRod::default();
                self.of(rod.case(), rod_numbers(&rod), rod.stretch, 16)
            }
            Self::PinPlate => {
                let plate = PinPlate::of_half_angle(PLATE_ANGLE);
                self.of(plate.case(), plate_numbers(&plate), plate.stretch, 12)
            }
        }
    }

    fn cylinder(self, a_over_r: f64) -> Benchmark {
        let numbers = Cylinder { a_over_r, ..Default::default() };
        let given = hertz_numbers(numbers.radius, numbers.young, numbers.poisson, a_over_r, numbers.stretch);
        self.of(numbers.case(), given, 1.25 * numbers.half_width(), 8)
    }

    fn of(self, case: Case, numbers: BTreeMap<String, f64>, reach: f64, elements: usize) -> Benchmark {
        let stations = (0..STATIONS).map(|k| reach * (k as f64 + 0.5) / STATIONS as f64).collect();
        let physical = PhysicalScene { case: case.name.clone(), numbers, stations };
        Benchmark { scene: self, physical, case, elements }
    }
}

fn hertz_numbers(radius: f64, young: f64, poisson: f64, a_over_r: f64, stretch: f64) -> BTreeMap<String, f64> {
    let list =
        [("radius", radius), ("young", young), ("poisson", poisson), ("a_over_r", a_over_r), ("stretch", stretch)];
    list.map(|(name, value)| (name.to_owned(), value)).into()
}

fn rod_numbers(rod: &PinRod) -> BTreeMap<String, f64> {
    let list = [
        ("pin_radius", rod.pin_radius),
        ("clearance", rod.clearance),
        ("eye_outer_radius", rod.eye_outer_radius),
        ("shank_width", rod.shank_width),
        ("shank_end", rod.shank_end),
        ("thickness", rod.thickness),
        ("pin_young", rod.pin.young),
        ("pin_poisson", rod.pin.poisson),
        ("rod_young", rod.rod.young),
        ("rod_poisson", rod.rod.poisson),
        ("force", rod.force),
        ("stretch", rod.stretch),
    ];
    list.map(|(name, value)| (name.to_owned(), value)).into()
}

fn plate_numbers(plate: &PinPlate) -> BTreeMap<String, f64> {
    let list = [
        ("pin_radius", plate.pin_radius),
        ("clearance", plate.clearance),
        ("rim_radius", plate.rim_radius),
        ("thickness", plate.thickness),
        ("young", plate.material.young),
        ("poisson", plate.material.poisson),
        ("force", plate.force),
        ("stretch", plate.stretch),
    ];
    list.map(|(name, value)| (name.to_owned(), value)).into()
}
