//! What is run: points, each predicted from the condensed matrices before; of a recorded plane a fixed twentieth; and the paper's
//! formulations beside what the program takes in their place.

use std::path::Path;

use rayon::prelude::*;

use crate::algorithm::StiffnessRule;
use crate::contact::ContactPoint;
use crate::error::Error;
use crate::solution::IterationError;
use crate::solve::run::Run;
use crate::solve::{Discretisation, Ended, Formulation, Iteration};
use crate::stability::{Limit, halving, linear, rate, release};
use crate::study::Planned;
use crate::study::atlas::plane::{Plane, STRETCH, Site};
use crate::study::atlas::record::{Chart, HEAD, Record};
use crate::study::method::Method;
use crate::study::records::{self as kept, rounded};

/// One trial a plane, and one a scene of the paper.
pub fn plan() -> Vec<Planned<Numbers>> {
    let planes = Plane::ALL.map(|plane| Planned::new("stability atlas", plane.name(), move || of_plane(plane)));
    let saved = Plane::PAPER
        .map(|scene| Planned::new(format!("before and after, {}", scene.name()), "all nine", move || saved(scene)));
    planes.into_iter().chain(saved).collect()
}

/// What came out of a trial.
#[derive(Clone, Debug)]
pub enum Numbers {
    /// A plane.
    Surveyed {
        /// As recorded.
        chart: Chart,
        /// Points that were recomputed.
        recomputed: usize,
        /// Those of them that are not as recorded.
        moved: usize,
    },
    /// What acceleration and initial stiffness save each formulation on a scene of the paper.
    Saved(Plane, Vec<Saved>),
}

/// A formulation as it stands in the paper, and as the program takes it.
#[derive(Clone, Debug)]
pub struct Saved {
    /// Name of the element and the algorithm.
    pub paper: String,
    /// Name of what the program takes.
    pub program: String,
    /// Iterations of both; none where it does not converge.
    pub iterations: [Option<usize>; 2],
    /// Peak pressure \[MPa\] and second-moment width \[mm\] of the paper's.
    pub measured: [f64; 2],
    /// Error of p₀ and a of what the program takes.
    pub error: f64,
}

/// Of the meshes of the full planes every third is entered again, and on it three of twenty points; of the others every mesh, and
/// one of twenty points.
const FULL: [usize; 2] = [3, 3];
const OTHERS: [usize; 2] = [1, 1];
const OF: usize = 20;
/// A recomputed error or prediction may differ by this share: the records hold four digits.
const DIGITS: f64 = 2e-3;
/// A spectral radius up to here is 1 to round-off: pressures that no displacement feels stay as they are, and hurt nobody.
const INDIFFERENT: f64 = 1.0 + 1e-6;
/// Most iterations of a formulation of the paper: more than any takes on the cylinder; on the pin–rod some take fifty thousand, which
/// would tell no more.
pub const ENOUGH: usize = 6_000;

/// The record of a plane, and what of it was recomputed.
fn of_plane(plane: Plane) -> Result<Numbers, Error> {
    let chart = Chart::read(plane)?;
    let methods = plane.methods().len();
    let [every, share] = if plane.is_full() { FULL } else { OTHERS };
    let entered: Vec<(usize, Site)> = plane.sites().into_iter().enumerate().step_by(every).collect();
    let again = |(k, site): &(usize, Site)| -> Result<Vec<bool>, Error> {
        let chosen = |row: usize, column: usize| (7 * (k * methods + row) + 3 * column) % OF < share;
        let fresh = points(site, chosen)?;
        Ok(fresh
            .iter()
            .map(|([row, column], fresh)| is_as_recorded(&chart, k * methods + row, *column, fresh))
            .collect())
    };
    let as_recorded = entered.par_iter().map(again).collect::<Result<Vec<_>, _>>()?.concat();
    let moved = as_recorded.iter().filter(|same| !**same).count();
    Ok(Numbers::Surveyed { recomputed: as_recorded.len(), moved, chart })
}

/// Whether a fresh point is the recorded one: class and prediction always, what was measured where no boundary is near.
pub fn is_as_recorded(chart: &Chart, row: usize, column: usize, fresh: &Record) -> bool {
    let kept = &chart.rows[row][column];
    let near = |a: f64, b: f64| a.is_finite() && b.is_finite() && (a - b).abs() <= DIGITS * a.abs().max(b.abs());
    let alike = |a: f64, b: f64| (a.is_nan() && b.is_nan()) || a == b || near(a, b);
    let both =
        |a: Option<f64>, b: Option<f64>| a.is_none() && b.is_none() || a.zip(b).is_some_and(|(a, b)| alike(a, b));
    let measured =
        kept.iterations == fresh.iterations && alike(kept.error, fresh.error) && both(kept.penalty, fresh.penalty);
    let exact = kept.class == Ended::Converged && !chart.is_near_a_boundary(row, column);
    let predicted = both(kept.predicted_iterations, fresh.predicted_iterations);
    kept.class == fresh.class && predicted && (!exact || measured)
}

/// Surveys a plane into a file; what is finished of it is kept in the folder `unfinished`.
pub fn renew(plane: Plane, unfinished: &Path, file: &Path, done: impl Fn() + Sync) -> Result<usize, Error> {
    kept::survey([unfinished, file], &kept::named(HEAD), &plane.sites(), Site::key, records, done)
}

/// Every point of a site, in the order of the record.
pub fn records(site: &Site) -> Result<Vec<Record>, Error> {
    Ok(points(site, |_, _| true)?.into_iter().map(|(_, record)| record).collect())
}

/// The points of a site that are chosen by the places of their method and of their initial stiffness, with these places.
fn points(site: &Site, chosen: impl Fn(usize, usize) -> bool) -> Result<Vec<([usize; 2], Record)>, Error> {
    let case = site.case();
    let discretisation = Discretisation::of(case.scene, case.resolution)?;
    let (methods, stiffnesses) = (site.plane.methods(), site.plane.stiffnesses());
    // Every element has as many methods.
    let by_element: Vec<&[Method]> = methods.chunk_by(|a, b| a.element == b.element).collect();
    let grounds: Vec<Ground> = by_element.iter().map(|own| Ground::of(&discretisation, *site, own[0])).collect();
    let all = (0..methods.len()).flat_map(|row| (0..stiffnesses.len()).map(move |column| [row, column]));
    let places: Vec<[usize; 2]> = all.filter(|[row, column]| chosen(*row, *column)).collect();
    let fresh = |&[row, column]: &[usize; 2]| {
        let ground = &grounds[row / by_element[0].len()];
        Ok(([row, column], ground.record(methods[row], stiffnesses[column])?))
    };
    places.par_iter().map(fresh).collect()
}

/// What the points of one contact element on a site share.
pub struct Ground<'a> {
    discretisation: &'a Discretisation,
    site: Site,
    points: Vec<ContactPoint>,
    limit: Option<Limit>,
}

impl<'a> Ground<'a> {
    /// Contact points of a method on its site, condensed, and the contact that it shall end in.
    pub fn of(discretisation: &'a Discretisation, site: Site, method: Method) -> Self {
        let formulation = site.formulation(method, 1.0);
        let points = discretisation.points(&formulation);
        let limit = Limit::of(&discretisation.problem(&formulation, &points));
        Self { discretisation, site, points, limit }
    }

    /// Predicts and runs a method at an initial stiffness.
    pub fn record(&self, method: Method, stiffness: f64) -> Result<Record, Error> {
        let formulation = self.site.formulation(method, stiffness);
        let run = Run::of(self.discretisation, &formulation);
        let (class, iterations) = Ended::of(&run)?;
        let [error, penalty] = run.map_or([f64::NAN; 2], |run| [run.iteration_error(), run.penalty_error()]);
        Ok(Record {
            method,
            ordinate: self.site.ordinate,
            stiffness: rounded(stiffness),
            class,
            iterations,
            error: rounded(error),
            penalty: (method.rule == StiffnessRule::Penalty).then_some(rounded(penalty)),
            predicted_iterations: self.predicted(method, &formulation).map(rounded),
        })
    }

    /// The iterations that the spectral radius on the limit's active set asks for; the halving law for kinematic load; nothing of what
    /// is accelerated.
    fn predicted(&self, method: Method, formulation: &Formulation) -> Option<f64> {
        let limit = self.limit.as_ref()?;
        if formulation.settings.increments > 1 || method.is_accelerated() {
            return None;
        }
        let problem = self.discretisation.problem(formulation, &self.points);
        let tolerance = formulation.settings.tolerance;
        let (rate, iterations) = match (method.algorithm, method.rule) {
            (Iteration::Kinematic, StiffnessRule::Switching) => {
                let stretch = self.discretisation.scene.contact().stretch;
                let spacing = stretch / (self.discretisation.interfaces[0].nodes.len() - 1) as f64;
                let edge = limit.edge(&problem).max(spacing);
                return Some(halving::iterations(stretch, edge, spacing, formulation.stiffness) as f64);
            }
            (Iteration::Constant, StiffnessRule::Correction) => {
                let iterations = linear::iterations(&problem, limit, IterationError::largest, tolerance);
                let iterations = iterations.map(|iterations| iterations.max(linear::worked_off(&problem, limit)));
                rate::correction(&problem, &limit.closed).zip(iterations)
            }
            (Iteration::Constant, StiffnessRule::Secant) => {
                rate::secant_force(&problem, limit).map(|rate| (rate, rate::iterations(rate, tolerance)))
            }
            (Iteration::Varying, rule) => {
                let rate = match rule {
                    StiffnessRule::Correction => rate::varying_correction(&problem, limit),
                    _ => rate::secant(&problem, &limit.target(&problem), &limit.approach, tolerance * limit.length()),
                };
                rate.zip(release::iterations(&problem, limit, rule, tolerance))
            }
            _ => None,
        }?;
        Some(if rate > INDIFFERENT { f64::INFINITY } else { iterations })
    }
}

/// Every formulation as it stands in the paper, for as long as it takes, and as the program takes it, on the mesh of the library.
fn saved(scene: Plane) -> Result<Numbers, Error> {
    let case = scene.case(STRETCH);
    let discretisation = Discretisation::of(case.scene, case.resolution)?;
    let pairs = Formulation::nine().into_iter().zip(Formulation::compared());
    let of = |(mut paper, program): (Formulation, Formulation)| {
        paper.settings.max_iterations = ENOUGH;
        let [before, after] = [&paper, &program].map(|formulation| Run::of(&discretisation, formulation));
        let (before, after) = (before?, after?);
        let iterations = [&before, &after].map(|run| run.solution.converged().then_some(run.solution.work.iterations));
        let measures = before.measures();
        let measured = [measures.peak.pressure, measures.second_moment_width];
        Ok(Saved { paper: paper.name(), program: program.name(), iterations, measured, error: after.iteration_error() })
    };
    Ok(Numbers::Saved(scene, pairs.map(of).collect::<Result<_, Error>>()?))
}
