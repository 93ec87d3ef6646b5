//! What error bars cost: a solve with them over the same solve without.

use std::path::PathBuf;
use std::time::Instant;

use serde::{Deserialize, Serialize};

use crate::accuracy::bars;
use crate::case::library::Cylinder;
use crate::checkout::root;
use crate::error::Error;
use crate::solve::{Discretisation, Formulation, Run};
use crate::study::timings::growth::resolution;
use crate::study::timings::machine::Machine;
use crate::study::timings::record::FOLDER;
use crate::study::timings::statistics::Spread;

/// Elements per half-width and refinement of the meshes, and how often each is measured.
pub const MESHES: [(usize, u32, usize); 7] =
    [(4, 0, 9), (8, 0, 9), (8, 1, 9), (12, 1, 7), (8, 2, 5), (16, 2, 3), (8, 3, 3)];
/// What renews the record.
const RENEW: &str = "run `cargo run --release -- timings --bars` and review the diff of snapshots/timings";

/// The record.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct BarCosts {
    /// On what.
    pub machine: Machine,
    /// Mesh by mesh.
    pub costs: Vec<BarCost>,
}

/// What bars cost on one mesh of the cylinder.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct BarCost {
    /// Elements per half-width.
    pub elements: usize,
    /// Times halved.
    pub refinement: u32,
    /// Unknown displacement components.
    pub dofs: usize,
    /// Seconds of the solve without bars, on one thread.
    pub alone: Spread,
    /// With them over without, run by run: on one thread, and on all.
    pub ratio: [Spread; 2],
}

/// Degrees of freedom of a mesh.
pub fn dofs(elements: usize, refinement: u32) -> Result<usize, Error> {
    Ok(Discretisation::of(Cylinder::default().scene(), resolution(elements, refinement))?.system.dofs())
}

/// Measures a mesh so many times on the threads of some pools, one thread first.
pub fn measure(
    (elements, refinement, repeats): (usize, u32, usize),
    pools: [&rayon::ThreadPool; 2],
) -> Result<BarCost, Error> {
    let seconds = |pool: &rayon::ThreadPool| -> Result<Vec<[f64; 2]>, Error> {
        pool.install(|| (0..repeats).map(|_| once(elements, refinement)).collect())
    };
    let [one, all] = [seconds(pools[0])?, seconds(pools[1])?];
    let of = |runs: &[[f64; 2]], k: usize| runs.iter().map(|run| run[k]).collect::<Vec<f64>>();
    let ratio = [&one, &all].map(|runs| Spread::of_ratios(&of(runs, 1), &of(runs, 0)));
    Ok(BarCost { elements, refinement, dofs: dofs(elements, refinement)?, alone: Spread::of(&of(&one, 0)), ratio })
}

/// Seconds of a solve as the command `solve` does it without bars, and with them.
fn once(elements: usize, refinement: u32) -> Result<[f64; 2], Error> {
    let clock = Instant::now();
    let discretisation = Discretisation::of(Cylinder::default().scene(), resolution(elements, refinement))?;
    let run = Run::of(&discretisation, &Formulation::verification())?.with_limits(&discretisation)?;
    let alone = clock.elapsed().as_secs_f64();
    std::hint::black_box(bars(&discretisation, &run, &[])?);
    Ok([alone, clock.elapsed().as_secs_f64()])
}

impl BarCosts {
    /// Reads what is committed.
    pub fn read() -> Result<Self, Error> {
        let text = std::fs::read_to_string(file()).map_err(|_| Error::missing_file(&file(), RENEW))?;
        serde_json::from_str(&text).map_err(|error| Error::unreadable(&file(), error, RENEW))
    }

    /// Writes the record.
    pub fn write(&self) -> Result<(), Error> {
        let text = serde_json::to_string_pretty(self).map_err(|error| Error::unwritable(&file(), error))?;
        std::fs::write(file(), text + "\n").map_err(|error| Error::unwritable(&file(), error))
    }
}

fn file() -> PathBuf {
    root().join(FOLDER).join("bars.json")
}
