//! The scenes that every code solves on its own meshes, as numbers.

use std::collections::BTreeMap;

use crate::case::library::{Cylinder, PinPlate, PinRod, TruncatedHertz};
use crate::case::problem::{self, Parts, Problem};
use crate::error::Error;
use crate::oracle::cross_code::PhysicalScene;

/// Stretches of equal length over which profiles are compared by their means; the stations are their middles.
pub const STATIONS: usize = 40;
/// Half-angle of the contact in the wide plate \[degrees\].
const PLATE_ANGLE: f64 = 60.0;

/// Names of the scenes, in the order of [`benchmarks`].
pub const NAMES: [&str; 5] =
    ["cylinder, a/R = 0.05", "cylinder, a/R = 0.1", "truncated Hertz", "pin-rod", "pin in plate"];

/// A scene for all codes.
pub struct Benchmark {
    /// Name.
    pub name: &'static str,
    /// The scene for the other codes.
    pub physical: PhysicalScene,
    /// The scene for us, with its closed form if there is one.
    pub problem: Problem,
    /// Elements of our coarsest mesh per half-width, or per 10 mm of arc.
    pub elements: usize,
    /// Agreement demanded of peak and half-width, and of the profile.
    pub demanded: [f64; 2],
    /// Whether the contact coordinate is an angle.
    pub arc: bool,
}

/// The scenes.
pub fn benchmarks() -> Result<Vec<Benchmark>, Error> {
    let cylinder = |name, a_over_r| {
        let numbers = Cylinder { a_over_r, ..Default::default() };
        let half_width = numbers.half_width();
        let given = hertz_numbers(numbers.radius, numbers.young, numbers.poisson, a_over_r, numbers.stretch);
        benchmark(name, "cylinder", given, 1.25 * half_width, problem::cylinder(numbers), 8)
    };
    let truncated = TruncatedHertz::default();
    let (half_width, a_over_r) = (truncated.half_width(), truncated.a_over_r);
    let mut given = hertz_numbers(truncated.radius, truncated.young, truncated.poisson, a_over_r, truncated.stretch);
    given.insert("size".into(), truncated.size);
    let block = problem::truncated_hertz(truncated);
    let rod = PinRod::default();
    let plate = problem::plate(PLATE_ANGLE);
    Ok(vec![
        cylinder(NAMES[0], 0.05),
        cylinder(NAMES[1], 0.1),
        benchmark(NAMES[2], "truncated-hertz", given, 1.25 * half_width, block, 8),
        benchmark(NAMES[3], "pin-rod", rod_numbers(&rod), rod.stretch, (rod.scene(), 32, None), 16),
        benchmark(NAMES[4], "pin-plate", plate_numbers(&plate), plate.stretch, problem::pin_plate(PLATE_ANGLE), 12),
    ])
}

fn benchmark(
    name: &'static str,
    case: &'static str,
    numbers: BTreeMap<String, f64>,
    reach: f64,
    parts: Parts,
    elements: usize,
) -> Benchmark {
    let stations = (0..STATIONS).map(|k| reach * (k as f64 + 0.5) / STATIONS as f64).collect();
    let arc = case.starts_with("pin");
    // Hertz scenes: profile reported, its square-root edge is where meshes differ.
    let demanded = if arc { [5e-3, 5e-3] } else { [1e-3, 1.5e-2] };
    let physical = PhysicalScene { case: case.into(), numbers, stations };
    Benchmark { name, physical, problem: Problem::new(case, name, parts), elements, demanded, arc }
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
