//! Constant stiffness towards fixed target springs: the condition of the literature, at every point of a grid.

use serde::Serialize;

use crate::algorithm::{ContactProblem, Springs};
use crate::contact::ContactPoint;
use crate::error::Error;
use crate::solution::Work;
use crate::solve::{Element, Formulation, Iteration, Settings};
use crate::stability::rate;
use crate::study::stability::ground;

/// Target springs by their largest κ*: those that carry the contact's own pressure without a gap, `p/g`, cut off there. A
/// negative one stands in every point and pushes the bodies apart, so that S + K* is not positive definite.
const TARGETS: [f64; 7] = [-0.1, 0.1, 1.0, 3.0, 10.0, 1e2, 1e4];
/// Nearer to the boundary than this a point is not judged.
pub(super) const NEAR: f64 = 1.02;
/// Iterations of a window, relative difference of ln ρ between two of them at which the slowest mode is alone, most windows.
const WINDOW: usize = 40;
const SETTLED: f64 = 5e-4;
const WINDOWS: usize = 300;
/// Windows after which a point is left whose [`progress`] is below the next number: it crawls.
const START: usize = 5;
const HOPELESS: f64 = 0.1;
/// Starts towards target springs.
#[derive(Clone, Debug, Serialize)]
pub struct Target {
    /// Their largest κ*.
    pub largest: f64,
    /// The starts.
    pub starts: Vec<Start>,
}

/// A start, predicted and observed.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Start {
    /// Whether S + K* and S + 2K₀ − K* are positive definite.
    pub definite: bool,
    /// Whether that is otherwise next to κ₀.
    pub near_the_boundary: bool,
    /// Spectral radius; NaN where there is none.
    pub predicted: f64,
    /// Rate of the slowest mode.
    pub observed: f64,
}

/// How a point ends within the limit of iterations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// To the tolerance.
    Converges,
    /// Neither.
    Crawls,
    /// By as much as it should have come nearer.
    Diverges,
}

/// κ₀ over twelve decades by halves.
fn stiffnesses() -> impl Iterator<Item = f64> {
    (-12..=12).map(|k| 10f64.powf(0.5 * f64::from(k)))
}

/// Every start towards every target with an element.
pub fn grid(element: Element) -> Result<Vec<Target>, Error> {
    let discretisation = ground::discretised()?;
    let formulation = Formulation::new(element, Iteration::Constant);
    let points: Vec<ContactPoint> = discretisation.points(&formulation);
    let problem = discretisation.problem(&formulation, &points);
    let asked = ground::limit(&problem)?.target(&problem);
    let target = |largest: f64| {
        let wanted: Vec<f64> = match largest * problem.scale.stiffness {
            repelling if largest < 0.0 => vec![repelling; points.len()],
            largest => asked.iter().map(|k| k.min(largest)).collect(),
        };
        Target { largest, starts: stiffnesses().map(|initial| start(&problem, initial, &wanted)).collect() }
    };
    Ok(TARGETS.map(target).into())
}

fn start(problem: &ContactProblem, initial: f64, wanted: &[f64]) -> Start {
    let springs = |kappa: f64| vec![kappa * problem.scale.stiffness; wanted.len()];
    let definite = |kappa: f64| definite(problem, &springs(kappa), wanted);
    Start {
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
pub fn progress(rate: f64) -> f64 {
    let settings = Settings::default();
    settings.max_iterations as f64 * rate.ln() / settings.tolerance.ln()
}

/// How a rate ends.
pub fn end(rate: f64) -> End {
    match progress(rate) {
        progress if progress >= 1.0 => End::Converges,
        progress if progress <= -1.0 => End::Diverges,
        _ => End::Crawls,
    }
}

/// Rate at which `(S + K₀) u⁺ = (K₀ − K*) u` shrinks a start that holds every mode, over [`WINDOW`] iterations.
///
/// Without a load the solution is zero: however small the error, it has all its digits.
fn observed_rate(problem: &ContactProblem, initial: &[f64], target: &[f64]) -> f64 {
    let Some(factor) = problem.factorise(initial, &mut Work::default()) else { return f64::NAN };
    let unloaded = vec![0.0; problem.load.len()];
    let irregular = |i: usize| (0.618 * (i + 1) as f64).fract() - 0.5;
    let mut springs = Springs { stiffness: initial.to_vec(), force: (0..initial.len()).map(irregular).collect() };
    let mut last = f64::NAN;
    for window in 0..WINDOWS {
        let mut grown = 0.0;
        for _ in 0..WINDOW {
            let found = problem.equilibrium(&factor, &unloaded, &springs, |_| 0.0, &mut Work::default());
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
