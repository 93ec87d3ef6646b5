//! One point: predicted from the condensed matrices, then run.

use crate::algorithm::StiffnessRule;
use crate::contact::ContactPoint;
use crate::error::{Error, Kind};
use crate::measure::profile::weighted_line;
use crate::solution::{IterationError, Solution};
use crate::solve::run::Run;
use crate::solve::{Discretisation, Formulation, Iteration};
use crate::stability::{Limit, halving, linear, rate, release};
use crate::study::atlas::record::Record;
use crate::study::atlas::row::Row;
use crate::study::class::Class;
use crate::study::records::rounded;

/// A spectral radius up to here is 1 to round-off: pressures that no displacement feels stay as they are, and hurt nobody.
const INDIFFERENT: f64 = 1.0 + 1e-6;

/// A scene on a mesh, condensed once for all its points.
pub struct Site {
    discretisation: Discretisation,
}

/// What the points of one contact element on a site share.
pub struct Ground<'a> {
    site: &'a Site,
    points: Vec<ContactPoint>,
    limit: Option<Limit>,
}

impl Site {
    /// Mesh and condensation of a row.
    pub fn of(row: &Row) -> Result<Self, Error> {
        let case = row.case();
        Ok(Self { discretisation: Discretisation::of(case.scene, case.resolution)? })
    }
}

impl<'a> Ground<'a> {
    /// Contact points and limit of a row on its site.
    pub fn of(site: &'a Site, row: &Row) -> Result<Self, Error> {
        let formulation = row.formulation(1.0);
        let points = site.discretisation.points(&formulation);
        let limit = Limit::of(&site.discretisation.problem(&formulation, &points));
        Ok(Self { site, points, limit })
    }

    /// Predicts and runs a row at an initial stiffness.
    pub fn record(&self, row: &Row, stiffness: f64) -> Result<Record, Error> {
        let formulation = row.formulation(stiffness);
        let [predicted_rate, predicted_iterations] = self.predicted(row, &formulation);
        let record = |class, iterations, iteration_error, rate, [error, penalty]: [f64; 2]| Record {
            method: row.method,
            ordinate: row.ordinate,
            stiffness: rounded(stiffness),
            class,
            iterations,
            iteration_error: rounded(iteration_error),
            rate: rounded(rate),
            error: rounded(error),
            penalty: rounded(penalty),
            predicted_rate: rounded(predicted_rate),
            predicted_iterations: rounded(predicted_iterations),
        };
        match Run::of(&self.site.discretisation, &formulation) {
            Ok(run) => {
                let solution = &run.solution;
                let [iteration, rate] = [solution.error().largest(), observed_rate(solution)];
                let errors = [run.iteration_error(), run.penalty_error()];
                Ok(record(Class::of(solution.outcome), solution.work.iterations, iteration, rate, errors))
            }
            Err(Error { kind: Kind::NoSpringLeft { iterations }, .. }) => {
                Ok(record(Class::Unsupported, iterations, f64::NAN, f64::NAN, [f64::NAN; 2]))
            }
            Err(Error { kind: Kind::SpringsTooSoft, .. }) => {
                Ok(record(Class::Unsupported, 0, f64::NAN, f64::NAN, [f64::NAN; 2]))
            }
            Err(Error { kind: Kind::ContactBeyondCandidates { .. }, .. }) => {
                Ok(record(Class::Beyond, 0, f64::NAN, f64::NAN, [f64::NAN; 2]))
            }
            Err(error) => Err(error),
        }
    }

    /// Spectral radius on the limit's active set and the iterations it asks for; the halving law for kinematic load; nothing of what
    /// is accelerated.
    fn predicted(&self, row: &Row, formulation: &Formulation) -> [f64; 2] {
        let Some(limit) = &self.limit else { return [f64::NAN; 2] };
        if formulation.settings.increments > 1 || row.method.is_accelerated() {
            return [f64::NAN; 2];
        }
        let problem = self.site.discretisation.problem(formulation, &self.points);
        let tolerance = formulation.settings.tolerance;
        let found = match (row.method.algorithm, row.method.rule) {
            (Iteration::Kinematic, StiffnessRule::Switching) => {
                let stretch = self.site.discretisation.scene.contact().stretch;
                let spacing = stretch / (self.site.discretisation.interfaces[0].nodes.len() - 1) as f64;
                let edge = limit.edge(&problem).max(spacing);
                return [f64::NAN, halving::iterations(stretch, edge, spacing, formulation.stiffness) as f64];
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
        };
        let [rate, iterations] = found.map_or([f64::NAN; 2], |(rate, iterations)| [rate, iterations]);
        [rate, if rate > INDIFFERENT { f64::INFINITY } else { iterations }]
    }
}

/// Slope of the logarithm of the iteration error over the latter half of the iterations.
fn observed_rate(solution: &Solution) -> f64 {
    let errors: Vec<f64> = solution.history.iter().map(|iteration| iteration.error.largest()).collect();
    let latter = &errors[errors.len() / 2..];
    if latter.len() < 5 {
        return f64::NAN;
    }
    let points: Vec<[f64; 3]> = latter.iter().enumerate().map(|(step, r)| [step as f64, r.ln(), 1.0]).collect();
    weighted_line(&points).1.exp()
}

/// Whether two rows share their ground: scene, mesh and contact points.
pub fn share_ground(a: &Row, b: &Row) -> bool {
    let key = |row: &Row| (row.plane, row.ordinate.to_bits(), row.method.element);
    key(a) == key(b)
}
