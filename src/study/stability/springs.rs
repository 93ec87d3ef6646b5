//! Stability of constant and varying stiffness: towards fixed springs, and next to the contact.

use crate::algorithm::{Algorithm, ContactProblem, Springs, StiffnessRule, Varying};
use crate::case::{Check, Judged, Quantity, Reference};
use crate::error::Error;
use crate::markdown::{self, Column};
use crate::measure::larger;
use crate::solution::{Outcome, Work};
use crate::solve::{Element, Formulation, Iteration, Settings};
use crate::stability::{Limit, rate};
use crate::study::stability::rates::{ACCEPTED, MEASURABLE, discretised, limit};

/// A number between −½ and ½ for each point, in no order.
fn irregular(point: usize) -> f64 {
    (0.618 * (point + 1) as f64).fract() - 0.5
}

/// Target springs by their largest κ*: those that carry the contact's own pressure without a gap, `p/g`, cut off there.
/// A negative one stands in every point and pushes the bodies apart, so that S + K* is not positive definite.
const TARGETS: [f64; 7] = [-0.1, 0.1, 1.0, 3.0, 10.0, 1e2, 1e4];
/// Nearer to the boundary than this a point is not judged.
const NEAR: f64 = 1.02;
/// Iterations of a window, relative difference of ln ρ between two of them at which the slowest mode is alone, most
/// windows.
const WINDOW: usize = 40;
const SETTLED: f64 = 5e-4;
const WINDOWS: usize = 300;
/// Windows after which a point is left whose [`progress`] is below the next number: it crawls.
const START: usize = 5;
const HOPELESS: f64 = 0.1;
/// Towards fixed springs a start is not judged that ends about where the limit of iterations is: [`progress`] between
/// these.
const CRAWLING: std::ops::Range<f64> = 0.98..1.02;

/// A start of constant stiffness towards given springs: the condition of the literature, and what is observed.
#[derive(Clone, Copy, Debug)]
pub struct Towards {
    /// Largest κ* of the target.
    pub target: f64,
    /// Whether S + K* and S + 2K₀ − K* are positive definite.
    pub definite: bool,
    /// Whether that is otherwise next to κ₀.
    pub near_the_boundary: bool,
    /// Spectral radius; NaN where there is none.
    pub predicted: f64,
    /// Rate of the slowest mode.
    pub observed: f64,
}

/// Starts over twelve decades of κ₀ by halves, towards every target.
pub fn towards(element: Element) -> Result<Vec<Towards>, Error> {
    let discretisation = discretised()?;
    let formulation = Formulation::new(element, Iteration::Constant);
    let points = discretisation.points(&formulation);
    let problem = discretisation.problem(&formulation, &points);
    let asked = limit(&problem)?.target(&problem);
    let to = |target: f64| {
        let wanted: Vec<f64> = match target * problem.scale.stiffness {
            repelling if target < 0.0 => vec![repelling; points.len()],
            largest => asked.iter().map(|k| k.min(largest)).collect(),
        };
        (-12..=12).map(|k| start(&problem, 10f64.powf(0.5 * f64::from(k)), (target, &wanted))).collect::<Vec<_>>()
    };
    Ok(TARGETS.into_iter().flat_map(to).collect())
}

fn start(problem: &ContactProblem, initial: f64, (target, wanted): (f64, &[f64])) -> Towards {
    let springs = |kappa: f64| vec![kappa * problem.scale.stiffness; wanted.len()];
    let definite = |kappa: f64| definite(problem, &springs(kappa), wanted);
    Towards {
        target,
        definite: definite(initial),
        near_the_boundary: definite(initial * NEAR) != definite(initial / NEAR),
        predicted: rate::fixed_target(problem, &springs(initial), wanted).unwrap_or(f64::NAN),
        observed: observed_rate(problem, &springs(initial), wanted),
    }
}

/// `S + K* ≻ 0` and `S + 2K₀ − K* ≻ 0`.
fn definite(problem: &ContactProblem, initial: &[f64], target: &[f64]) -> bool {
    let other: Vec<f64> = initial.iter().zip(target).map(|(k0, k)| 2.0 * k0 - k).collect();
    rate::holds(problem, target) && rate::holds(problem, &other)
}

/// Decades per limit of iterations over the decades asked for: above 1 it ends, converged or diverged, below it crawls.
fn progress(rate: f64) -> f64 {
    let settings = Settings::default();
    settings.max_iterations as f64 * rate.ln() / settings.tolerance.ln()
}

/// How a rate ends within the limit of iterations: at the tolerance, as far beyond the start, or in between.
fn end(rate: f64) -> Outcome {
    match progress(rate) {
        progress if progress >= 1.0 => Outcome::Converged,
        progress if progress <= -1.0 => Outcome::Diverged,
        _ => Outcome::Capped,
    }
}

/// Rate at which `(S + K₀) u⁺ = (K₀ − K*) u` shrinks a start that holds every mode, over [`WINDOW`] iterations.
///
/// Without a load the solution is zero: however small the error, it has all its digits.
fn observed_rate(problem: &ContactProblem, initial: &[f64], target: &[f64]) -> f64 {
    let Some(factor) = problem.factorise(initial, &mut Work::default()) else { return f64::NAN };
    let problem = ContactProblem { load: &vec![0.0; problem.load.len()], ..problem.clone() };
    let mut springs = Springs { stiffness: initial.to_vec(), force: (0..initial.len()).map(irregular).collect() };
    let mut last = f64::NAN;
    for window in 0..WINDOWS {
        let mut grown = 0.0;
        for _ in 0..WINDOW {
            let found = problem.equilibrium(&factor, &springs, |_| 0.0, &mut Work::default());
            let force: Vec<f64> = (0..initial.len()).map(|i| (target[i] - initial[i]) * found.approach[i]).collect();
            let [before, after] = [&springs.force, &force].map(|v| v.iter().map(|r| r * r).sum::<f64>().sqrt());
            grown += (after / before).ln() / WINDOW as f64;
            springs.force = force.iter().map(|r| r / after).collect();
        }
        let crawls = window >= START && progress(grown.exp()).abs() < HOPELESS;
        if crawls || ((grown - last) / grown).abs() < SETTLED {
            return grown.exp();
        }
        last = grown;
    }
    last.exp()
}

/// The condition decides how a start ends, and the spectral radius how fast.
pub fn judge_towards(starts: &[Towards]) -> Vec<Judged> {
    let is_judged = |start: &&Towards| !start.near_the_boundary && !CRAWLING.contains(&progress(start.predicted).abs());
    let judged: Vec<&Towards> = starts.iter().filter(is_judged).collect();
    let ends_otherwise =
        |start: &&&Towards| (start.predicted < 1.0) != start.definite || end(start.observed) != end(start.predicted);
    let compared = judged.iter().filter(|start| (MEASURABLE[0]..MEASURABLE[1]).contains(&start.predicted));
    let errors: Vec<f64> = compared.map(|start| (start.observed.ln() / start.predicted.ln() - 1.0).abs()).collect();
    vec![
        Check::none(
            "start towards fixed springs that does not converge although S + K* and S + 2K₀ − K* are positive \
                definite, or converges although they are not",
            format!(
                "at every start farther than a factor of {NEAR} from the boundary; where it merely crawls, \
                predicted iterations against the limit"
            ),
        )
        .asked_of(judged.len())
        .judge(judged.iter().filter(ends_otherwise).count() as f64),
        Check::error(
            Quantity::at("largest error of ln ρ, ρ the rate towards fixed springs", format!("{} points", errors.len())),
            Reference::own("spectral radius", 0.0),
            ACCEPTED,
            "over forty iterations, once the slowest mode is alone",
        )
        .judge(errors.into_iter().reduce(larger).unwrap_or(f64::NAN)),
    ]
}

/// The starts towards each target by how they end.
pub(super) fn table_of_towards(starts: &[Towards]) -> String {
    fn ending(starts: &[Towards], wanted: Outcome) -> String {
        starts.iter().filter(|start| end(start.observed) == wanted).count().to_string()
    }
    let columns: [Column<&[Towards]>; 4] = [
        ("largest κ*", |starts| starts[0].target.to_string()),
        ("converges", |starts| ending(starts, Outcome::Converged)),
        ("crawls", |starts| ending(starts, Outcome::Capped)),
        ("diverges", |starts| ending(starts, Outcome::Diverged)),
    ];
    let targets: Vec<&[Towards]> = starts.chunk_by(|a, b| a.target.total_cmp(&b.target).is_eq()).collect();
    markdown::columns(&columns, &targets)
}

/// Initial stiffnesses around the boundary of varying stiffness with `correction`.
const AROUND: [f64; 10] = [0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0];
/// Relative change of the limit's springs at the start, iterations followed, and what error tells staying from leaving.
const NUDGE: f64 = 1e-3;
const STEPS: usize = 3000;
const LEFT: f64 = 1e-2;

/// Varying stiffness with `correction`, started next to the contact.
#[derive(Clone, Copy, Debug)]
pub struct Basin {
    /// Initial stiffness κ₀.
    pub stiffness: f64,
    /// Spectral radius next to the contact; NaN where there is none.
    pub predicted: f64,
    /// Whether it stays when started next to the contact.
    pub stays: bool,
}

/// Every start with an element.
pub fn basin(element: Element) -> Result<Vec<Basin>, Error> {
    let discretisation = discretised()?;
    let start = |stiffness: f64| {
        let base = Formulation::new(element, Iteration::Varying);
        let formulation = Formulation { rule: StiffnessRule::Correction, stiffness, ..base };
        let points = discretisation.points(&formulation);
        let problem = discretisation.problem(&formulation, &points);
        let limit = limit(&problem)?;
        let predicted = rate::varying_correction(&problem, &limit).unwrap_or(f64::NAN);
        Ok(Basin { stiffness, predicted, stays: stays(&problem, &limit) })
    };
    AROUND.into_iter().map(start).collect()
}

/// Whether springs nudged off the limit's bring the error down, or away.
fn stays(problem: &ContactProblem, limit: &Limit) -> bool {
    let nudge = |(i, k): (usize, &f64)| problem.scale.clip(k * (1.0 + NUDGE * irregular(i)));
    let stiffness: Vec<f64> = limit.target(problem).iter().enumerate().map(nudge).collect();
    let mut springs = Springs { force: vec![0.0; stiffness.len()], stiffness };
    let mut algorithm = Varying::new(StiffnessRule::Correction);
    let mut error = f64::NAN;
    for _ in 0..STEPS {
        let Some(iterate) = algorithm.next(problem, &mut springs, &mut Work::default()) else { return false };
        error = limit.error(problem, iterate.pressure, iterate.approach).largest();
    }
    error < LEFT * NUDGE
}

/// The spectral radius decides whether a start next to the contact stays.
pub fn judge_basin(starts: &[Basin]) -> Judged {
    let is_wrong = |start: &&Basin| start.predicted.is_nan() || start.stays != (start.predicted < 1.0);
    Check::none(
        "start next to the contact, with varying stiffness and correction, that stays although its spectral \
            radius is above 1, or leaves although it is below",
        "the boundary is where 2 (S + K*) − max(K*, K₀) ceases to be positive definite on the closed points",
    )
    .asked_of(starts.len())
    .judge(starts.iter().filter(is_wrong).count() as f64)
}

/// Every start with the name of its element.
pub(super) fn table_of_basin(starts: &[(&str, &Basin)]) -> String {
    let columns: [Column<(&str, &Basin)>; 4] = [
        ("element", |(element, _)| element.to_string()),
        ("κ₀", |(_, start)| start.stiffness.to_string()),
        ("predicted ρ", |(_, start)| format!("{:.3}", start.predicted)),
        ("next to the contact", |(_, start)| if start.stays { "stays" } else { "leaves" }.into()),
    ];
    markdown::columns(&columns, starts)
}
