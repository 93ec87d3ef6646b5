//! One contact solve of the cylinder at three sizes, stage by stage, against one plain sparse Cholesky solve, and the
//! same of the sphere at two.

use std::collections::BTreeMap;
use std::time::Instant;

use serde::{Deserialize, Serialize};

use crate::case::library::find;
use crate::clock::{Clock, Seconds, Stage};
use crate::condensation::Plain;
use crate::elasticity::{ElasticSystem, numbered};
use crate::error::Error;
use crate::measure::order::slope;
use crate::mesh::{Mesh, Order, Resolution};
use crate::solve::{Change, Discretisation, Formulation};
use crate::study::seconds::{Spread, quantile, ratios};

/// Elements per half-width and refinement of the meshes of some 10⁴, 10⁵ and 10⁶ degrees of freedom, and how often each
/// is measured.
pub const MESHES: [(usize, u32, usize); 3] = [(12, 1, 15), (8, 3, 7), (20, 4, 3)];
/// The case that is measured on all of them.
pub const CYLINDER: &str = "cylinder";
/// The body of revolution with the same meshes, and on how many of the first it is measured.
pub const SPHERE: (&str, usize) = ("sphere", 2);
/// Degrees of freedom up to which the tests count iterations and entries of the factor again.
pub const RECOUNTED: usize = 200_000;
/// Stages that are the mesh and the matrix, not the contact solve.
const BEFORE: [Stage; 2] = [Stage::Mesh, Stage::Assembly];

/// What one mesh cost.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Growth {
    /// Counts, the same on every machine.
    pub counts: Counts,
    /// Seconds by stage on one thread.
    pub stages: BTreeMap<String, Spread>,
    /// Seconds of the contact solve: from the assembled matrix to the full displacement, ordering included.
    pub contact: Spread,
    /// Seconds of one plain sparse Cholesky solve.
    pub plain: Spread,
    /// The contact solve over the plain solve of the same run.
    pub ratio: Spread,
    /// What three of four of these runs stay below.
    pub ratio_quartile: f64,
    /// Assembly on one thread, and on all, over the plain solve of the same run.
    pub assembly_ratio: [Spread; 2],
    /// One more solve with another load and clearance over the contact solve of the same run.
    pub again_ratio: Spread,
    /// Largest memory of a process that does nothing else over the bytes of the factor; none where it cannot be read.
    pub memory_ratio: Option<f64>,
}

impl Growth {
    /// Median seconds of some stages together; NaN where one is not recorded.
    pub fn seconds(&self, stages: &[Stage]) -> f64 {
        let median = |stage: &Stage| self.stages.get(stage.name()).map_or(f64::NAN, |spread| spread.median);
        stages.iter().map(median).sum()
    }
}

/// Exponent e of `y = c nᵉ`, n degrees of freedom, by least squares of the logarithms.
pub fn exponent(growth: &[Growth], of: impl Fn(&Growth) -> f64) -> f64 {
    let dofs: Vec<f64> = growth.iter().map(|one| one.counts.dofs as f64).collect();
    slope(&dofs, &growth.iter().map(of).collect::<Vec<_>>())
}

/// What does not depend on the machine.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Counts {
    /// Name of the case.
    pub case: String,
    /// Elements per half-width.
    pub elements: usize,
    /// Times halved.
    pub refinement: u32,
    /// Unknown displacement components.
    pub dofs: usize,
    /// Retained normal displacements.
    pub retained: usize,
    /// Contact iterations.
    pub iterations: usize,
    /// Entries of the sparse factor.
    pub factor_entries: usize,
    /// Operations of the sparse factorisation.
    pub factor_operations: f64,
}

/// A mesh of either.
fn resolution(elements: usize, refinement: u32) -> Resolution {
    Resolution { elements, refinement, order: Order::Quadratic }
}

/// A case on a mesh.
fn discretised(case: &str, elements: usize, refinement: u32) -> Result<Discretisation, Error> {
    Discretisation::of(find(case, None)?.scene, resolution(elements, refinement))
}

/// Counts of a mesh of a case.
pub fn counts(case: &str, elements: usize, refinement: u32) -> Result<Counts, Error> {
    let discretisation = discretised(case, elements, refinement)?;
    let solution = discretisation.solve(&Formulation::verification())?;
    Ok(counted(&discretisation, (elements, refinement), solution.work.iterations))
}

fn counted(discretisation: &Discretisation, (elements, refinement): (usize, u32), iterations: usize) -> Counts {
    let condensed = &discretisation.condensed;
    Counts {
        case: discretisation.scene.name.clone(),
        elements,
        refinement,
        dofs: discretisation.system.dofs(),
        retained: condensed.retained(),
        iterations,
        factor_entries: condensed.factor_entries(),
        factor_operations: condensed.operations(),
    }
}

/// Measures a mesh of a case so many times, ours and the plain solve by turns.
pub fn measure(
    case: &str,
    (elements, refinement, repeats): (usize, u32, usize),
    memory: Option<f64>,
) -> Result<Growth, Error> {
    let scene = find(case, None)?.scene;
    let mesh = Mesh::of(&scene, resolution(elements, refinement))?;
    let system = ElasticSystem::assemble(&scene, &mesh)?;
    let reference = Plain::of(&system.bodies[0])?;
    drop((mesh, system));
    let (mut runs, mut plain) = (Vec::new(), Vec::new());
    for _ in 0..repeats {
        runs.push(once(case, elements, refinement)?);
        let clock = Instant::now();
        std::hint::black_box(reference.solve()?);
        plain.push(clock.elapsed().as_secs_f64());
    }
    let stage =
        |one: Stage| -> Vec<f64> { runs.iter().map(|(_, stages, _)| sum(stages, |stage| stage == one)).collect() };
    let contact: Vec<f64> = runs.iter().map(|(_, stages, _)| sum(stages, |stage| !BEFORE.contains(&stage))).collect();
    let [again, on_all] = [0, 1].map(|k| runs.iter().map(|(.., others)| others[k]).collect::<Vec<f64>>());
    let counts = runs[0].0.clone();
    Ok(Growth {
        stages: Stage::ALL.iter().map(|&one| (one.name().to_owned(), Spread::of(&stage(one)))).collect(),
        contact: Spread::of(&contact),
        plain: Spread::of(&plain),
        ratio: Spread::of(&ratios(&contact, &plain)),
        ratio_quartile: quantile(&ratios(&contact, &plain), 0.75),
        assembly_ratio: [stage(Stage::Assembly), on_all].map(|seconds| Spread::of(&ratios(&seconds, &plain))),
        again_ratio: Spread::of(&ratios(&again, &contact)),
        memory_ratio: memory.map(|bytes| bytes / (8.0 * counts.factor_entries as f64)),
        counts,
    })
}

fn sum(stages: &[(Stage, f64)], which: impl Fn(Stage) -> bool) -> f64 {
    stages.iter().filter(|(stage, _)| which(*stage)).map(|(_, seconds)| seconds).sum()
}

/// Seconds of one run: beside counts and stages those of one more solve, and of the assembly on all threads.
fn once(case: &str, elements: usize, refinement: u32) -> Result<(Counts, Seconds, [f64; 2]), Error> {
    let discretisation = discretised(case, elements, refinement)?;
    let mut clock = Clock::silent().after(&discretisation.seconds);
    let solution = clock.time(Stage::Iteration, || discretisation.solve(&Formulation::verification()))?;
    let recovered = || std::hint::black_box(discretisation.condensed.recover(1.0, &solution.displacement));
    clock.time(Stage::Recovery, recovered);
    let change = Change { load: 1.05, clearance: 0.02 * discretisation.scene.reference.gap };
    let again = Instant::now();
    std::hint::black_box(discretisation.solve_from(Some(&solution), &Formulation::verification(), change)?);
    let again = again.elapsed().as_secs_f64();
    let counts = counted(&discretisation, (elements, refinement), solution.work.iterations);
    let Discretisation { scene, mesh, .. } = discretisation;
    let numbering = numbered(&scene, &mesh)?;
    let assembly_on_all = on(ALL, || {
        let clock = Instant::now();
        std::hint::black_box(ElasticSystem::assemble_numbered(&scene, &mesh, numbering, &|_| 1.0)?);
        Ok(clock.elapsed().as_secs_f64())
    })?;
    Ok((counts, clock.seconds, [again, assembly_on_all]))
}

/// Solves once and returns the largest memory of this process so far \[bytes\]; NaN where the system does not tell.
pub fn memory_of_one_solve(elements: usize, refinement: u32) -> Result<f64, Error> {
    let discretisation = discretised(CYLINDER, elements, refinement)?;
    let solution = discretisation.solve(&Formulation::verification())?;
    std::hint::black_box(discretisation.condensed.recover(1.0, &solution.displacement));
    Ok(largest_memory("self").unwrap_or(f64::NAN))
}

/// The largest memory of a process so far \[bytes\]; none where the system does not tell.
pub fn largest_memory(process: &str) -> Option<f64> {
    let status = std::fs::read_to_string(format!("/proc/{process}/status")).ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    Some(1024.0 * line.trim().strip_suffix("kB")?.trim().parse::<f64>().ok()?)
}

/// As many threads as the processor offers.
pub const ALL: usize = 0;

/// Work on so many threads.
pub fn on<T: Send>(threads: usize, work: impl FnOnce() -> Result<T, Error> + Send) -> Result<T, Error> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().map_err(|error| {
        Error::at("timings", format!("no thread can be started: {error}"), "free memory, or raise the limit of threads")
    })?;
    pool.install(work)
}
