//! What more digits cost: meshes fitted to the contact, and 8-node ones as fine on all candidates, under the loads of the charts.

use std::time::Instant;

use serde::{Deserialize, Serialize};

use crate::case::library::TruncatedHertz;
use crate::error::Error;
use crate::measure::larger;
use crate::mesh::{Order, Resolution};
use crate::solve::{Discretisation, Fitted, Formulation, Run};
use crate::study::timings::answers::Answers;
use crate::study::timings::precision::{Family, half_widths};
use crate::study::timings::statistics::Spread;

/// Meshes that are timed, and how often under each load: the 8-node ones each up to a third finer than the one before.
pub const MESHES: [(Cells, usize); 17] = [
    (Cells::Fitted(4), 5),
    (Cells::Fitted(5), 5),
    (Cells::Fitted(6), 5),
    (Cells::Quadratic(8), 3),
    (Cells::Quadratic(10), 3),
    (Cells::Quadratic(13), 3),
    (Cells::Quadratic(16), 3),
    (Cells::Quadratic(20), 3),
    (Cells::Quadratic(26), 3),
    (Cells::Quadratic(32), 3),
    (Cells::Quadratic(40), 1),
    (Cells::Quadratic(52), 1),
    (Cells::Quadratic(64), 1),
    (Cells::Quadratic(80), 1),
    (Cells::Quadratic(104), 1),
    (Cells::Quadratic(128), 1),
    (Cells::Quadratic(160), 1),
];
/// Elements per half-width across one of which the loads move the edge where cells end with the contact.
const ACROSS: usize = 8;
/// Degrees of freedom up to which errors are computed again whenever the suite runs.
pub const RECOMPUTED: usize = 10_000;

/// Cells of a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Cells {
    /// Fitted to the contact, for so many digits.
    Fitted(usize),
    /// 8-node cells, so many on the nominal half-width.
    Quadratic(usize),
}

/// A mesh, what it costs and what it reaches.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Reached {
    /// What it is made of.
    pub cells: Cells,
    /// Degrees of freedom of the last mesh, the most under any load.
    pub dofs: usize,
    /// Seconds from the scene to the pressures, all meshes on the way included: median, least and most over the loads.
    pub seconds: Spread,
    /// Error of p₀: median and worst.
    pub peak: f64,
    /// Worst.
    pub peak_worst: f64,
    /// Error of a: median and worst.
    pub half_width: f64,
    /// Worst.
    pub half_width_worst: f64,
}

impl Reached {
    /// The larger worst error of p₀ and a; NaN where either is.
    pub fn worst(&self) -> f64 {
        larger(self.peak_worst, self.half_width_worst)
    }
}

/// Measures a mesh under all loads, so many times under each.
pub fn measure(cells: Cells, repeats: usize) -> Result<Reached, Error> {
    let (mut seconds, mut errors, mut dofs) = (Vec::new(), Vec::new(), 0);
    // Across one element of the mesh itself, as on the charts: across a coarser one, the edge would often be on a node.
    let across = match cells {
        Cells::Fitted(_) => ACROSS,
        Cells::Quadratic(elements) => elements,
    };
    for half_width in half_widths(Family::Truncated.nominal(), across) {
        let mut laps = Vec::new();
        for _ in 0..repeats.max(1) {
            let clock = Instant::now();
            let run = solved(cells, half_width)?;
            laps.push(clock.elapsed().as_secs_f64());
            dofs = dofs.max(run.dofs);
            if laps.len() == 1 {
                let (_, exact) = Family::Truncated.loaded(half_width);
                errors.push(Answers::HERTZ.errors(&run, &exact, half_width / Family::Truncated.nominal()));
            }
        }
        seconds.push(Spread::of(&laps).median);
    }
    let [peak, half_width] = [0, 1].map(|k| Spread::of(&errors.iter().map(|errors| errors[k]).collect::<Vec<_>>()));
    Ok(Reached {
        cells,
        dofs,
        seconds: Spread::of(&seconds),
        peak: peak.median,
        peak_worst: peak.most,
        half_width: half_width.median,
        half_width_worst: half_width.most,
    })
}

fn solved(cells: Cells, half_width: f64) -> Result<Run, Error> {
    let (mut scene, _) = Family::Truncated.loaded(half_width);
    match cells {
        Cells::Fitted(digits) => {
            Fitted::of_digits(digits).solve(&scene, &Formulation::verification()).map(|answer| answer.run)
        }
        Cells::Quadratic(elements) => {
            let order = Order::Quadratic;
            let usual = TruncatedHertz::default().case().resolution.elements;
            scene.grading = order.refined(&scene.grading, elements as f64 / usual as f64);
            let discretisation = Discretisation::of(scene, Resolution { elements, refinement: 0, order })?;
            Run::of(&discretisation, &Formulation::verification())
        }
    }
}

/// The cheapest fitted mesh within an error under every load.
pub fn fitted(reached: &[Reached], error: f64) -> Option<&Reached> {
    let enough = |one: &&Reached| matches!(one.cells, Cells::Fitted(_)) && one.worst() <= error;
    reached.iter().filter(enough).min_by(|a, b| a.seconds.median.total_cmp(&b.seconds.median))
}

/// Seconds at which 8-node cells have just this error under the worst load: by a power law between the two meshes around it, so that
/// the steps between meshes favour nobody. None where no mesh reaches it, or the coarsest already does.
pub fn quadratic(reached: &[Reached], error: f64) -> Option<f64> {
    let mut own: Vec<&Reached> = reached.iter().filter(|one| matches!(one.cells, Cells::Quadratic(_))).collect();
    own.sort_by(|a, b| a.seconds.median.total_cmp(&b.seconds.median));
    let first = own.iter().position(|one| one.worst() <= error)?;
    let [before, after] = [own[first.checked_sub(1)?], own[first]];
    let share = (error / before.worst()).ln() / (after.worst() / before.worst()).ln();
    Some(before.seconds.median * (after.seconds.median / before.seconds.median).powf(share))
}
