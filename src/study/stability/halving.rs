//! The halving law of kinematic load: predicted against measured iterations.

use serde::Serialize;

use crate::case::library::{Cylinder, PinRod, TruncatedHertz};
use crate::error::Error;
use crate::mesh::{Order, Resolution};
use crate::solve::run::Run;
use crate::solve::{Discretisation, Element, Formulation, Iteration};
use crate::stability::halving;

/// Candidate stretch over the half-width, elements per half-width and initial stiffnesses of the halving law.
const STRETCHES: [f64; 4] = [1.0, 1.5, 2.0, 3.0];
const ELEMENTS: [usize; 3] = [5, 8, 16];
pub(super) const STARTS: [f64; 3] = [0.1, 1.0, 1e6];
/// Tenths of a decade of κ₀ among which soft springs are told from hard ones on truncated Hertz.
const TENTHS: std::ops::RangeInclusive<i32> = -15..=5;
/// Candidates of the pin-rod beyond its contact \[degrees\], and elements per 10 mm of arc, each twice the one before.
const PIN_STRETCHES: [f64; 4] = [65.0, 70.0, 75.0, 85.0];
pub(super) const PIN_ELEMENTS: [usize; 2] = [12, 24];

/// A scene on which the law is tried.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Scene {
    /// The cylinder.
    Cylinder,
    /// Truncated Hertz.
    TruncatedHertz,
    /// The pin-rod, whose contact is no Hertz contact.
    PinRod,
}

/// A scene on all its meshes.
#[derive(Clone, Debug, Serialize)]
pub struct Law {
    /// The scene.
    pub scene: Scene,
    /// The meshes.
    pub meshes: Vec<Mesh>,
    /// Least κ₀ of each mesh from which on no start takes more iterations than a hard one; empty but on truncated Hertz.
    pub hard_from: Vec<f64>,
}

/// A candidate stretch on a mesh.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Mesh {
    /// Candidate stretch over the half-width, on the pin-rod over the last closed point.
    pub stretch: f64,
    /// Elements per half-width, on the pin-rod per 10 mm.
    pub elements: usize,
    /// From a soft start and from harder ones.
    pub iterations: [Iterations; 3],
}

/// Iterations from a start.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Iterations {
    /// Initial stiffness κ₀.
    pub stiffness: f64,
    /// By the law.
    pub predicted: usize,
    /// As measured; none where the run did not converge.
    pub measured: Option<usize>,
}

impl Scene {
    /// All.
    pub const ALL: [Self; 3] = [Self::Cylinder, Self::TruncatedHertz, Self::PinRod];

    /// Name of its trial.
    pub fn name(self) -> &'static str {
        match self {
            Self::Cylinder => "cylinder",
            Self::TruncatedHertz => "truncated hertz",
            Self::PinRod => "pin-rod",
        }
    }
}

/// A scene on all its meshes.
pub fn law(scene: Scene) -> Result<Law, Error> {
    let on_grid = |stretches: &[f64], elements: &[usize], mesh: &dyn Fn(f64, usize) -> Result<Mesh, Error>| {
        let pairs = stretches.iter().flat_map(|&stretch| elements.iter().map(move |&elements| (stretch, elements)));
        pairs.map(|(stretch, elements)| mesh(stretch, elements)).collect::<Result<Vec<_>, _>>()
    };
    let meshes = match scene {
        Scene::Cylinder => on_grid(&STRETCHES, &ELEMENTS, &|stretch, elements| {
            hertz(Cylinder { stretch, ..Default::default() }.scene(), stretch, elements)
        }),
        Scene::TruncatedHertz => on_grid(&STRETCHES, &ELEMENTS, &|stretch, elements| {
            hertz(TruncatedHertz { stretch, ..Default::default() }.scene(), stretch, elements)
        }),
        Scene::PinRod => on_grid(&PIN_STRETCHES, &PIN_ELEMENTS, &pin_rod),
    };
    let hard_from = match scene {
        Scene::TruncatedHertz => STRETCHES[1..].iter().flat_map(|&s| ELEMENTS.map(|e| (s, e))).map(hard_from).collect(),
        Scene::Cylinder | Scene::PinRod => Ok(Vec::new()),
    };
    Ok(Law { scene, meshes: meshes?, hard_from: hard_from? })
}

/// Where the starts of truncated Hertz cease to be soft, with candidates beyond the contact.
fn hard_from((stretch, elements): (f64, usize)) -> Result<f64, Error> {
    let scene = TruncatedHertz { stretch, ..Default::default() }.scene();
    let discretisation = Discretisation::of(scene, Resolution { elements, refinement: 0, order: Order::Quadratic })?;
    let [.., hard] = STARTS;
    let hard = measured(&discretisation, hard)?;
    let mut from = f64::NAN;
    for tenth in TENTHS.rev() {
        let stiffness = 10f64.powf(0.1 * f64::from(tenth));
        match (measured(&discretisation, stiffness)?, hard) {
            (Some(iterations), Some(hard)) if iterations <= hard => from = stiffness,
            _ => break,
        }
    }
    Ok(from)
}

/// Iterations of kinematic load on nodes; none where it does not converge.
fn measured(discretisation: &Discretisation, stiffness: f64) -> Result<Option<usize>, Error> {
    let formulation = Formulation { stiffness, ..Formulation::new(Element::Node, Iteration::Kinematic) };
    let solution = discretisation.solve(&formulation)?;
    Ok(solution.converged().then_some(solution.work.iterations))
}

/// A Hertz contact: its half-width is known beforehand.
fn hertz(scene: crate::scene::Scene, stretch: f64, elements: usize) -> Result<Mesh, Error> {
    let half_width = scene.reference.length;
    let resolution = Resolution { elements, refinement: 0, order: Order::Quadratic };
    let discretisation = Discretisation::of(scene, resolution)?;
    let spacing = half_width / (2.0 * elements as f64);
    let iterations = from_all(&discretisation, [stretch * half_width, half_width, spacing])?;
    Ok(Mesh { stretch, elements, iterations })
}

/// The pin-rod: its last closed point is found first.
fn pin_rod(degrees: f64, elements: usize) -> Result<Mesh, Error> {
    let scene = PinRod { stretch: degrees.to_radians(), ..Default::default() }.scene();
    let discretisation = Discretisation::of(scene, Resolution { elements, refinement: 0, order: Order::Quadratic })?;
    let edge = Run::of(&discretisation, &Formulation::verification())?.measures().edge();
    let stretch = discretisation.scene.contact().stretch;
    let spacing = stretch / (discretisation.interfaces[0].nodes.len() - 1) as f64;
    Ok(Mesh { stretch: stretch / edge, elements, iterations: from_all(&discretisation, [stretch, edge, spacing])? })
}

/// Iterations from every start: candidates to `stretch`, contact to `edge`, nodes `spacing` apart.
fn from_all(discretisation: &Discretisation, [stretch, edge, spacing]: [f64; 3]) -> Result<[Iterations; 3], Error> {
    let iterations = |stiffness: f64| -> Result<Iterations, Error> {
        let predicted = halving::iterations(stretch, edge, spacing, stiffness);
        Ok(Iterations { stiffness, predicted, measured: measured(discretisation, stiffness)? })
    };
    let [soft, middle, hard] = STARTS;
    Ok([iterations(soft)?, iterations(middle)?, iterations(hard)?])
}
