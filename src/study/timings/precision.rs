//! Error against seconds and work, over loads the mesh does not know.
//!
//! The mesh is graded for the nominal half-width and the candidate stretch; eight loads then move the contact edge across
//! one of its elements, so that no mesh has the edge on a node by luck. Every point is the median and the worst of them.

use std::time::Instant;

use serde::{Deserialize, Serialize};

use crate::error::Error;
use crate::measure::larger;
use crate::mesh::Resolution;
use crate::oracle::analytic::hertz::Hertz;
use crate::solve::run::Run;
use crate::solve::{Discretisation, Fitted, Formulation};
use crate::study::pairing::Pairing;
use crate::study::timings::series::{Series, nominal};
use crate::study::timings::statistics::Spread;

/// Loads of every point.
pub const LOADS: usize = 8;
/// Elements per half-width across one of which the loads move the edge where a mesh has none of ours.
pub const ACROSS: usize = 8;

/// One point of the charts.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Point {
    /// Whose mesh, and of which cells.
    pub series: Series,
    /// Elements per nominal half-width, digits for which it is fitted, or its place in the series of another code.
    pub mesh: usize,
    /// Contact element and algorithm of ours.
    pub formulation: Option<Pairing>,
    /// Unknown displacement components; of the last mesh where several are solved on the way.
    pub dofs: usize,
    /// Operations of the sparse factorisation and, median, of the iteration; NaN where they are not counted.
    pub operations: f64,
    /// Loads of eight that converged; the errors are numbers only where all do.
    pub converged: usize,
    /// Seconds from the scene to the pressures, all meshes on the way included: median.
    pub seconds: f64,
    /// Error of p₀: median and worst.
    pub peak: f64,
    /// Worst.
    pub peak_worst: f64,
    /// Error of a: median and worst.
    pub half_width: f64,
    /// Worst.
    pub half_width_worst: f64,
}

impl Point {
    /// The larger median error of p₀ and a.
    pub fn error(&self) -> f64 {
        larger(self.peak, self.half_width)
    }

    /// The larger worst error of p₀ and a; NaN where either is.
    pub fn worst(&self) -> f64 {
        larger(self.peak_worst, self.half_width_worst)
    }
}

/// Half-widths of the loads: from the nominal one on, across one element.
pub fn half_widths(elements: usize) -> [f64; LOADS] {
    std::array::from_fn(|k| nominal() * (1.0 + k as f64 / (LOADS * elements) as f64))
}

/// One load by one formulation.
struct Loaded {
    run: Run,
    seconds: f64,
    errors: [f64; 2],
}

/// Points of one of our meshes, one a formulation.
pub fn measure(series: Series, mesh: usize) -> Result<Vec<Point>, Error> {
    let formulations = series.formulations();
    let mut loaded: Vec<Vec<Loaded>> = formulations.iter().map(|_| Vec::new()).collect();
    let across = if series == Series::Fitted { ACROSS } else { mesh };
    for half_width in half_widths(across) {
        let runs = solved(series, mesh, half_width, &formulations)?;
        let (_, exact) = series.loaded(half_width);
        for ((run, seconds), loaded) in runs.into_iter().zip(&mut loaded) {
            loaded.push(Loaded { errors: errors(&run, &exact), run, seconds });
        }
    }
    let point = |(formulation, loaded): (&Formulation, Vec<Loaded>)| {
        let over = |of: &dyn Fn(&Loaded) -> f64| Spread::of(&loaded.iter().map(of).collect::<Vec<_>>());
        let [peak, half_width] = [0, 1].map(|k| over(&|one| one.errors[k]));
        let counted = loaded[0].run.sparse_operations + over(&|one| one.run.solution.work.operations).median;
        Point {
            series,
            mesh,
            formulation: Some(Pairing::of(formulation)),
            dofs: loaded.iter().map(|one| one.run.dofs).max().unwrap_or(0),
            operations: if series == Series::Fitted { f64::NAN } else { counted },
            converged: loaded.iter().filter(|one| one.run.solution.converged()).count(),
            seconds: over(&|one| one.seconds).median,
            peak: peak.median,
            peak_worst: peak.most,
            half_width: half_width.median,
            half_width_worst: half_width.most,
        }
    };
    Ok(formulations.iter().zip(loaded).map(point).collect())
}

/// Relative errors of p₀ and a; NaN where the run did not converge.
fn errors(run: &Run, exact: &Hertz) -> [f64; 2] {
    if !run.solution.converged() {
        return [f64::NAN; 2];
    }
    let measures = run.measures();
    let pairs = [(measures.peak.pressure, exact.peak_pressure()), (measures.second_moment_width, exact.half_width())];
    pairs.map(|(found, exact)| (found / exact - 1.0).abs())
}

/// One mesh under one load by some formulations, each with its seconds.
pub fn solved(
    series: Series,
    mesh: usize,
    half_width: f64,
    formulations: &[Formulation],
) -> Result<Vec<(Run, f64)>, Error> {
    let (scene, _) = series.loaded(half_width);
    let Some(order) = series.order() else {
        let fitted = |formulation| {
            let clock = Instant::now();
            let run = Fitted::of_digits(mesh).solve(&scene, formulation)?.run;
            Ok((run, clock.elapsed().as_secs_f64()))
        };
        return formulations.iter().map(fitted).collect();
    };
    let discretisation = Discretisation::of(scene, Resolution { elements: mesh, refinement: 0, order })?;
    let of = |formulation| {
        let run = Run::of(&discretisation, formulation)?;
        let seconds = run.seconds.iter().map(|(_, seconds)| seconds).sum();
        Ok((run, seconds))
    };
    formulations.iter().map(of).collect()
}

/// All our meshes of the charts.
pub fn meshes() -> Vec<(Series, usize)> {
    let of = |series: Series| series.meshes().iter().map(move |mesh| (series, *mesh));
    Series::OURS.into_iter().flat_map(of).collect()
}
