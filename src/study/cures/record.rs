//! The runs of the study of reach, as measured now and as recorded.
//!
//! An accelerated run of a hundred iterations amplifies round-off until another machine counts other iterations. The shares hold
//! everywhere; the page shows the record of one machine, so that it is the same on all.

use std::fs;
use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use crate::algorithm::Acceleration;
use crate::case::library::TruncatedHertz;
use crate::checkout::root;
use crate::error::Error;
use crate::measure::larger;
use crate::mesh::{Order, Resolution};
use crate::solution::Solution;
use crate::solve::{Discretisation, Element, Formulation, Iteration, Settings};

/// Candidate stretch over the half-width and elements per half-width of each plane of the study.
pub const PLANES: [(f64, usize); 7] = [(1.0, 8), (1.5, 8), (2.0, 8), (3.0, 8), (4.0, 8), (2.0, 4), (2.0, 16)];
/// The plane that is drawn.
pub const DRAWN: usize = 2;
/// Iterations within which a run must converge.
pub const ITERATIONS: usize = 200;
/// The record.
pub const RECORD: &str = "snapshots/atlas/reach.json";
/// The engineering tolerance, and the penetration that the hardest springs of kinematic load leave,
/// `p/k_hard ≈ 1e-6 g_ref`.
pub const TOLERANCES: [f64; 2] = [1e-3, 1e-6];

/// Runs of one element and acceleration from every start on every plane.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Runs {
    /// Contact element.
    pub element: Element,
    /// Acceleration of constant stiffness.
    pub acceleration: Acceleration,
    /// Iterations to each tolerance by plane and start; none where 200 are not enough.
    pub iterations: [Vec<Vec<Option<usize>>>; 2],
    /// Accelerated iterations given up.
    pub rejected: usize,
}

/// Runs as they are now.
#[derive(Clone, Debug, Serialize)]
pub struct Measured {
    /// The runs.
    pub runs: Runs,
    /// Largest difference of mean edge pressures to kinematic load on the drawn plane, over p_ref.
    pub apart: f64,
}

impl Runs {
    /// The formulation, without its initial stiffness.
    pub fn formulation(&self) -> Formulation {
        Formulation { acceleration: self.acceleration, ..Formulation::new(self.element, Iteration::Constant) }
    }

    /// Part of the starts that converge.
    pub fn share(&self, tolerance: usize) -> f64 {
        let all = self.iterations[tolerance].iter().flatten();
        all.clone().flatten().count() as f64 / all.count() as f64
    }
}

/// Initial stiffnesses: third decades from 1e-3 to 1e3.
pub fn stiffnesses() -> Vec<f64> {
    (-9..=9).map(|k| 10f64.powf(f64::from(k) / 3.0)).collect()
}

/// Truncated Hertz on a plane of the study.
pub fn discretised((stretch, elements): (f64, usize)) -> Result<Discretisation, Error> {
    let scene = TruncatedHertz { stretch, ..Default::default() }.scene();
    Discretisation::of(scene, Resolution { elements, refinement: 0, order: Order::Quadratic })
}

/// Runs of an element as they are now, plain first.
pub fn measure(element: Element) -> Result<Vec<Measured>, Error> {
    let planes = PLANES.iter().map(|&plane| discretised(plane)).collect::<Result<Vec<_>, _>>()?;
    let exact = planes[DRAWN].solve(&Formulation::new(element, Iteration::Kinematic).tolerance(1e-8))?;
    Acceleration::OF_FORCES.iter().map(|&acceleration| runs(element, acceleration, &planes, &exact)).collect()
}

fn runs(
    element: Element,
    acceleration: Acceleration,
    planes: &[Discretisation],
    exact: &Solution,
) -> Result<Measured, Error> {
    let mut runs = Runs { element, acceleration, iterations: Default::default(), rejected: 0 };
    let settings = Settings { tolerance: TOLERANCES[1], max_iterations: ITERATIONS, ..Settings::default() };
    let base = Formulation { settings, ..runs.formulation() };
    let mut apart = Vec::new();
    for (index, plane) in planes.iter().enumerate() {
        let mut iterations = [Vec::new(), Vec::new()];
        for stiffness in stiffnesses() {
            let solution = plane.solve(&Formulation { stiffness, ..base.clone() })?;
            runs.rejected += solution.work.rejected;
            for (iterations, tolerance) in iterations.iter_mut().zip(TOLERANCES) {
                let mut history = solution.history.iter();
                iterations.push(history.position(|iteration| iteration.error.largest() <= tolerance).map(|at| at + 1));
            }
            if index == DRAWN && solution.converged() {
                apart.push(difference(&solution, exact) / plane.scene.reference.pressure);
            }
        }
        runs.iterations.iter_mut().zip(iterations).for_each(|(all, iterations)| all.push(iterations));
    }
    // None that converges on the drawn plane is no agreement.
    Ok(Measured { runs, apart: apart.into_iter().reduce(larger).unwrap_or(f64::NAN) })
}

/// Largest difference of mean edge pressures \[MPa\].
fn difference(one: &Solution, other: &Solution) -> f64 {
    let differences = one.edges.iter().zip(&other.edges).map(|(a, b)| (a.pressure - b.pressure).abs());
    differences.fold(0.0, larger)
}

/// The recorded runs of an element.
pub fn read(element: Element) -> Result<Vec<Runs>, Error> {
    let renew = "run `cargo run --release -- atlas` and review its diff";
    let text = fs::read_to_string(path()).map_err(|error| Error::unreadable(&path(), error, renew))?;
    let all: Vec<Runs> = serde_json::from_str(&text).map_err(|error| Error::unreadable(&path(), error, renew))?;
    let found: Vec<Runs> = all.into_iter().filter(|runs| runs.element == element).collect();
    let complete = |runs: &Runs| {
        let planes = runs.iterations.iter().flatten();
        runs.iterations.iter().all(|planes| planes.len() == PLANES.len())
            && planes.into_iter().all(|plane| plane.len() == stiffnesses().len())
    };
    if found.iter().map(|runs| runs.acceleration).eq(Acceleration::OF_FORCES) && found.iter().all(complete) {
        return Ok(found);
    }
    Err(Error::file(&path(), format!("runs of `{}` are missing", element.name()), renew))
}

/// Measures every element and writes the record, a line for each formulation.
pub fn write() -> Result<(), Error> {
    let mut lines = Vec::new();
    for element in Element::ALL {
        for measured in measure(element)? {
            lines.push(
                serde_json::to_string(&measured.runs).expect("numbers, strings and lists can be written as JSON"),
            );
        }
    }
    fs::write(path(), format!("[\n{}\n]\n", lines.join(",\n"))).map_err(|error| Error::unwritable(&path(), error))
}

fn path() -> PathBuf {
    root().join(RECORD)
}
