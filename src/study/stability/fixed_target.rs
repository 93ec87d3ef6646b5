//! Constant stiffness towards fixed target springs: the condition of the literature, at every point of a grid.

use crate::algorithm::{ContactProblem, Springs};
use crate::case::{Judged, Reference};
use crate::contact::ContactPoint;
use crate::error::Error;
use crate::solution::Work;
use crate::solve::{Discretisation, Element, Formulation, Iteration, Settings};
use crate::stability::{Limit, rate};
use crate::study::unsorted::{Finding, Table, Trial};

/// Name of the trials.
pub const FIXED_TARGET: &str = "constant stiffness, fixed target springs";

/// Target springs by their largest κ*: those that carry the contact's own pressure without a gap, `p/g`, cut off there. A
/// negative one stands in every point and pushes the bodies apart, so that S + K* is not positive definite.
const TARGETS: [f64; 7] = [-0.1, 0.1, 1.0, 3.0, 10.0, 1e2, 1e4];
/// Nearer to the boundary than this a point is not judged.
const NEAR: f64 = 1.02;
/// Neither is one that ends about where the limit of steps is: [`progress`] between these.
const CRAWLING: std::ops::Range<f64> = 0.98..1.02;
/// Rates between which prediction and measurement are compared.
const MEASURABLE: [f64; 2] = [0.05, 0.999];
/// Steps of a window, relative difference of ln ρ between two of them at which the slowest mode is alone, most windows.
const WINDOW: usize = 40;
const SETTLED: f64 = 5e-4;
const WINDOWS: usize = 300;
/// Windows after which a point is left whose [`progress`] is below the next number: it crawls.
const START: usize = 5;
const HOPELESS: f64 = 0.1;
/// Error of ln ρ that is accepted.
const ACCEPTED: f64 = 0.05;

/// How a point ends within the limit of steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum End {
    Converges,
    Crawls,
    Diverges,
}

/// One trial an element.
pub(super) fn trials() -> Vec<Trial> {
    Element::ALL.map(|element| Trial::new(FIXED_TARGET, element.name(), move || grid(element))).into()
}

/// κ₀ over twelve decades by halves.
fn stiffnesses() -> impl Iterator<Item = f64> {
    (-12..=12).map(|k| 10f64.powf(0.5 * f64::from(k)))
}

fn grid(element: Element) -> Result<Finding, Error> {
    let problem = super::truncated();
    let discretisation = Discretisation::of(problem.scene.clone(), problem.resolution)?;
    let formulation = Formulation::new(element, Iteration::Constant);
    let points: Vec<ContactPoint> = discretisation.points(&formulation);
    let problem = discretisation.problem(&formulation, &points);
    let springs = |kappa: f64| vec![kappa * problem.scale.stiffness; points.len()];
    let Some(limit) = Limit::of(&problem) else {
        return Ok(Finding { checks: checks(0, 0, 0, f64::NAN), ..Default::default() });
    };
    let (mut judged, mut wrong, mut compared, mut worst) = (0, 0, 0, 0.0_f64);
    let mut rows = Vec::new();
    for target in TARGETS {
        let mut counts = [0; 3];
        let largest = target * problem.scale.stiffness;
        let wanted = if target < 0.0 {
            springs(target)
        } else {
            limit.target(&problem).into_iter().map(|k| k.min(largest)).collect()
        };
        for initial in stiffnesses() {
            let converges = |k: f64| definite(&problem, &springs(k), &wanted);
            let observed = observed_rate(&problem, &springs(initial), &wanted);
            let seen = end(observed);
            counts[seen as usize] += 1;
            let predicted = rate::fixed_target(&problem, &springs(initial), &wanted).unwrap_or(f64::NAN);
            if converges(initial * NEAR) != converges(initial / NEAR) || CRAWLING.contains(&progress(predicted).abs()) {
                continue;
            }
            judged += 1;
            let sign_is_right = (predicted < 1.0) == converges(initial);
            wrong += usize::from(!sign_is_right || seen != end(predicted));
            if (MEASURABLE[0]..MEASURABLE[1]).contains(&predicted) {
                compared += 1;
                let error = (observed.ln() / predicted.ln() - 1.0).abs();
                worst = if error.is_nan() { f64::NAN } else { worst.max(error) };
            }
        }
        rows.push([vec![target.to_string()], counts.map(|n| n.to_string()).into()].concat());
    }
    let head = ["largest κ*", "converges", "crawls", "diverges"].map(String::from).into();
    let title = format!("{FIXED_TARGET}, {}: starts κ₀ of 25 from 1e-6 to 1e6 by how they end", element.name());
    let checks = checks(judged, wrong, compared, worst);
    Ok(Finding { checks, tables: vec![Table { title, head, rows }], ..Default::default() })
}

fn checks(judged: usize, wrong: usize, compared: usize, worst: f64) -> Vec<Judged> {
    vec![
        Judged::at_most(
            "Constant stiffness shall converge to fixed springs if and only if S + K* and S + 2K₀ − K* are positive definite",
            format!("points of {judged} that end otherwise"),
            if judged == 0 { f64::NAN } else { wrong as f64 },
            Reference::own("predicted", 0.0),
            "at every point farther than 2 % from the boundary; where it merely crawls, predicted steps against the limit",
        ),
        Judged::norm(
            "The rate towards fixed springs shall be the spectral radius",
            format!("largest error of ln ρ, {compared} points"),
            if compared == 0 { f64::NAN } else { worst },
            Reference::own("spectral radius", 0.0),
            ACCEPTED,
            "over forty steps, once the slowest mode is alone",
        ),
    ]
}

/// `S + K* ≻ 0` and `S + 2K₀ − K* ≻ 0`.
fn definite(problem: &ContactProblem, initial: &[f64], target: &[f64]) -> bool {
    let other: Vec<f64> = initial.iter().zip(target).map(|(k0, k)| 2.0 * k0 - k).collect();
    rate::holds(problem, target) && rate::holds(problem, &other)
}

/// Decades per limit of steps over the decades asked for: above 1 it ends, converged or diverged, below it crawls.
fn progress(rate: f64) -> f64 {
    let settings = Settings::default();
    settings.max_steps as f64 * rate.ln() / settings.tolerance.ln()
}

fn end(rate: f64) -> End {
    match progress(rate) {
        progress if progress >= 1.0 => End::Converges,
        progress if progress <= -1.0 => End::Diverges,
        _ => End::Crawls,
    }
}

/// Rate at which `(S + K₀) u⁺ = (K₀ − K*) u` shrinks a start that holds every mode, over [`WINDOW`] steps.
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
