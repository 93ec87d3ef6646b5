//! One contact solve of the cylinder from 10³ to 10⁶ degrees of freedom, stage by stage, against one plain sparse Cholesky solve.

use std::collections::BTreeMap;
use std::time::Instant;

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::case::library::Cylinder;
use crate::clock::{Clock, Seconds, Stage};
use crate::condensation::Plain;
use crate::elasticity::{ElasticSystem, Numbering};
use crate::error::{Error, Place};
use crate::mesh::{Mesh, Order, Resolution};
use crate::solution::Solution;
use crate::solve::{Change, Discretisation, Formulation, Iteration, Origin};
use crate::study::timings::statistics::{Spread, upper_quartile};

/// Elements per half-width and refinement of the meshes, and how often each is measured.
pub const MESHES: [(usize, u32, usize); 8] =
    [(4, 0, 15), (8, 0, 15), (12, 1, 15), (8, 2, 9), (8, 3, 7), (16, 3, 5), (8, 4, 3), (20, 4, 3)];
/// Degrees of freedom up to which iterations and entries of the factor are counted again whenever the suite runs.
pub const RECOUNTED: usize = 200_000;
/// Degrees of freedom from which exponents are fitted: below, starting costs as much as solving.
pub const LARGE: f64 = 7e3;
/// Where nine formulations are solved on one mesh: as many degrees of freedom with fewer and with more of them retained.
pub const NINE: [(usize, u32); 2] = [(2, 4), (8, 3)];

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
    /// What three of four of these runs stay below; none in records from before it was kept.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ratio_quartile: Option<f64>,
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

/// What does not depend on the machine.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Counts {
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

/// The cylinder on a mesh.
pub fn resolution(elements: usize, refinement: u32) -> Resolution {
    Resolution { elements, refinement, order: Order::Quadratic }
}

/// Counts of a mesh.
pub fn counts(elements: usize, refinement: u32) -> Result<Counts, Error> {
    let scene = Cylinder::default().scene();
    let discretisation = Discretisation::of(scene, resolution(elements, refinement))?;
    let solution = discretisation.solve(&Formulation::verification())?;
    Ok(counted(&discretisation, (elements, refinement), solution.work.iterations))
}

fn counted(discretisation: &Discretisation, (elements, refinement): (usize, u32), iterations: usize) -> Counts {
    let condensed = &discretisation.condensed;
    Counts {
        elements,
        refinement,
        dofs: discretisation.system.dofs(),
        retained: condensed.retained(),
        iterations,
        factor_entries: condensed.factor_entries(),
        factor_operations: condensed.operations(),
    }
}

/// Seconds of one run.
struct Once {
    counts: Counts,
    stages: Seconds,
    again: f64,
    assembly_on_all: f64,
}

/// Measures a mesh so many times, ours and the plain solve by turns.
pub fn measure((elements, refinement, repeats): (usize, u32, usize), memory: Option<f64>) -> Result<Growth, Error> {
    let scene = Cylinder::default().scene();
    let mesh = Mesh::of(&scene, resolution(elements, refinement))?;
    let system = ElasticSystem::assemble(&scene, &mesh)?;
    let reference = Plain::of(&system.bodies[0])?;
    drop((mesh, system));
    let (mut runs, mut plain) = (Vec::new(), Vec::new());
    for _ in 0..repeats {
        runs.push(once(elements, refinement)?);
        let clock = Instant::now();
        std::hint::black_box(reference.solve()?);
        plain.push(clock.elapsed().as_secs_f64());
    }
    let stage = |one: Stage| -> Vec<f64> { runs.iter().map(|run| sum(&run.stages, |stage| stage == one)).collect() };
    let contact: Vec<f64> = runs.iter().map(|run| sum(&run.stages, |stage| !BEFORE.contains(&stage))).collect();
    let on_all: Vec<f64> = runs.iter().map(|run| run.assembly_on_all).collect();
    let again: Vec<f64> = runs.iter().map(|run| run.again).collect();
    let counts = runs[0].counts.clone();
    Ok(Growth {
        stages: Stage::ALL.iter().map(|&one| (one.name().to_owned(), Spread::of(&stage(one)))).collect(),
        contact: Spread::of(&contact),
        plain: Spread::of(&plain),
        ratio: Spread::of_ratios(&contact, &plain),
        ratio_quartile: Some(upper_quartile(&contact.iter().zip(&plain).map(|(a, b)| a / b).collect::<Vec<_>>())),
        assembly_ratio: [Spread::of_ratios(&stage(Stage::Assembly), &plain), Spread::of_ratios(&on_all, &plain)],
        again_ratio: Spread::of_ratios(&again, &contact),
        memory_ratio: memory.map(|bytes| bytes / (8.0 * counts.factor_entries as f64)),
        counts,
    })
}

/// Seconds of the contact solve alone.
pub fn contact_seconds(elements: usize, refinement: u32, repeats: usize) -> Result<Spread, Error> {
    let one = |_| once(elements, refinement).map(|run| sum(&run.stages, |stage| !BEFORE.contains(&stage)));
    Ok(Spread::of(&(0..repeats).map(one).collect::<Result<Vec<_>, _>>()?))
}

fn sum(stages: &[(Stage, f64)], which: impl Fn(Stage) -> bool) -> f64 {
    stages.iter().filter(|(stage, _)| which(*stage)).map(|(_, seconds)| seconds).sum()
}

fn once(elements: usize, refinement: u32) -> Result<Once, Error> {
    let scene = Cylinder::default().scene();
    let discretisation = Discretisation::of(scene, resolution(elements, refinement))?;
    let mut clock = Clock::silent().after(&discretisation.seconds);
    let solution = clock.time(Stage::Iteration, || discretisation.solve(&Formulation::verification()))?;
    let recovered = || std::hint::black_box(discretisation.condensed.recover(&solution.displacement));
    clock.time(Stage::Recovery, recovered);
    let change = Change { load: 1.05, clearance: 0.02 * discretisation.scene.reference.gap };
    let again = Instant::now();
    std::hint::black_box(discretisation.solve_from(Origin::From(&solution), &Formulation::verification(), change)?);
    let again = again.elapsed().as_secs_f64();
    let counts = counted(&discretisation, (elements, refinement), solution.work.iterations);
    let Discretisation { scene, mesh, .. } = discretisation;
    let assembly_on_all = assembly_on_all_threads(&scene, &mesh)?;
    Ok(Once { counts, stages: clock.seconds, again, assembly_on_all })
}

/// Seconds of the assembly on as many threads as the processor offers.
fn assembly_on_all_threads(scene: &crate::scene::Scene, mesh: &Mesh) -> Result<f64, Error> {
    let numbering = Numbering::of(scene, mesh)?;
    let on_all = || -> Result<f64, Error> {
        let clock = Instant::now();
        std::hint::black_box(ElasticSystem::assemble_numbered(scene, mesh, numbering, &|_| 1.0)?);
        Ok(clock.elapsed().as_secs_f64())
    };
    match rayon::ThreadPoolBuilder::new().build() {
        Ok(pool) => pool.install(on_all),
        Err(_) => on_all(),
    }
}

/// Solves once and returns the largest memory of this process so far \[bytes\]; NaN where the system does not tell.
pub fn memory_of_one_solve(elements: usize, refinement: u32) -> Result<f64, Error> {
    let scene = Cylinder::default().scene();
    let discretisation = Discretisation::of(scene, resolution(elements, refinement))?;
    let solution = discretisation.solve(&Formulation::verification())?;
    std::hint::black_box(discretisation.condensed.recover(&solution.displacement));
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kilobytes = line.and_then(|text| text.trim().strip_suffix("kB")?.trim().parse::<f64>().ok());
    Ok(kilobytes.map_or(f64::NAN, |kilobytes| 1024.0 * kilobytes))
}

/// Several formulations on one condensation over the single node + kinematic solve, on one thread and on all.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Nine {
    /// Counts of the mesh.
    pub counts: Counts,
    /// All nine.
    pub all: [Spread; 2],
    /// Those six of them that do not factorise at every iteration until springs die out.
    pub without_varying: [Spread; 2],
    /// Iterations of varying stiffness with its three elements.
    pub varying_iterations: usize,
}

/// Measures the nine at their own defaults on one mesh, so many times.
pub fn nine((elements, refinement): (usize, u32), repeats: usize) -> Result<Nine, Error> {
    let scene = Cylinder::default().scene();
    let discretisation = Discretisation::of(scene, resolution(elements, refinement))?;
    let (mut all, mut six, mut last) = ([vec![], vec![]], [vec![], vec![]], None);
    for _ in 0..repeats {
        // One thread, then as many as the processor offers.
        for (threads, (all, six)) in [1, 0].into_iter().zip(all.iter_mut().zip(&mut six)) {
            let once = match rayon::ThreadPoolBuilder::new().num_threads(threads).build() {
                Ok(pool) => pool.install(|| once_all_nine(elements, refinement))?,
                Err(_) => once_all_nine(elements, refinement)?,
            };
            all.push((once.shared + once.others + once.varying) / (once.shared + once.single));
            six.push((once.shared + once.others) / (once.shared + once.single));
            last = Some(once);
        }
    }
    let none = || Error::at(Place::Nowhere, "nothing was measured", "repeat at least once");
    let OnceNine { iterations, varying_iterations, .. } = last.ok_or_else(none)?;
    let spreads = |lists: [Vec<f64>; 2]| lists.map(|list| Spread::of(&list));
    let counts = counted(&discretisation, (elements, refinement), iterations);
    Ok(Nine { counts, all: spreads(all), without_varying: spreads(six), varying_iterations })
}

/// Seconds of the condensation that all share, of the single solve, and of the nine.
struct OnceNine {
    shared: f64,
    single: f64,
    others: f64,
    varying: f64,
    iterations: usize,
    varying_iterations: usize,
}

/// Mesh to displacements by the single formulation and by the nine, these side by side on the threads at hand.
fn once_all_nine(elements: usize, refinement: u32) -> Result<OnceNine, Error> {
    let scene = Cylinder::default().scene();
    let clock = Instant::now();
    let discretisation = Discretisation::of(scene, resolution(elements, refinement))?;
    let shared = clock.elapsed().as_secs_f64();
    let solved = |formulations: &[Formulation]| -> Result<(f64, Vec<Solution>), Error> {
        let clock = Instant::now();
        let each = formulations.par_iter().with_max_len(1).map(|formulation| discretisation.solve(formulation));
        let solutions = each.collect::<Result<Vec<_>, Error>>()?;
        let retained: Vec<&[f64]> = solutions.iter().map(|solution| solution.displacement.as_slice()).collect();
        std::hint::black_box(discretisation.condensed.recover_all(&retained));
        Ok((clock.elapsed().as_secs_f64(), solutions))
    };
    let iterations = |solutions: &[Solution]| solutions.iter().map(|solution| solution.work.iterations).sum();
    let (varying, others): (Vec<_>, Vec<_>) =
        Formulation::nine().into_iter().partition(|formulation| formulation.algorithm == Iteration::Varying);
    let (single, one) = solved(&[Formulation::verification()])?;
    let (others, _) = solved(&others)?;
    let (varying, three) = solved(&varying)?;
    Ok(OnceNine {
        shared,
        single,
        others,
        varying,
        iterations: iterations(&one),
        varying_iterations: iterations(&three),
    })
}
