//! Scenes meshed and solved, and their errors.

use serde::Serialize;

use crate::case::library::{Patch, TruncatedHertz};
use crate::elasticity::ElasticSystem;
use crate::error::Error;
use crate::measure::larger;
use crate::mesh::{Mesh, Order, Resolution};
use crate::scene::{Grading, Scene};
use crate::solve::run::{Errors, Run};
use crate::solve::{Discretisation, Element, Formulation, Iteration};
use crate::study::limits::seen::Seen;

/// Cells of four and of eight nodes.
pub(super) const ORDERS: [Order; 2] = [Order::Linear, Order::Quadratic];

/// What is found at every value with 4-node and with 8-node cells.
pub(super) fn with_both_orders<T>(
    values: &[f64],
    at: impl Fn(f64, Order) -> Result<T, Error>,
) -> Result<Vec<[T; 2]>, Error> {
    let both = |&value: &f64| {
        let [linear, quadratic] = ORDERS.map(|order| at(value, order));
        Ok([linear?, quadratic?])
    };
    values.iter().map(both).collect()
}

/// What one of the nine formulations made of a scene.
#[derive(Clone, Debug, Serialize)]
pub struct OfNine {
    /// Its contact element.
    pub element: Element,
    /// Its algorithm.
    pub algorithm: Iteration,
    /// How it ended.
    pub seen: Seen,
    /// Largest pressure \[MPa\]; NaN where there is no solution.
    pub pressure: f64,
}

/// What all nine formulations make of a discretisation.
pub(super) fn nine(discretisation: &Discretisation) -> Vec<OfNine> {
    let solved = |formulation: Formulation| {
        let run = Run::of(discretisation, &formulation);
        let highest = |run: &Run| run.solution.points.iter().map(|point| point.pressure).reduce(larger);
        OfNine {
            element: formulation.element,
            algorithm: formulation.algorithm,
            seen: Seen::of(&run),
            pressure: run.ok().and_then(|run| highest(&run)).unwrap_or(f64::NAN),
        }
    };
    Formulation::nine().into_iter().map(solved).collect()
}

/// How many runs meet a criterion.
pub(super) fn count(runs: &[OfNine], criterion: impl Fn(&OfNine) -> bool) -> f64 {
    runs.iter().filter(|run| criterion(run)).count() as f64
}

/// Truncated Hertz of some numbers on a mesh of `elements` per half-width.
pub(super) fn truncated(numbers: TruncatedHertz, elements: usize, order: Order) -> Result<Discretisation, Error> {
    meshed(numbers.scene(), elements, order)
}

/// Truncated Hertz on cells that hardly grow: what fails is then the cells' doing, not their sizes'.
pub(super) fn on_even_cells(numbers: TruncatedHertz) -> Scene {
    let mut scene = numbers.scene();
    scene.grading = Grading { along: 1.3, depth: 1.25, ..scene.grading };
    scene
}

/// A scene on a mesh of `elements` per half-width.
pub(super) fn meshed(scene: Scene, elements: usize, order: Order) -> Result<Discretisation, Error> {
    Discretisation::of(scene, Resolution { elements, refinement: 0, order })
}

/// The verification formulation on a discretisation.
pub(super) fn verified(discretisation: &Discretisation) -> Result<Run, Error> {
    Run::of(discretisation, &Formulation::verification())
}

/// The same, assembled past the checks of the scene.
pub(super) fn unchecked(scene: &Scene, mesh: Mesh, resolution: Resolution) -> Result<Run, Error> {
    let system = ElasticSystem::assemble(scene, &mesh)?;
    verified(&Discretisation::of_system(scene.clone(), resolution, mesh, system)?)
}

/// Relative errors of p₀ and a against the scene's reference values; NaN where the run did not converge.
pub(super) fn hertz_errors(scene: &Scene, run: &Run) -> Errors {
    let error = |found: f64, wanted: f64| if run.solution.converged() { found / wanted - 1.0 } else { f64::NAN };
    let (measures, reference) = (run.measures(), &scene.reference);
    Errors {
        peak: error(measures.peak.pressure, reference.pressure),
        half_width: error(measures.second_moment_width, reference.length),
    }
}

/// Largest departure from the uniform pressure of the patch test; NaN where the run did not converge.
pub(super) fn patch_error(numbers: &Patch, run: &Run) -> f64 {
    let departures = run.solution.points.iter().map(|point| point.pressure / numbers.pressure - 1.0);
    if run.solution.converged() { largest(departures) } else { f64::NAN }
}

/// The largest size of some values; NaN if any is.
pub(super) fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(0.0, |worst, x| larger(worst, x.abs()))
}

/// The largest error of some; NaN if any is.
pub(super) fn worst(errors: impl IntoIterator<Item = Errors>) -> f64 {
    largest(errors.into_iter().map(|errors| errors.largest()))
}

/// Whether an error is above a bound, or no number.
pub(super) fn exceeds(error: f64, bound: f64) -> bool {
    error.is_nan() || error > bound
}
