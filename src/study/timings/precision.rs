//! Error against seconds and work, over loads the mesh does not know.
//!
//! The mesh is graded for the nominal half-width and the candidate stretch; eight loads then move the contact edge across
//! one of its elements, so that no mesh has the edge on a node by luck. Every point is the median and the worst of them.

use serde::{Deserialize, Serialize};

use crate::clock::Seconds;
use crate::error::Error;
use crate::measure::larger;
use crate::mesh::{Order, Resolution};
use crate::solve::run::Run;
use crate::solve::{Discretisation, Formulation};
use crate::study::pairing::Pairing;
use crate::study::timings::answers::Answers;
use crate::study::timings::statistics::Spread;

pub use crate::study::timings::family::{ELEMENTS, Family, TOLERANCE};

/// Loads of every point.
pub const LOADS: usize = 8;
/// Errors that are asked for.
pub const ASKED: [f64; 4] = [1e-2, 3e-3, 1e-3, 3e-4];
/// One point of the charts.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Point {
    /// Scene and grading.
    pub family: Family,
    /// Nodes of a cell.
    pub cell_nodes: usize,
    /// Elements per nominal half-width.
    pub elements: usize,
    /// Contact element and algorithm.
    pub formulation: Pairing,
    /// Unknown displacement components.
    pub dofs: usize,
    /// Operations of the sparse factorisation.
    pub sparse_operations: f64,
    /// Operations of the iteration, median.
    pub dense_operations: f64,
    /// Iterations, median.
    pub iterations: f64,
    /// Loads of eight that converged; the errors are numbers only where all do.
    pub converged: usize,
    /// Seconds from the scene to the pressures, median.
    pub seconds: f64,
    /// Error of p₀ against the answer of the scene: median and worst.
    pub peak: f64,
    /// Worst.
    pub peak_worst: f64,
    /// Error of a: median and worst.
    pub half_width: f64,
    /// Worst.
    pub half_width_worst: f64,
    /// L2(p) against Hertz: median and worst.
    pub l2: f64,
    /// Worst.
    pub l2_worst: f64,
}

impl Point {
    /// The larger median error of p₀ and a.
    pub fn error(&self) -> f64 {
        larger(self.peak, self.half_width)
    }

    /// Operations in all.
    pub fn operations(&self) -> f64 {
        self.sparse_operations + self.dense_operations
    }
}

/// Half-widths of the loads: from the nominal one on, across one element.
pub fn half_widths(nominal: f64, elements: usize) -> [f64; LOADS] {
    std::array::from_fn(|k| nominal * (1.0 + k as f64 / (LOADS * elements) as f64))
}

/// One load by one formulation.
struct Loaded {
    run: Run,
    errors: [f64; 3],
}

/// Points of one mesh, one a formulation, their errors against the answers of the family.
pub fn measure(family: Family, order: Order, elements: usize, answers: &Answers) -> Result<Vec<Point>, Error> {
    let formulations = family.formulations();
    let mut loaded: Vec<Vec<Loaded>> = formulations.iter().map(|_| Vec::new()).collect();
    for half_width in half_widths(family.nominal(), elements) {
        let (scene, exact) = family.loaded(half_width);
        let discretisation = Discretisation::of(scene, Resolution { elements, refinement: 0, order })?;
        for (formulation, loaded) in formulations.iter().zip(&mut loaded) {
            let run = Run::of(&discretisation, formulation)?;
            let errors = answers.errors(&run, &exact, half_width / family.nominal());
            loaded.push(Loaded { run, errors });
        }
    }
    let points = formulations.iter().zip(loaded);
    Ok(points.map(|(formulation, loaded)| point(family, order, elements, formulation, &loaded)).collect())
}

fn point(family: Family, order: Order, elements: usize, formulation: &Formulation, loaded: &[Loaded]) -> Point {
    let over = |of: &dyn Fn(&Loaded) -> f64| Spread::of(&loaded.iter().map(of).collect::<Vec<_>>());
    let [peak, half_width, l2] = [0, 1, 2].map(|k| over(&|one| one.errors[k]));
    let first = &loaded[0].run;
    Point {
        family,
        cell_nodes: order.nodes_per_cell(),
        elements,
        formulation: Pairing::of(formulation),
        dofs: first.dofs,
        sparse_operations: first.sparse_operations,
        dense_operations: over(&|one| one.run.solution.work.operations).median,
        iterations: over(&|one| one.run.solution.work.iterations as f64).median,
        converged: loaded.iter().filter(|one| one.run.solution.converged()).count(),
        seconds: over(&|one| one.run.seconds.iter().map(|(_, seconds)| seconds).sum()).median,
        peak: peak.median,
        peak_worst: peak.most,
        half_width: half_width.median,
        half_width_worst: half_width.most,
        l2: l2.median,
        l2_worst: l2.most,
    }
}

/// Seconds by stage of one formulation on one mesh, under each of the loads.
pub fn laps(family: Family, order: Order, elements: usize, formulation: &Formulation) -> Result<Vec<Laps>, Error> {
    let one = |half_width: f64| {
        let (scene, _) = family.loaded(half_width);
        Ok(Run::of(&Discretisation::of(scene, Resolution { elements, refinement: 0, order })?, formulation)?.seconds)
    };
    half_widths(family.nominal(), elements).into_iter().map(one).collect()
}

/// Seconds by stage.
pub type Laps = Seconds;

/// Families with the orders of their cells.
pub fn series() -> impl Iterator<Item = (Family, Order)> {
    let orders = |family: Family| [Order::Linear, Order::Quadratic].map(|order| (family, order));
    Family::ALL.into_iter().flat_map(orders)
}

/// All meshes of the charts.
pub fn meshes() -> Vec<(Family, Order, usize)> {
    let of = |(family, order): (Family, Order)| family.elements().map(move |elements| (family, order, elements));
    series().flat_map(of).collect()
}
